package brickless.world.svg;

import static brickless.world.svg.Drawings.robot;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import brickless.world.DescriptionException;
import brickless.world.MotorType;
import brickless.world.Point2;
import brickless.world.RobotModel;
import brickless.world.RobotModel.Caster;
import brickless.world.RobotModel.Claw;
import brickless.world.RobotModel.SensorMount;
import brickless.world.RobotModel.Turret;
import brickless.world.RobotModel.Wheel;
import brickless.world.SensorType;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class RobotReaderTest {
    private static SensorMount sensor(String body) {
        return robot(body).sensors().get(0);
    }

    @Test
    void chassisCollidesAndWeighsWhatItSays() throws DescriptionException {
        RobotModel robot = SvgRobotReader.readText("my/bot.svg",
                "<svg><g data-part='chassis' data-mass-kg='0.9'><rect width='100' height='50'/>"
                + "<rect x='100' width='20' height='50'/><path d='M0,0h50' stroke='red' fill='none'/><circle r='5' "
                        + "data-solid='none'/></g>"
                + "<circle r='300'/></svg>");
        assertThat(robot.name()).isEqualTo("bot");
        assertThat(robot.massKilograms()).isEqualTo(0.9);
        assertThat(robot.chassis().stream().map(Drawings::text))
                .containsExactly("0,0 100,0 100,50 0,50", "100,0 120,0 120,50 100,50");
    }

    @Test
    void massesOfTwoChassisPartsAddUp() throws DescriptionException {
        RobotModel robot = SvgRobotReader.readText("b",
                "<svg><rect data-part='chassis' data-mass-kg='0.5' width='9' height='9'/>"
                + "<rect data-part='chassis' data-mass-kg='0.25' x='20' width='9' height='9'/></svg>");
        assertThat(robot.massKilograms()).isEqualTo(0.75);
    }

    @Test
    void robotWithoutWheelsIsAllowedAndWeighsThreeQuartersOfAKilogram() {
        RobotModel robot = robot("");
        assertThat(robot.wheels()).isEmpty();
        assertThat(robot.massKilograms()).isEqualTo(0.75);
    }

    @Test
    void wheelWithEverythingStated() {
        Wheel wheel = robot("<rect id='w' data-part='wheel' data-port='D' data-motor='nxt' data-diameter-mm='43.2' "
                + "data-gear-ratio='3' data-inverted='true'"
                + " data-omni='true' x='-20' y='50' width='40' height='20' transform='rotate(90)'/>").wheels().get(0);
        assertThat(wheel).isEqualTo(new Wheel("w", 3, MotorType.NXT, 0.0432, 3, true, new Point2(-0.06, 0), Math.PI / 2,
                true));
    }

    @Test
    void backlashIsAnAngleOfTheWheelOrTurret() {
        assertThat(robot("<rect data-part='wheel' data-port='A' data-backlash-degrees='5' width='9' height='9'/>")
                .wheels().get(0).backlashRadians()).isCloseTo(Math.toRadians(5), within(1e-12));
        assertThat(robot("<g data-part='turret' data-port='A' data-backlash-degrees='3'><circle r='9'/></g>")
                .turrets().get(0).backlashRadians()).isCloseTo(Math.toRadians(3), within(1e-12));
    }

    @Test
    void wheelWithDefaults() {
        Wheel wheel = robot("<rect data-part='wheel' data-port='A' x='-28' y='46' width='56' height='28'/>").wheels()
                .get(0);
        assertThat(wheel).isEqualTo(new Wheel("rect-line-3", 0, MotorType.LARGE, 0.056, 1, false, new Point2(0, 0.06),
                0, false));
    }

    @Test
    void headingAttributeTurnsAPartWithoutTurningItsDrawing() {
        assertThat(robot("<rect data-part='wheel' data-port='A' data-heading-degrees='-90' width='9' height='9'/>")
                .wheels().get(0).headingRadians())
                .isCloseTo(-Math.PI / 2, within(1e-15));
    }

    @Test
    void caster() {
        assertThat(robot("<circle id='ball' data-part='caster' cx='-80' r='8'/>").casters())
                .containsExactly(new Caster("ball", new Point2(-0.08, 0), 0.05));
        assertThat(robot("<circle data-part='caster' data-friction='0.3' r='8'/>").casters().get(0).dragCoefficient())
                .isEqualTo(0.3);
    }

    @Test
    void distanceSensorLooksFromTheMiddleOfItsFrontEdge() {
        SensorMount eye = sensor("<rect id='us' data-part='sensor' data-port='S4' data-sensor='ev3-ultrasonic' "
                + "x='50' y='-20' width='20' height='40'/>");
        assertThat(eye.port()).isEqualTo(3);
        assertThat(eye.type()).isEqualTo(SensorType.EV3_ULTRASONIC);
        assertThat(eye.position()).isEqualTo(new Point2(0.07, 0));
        assertThat(eye.headingRadians()).isZero();
        assertThat(eye.heightMetres()).isEqualTo(0.06);
        assertThat(Drawings.text(eye.outline())).isEqualTo("50,-20 70,-20 70,20 50,20");
        assertThat(eye.turret()).isEmpty();
    }

    @Test
    void turnedSensorLooksWhereItsXAxisPoints() {
        SensorMount left = sensor("<g transform='translate(10,-50) rotate(-90)' data-part='sensor' data-port='S1' "
                + "data-sensor='ev3-infrared'>"
                + "<rect x='-10' y='-15' width='20' height='30'/><circle cx='6' r='4'/></g>");
        assertThat(left.position()).isEqualTo(new Point2(0.01, -0.06));
        assertThat(left.headingRadians()).isEqualTo(-Math.PI / 2);
    }

    @Test
    void colourSensorLooksDownFromItsMiddle() {
        SensorMount eye = sensor("<circle data-part='sensor' data-port='S3' data-sensor='ev3-color' cx='80' cy='5' "
                + "r='11' transform='rotate(90)'/>");
        assertThat(eye.position()).isEqualTo(new Point2(-0.005, 0.08));
        assertThat(eye.heightMetres()).isEqualTo(0.008);
        assertThat(sensor("<circle data-part='sensor' data-port='S3' data-sensor='ev3-color' data-height-mm='12.5' "
                + "r='11'/>").heightMetres()).isEqualTo(0.0125);
    }

    @Test
    void touchSensorsOutlineIsItsBumper() {
        SensorMount bumper = sensor("<g data-part='sensor' data-port='S1' data-sensor='ev3-touch'><rect x='90' "
                + "y='-5' width='10' height='10'/>"
                + "<rect x='100' y='-60' width='10' height='120'/></g>");
        assertThat(Drawings.text(bumper.outline())).isEqualTo("100,-60 110,-60 110,60 100,60");
        assertThat(bumper.position()).isEqualTo(new Point2(0.11, 0));
    }

    @ParameterizedTest
    @EnumSource(SensorType.class)
    void everySensorKindCanBeNamed(SensorType type) {
        assertThat(sensor("<rect data-part='sensor' data-port='S2' data-sensor='" + type.attribute()
                + "' width='9' height='9'/>").type()).isEqualTo(type);
    }

    @Test
    void turretCarriesSensorsAboutItsOrigin() {
        RobotModel robot = robot("<g id='head' data-part='turret' data-port='A' data-gear-ratio='3' "
                + "data-inverted='true' transform='translate(40,0)'>"
                + "<circle r='20'/><rect data-part='sensor' data-port='S1' data-sensor='ev3-infrared' x='10' y='-10' "
                        + "width='15' height='20'/></g>");
        Turret head = robot.turrets().get(0);
        assertThat(head.port()).isZero();
        assertThat(head.motor()).isEqualTo(MotorType.MEDIUM);
        assertThat(head.gearRatio()).isEqualTo(3);
        assertThat(head.inverted()).isTrue();
        assertThat(head.pivot()).isEqualTo(new Point2(0.04, 0));
        assertThat(head.outlines()).hasSize(1);
        SensorMount eye = robot.sensors().get(0);
        assertThat(eye.turret()).isEqualTo(Optional.of("head"));
        assertThat(eye.position().x()).isCloseTo(0.065, within(1e-12));
    }

    @Test
    void pivotMayBeGiven() {
        Turret head = robot("<g data-part='turret' data-port='A' data-pivot='30, -5'><rect x='20' width='20' "
                + "height='9'/></g>").turrets().get(0);
        assertThat(head.pivot()).isEqualTo(new Point2(0.03, -0.005));
    }

    @Test
    void clawsAndArms() {
        Claw claw = robot("<g id='c' data-part='claw' data-port='A' data-min-degrees='-20' data-max-degrees='70' "
                + "transform='translate(60,0)'>"
                + "<rect width='50' height='6' y='-30'/><rect width='50' height='6' y='24'/></g>").claws().get(0);
        assertThat(claw.minDegrees()).isEqualTo(-20);
        assertThat(claw.maxDegrees()).isEqualTo(70);
        assertThat(claw.pivot()).isEqualTo(new Point2(0.06, 0));
        assertThat(claw.outlines()).hasSize(2);
        Claw arm = robot("<rect data-part='arm' data-port='D' width='50' height='6'/>").claws().get(0);
        assertThat(new double[] {arm.minDegrees(), arm.maxDegrees()}).containsExactly(0, 90);
        assertThat(arm.motor()).isEqualTo(MotorType.MEDIUM);
    }
}
