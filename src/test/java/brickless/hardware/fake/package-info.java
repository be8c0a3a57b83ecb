/**
 * Fakes of a brick's sockets for contract tests: everything is recorded, and time passes only when the test says so.
 */
package brickless.hardware.fake;
