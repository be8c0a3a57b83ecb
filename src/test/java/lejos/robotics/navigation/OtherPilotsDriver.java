package lejos.robotics.navigation;

import java.util.Map;
import java.util.Random;
import lejos.Agreement.Sightings;
import lejos.hardware.Power;
import lejos.robotics.FakeMotor;

/** Drives the pilots of cars and of robots on three omnidirectional wheels, and notes what their motors are told. */
final class OtherPilotsDriver {
    /**
     * The published class computes in single precision: a whole number may be off by one, which is made to count
     * little.
     */
    private static final double WHOLE = 1000;

    /** Each published pilot leaves a thread behind: few pilots, many moves. */
    private static final int ROUNDS = 50;

    private final Sightings seen = new Sightings();
    private final Random random;
    private final FakeMotor[] motors = {new FakeMotor(), new FakeMotor(), new FakeMotor()};

    private OtherPilotsDriver(int seed) {
        random = new Random(seed);
    }

    static Map<String, Double> play(int seed) {
        OtherPilotsDriver driver = new OtherPilotsDriver(seed);
        if (seed % 2 == 0) {
            driver.car();
        } else {
            driver.omni();
        }
        return driver.seen;
    }

    private void car() {
        double radius = 100 + random.nextInt(200);
        SteeringPilot pilot = new SteeringPilot(20 + random.nextDouble() * 80, motors[0], motors[1], radius,
                20 + random.nextInt(60), -20 - random.nextInt(60));
        seen.note("radius", pilot.getMinRadius()).note("increment", pilot.getMovementIncrement());
        for (int round = 0; round < ROUNDS; round++) {
            pilot.travel(amount());
            note(round + " travel");
            pilot.arc(radius + random.nextInt(300), amount());
            note(round + " left arc");
            pilot.travelArc(-radius - random.nextInt(300), amount());
            note(round + " right arc");
            pilot.travelArc(Double.POSITIVE_INFINITY, amount());
            note(round + " straight");
        }
        motors[0].setSlow();
        pilot.arcForward(radius);
        seen.note("steering", motors[1].getTachoCount()).note("moving", pilot.isMoving());
        pilot.stop();
        seen.note("last", motors[0].lastCommand().endsWith("stop")).note("still moving", pilot.isMoving());
        refusal(pilot, radius);
    }

    private void refusal(SteeringPilot pilot, double radius) {
        boolean refused = false;
        try {
            pilot.arc(radius - 1, 10);
        } catch (IllegalArgumentException e) {
            refused = true;
        }
        seen.note("refused", refused);
    }

    @SuppressWarnings("deprecation")
    private void omni() {
        OmniPilot pilot = new OmniPilot(50 + random.nextInt(100), 20 + random.nextInt(80), motors[0],
                motors[1], motors[2], random.nextBoolean(), random.nextBoolean(), new Volts(6 + random.nextInt(3)));
        seen.note("speed", pilot.getLinearSpeed()).note("turn", pilot.getAngularSpeed());
        seen.note("limit", pilot.getMaxLinearSpeed()).note("turn limit", pilot.getMaxAngularSpeed());
        pilot.rotate(amount());
        note("rotate");
        for (int round = 0; round < ROUNDS; round++) {
            pilot.setLinearSpeed(20 + random.nextInt(200));
            pilot.setAngularSpeed(10 + random.nextInt(200));
            pilot.travel(amount());
            note(round + " travel");
            pilot.travel(amount(), (double) random.nextInt(360));
            note(round + " travel aslant");
            pilot.rotate(amount());
            note(round + " rotate");
            pilot.arc(50 + random.nextInt(300), amount());
            note(round + " arc");
            pilot.travelArc(50 + random.nextInt(300), amount());
            note(round + " travel arc");
        }
    }

    private double amount() {
        return random.nextInt(600) - 300 + 0.5;
    }

    private void note(String label) {
        for (int i = 0; i < motors.length; i++) {
            String[] words = motors[i].lastCommand().split("[, ]+");
            String name = label + " " + i;
            if (words.length > 3) {
                int by = Integer.parseInt(words[3]);
                seen.note(name + " speed", by == 0 ? 0 : Integer.parseInt(words[1]) / WHOLE)
                        .note(name + " by", by / WHOLE);
            }
        }
    }

    private static final class Volts implements Power {
        private final float voltage;

        Volts(float voltage) {
            this.voltage = voltage;
        }

        @Override
        public int getVoltageMilliVolt() {
            return (int) (voltage * 1000);
        }

        @Override
        public float getVoltage() {
            return voltage;
        }

        @Override
        public float getBatteryCurrent() {
            return 0;
        }

        @Override
        public float getMotorCurrent() {
            return 0;
        }
    }
}
