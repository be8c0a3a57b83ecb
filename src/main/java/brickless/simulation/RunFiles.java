package brickless.simulation;

import brickless.trace.HtmlReport;
import brickless.trace.ReportScene;
import brickless.world.RobotModel;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Writes the files of a finished run that are made at its end, and publishes all of them. */
final class RunFiles {
    private final RunFolder folder;
    private final SimulationSettings settings;
    private final Recorder recorder;
    private final List<RobotSession> sessions;

    RunFiles(RunFolder folder, SimulationSettings settings, Recorder recorder, List<RobotSession> sessions) {
        this.folder = folder;
        this.settings = settings;
        this.recorder = recorder;
        this.sessions = sessions;
    }

    void write(RunReport report) {
        folder.write("summary.json", report.json() + "\n");
        folder.write("world.svg", settings.world().svg());
        Map<String, RobotModel> models = new LinkedHashMap<>();
        for (int i = 0; i < sessions.size(); i++) {
            RobotSession session = sessions.get(i);
            models.put(session.name(), session.model());
            folder.write(i == 0 ? "screen.png" : "screen-" + session.name() + ".png", session.panel().screen().asPng());
            folder.write(FinishedRun.robotFile(i, session.name()), session.model().svg());
        }
        WrittenFiles written = new WrittenFiles(folder);
        for (int i = 0; i < sessions.size(); i++) {
            written.write(i == 0 ? "files" : "files-" + sessions.get(i).name(), sessions.get(i));
        }
        written.finish();
        folder.write("path.svg", recorder.path().svg(settings.world(), models));
        page(report, new ReportScene(settings.world(), models));
        folder.publish();
    }

    private void page(RunReport report, ReportScene scene) {
        try (OutputStream out = folder.open("report.html")) {
            HtmlReport.write(out, recorder.recording(), scene, Optional.of(report.json()));
        } catch (IOException e) {
            throw new UncheckedIOException("cannot write report.html", e);
        }
    }
}
