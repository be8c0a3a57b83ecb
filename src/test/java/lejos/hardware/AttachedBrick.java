package lejos.hardware;

import brickless.hardware.BrickAccess;
import brickless.hardware.fake.FakeBrick;
import brickless.hardware.fake.FakeMotor;
import brickless.hardware.fake.FakeSensor;
import lejos.internal.ev3.EV3IOPort;
import org.junit.jupiter.api.extension.AfterEachCallback;
import org.junit.jupiter.api.extension.BeforeEachCallback;
import org.junit.jupiter.api.extension.ExtensionContext;

/** A fresh fake brick for every test; ports that the test leaves open are closed after it. */
public final class AttachedBrick implements BeforeEachCallback, AfterEachCallback {
    private FakeBrick brick;

    @Override
    public void beforeEach(ExtensionContext context) {
        brick = new FakeBrick();
        BrickAccess.attach(brick);
    }

    @Override
    public void afterEach(ExtensionContext context) {
        EV3IOPort.closeAll();
        BrickAccess.attach(null);
    }

    /** The brick itself. */
    public FakeBrick get() {
        return brick;
    }

    /** Motor socket 0 to 3. */
    public FakeMotor motor(int index) {
        return brick.motor(index);
    }

    /** Input socket 0 to 3. */
    public FakeSensor sensor(int index) {
        return brick.sensor(index);
    }

    /** Lets time pass. */
    public void advance(int millis) {
        brick.advance(millis);
    }
}
