package lejos.robotics;

/** An unregulated motor seen from the other side: forward is backward. */
class ReversedEncoderMotor implements EncoderMotor {
    private final EncoderMotor motor;

    ReversedEncoderMotor(EncoderMotor motor) {
        this.motor = motor;
    }

    EncoderMotor original() {
        return motor;
    }

    @Override
    public int getPower() {
        return motor.getPower();
    }

    @Override
    public void setPower(int power) {
        motor.setPower(power);
    }

    @Override
    public void backward() {
        motor.forward();
    }

    @Override
    public void flt() {
        motor.flt();
    }

    @Override
    public void forward() {
        motor.backward();
    }

    @Override
    public boolean isMoving() {
        return motor.isMoving();
    }

    @Override
    public void stop() {
        motor.stop();
    }

    @Override
    public int getTachoCount() {
        return -motor.getTachoCount();
    }

    @Override
    public void resetTachoCount() {
        motor.resetTachoCount();
    }
}
