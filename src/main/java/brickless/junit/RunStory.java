package brickless.junit;

import brickless.simulation.Run;
import brickless.simulation.RunReport;
import java.util.Optional;

/** Tells what a run was and how to see it again. */
final class RunStory {
    private RunStory() {}

    /**
     * The story; empty for a run that never went on.
     *
     * @param open whether the program was still running when the test ended
     */
    static Optional<String> of(Run run, boolean open) {
        if (run.time().isZero()) {
            return Optional.empty();
        }
        RunReport report = run.report();
        String outcome = open ? "still running" : report.outcome().kind() + report.outcome().exitStatus()
                .map(s -> " with status " + s).orElse("");
        StringBuilder story = new StringBuilder("simulation of " + report.main() + " in " + report.world() + " with "
                + report.robot());
        story.append("\n  outcome  ").append(outcome).append(" after ").append(Seconds.text(run.time()))
                .append(" simulated seconds, seed ")
                .append(report.seed());
        report.outcome().error().ifPresent(error -> story.append("\n  error    ")
                .append(error.replace("\n", "\n           ")));
        if (!report.files().isEmpty()) {
            story.append("\n  trace    ").append(report.files()).append("\n  replay   brickless replay ")
                    .append(quoted(report.files()));
        }
        return Optional.of(story.toString());
    }

    private static String quoted(String path) {
        return path.contains(" ") ? "'" + path + "'" : path;
    }
}
