package brickless.simulation;

import brickless.world.Pose2;

/**
 * Something a person or the world does to a robot at a given time. Times are nanoseconds since the start of the run.
 */
public sealed interface Stimulus {
    /** When it happens. */
    long atNanos();

    /** The action in the words of the stimuli file, without the time. */
    String text();

    /** A key of the brick is held; {@code keyMask} as in {@code KeySocket}. */
    record Press(long atNanos, int keyMask, long forNanos, String text) implements Stimulus {}

    /** The touch sensor at a port (0 to 3) is held by hand. */
    record Push(long atNanos, int port, long forNanos, String text) implements Stimulus {}

    /** A button of the infrared remote is held: channel 1 to 4, LEGO code 1 to 11. */
    record Remote(long atNanos, int channel, int code, long forNanos, String text) implements Stimulus {}

    /** A short noise. */
    record Clap(long atNanos, double decibels, String text) implements Stimulus {}

    /** A robot or movable obstacle is put somewhere else. */
    record Move(long atNanos, String target, Pose2 pose, String text) implements Stimulus {}

    /** A movable obstacle is taken away. */
    record Remove(long atNanos, String target, String text) implements Stimulus {}

    /** The battery's no-load voltage changes. */
    record Battery(long atNanos, double volts, String text) implements Stimulus {}

    /** Something is held until it is released: what a person does who does not know yet for how long. */
    record Hold(long atNanos, Holdable what, String text) implements Stimulus {}

    /** Something that was held is let go. */
    record Release(long atNanos, Holdable what, String text) implements Stimulus {}

    /** A stimulus that concerns the robot with this name instead of the first one (or, for a remote, all). */
    record On(String robot, Stimulus what) implements Stimulus {
        @Override
        public long atNanos() {
            return what.atNanos();
        }

        @Override
        public String text() {
            return what.text() + " on " + robot;
        }
    }

    /** What can be held for a time that is not known when it begins. */
    sealed interface Holdable {}

    /** A key of the brick. */
    record Key(int mask) implements Holdable {}

    /** The touch sensor at a port (0 to 3). */
    record TouchSensor(int port) implements Holdable {}

    /** A button of the infrared remote: channel 1 to 4, LEGO code 1 to 11. */
    record RemoteButton(int channel, int code) implements Holdable {}
}
