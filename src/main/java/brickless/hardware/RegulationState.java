package brickless.hardware;

/** Phase of a motor controller, in the order of the original's state numbers 0 to 6. */
public enum RegulationState {
    /** Not powered: coasting. */
    IDLE,
    /** The last move was given up because the motor was blocked. */
    STALL,
    /** Standing still under active position hold. */
    HOLD,
    /** A move was accepted and begins with the next control tick. */
    START,
    /** Speeding up (or changing speed). */
    ACCEL,
    /** Running at the requested speed. */
    MOVE,
    /** Slowing down or settling at the target. */
    DECEL;

    /** Whether {@code isMoving()} is true in this state. */
    public boolean moving() {
        return compareTo(START) >= 0;
    }
}
