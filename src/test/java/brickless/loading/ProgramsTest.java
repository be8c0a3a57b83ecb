package brickless.loading;

import brickless.kernel.KernelSettings;
import org.junit.jupiter.api.Test;
class ProgramsTest {
    @Test void x() {
        ProgramRun r = ProgramRun.of("programs.passing.threads.PingPong", KernelSettings.defaults(), "");
        System.out.println(r);
        System.out.println(ProgramRun.of("programs.passing.threads.PingPong", KernelSettings.defaults(), ""));
    }
}
