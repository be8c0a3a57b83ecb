package brickless.simulation;

import brickless.world.Point2;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

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
        Map<String, List<List<Point2>>> outlines = new LinkedHashMap<>();
        sessions.forEach(session -> outlines.put(session.name(), session.model().chassis()));
        folder.write("path.svg", recorder.path().svg(settings.world(), outlines));
        for (int i = 0; i < sessions.size(); i++) {
            RobotSession session = sessions.get(i);
            folder.write(i == 0 ? "screen.png" : "screen-" + session.name() + ".png", session.panel().screen().asPng());
            if (session.fitted()) {
                folder.write(i == 0 ? "robot.svg" : "robot-" + session.name() + ".svg", session.model().svg());
            }
        }
        folder.publish();
    }
}
