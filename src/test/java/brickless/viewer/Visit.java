package brickless.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.program.Program;
import brickless.simulation.RunReport;
import brickless.simulation.Simulation;
import brickless.simulation.SimulationSettings;
import brickless.simulation.StimuliReader;
import brickless.world.DescriptionException;
import brickless.world.svg.SvgWorldReader;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** A live view of a program of the tests, and requests to it. */
final class Visit implements AutoCloseable {
    static final Duration UNLIMITED = Duration.ofNanos(Long.MAX_VALUE);
    private static final String WORLD = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 2000 1000'>"
            + "<rect id='box' data-solid='movable' data-mass-kg='0.5' x='1000' y='450' width='100' height='100'/>"
            + "<g data-robot='left' transform='translate(300 500)'/>"
            + "<g data-robot='right' transform='translate(1500 500)'/></svg>";
    private static final Pattern LIMIT = Pattern.compile("--for ([0-9.]+m?s)");

    final LiveView view;
    private final Class<?> program;
    private final HttpClient client = HttpClient.newHttpClient();

    private Visit(Class<?> program, RunSource source, double speed) {
        this.program = program;
        view = LiveView.open(source, ViewOptions.of(0, Optional.empty(), speed));
    }

    static Visit to(RunSource source, double speed) {
        return new Visit(Object.class, source, speed);
    }

    static RunSource.Prepared prepared(Class<?> program, SimulationSettings settings, OptionalLong seed) {
        return new RunSource.Prepared(Program.onClassPath(program.getName()),
                settings.toBuilder().seed(seed.orElse(settings.seed())).build(), List.of(),
                limit -> "brickless run --for " + brickless.simulation.Durations.text(limit));
    }

    /** Watches a program with two robots at a speed. */
    static Visit to(Class<?> program, double speed) {
        return to(program, settings().build(), speed);
    }

    static Visit to(Class<?> program, SimulationSettings settings, double speed) {
        return new Visit(program, seed -> prepared(program, settings, seed), speed);
    }

    /** As {@code brickless view} sets them: no limit, no automatic keys, somebody is there. */
    static SimulationSettings.Builder settings() {
        try {
            return SimulationSettings.builder(SvgWorldReader.readText("two.svg", WORLD)).pressButtons(false)
                    .attended(true).limit(UNLIMITED);
        } catch (DescriptionException e) {
            throw new IllegalStateException(e);
        }
    }

    URI address(String resource) {
        return URI.create(view.address() + resource);
    }

    HttpResponse<String> send(HttpRequest.Builder request) throws IOException, InterruptedException {
        return client.send(request.build(), HttpResponse.BodyHandlers.ofString());
    }

    HttpResponse<String> get(String resource) throws IOException, InterruptedException {
        return send(HttpRequest.newBuilder(address(resource)));
    }

    HttpResponse<String> post(String body) throws IOException, InterruptedException {
        return send(HttpRequest.newBuilder(address("do")).header("Content-Type", "application/json")
                .POST(HttpRequest.BodyPublishers.ofString(body)));
    }

    /** A command that is carried out. */
    void command(String body) throws IOException, InterruptedException {
        HttpResponse<String> answer = post(body.replace('\'', '"'));
        assertThat(answer.statusCode()).as(answer.body()).isEqualTo(204);
    }

    /** Ends the view and returns the figures of its last run. */
    RunReport end() throws InterruptedException {
        view.close();
        return view.awaitEnd().orElseThrow();
    }

    /** Runs the program headless with a saved stimuli file, as the command in its first lines says. */
    RunReport repeat(String stimuli, SimulationSettings settings) throws DescriptionException {
        Matcher limit = LIMIT.matcher(stimuli);
        assertThat(limit.find()).as(stimuli).isTrue();
        brickless.simulation.Run run = new Simulation(settings.toBuilder()
                .stimuli(StimuliReader.readText("stimuli.txt", stimuli))
                .limit(brickless.simulation.Durations.parse(limit.group(1)).orElseThrow()).build()).start(program);
        run.toEnd();
        return run.report();
    }

    @Override
    public void close() {
        view.close();
    }
}
