package brickless.hardware;

/** Service that starts a live brick, paced to the wall clock, for a program that was started as plain Java. */
public interface BrickProvider {
    /** Starts a default simulation and returns its brick. Called at most once per class loader. */
    BrickHardware startLive();
}
