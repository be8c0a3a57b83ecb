package brickless.simulation;

import brickless.trace.Decimals;
import brickless.trace.JsonText;
import brickless.world.Pose2;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * The figures of a finished run.
 *
 * @param program program as the user named it
 * @param main main class
 * @param world name of the world
 * @param robot name of the robot's model
 * @param seed seed
 * @param outcome how it ended
 * @param goal what was to be reached
 * @param wallSeconds time it took on this machine
 * @param distanceMetres way driven by the (first) robot
 * @param collisions contacts of the robot with obstacles or other robots that began
 * @param zones zones entered, in order of first entry
 * @param finalPose pose at the end
 * @param traceHash SHA-256 of the canonical trace
 * @param contextSwitches switches between program threads
 * @param physicsSteps physics steps done
 * @param backend back-end used
 * @param jdk version of the JDK used
 * @param notes lines for the user about what was done for them: fitted robot, keys pressed
 * @param files folder with the files of the run, empty if none
 */
public record RunReport(String program, String main, String world, String robot, long seed, Outcome outcome,
        Optional<Goal> goal, double wallSeconds, double distanceMetres, int collisions, List<String> zones,
        Pose2 finalPose, String traceHash, long contextSwitches, long physicsSteps, String backend, String jdk,
        List<String> notes, String files) {
    public RunReport {
        zones = List.copyOf(zones);
        notes = List.copyOf(notes);
    }

    /** Whether a goal was asked for and not reached. */
    public boolean goalMissed() {
        return goal.isPresent() && !goal.get().reachedBy(outcome);
    }

    /** Simulated seconds. */
    public double simulatedSeconds() {
        return outcome.timeNanos() / 1e9;
    }

    /** Simulated time over wall time. */
    public double realTimeFactor() {
        return simulatedSeconds() / Math.max(1e-9, wallSeconds);
    }

    /** Exit status of the command line: 0 success, 1 failure of the program or a missed goal. */
    public int exitStatus() {
        return outcome.successful() && !goalMissed() ? 0 : 1;
    }

    /** The JSON object of {@code --json}. */
    public String json() {
        return json(true);
    }

    /** The JSON object of a sweep: nothing that depends on the machine, its load or its JDK. */
    public String portableJson() {
        return json(false);
    }

    private String json(boolean withHost) {
        return JsonText.object(line -> {
            line.text("program", program).text("main", main).text("world", world).text("robot", robot)
                    .integer("seed", seed);
            line.text("outcome", outcome.kind());
            if (outcome.exitStatus().isPresent()) {
                line.integer("exitStatus", outcome.exitStatus().get());
            } else {
                line.nothing("exitStatus");
            }
            goal.ifPresent(wanted -> line.text("goal", wanted.text()));
            if (!withHost || goal.isPresent()) {
                line.flag("passed", exitStatus() == 0);
            }
            line.seconds("simulatedSeconds", outcome.timeNanos());
            if (withHost) {
                line.number("wallSeconds", wallSeconds, 3).number("realTimeFactor", realTimeFactor(), 1);
            }
            line.number("distanceMetres", distanceMetres, 4).integer("collisions", collisions).texts("zones", zones);
            line.object("finalPose", () -> line.number("xMetres", finalPose.x(), 5).number("yMetres", finalPose.y(), 5)
                    .number("headingDegrees", headingDegrees(), 3));
            line.text("traceHash", traceHash).integer("contextSwitches", contextSwitches)
                    .integer("physicsSteps", physicsSteps);
            if (withHost) {
                line.text("backend", backend).text("jdk", jdk);
            }
            if (outcome.error().isPresent()) {
                line.text("error", outcome.error().get());
            } else {
                line.nothing("error");
            }
        });
    }

    private double headingDegrees() {
        double degrees = StrictMath.toDegrees(finalPose.headingRadians()) % 360;
        return degrees > 180 ? degrees - 360 : degrees <= -180 ? degrees + 360 : degrees;
    }

    /** The summary for people. */
    public String text() {
        StringBuilder text = new StringBuilder();
        text.append(String.format(Locale.ROOT, "%s in %s with %s, seed %d%n", main, world, robot, seed));
        notes.forEach(note -> text.append("  ").append(note).append(System.lineSeparator()));
        text.append(String.format(Locale.ROOT, "  outcome    %s%s%s after %s simulated seconds%n", outcome.kind(),
                outcome.exitStatus().map(status -> " with status " + status).orElse(""),
                goalMissed() ? " (goal not reached)" : "", Decimals.text(simulatedSeconds(), 3)));
        text.append(String.format(Locale.ROOT,
                "  robot      drove %.2f m, %d collisions, ends at %.0f mm, %.0f mm, heading %.0f degrees%n",
                distanceMetres, collisions, finalPose.x() * 1000, finalPose.y() * 1000, headingDegrees()));
        if (!zones.isEmpty()) {
            text.append("  zones      ").append(String.join(", ", zones)).append(System.lineSeparator());
        }
        text.append(String.format(Locale.ROOT, "  speed      %.2f s of wall time, %.0f times real time (JDK %s, %s)%n",
                wallSeconds, realTimeFactor(), jdk, backend));
        text.append("  trace      ").append(traceHash);
        if (!files.isEmpty()) {
            text.append(System.lineSeparator()).append("  files      ").append(files);
        }
        return text.toString();
    }
}
