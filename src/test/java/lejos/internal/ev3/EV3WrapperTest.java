package lejos.internal.ev3;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import brickless.device.panel.PanelBench;
import brickless.device.panel.ScreenText;
import java.io.PrintStream;
import lejos.hardware.Button;
import lejos.hardware.lcd.LCD;
import lejos.realm.OnPanel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

@ExtendWith(OnPanel.class)
class EV3WrapperTest {
    private PanelBench bench;

    /** Not public, like the mains of many programs. */
    static final class Printing {
        private Printing() {}

        static void main(String[] args) {
            System.out.println("args " + args.length);
            System.err.print("oops");
            LCD.drawString("drawn", 0, 5);
        }
    }

    static final class Failing {
        private Failing() {}

        static void main(String[] args) {
            throw new IllegalStateException("broken", new IllegalArgumentException("why"));
        }
    }

    /** Runs with the host's streams and handler put back afterwards. */
    private static void run(Class<?> program) throws Throwable {
        PrintStream out = System.out;
        PrintStream err = System.err;
        Thread.UncaughtExceptionHandler handler = Thread.getDefaultUncaughtExceptionHandler();
        try {
            EV3Wrapper.main(new String[] {program.getName()});
        } finally {
            System.setOut(out);
            System.setErr(err);
            Thread.setDefaultUncaughtExceptionHandler(handler);
        }
    }

    @Test
    void printedTextGoesToTheConsoleAndToItsOwnLayer() throws Throwable {
        run(Printing.class);
        bench.screen.settle();
        assertThat(bench.log.out()).isEqualTo("args 0" + System.lineSeparator());
        assertThat(bench.log.err()).isEqualTo("oops");
        assertThat(bench.screen.asText()).isEqualTo("args 0\noops\n\n\n\ndrawn");
        LCD.clear();
        bench.screen.settle();
        assertThat(bench.screen.asText()).as("LCD.clear does not clear printed text").isEqualTo("args 0\noops");
    }

    @Test
    void exceptionsOfMainComeOutUnwrapped() {
        assertThatThrownBy(() -> run(Failing.class)).isInstanceOf(IllegalStateException.class).hasMessage("broken");
    }

    @Test
    void layersAreMadeInTheOrderTheyAreCycledThrough() throws Throwable {
        run(Printing.class);
        EV3LCDManager.LCDLayer[] layers = EV3LCDManager.getLocalLCDManager().getLayers();
        assertThat(layers).extracting(EV3LCDManager.LCDLayer::getName)
                .containsExactly("LCD", "STDOUT", "EXCEPTION", "SYSTEM");
        assertThat(layers).extracting(EV3LCDManager.LCDLayer::isOpen).containsExactly(true, true, false, false);
    }

    @Test
    void uncaughtExceptionIsReportedBuzzedAndShownUntilTheNextDrawingWhenNobodyIsThere() {
        IllegalStateException failure = new IllegalStateException("broken");
        LCD.drawString("running", 0, 0);
        new EV3Wrapper().uncaughtException(Thread.currentThread(), failure);
        assertThat(bench.log.uncaught()).containsExactly(failure);
        assertThat(bench.events()).contains("tone 100 Hz 500 ms 80 %");
        assertThat(bench.millis()).isBetween(500.0, 600.0);
        assertThat(bench.screen.asSmallText()).startsWith("Uncaught exception");
        LCD.drawString("going on", 0, 1);
        LCD.refresh();
        assertThat(bench.screen.asText()).isEqualTo("running\ngoing on");
    }

    @Test
    void aSecondExceptionReplacesTheFirstOnTheScreen() {
        LCD.drawString("running", 0, 0);
        new EV3Wrapper().uncaughtException(Thread.currentThread(), new IllegalStateException("first"));
        new EV3Wrapper().uncaughtException(Thread.currentThread(), new IllegalStateException("second"));
        assertThat(bench.screen.asSmallText()).contains("second").doesNotContain("first", "running");
        LCD.clear(3);
        LCD.refresh();
        assertThat(bench.screen.asText()).isEqualTo("running");
    }

    @Test
    void exceptionScreenNamesTheFailureAndWaitsForEscapeWhenSomebodyIsThere() {
        bench.keys.setAttended(true);
        StringBuilder seen = new StringBuilder();
        bench.pressAt(1000, Button.ID_RIGHT, 200).pressAt(2000, Button.ID_ESCAPE, 200);
        bench.at(900, () -> seen.append(ScreenText.readSmall(bench.screen.displayed())).append("\n--\n"));
        bench.at(1900, () -> seen.append(ScreenText.readSmall(bench.screen.displayed())));
        IllegalStateException failure = new IllegalStateException("broken", new IllegalArgumentException("why"));
        failure.setStackTrace(new StackTraceElement[] {new StackTraceElement("my.Robot", "drive", "Robot.java", 17)});
        new EV3Wrapper().uncaughtException(Thread.currentThread(), failure);
        assertThat(seen).hasToString("""
                Uncaught exception

                java.lang.IllegalStateExcepti
                broken

                by java.lang.IllegalArgumentE
                why

                Robot.drive:17
                --
                ght exception

                lang.IllegalStateException
                n

                va.lang.IllegalArgumentExcept


                .drive:17""");
        assertThat(bench.millis()).isBetween(2000.0, 2200.0);
        assertThat(bench.screen.asText()).isEmpty();
    }
}
