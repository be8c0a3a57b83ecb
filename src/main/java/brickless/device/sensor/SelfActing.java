package brickless.device.sensor;

/** A device that follows the arena of its own accord: it measures in its own rhythm, not when asked. */
interface SelfActing {
    /** Called after every step. */
    void afterStep(long nowNanos);
}
