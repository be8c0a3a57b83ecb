package brickless.cli;

import java.io.Console;
import java.io.PrintStream;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.util.Locale;

/** Tells how far a sweep is: a bar that is redrawn on a terminal, else a line every tenth of the way. */
final class SweepProgress {
    private static final int BAR = 30;

    private final PrintStream err;
    private final int total;
    private final int before;
    private final boolean terminal;
    private final long started = System.nanoTime();
    private int told;

    SweepProgress(PrintStream err, int total, int before, int failed) {
        this.err = err;
        this.total = total;
        this.before = before;
        terminal = err == System.err && onTerminal();
        told = before * 10 / total;
        if (before > 0) {
            err.println(before + " of " + total + " runs are there already" + failures(failed));
        }
    }

    void done(int count, int failed) {
        if (terminal) {
            int full = (int) ((long) count * BAR / total);
            err.print("\r[" + "#".repeat(full) + ".".repeat(BAR - full) + "] " + count + "/" + total + failures(failed)
                    + rate(count) + " \033[K");
            err.flush();
        } else if (count * 10L / total > told) {
            told = (int) (count * 10L / total);
            err.println(count + " of " + total + " runs" + failures(failed) + rate(count));
        }
    }

    void end() {
        if (terminal) {
            err.println();
        }
    }

    private static String failures(int failed) {
        return failed == 0 ? "" : ", " + failed + " failed";
    }

    private String rate(int count) {
        double seconds = Math.max(1e-3, (System.nanoTime() - started) / 1e9);
        double perSecond = (count - before) / seconds;
        return perSecond <= 0 ? "" : String.format(Locale.ROOT, ", %.1f a second, %.0f s to go", perSecond,
                (total - count) / perSecond);
    }

    /** From Java 22 on there is a console even when it is no terminal, and a method that tells. */
    private static boolean onTerminal() {
        Console console = System.console();
        if (console == null || "dumb".equals(System.getenv("TERM"))) {
            return false;
        }
        try {
            return (boolean) MethodHandles.publicLookup()
                    .findVirtual(Console.class, "isTerminal", MethodType.methodType(boolean.class)).invoke(console);
        } catch (NoSuchMethodException e) {
            return true;
        } catch (Throwable e) {
            throw new IllegalStateException("cannot ask the console", e);
        }
    }
}
