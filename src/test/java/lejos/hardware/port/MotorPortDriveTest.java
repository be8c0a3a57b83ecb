package lejos.hardware.port;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import lejos.hardware.AttachedBrick;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class MotorPortDriveTest {
    @RegisterExtension
    final AttachedBrick brick = new AttachedBrick();

    @ParameterizedTest
    @CsvSource({"50,1,drive 50", "50,2,drive -50", "-30,1,drive -30", "-30,2,drive 30", "0,1,drive 0",
        "100,-1,drive 100", "100,0,drive 100", "200,1,drive -56", "200,2,drive 56", "-128,2,drive -128", "50,3,brake",
                "-50,3,brake",
        "50,4,coast", "50,5,brake"})
    void powerAndModeBecomeADuty(int power, int mode, String command) {
        MotorPort.A.open(BasicMotorPort.class).controlMotor(power, mode);
        assertEquals(List.of(command), brick.motor(0).log());
    }

    @Test
    void theCounterIsTheHardwaresOwn() {
        TachoMotorPort port = MotorPort.A.open(TachoMotorPort.class);
        brick.motor(0).turnByHand(-77);
        assertEquals(-77, port.getTachoCount());
        port.resetTachoCount();
        assertEquals(0, brick.motor(0).tachoDegrees());
    }

    @Test
    void theCounterSurvivesClosingThePort() {
        MotorPort.A.open(TachoMotorPort.class).close();
        brick.motor(0).turnByHand(10);
        assertEquals(10, MotorPort.A.open(TachoMotorPort.class).getTachoCount());
    }

    @Test
    void anOpenPortHasOneRegulator() {
        TachoMotorPort port = MotorPort.A.open(TachoMotorPort.class);
        assertSame(port.getRegulator(), port.getRegulator());
    }

    @Test
    void aClosedPortCannotBeUsed() {
        TachoMotorPort port = MotorPort.A.open(TachoMotorPort.class);
        port.close();
        assertThrows(IndexOutOfBoundsException.class, port::getTachoCount);
    }

    @Test
    void anOutputTellsThatAMotorIsPluggedIn() {
        ConfigurationPort port = MotorPort.B.open(ConfigurationPort.class);
        assertEquals(125, port.getPortType());
        assertEquals(7, port.getDeviceType());
    }
}
