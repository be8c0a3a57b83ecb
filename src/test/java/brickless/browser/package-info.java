/** A headless browser for tests of pages. */
package brickless.browser;
