package lejos.robotics.chassis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import lejos.Agreement;
import lejos.robotics.FakeMotor;
import lejos.robotics.localization.PoseProvider;
import lejos.robotics.navigation.Move;
import lejos.robotics.navigation.Pose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Two wheels of 56 mm, 120 mm apart, in millimetres; the motors' highest speed is 900 degrees per second. */
class WheeledChassisTest {
    private final FakeMotor left = new FakeMotor();
    private final FakeMotor right = new FakeMotor();
    private final WheeledChassis chassis = differential(60, -60);

    private WheeledChassis differential(double leftOffset, double rightOffset) {
        return new WheeledChassis(new Wheel[] {WheeledChassis.modelWheel(left, 56).offset(leftOffset),
            WheeledChassis.modelWheel(right, 56).offset(rightOffset)}, WheeledChassis.TYPE_DIFFERENTIAL);
    }

    @Test
    void chassisOfAllKindsAnswerAsThePublishedOnes() {
        Agreement.check(ChassisDriver.class, 3000, 1e-3, ChassisDriver::play);
    }

    @Test
    void limitsFollowFromWheelsAndMotors() {
        assertThat(chassis.getMaxLinearSpeed()).isCloseTo(439.82, within(0.01));
        assertThat(chassis.getMaxAngularSpeed()).isCloseTo(420, within(1e-9));
        assertThat(chassis.getLinearSpeed()).isCloseTo(219.91, within(0.01));
        assertThat(chassis.getAngularAcceleration()).isCloseTo(210, within(1e-9));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "100 | 450, 450, rotate 204 | 450, 450, rotate 204",
        "-100 | 450, 450, rotate -204 | 450, 450, rotate -204",
        "Infinity | 900, 450, forward | 900, 450, forward",
        "-Infinity | 900, 450, backward | 900, 450, backward"})
    void travelTurnsBothWheelsAlike(double distance, String leftCommand, String rightCommand) {
        chassis.travel(distance);
        assertCommands(leftCommand, rightCommand);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "0 | 90 | 450, 450, rotate -192 | 450, 450, rotate 192",
        "200 | 90 | 315, 315, rotate 450 | 585, 585, rotate 835",
        "-200 | 90 | 585, 585, rotate 835 | 315, 315, rotate 450",
        "200 | -90 | 315, 315, rotate -450 | 585, 585, rotate -835",
        "20 | 90 | 300, 300, rotate -128 | 600, 600, rotate 257",
        "200 | 0 | nothing | nothing"})
    void signOfTheAngleIsTheDirectionOfAnArc(double radius, double angle, String leftCommand, String rightCommand) {
        chassis.arc(radius, angle);
        assertCommands(leftCommand, rightCommand);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "200 | Infinity | forward 315 | forward 585",
        "-200 | Infinity | forward 585 | forward 315",
        "200 | -Infinity | backward 315 | backward 585",
        "-200 | -Infinity | backward 585 | backward 315",
        "0 | Infinity | backward 450 | forward 450",
        "0 | -Infinity | forward 450 | backward 450",
        "Infinity | 90 | forward 450 | forward 450",
        "-Infinity | -90 | backward 450 | backward 450"})
    void arcWithoutEndGoesWhereTheSameArcWithAnEndGoes(double radius, double angle, String leftMotion,
            String rightMotion) {
        chassis.arc(radius, angle);
        assertThat(motion(left)).isEqualTo(leftMotion);
        assertThat(motion(right)).isEqualTo(rightMotion);
    }

    private static String motion(FakeMotor motor) {
        String[] command = motor.lastCommand().split(", ");
        return command[2] + " " + command[1];
    }

    @Test
    void leftWheelWithANegativeOffsetTurnsTheRobotClockwise() {
        differential(-60, 60).rotate(90);
        assertCommands("450, 450, rotate 192", "450, 450, rotate -192");
    }

    @Test
    void linearSpeedLimitsAnArcOfAnyRadius() {
        WheeledChassis inCentimetres = new WheeledChassis(new Wheel[] {WheeledChassis.modelWheel(left, 5.6).offset(6),
            WheeledChassis.modelWheel(right, 5.6).offset(-6)}, WheeledChassis.TYPE_DIFFERENTIAL);
        inCentimetres.setSpeed(10, 336);
        inCentimetres.arc(20, 90);
        assertThat(left.getSpeed()).as("7 cm/s = 143 degrees/s inside").isEqualTo(143);
        assertThat(right.getSpeed()).as("13 cm/s = 266 degrees/s outside").isEqualTo(266);
    }

    @Test
    void wheelsReachTheirSpeedsTogether() {
        chassis.setVelocity(100, 30);
        assertCommands("469, 140, forward", "900, 268, forward");
    }

    @Test
    void stopIsCommandedEvenBeforeTheWheelsTurn() {
        chassis.setVelocity(100, 0);
        chassis.stop();
        assertThat(left.lastCommand()).endsWith("stop");
        assertThat(right.lastCommand()).endsWith("stop");
    }

    @Test
    void sidewaysIsRefusedByOrdinaryWheels() {
        assertThatThrownBy(() -> chassis.setVelocity(10, 90, 0)).isInstanceOf(RuntimeException.class);
        chassis.travelCartesian(-100, 0, 0);
        assertThat(left.lastCommand()).endsWith("backward");
    }

    @Test
    void backwardIsANegativeDistance() {
        chassis.moveStart();
        left.setTacho(-205);
        right.setTacho(-205);
        Move move = chassis.getDisplacement(new Move(0, 0, false));
        assertThat(move.getMoveType()).isEqualTo(Move.MoveType.TRAVEL);
        assertThat(move.getDistanceTraveled()).isCloseTo(-100.18f, within(0.01f));
    }

    @Test
    void shortArcInMetresIsAnArc() {
        WheeledChassis inMetres = new WheeledChassis(new Wheel[] {WheeledChassis.modelWheel(left, 0.056).offset(0.06),
            WheeledChassis.modelWheel(right, 0.056).offset(-0.06)}, WheeledChassis.TYPE_DIFFERENTIAL);
        inMetres.moveStart();
        left.setTacho(100);
        right.setTacho(200);
        assertThat(inMetres.getDisplacement(new Move(0, 0, false)).getMoveType()).isEqualTo(Move.MoveType.ARC);
        inMetres.moveStart();
        left.setTacho(0);
        right.setTacho(301);
        assertThat(inMetres.getDisplacement(new Move(0, 0, false)).getMoveType()).as("half a degree of way")
                .isEqualTo(Move.MoveType.ROTATE);
    }

    @Test
    void nothingDoneIsAStop() {
        chassis.moveStart();
        assertThat(chassis.getDisplacement(new Move(1, 1, true)).getMoveType()).isEqualTo(Move.MoveType.STOP);
    }

    @Test
    void fourWheelsAllCount() {
        FakeMotor rearLeft = new FakeMotor();
        FakeMotor rearRight = new FakeMotor();
        WheeledChassis four = new WheeledChassis(new Wheel[] {WheeledChassis.modelWheel(left, 56).offset(60),
            WheeledChassis.modelWheel(right, 56).offset(-60), WheeledChassis.modelWheel(rearLeft, 56).offset(60),
            WheeledChassis.modelWheel(rearRight, 56).offset(-60)}, WheeledChassis.TYPE_DIFFERENTIAL);
        assertThat(four.getMaxLinearSpeed()).isCloseTo(439.82, within(0.01));
        four.moveStart();
        left.setTacho(200);
        right.setTacho(200);
        rearLeft.setTacho(220);
        rearRight.setTacho(220);
        assertThat(four.getDisplacement(new Move(0, 0, false)).getDistanceTraveled()).as("210 degrees in the mean")
                .isCloseTo(102.63f, within(0.01f));
    }

    @Test
    void holonomicWheelsDriveSideways() {
        FakeMotor third = new FakeMotor();
        WheeledChassis star = new WheeledChassis(new Wheel[] {star(left, 0), star(right, 120), star(third, 240)},
                WheeledChassis.TYPE_HOLONOMIC);
        assertThat(star.getMaxAngularSpeed()).isCloseTo(320, within(1e-6));
        star.travelCartesian(0, 100, 0);
        assertThat(motion(left)).isEqualTo("forward 119");
        assertThat(motion(right)).isEqualTo("backward 59");
        assertThat(motion(third)).isEqualTo("backward 59");
    }

    private static Wheel star(FakeMotor motor, double angle) {
        return WheeledChassis.modelHolonomicWheel(motor, 48).polarPosition(angle, 135).gearRatio(2);
    }

    @Test
    void badSetupsAndSpeedsAreRefused() {
        Wheel wheel = WheeledChassis.modelWheel(left, 56);
        assertThatThrownBy(() -> new WheeledChassis(new Wheel[] {wheel}, 2))
                .isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> differential(60, 60)).isInstanceOf(RuntimeException.class);
        assertThatThrownBy(() -> chassis.setSpeed(0, 1)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> chassis.setAcceleration(1, -1)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void poseFollowsTheWheelsUpToTheMoment() {
        PoseProvider odometer = chassis.getPoseProvider();
        assertThat(chassis.getPoseProvider()).isSameAs(odometer);
        quarterTurnOf(100);
        Pose pose = odometer.getPose();
        assertThat(pose.getX()).isCloseTo(100, within(0.5f));
        assertThat(pose.getY()).isCloseTo(100, within(0.5f));
        assertThat(pose.getHeading()).isCloseTo(90, within(0.5f));
        odometer.setPose(new Pose(5, 6, 180));
        left.setTacho(left.getTachoCount() - 205);
        right.setTacho(right.getTachoCount() - 205);
        assertThat(odometer.getPose().getX()).as("backward, looking back").isCloseTo(105.2f, within(0.1f));
    }

    private void quarterTurnOf(double radius) {
        for (int degrees = 1; degrees <= 90; degrees++) {
            left.setTacho((int) Math.round(Math.toRadians(degrees) * (radius - 60) * 360 / (Math.PI * 56)));
            right.setTacho((int) Math.round(Math.toRadians(degrees) * (radius + 60) * 360 / (Math.PI * 56)));
            chassis.getPoseProvider().getPose();
        }
    }

    private void assertCommands(String leftCommand, String rightCommand) {
        assertThat(left.lastCommand()).isEqualTo(leftCommand);
        assertThat(right.lastCommand()).isEqualTo(rightCommand);
    }
}
