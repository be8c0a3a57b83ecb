package brickless.simulation;

import brickless.trace.HtmlReport;
import brickless.trace.JsonFields;
import brickless.trace.ReportRecording;
import brickless.trace.ReportScene;
import brickless.trace.RobotSample;
import brickless.trace.Sample;
import brickless.trace.TraceEvent;
import brickless.trace.TraceException;
import brickless.trace.TraceHeader;
import brickless.trace.TraceListener;
import brickless.trace.TraceReader;
import brickless.world.DescriptionException;
import brickless.world.RobotModel;
import brickless.world.svg.SvgRobotReader;
import brickless.world.svg.SvgWorldReader;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The folder of a run that is over. */
public final class FinishedRun {
    private static final String TRACE = "trace.jsonl";
    private static final String WORLD = "world.svg";

    private final Path folder;

    private FinishedRun(Path folder) {
        this.folder = folder;
    }

    /**
     * Opens a folder.
     *
     * @throws SetupException if it is not the folder of a finished run; the message says why
     */
    public static FinishedRun open(Path folder) {
        if (!Files.isDirectory(folder)) {
            throw new SetupException(folder + ": " + (Files.exists(folder) ? "is no folder" : "no such folder"));
        }
        if (!Files.isRegularFile(folder.resolve(TRACE))) {
            throw new SetupException(folder + ": is not the folder of a run: it holds no " + TRACE
                    + (Files.exists(folder.resolve(TRACE + ".part"))
                            ? "; the run that was writing it did not end" : ""));
        }
        return new FinishedRun(folder);
    }

    /**
     * The page that shows the run; made again from the trace if it is missing.
     *
     * @throws SetupException located, if it is missing and the other files of the run cannot be read
     */
    public Path report() {
        Path page = folder.resolve("report.html");
        if (!Files.isRegularFile(page)) {
            make(page);
        }
        return page;
    }

    private void make(Path page) {
        Models models = new Models(new ReportRecording());
        Path part = folder.resolve("report.html.part");
        try {
            TraceReader.read(folder.resolve(TRACE), models);
            if (!Files.isRegularFile(folder.resolve(WORLD))) {
                throw new SetupException(folder.resolve(WORLD)
                        + ": no such file; without it the arena cannot be drawn");
            }
            ReportScene scene = new ReportScene(SvgWorldReader.read(folder.resolve(WORLD)), models.robots());
            try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(part))) {
                HtmlReport.write(out, models.recording, scene, summary());
            }
            Files.move(part, page, StandardCopyOption.REPLACE_EXISTING);
        } catch (TraceException | DescriptionException e) {
            throw new SetupException(e.getMessage());
        } catch (IOException e) {
            throw new SetupException(page + ": cannot be written: " + e.getMessage());
        }
    }

    private Optional<String> summary() throws IOException {
        Path file = folder.resolve("summary.json");
        if (!Files.isRegularFile(file)) {
            return Optional.empty();
        }
        String text = Files.readString(file).strip();
        try {
            JsonFields.parse(text);
            return Optional.of(text);
        } catch (IllegalArgumentException e) {
            throw new SetupException(file + ": " + e.getMessage());
        }
    }

    /** Name of the file with the drawing of a run's robot; the first one's has no name in it. */
    static String robotFile(int index, String robot) {
        return index == 0 ? "robot.svg" : "robot-" + robot + ".svg";
    }

    /** Notes which robots take part, while the run is collected. */
    private final class Models implements TraceListener {
        private final ReportRecording recording;
        private List<String> names = List.of();

        Models(ReportRecording recording) {
            this.recording = recording;
        }

        Map<String, RobotModel> robots() throws DescriptionException {
            Map<String, RobotModel> robots = new LinkedHashMap<>();
            for (int i = 0; i < names.size(); i++) {
                robots.put(names.get(i), SvgRobotReader.read(folder.resolve(robotFile(i, names.get(i)))));
            }
            return robots;
        }

        @Override
        public void header(TraceHeader header) {
            recording.header(header);
        }

        @Override
        public void sample(Sample sample) {
            if (names.isEmpty()) {
                names = sample.robots().stream().map(RobotSample::name).toList();
            }
            recording.sample(sample);
        }

        @Override
        public void event(long timeNanos, String robot, TraceEvent event) {
            recording.event(timeNanos, robot, event);
        }
    }
}
