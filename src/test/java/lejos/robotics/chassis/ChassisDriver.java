package lejos.robotics.chassis;

import java.util.Map;
import java.util.Random;
import lejos.Agreement.Sightings;
import lejos.robotics.FakeMotor;
import lejos.robotics.navigation.Move;
import lejos.utility.Matrix;

/** Asks chassis of all kinds everything in which ours is to be the published one's equal. */
final class ChassisDriver {
    private static final double LARGE = 1000;

    private final Sightings seen = new Sightings();
    private final Random random;
    private final FakeMotor[] motors;
    private final WheeledChassis chassis;
    private final boolean holonomic;

    private ChassisDriver(int seed) {
        random = new Random(seed);
        holonomic = seed % 3 == 0;
        motors = new FakeMotor[holonomic ? 3 : 2];
        Wheel[] wheels = new Wheel[motors.length];
        for (int i = 0; i < motors.length; i++) {
            motors[i] = new FakeMotor();
            motors[i].setTacho(random.nextInt(1000) - 500);
            wheels[i] = holonomic ? holonomicWheel(i) : wheel(i);
        }
        chassis = new WheeledChassis(wheels, motors.length);
    }

    static Map<String, Double> play(int seed) {
        ChassisDriver driver = new ChassisDriver(seed);
        driver.limits();
        driver.moves();
        driver.velocities();
        driver.displacement();
        return driver.seen;
    }

    private Wheel wheel(int i) {
        double offset = (i == 0 ? 1 : -1) * (20 + random.nextDouble() * 80);
        return WheeledChassis.modelWheel(motors[i], 30 + random.nextDouble() * 60).offset(offset)
                .gearRatio(0.5 + random.nextDouble() * 3).invert(random.nextBoolean());
    }

    private Wheel holonomicWheel(int i) {
        WheeledChassis.HolonomicModeler wheel = WheeledChassis.modelHolonomicWheel(motors[i],
                30 + random.nextDouble() * 60).gearRatio(0.5 + random.nextDouble() * 3).invert(random.nextBoolean());
        double angle = i * 120 + random.nextDouble() * 30;
        return random.nextBoolean() ? wheel.polarPosition(angle, 50 + random.nextDouble() * 100)
                : wheel.cartesianPosition(40 + random.nextDouble() * 60, random.nextDouble() * 99, angle);
    }

    private void limits() {
        note("forward", chassis.getForward());
        note("reverse", chassis.getReverse());
        seen.note("greatest speed", chassis.getMaxLinearSpeed()).note("greatest turn", chassis.getMaxAngularSpeed());
        seen.note("speed", chassis.getLinearSpeed()).note("turn", chassis.getAngularSpeed());
        seen.note("acceleration", chassis.getLinearAcceleration()).note("turning", chassis.getAngularAcceleration());
        seen.note("radius", chassis.getMinRadius());
        for (FakeMotor motor : motors) {
            motor.setRotationSpeed(random.nextInt(600) - 300);
        }
        note("current", chassis.getCurrentSpeed());
    }

    private void moves() {
        chassis.setSpeed(5 + random.nextDouble() * 200, 5 + random.nextDouble() * 200);
        chassis.setAcceleration(5 + random.nextDouble() * 900, 5 + random.nextDouble() * 900);
        chassis.travel(random.nextDouble() * LARGE - LARGE / 2);
        note("travel");
        chassis.rotate(random.nextDouble() * LARGE - LARGE / 2);
        note("rotate");
        chassis.arc(0, random.nextDouble() * LARGE - LARGE / 2);
        note("arc on the spot");
        double radius = random.nextDouble() * LARGE - LARGE / 2;
        alikeFor(radius);
        chassis.arc(radius, random.nextDouble() * LARGE - LARGE / 2);
        note("arc");
        chassis.arc(radius, 0);
        note("no arc");
    }

    /**
     * Makes the speeds and accelerations such that the published rule, which looks at the radius only, is the intended
     * one.
     */
    private void alikeFor(double radius) {
        double distancePerDegree = Math.toRadians(Math.abs(radius));
        double linear = 50 + random.nextDouble() * 100;
        double share = distancePerDegree > 1 ? 1.1 + random.nextDouble() : 0.9 - random.nextDouble() / 2;
        double angular = linear * share / distancePerDegree;
        chassis.setSpeed(linear, angular);
        chassis.setAcceleration(linear * 4, angular * 4);
    }

    private void velocities() {
        chassis.setSpeed(100, 100);
        chassis.setAcceleration(300, 400);
        chassis.setVelocity(400 + random.nextDouble() * 200, random.nextDouble() * 90);
        note("velocity");
        chassis.setVelocity(400 + random.nextDouble() * 200, holonomic ? random.nextInt(360) : 180,
                random.nextDouble() * 50);
        note("velocity in a direction");
    }

    private void displacement() {
        chassis.moveStart();
        double distance = 20 + random.nextDouble() * LARGE / 5;
        double angle = random.nextInt(4) == 0 ? 0 : 3 + random.nextDouble() * 300;
        Matrix turned = chassis.getForward().times(new Matrix(new double[] {distance, 0, angle}, 3));
        for (int i = 0; i < motors.length; i++) {
            motors[i].setTacho(motors[i].getTachoCount() + (int) turned.get(i, 0));
        }
        Move move = chassis.getDisplacement(new Move(0, 0, false));
        seen.note("distance", move.getDistanceTraveled()).note("angle", move.getAngleTurned());
        seen.note("kind", move.getMoveType().ordinal()).note("moving", move.isMoving());
    }

    private void note(String label) {
        for (int i = 0; i < motors.length; i++) {
            String[] command = motors[i].lastCommand().split("[, ]+");
            seen.note(label + " acceleration " + i, hardlyChanges(motors[i], command) ? 0 : number(command[0]));
            seen.note(label + " speed " + i, number(command[1]));
            seen.note(label + " motion " + i, command[2].hashCode());
            seen.note(label + " angle " + i, command.length > 3 ? number(command[3]) : 0);
        }
    }

    /**
     * A motor that has its speed already is told to accelerate by 0 by the published class, which stops it for ever.
     */
    private static boolean hardlyChanges(FakeMotor motor, String[] command) {
        int speed = Integer.parseInt(command[1]) * (command[2].equals("backward") ? -1 : 1);
        return !command[2].equals("rotate") && Math.abs(speed - motor.getRotationSpeed()) < 20;
    }

    /** Poses of wheels are single precision: there, a whole number may be off by one, which is made to count little. */
    private double number(String digits) {
        return Integer.parseInt(digits) * (holonomic ? 1e-4 : 1);
    }

    private void note(String label, Matrix matrix) {
        double[] values = matrix.getRowPackedCopy();
        for (int i = 0; i < values.length; i++) {
            seen.note(label + " " + i, values[i]);
        }
    }
}
