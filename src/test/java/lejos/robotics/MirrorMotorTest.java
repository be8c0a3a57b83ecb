package lejos.robotics;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class MirrorMotorTest {
    private final MotorLog log = new MotorLog(Map.of("getTachoCount", 30, "getLimitAngle", 90, "getRotationSpeed", 45,
            "getSpeed", 360, "getMaxSpeed", 800f, "getPower", 70));
    private final RegulatedMotor motor = log.as(RegulatedMotor.class);

    @Test
    void directionsAreExchanged() {
        RegulatedMotor mirror = MirrorMotor.invertMotor(motor);
        log.calls().clear();
        mirror.forward();
        mirror.backward();
        mirror.rotate(10);
        mirror.rotate(-20, true);
        mirror.rotateTo(30);
        mirror.rotateTo(40, false);
        assertThat(log.calls()).containsExactly(
                "backward[]", "forward[]", "rotate[-10]", "rotate[20, true]", "rotateTo[-30]", "rotateTo[-40, false]");
    }

    @Test
    void readingsAreNegated() {
        RegulatedMotor mirror = MirrorMotor.invertMotor(motor);
        assertThat(mirror.getTachoCount()).isEqualTo(-30);
        assertThat(mirror.getLimitAngle()).isEqualTo(-90);
        assertThat(mirror.getRotationSpeed()).isEqualTo(-45);
    }

    @Test
    void settingsPassUnchanged() {
        RegulatedMotor mirror = MirrorMotor.invertMotor(motor);
        log.calls().clear();
        mirror.setSpeed(100);
        mirror.setAcceleration(200);
        mirror.setStallThreshold(5, 6);
        mirror.stop(true);
        mirror.flt(false);
        assertThat(log.calls()).containsExactly(
                "setSpeed[100]", "setAcceleration[200]", "setStallThreshold[5, 6]", "stop[true]", "flt[false]");
        assertThat(mirror.getSpeed()).isEqualTo(360);
        assertThat(mirror.getMaxSpeed()).isEqualTo(800);
    }

    @Test
    void invertingTwiceGivesTheOriginalBack() {
        assertThat(MirrorMotor.invertMotor(MirrorMotor.invertMotor(motor)) == motor).isTrue();
        EncoderMotor encoderMotor = log.as(EncoderMotor.class);
        assertThat(MirrorMotor.invertMotor(MirrorMotor.invertMotor(encoderMotor)) == encoderMotor).isTrue();
    }

    @Test
    void listenerHearsOfTheMirror() {
        RegulatedMotor mirror = MirrorMotor.invertMotor(motor);
        List<String> heard = new ArrayList<>();
        RegulatedMotorListener listener = new RegulatedMotorListener() {
            @Override
            public void rotationStarted(RegulatedMotor source, int tachoCount, boolean stalled, long timeStamp) {
                heard.add((source == mirror) + " started " + tachoCount);
            }

            @Override
            public void rotationStopped(RegulatedMotor source, int tachoCount, boolean stalled, long timeStamp) {
                heard.add((source == mirror) + " stopped " + tachoCount + " " + stalled + " " + timeStamp);
            }
        };
        mirror.addListener(listener);
        ((RegulatedMotorListener) mirror).rotationStarted(motor, 5, false, 1);
        ((RegulatedMotorListener) mirror).rotationStopped(motor, 7, true, 2);
        assertThat(heard).containsExactly("true started -5", "true stopped -7 true 2");
        assertThat(mirror.removeListener()).isSameAs(listener);
    }

    @Test
    void mirrorsAreSynchronisedByTheirOriginals() {
        RegulatedMotor[] given = new RegulatedMotor[1];
        RegulatedMotor master = (RegulatedMotor) Proxy.newProxyInstance(getClass().getClassLoader(),
                new Class<?>[] {RegulatedMotor.class}, (self, method, arguments) -> {
                    if (method.getName().equals("synchronizeWith")) {
                        given[0] = ((RegulatedMotor[]) arguments[0])[0];
                    }
                    return null;
                });
        MirrorMotor.invertMotor(master).synchronizeWith(new RegulatedMotor[] {MirrorMotor.invertMotor(motor)});
        assertThat(given[0] == motor).isTrue();
    }

    @Test
    void reversedEncoderMotorKeepsItsPower() {
        EncoderMotor reversed = MirrorMotor.invertMotor(log.as(EncoderMotor.class));
        reversed.setPower(-40);
        reversed.forward();
        reversed.backward();
        assertThat(log.calls()).containsExactly("setPower[-40]", "backward[]", "forward[]");
        assertThat(reversed.getTachoCount()).isEqualTo(-30);
        assertThat(reversed.getPower()).isEqualTo(70);
    }
}
