/**
 * The devices of one robot, put together. May use: {@code brickless.device.motor}, {@code .sensor}, {@code .battery},
 * and what they use.
 */
package brickless.device;
