package brickless.viewer;

import java.util.OptionalLong;

/** What a viewer asks for. */
sealed interface Command {
    /** Holds the run. */
    record Pause() implements Command {}

    /** Lets it go on. */
    record Play() implements Command {}

    /** Lets it go on by some simulated time and holds it. */
    record Step(long nanos) implements Command {}

    /** Changes the speed. */
    record SetSpeed(double speed) implements Command {}

    /** Begins anew, with another seed or the last one. */
    record Restart(OptionalLong seed) implements Command {}

    /** Does something to the world, in the words of the stimuli file without the time. */
    record Touch(String words) implements Command {}

    /** Takes hold of something or lets it go; viewer 0 is one that did not say who it is. */
    record Hold(String robot, String what, boolean down, int viewer) implements Command {}
}
