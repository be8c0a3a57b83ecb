/**
 * The mechanics of an arena: bodies, wheels, contacts and rays, seen from above. The only user of JBox2D.
 *
 * <p>Public methods take and return SI units in the drawing's frame (x right, y down, headings clockwise). Everything
 * here is single threaded: callers hold the {@link brickless.physics.Arena}'s monitor. Steps allocate nothing beyond
 * what JBox2D itself does.
 *
 * <p>May use: {@code brickless.world}, {@code brickless.units}, JBox2D.
 */
package brickless.physics;
