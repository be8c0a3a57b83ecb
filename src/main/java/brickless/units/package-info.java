/** Unit conversions and nothing else. May use: the JDK. */
package brickless.units;
