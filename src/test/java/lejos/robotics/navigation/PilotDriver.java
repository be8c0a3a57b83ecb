package lejos.robotics.navigation;

import java.util.Map;
import java.util.Random;
import lejos.Agreement.Sightings;
import lejos.robotics.FakeMotor;
import lejos.robotics.chassis.Wheel;
import lejos.robotics.chassis.WheeledChassis;

/** Drives both kinds of pilots and notes what their motors are told and what they report of each move. */
final class PilotDriver {
    private final FakeMotor left = new FakeMotor();
    private final FakeMotor right = new FakeMotor();
    private final Sightings seen = new Sightings();
    private final Random random;

    private PilotDriver(int seed) {
        random = new Random(seed);
    }

    static Map<String, Double> play(int seed) {
        PilotDriver driver = new PilotDriver(seed);
        if (seed % 2 == 0) {
            driver.differential();
        } else {
            driver.chassis();
        }
        return driver.seen;
    }

    @SuppressWarnings("deprecation")
    private void differential() {
        double diameter = 20 + random.nextDouble() * 80;
        DifferentialPilot pilot = new DifferentialPilot(diameter, 60 + random.nextDouble() * 150, left, right,
                random.nextBoolean());
        note("new", pilot, pilot);
        pilot.setLinearSpeed(10 + random.nextDouble() * 300);
        pilot.setAngularSpeed(10 + random.nextDouble() * 300);
        pilot.setLinearAcceleration(20 + random.nextInt(900));
        finite(pilot, "set ");
        pilot.steer(rate(), amount());
        note("steer by", pilot, pilot);
        pilot.rotate(amount());
        note("turn", pilot, pilot);
        pilot.steer(rate());
        note("steer", pilot, null);
        pilot.stop();
        note("stop", pilot, null);
        pilot.steerBackward(rate());
        note("steer backward", pilot, null);
        pilot.stop();
        pilot.arcForward(radius());
        note("arc forward", pilot, null);
        pilot.stop();
        pilot.forward();
        note("forward", pilot, null);
        pilot.quickStop();
        note("quick stop", pilot, null);
    }

    private void finite(DifferentialPilot pilot, String label) {
        pilot.travel(amount());
        note(label + "travel", pilot, pilot);
        pilot.rotate(amount());
        note(label + "rotate", pilot, pilot);
        pilot.arc(radius(), amount());
        note(label + "arc", pilot, pilot);
        pilot.travelArc(radius(), amount());
        note(label + "travel arc", pilot, pilot);
    }

    private double rate() {
        return (1 + random.nextDouble() * 250) * (random.nextBoolean() ? 1 : -1);
    }

    private double radius() {
        return random.nextDouble() * 600 - 300;
    }

    private double amount() {
        return random.nextDouble() * 600 - 300;
    }

    private void chassis() {
        Wheel[] wheels = {WheeledChassis.modelWheel(left, 20 + random.nextDouble() * 80).offset(50).gearRatio(2),
            WheeledChassis.modelWheel(right, 20 + random.nextDouble() * 80).offset(-70).invert(random.nextBoolean())};
        MovePilot pilot = new MovePilot(new WheeledChassis(wheels, WheeledChassis.TYPE_DIFFERENTIAL));
        Latest latest = new Latest();
        pilot.addMoveListener(latest);
        seen.note("speed", pilot.getLinearSpeed()).note("turn", pilot.getAngularSpeed());
        seen.note("acceleration", pilot.getLinearAcceleration()).note("turning", pilot.getAngularAcceleration());
        pilot.travel(100 + amount() / 4);
        note("travel", latest);
        pilot.setLinearSpeed(10 + random.nextDouble() * 300);
        pilot.setAngularAcceleration(10 + random.nextDouble() * 300);
        pilot.rotate(amount());
        note("rotate", latest);
        pilot.travel(100 + amount() / 4);
        note("travel again", latest);
        double radius = 100 + random.nextDouble() * 300;
        pilot.setLinearSpeed(20);
        pilot.setAngularSpeed(200);
        pilot.setLinearAcceleration(80);
        pilot.setAngularAcceleration(800);
        pilot.arc(random.nextBoolean() ? radius : -radius, 30 + random.nextInt(200));
        note("arc", latest);
    }

    private void note(String label, DifferentialPilot pilot, Object rotating) {
        command(label + " left", left);
        command(label + " right", right);
        seen.note(label + " distance", pilot.getMovementIncrement()).note(label + " angle", pilot.getAngleIncrement());
        if (rotating != null) {
            seen.note(label + " speeds", pilot.getLinearSpeed() + 3 * pilot.getAngularSpeed()
                    + 7 * pilot.getMaxRotateSpeed());
            seen.note(label + " limits", pilot.getMaxLinearSpeed() + 5 * pilot.getMaxAngularSpeed()
                    + pilot.getTurnRate());
        }
    }

    private void note(String label, Latest latest) {
        command(label + " left", left);
        command(label + " right", right);
        latest.note(seen, label + " started", latest.started);
        latest.note(seen, label + " stopped", latest.stopped);
    }

    private void command(String label, FakeMotor motor) {
        String command = motor.lastCommand();
        if (command.equals("nothing")) {
            seen.note(label + " speed", motor.getSpeed());
            return;
        }
        String[] words = command.split("[, ]+");
        seen.note(label + " acceleration", Integer.parseInt(words[0]));
        seen.note(label + " speed", words[2].equals("stop") ? 0 : Integer.parseInt(words[1]));
        seen.note(label + " motion", words[2].hashCode())
                .note(label + " by", words.length > 3 ? Integer.parseInt(words[3]) : 0);
    }

    /** Copies what the events say, without what is repaired: the sign of a distance, the kind of almost a turn. */
    private static final class Latest implements MoveListener {
        private volatile float[] started;
        private volatile float[] stopped;

        @Override
        public void moveStarted(Move event, MoveProvider mp) {
            started = values(event);
        }

        @Override
        public void moveStopped(Move event, MoveProvider mp) {
            stopped = values(event);
        }

        private static float[] values(Move move) {
            boolean turn = Math.abs(move.getDistanceTraveled()) < 5;
            return new float[] {turn ? 0 : move.getMoveType().ordinal(), Math.abs(move.getDistanceTraveled()),
                move.getAngleTurned(), move.getTravelSpeed(), move.getRotateSpeed(), move.isMoving() ? 1 : 0};
        }

        private static void note(Sightings seen, String label, float[] values) {
            for (int i = 0; i < values.length; i++) {
                seen.note(label + " " + i, values[i]);
            }
        }
    }
}
