package lejos.robotics.subsumption;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.hardware.BrickAccess;
import brickless.hardware.BrickHardware;
import brickless.hardware.ProgramLog;
import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What the brick's log hears of an arbitrator. */
@Timeout(value = 10, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class ArbitrationReportTest {
    private final List<String> heard = new ArrayList<>();

    @BeforeEach
    void attachBrickThatOnlyListens() {
        ProgramLog log = proxy(ProgramLog.class, (name, arguments) -> {
            boolean creation = name.equals("arbitratorCreated");
            heard.add(name + (creation ? Arrays.toString((String[]) arguments[0]) : Arrays.toString(arguments)));
            return creation ? 7 : null;
        });
        BrickAccess.attach(proxy(BrickHardware.class, (name, arguments) -> name.equals("log") ? log : null));
    }

    @AfterEach
    void detachBrick() {
        BrickAccess.attach(null);
    }

    @Test
    void onlyChangesAreReported() {
        Recorded low = new Recorded();
        Recorded high = new Recorded();
        low.wants = true;
        Arbitrator arbitrator = new Arbitrator(new Behavior[] {low, high});
        low.act = () -> {
            high.awaitAskedAgain(3);
            high.wants = true;
            low.awaitSuppressed(3);
        };
        high.act = arbitrator::stop;
        arbitrator.go();
        String name = Recorded.class.getName();
        assertThat(heard).containsExactly(
                "arbitratorCreated[" + name + ", " + name + "]",
                "behaviourWanted[7, 0]", "behaviourActive[7, 0]",
                "behaviourWanted[7, -1]", "behaviourWanted[7, 1]", "behaviourSuppressed[7, 0]",
                "behaviourActive[7, -1]", "behaviourActive[7, 1]", "behaviourActive[7, -1]");
    }

    private interface Answer {
        Object to(String name, Object[] arguments);
    }

    private static <T> T proxy(Class<T> type, Answer answer) {
        return type.cast(Proxy.newProxyInstance(type.getClassLoader(), new Class<?>[] {type},
                (self, method, arguments) -> answer.to(method.getName(), arguments)));
    }
}
