package brickless.junit;

import brickless.simulation.Run;
import brickless.simulation.Simulation;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.junit.jupiter.api.extension.ExtensionConfigurationException;
import org.junit.jupiter.api.extension.ExtensionContext;

/** The simulation of one test, made when it is first asked for, and the runs that were started from it. Thread-safe. */
final class TestSimulation {
    private static final ExtensionContext.Namespace NAMESPACE =
            ExtensionContext.Namespace.create(SimulationExtension.class);

    private final ExtensionContext context;
    private final List<Run> runs = new ArrayList<>();
    private OptionalLong seed = OptionalLong.empty();
    private Simulation simulation;
    private Run run;

    private TestSimulation(ExtensionContext context) {
        this.context = context;
    }

    /** The simulation of the test that a context belongs to. */
    static TestSimulation of(ExtensionContext context) {
        return context.getStore(NAMESPACE).getOrComputeIfAbsent(context.getUniqueId(),
                id -> new TestSimulation(context), TestSimulation.class);
    }

    /** Sets the seed, before the simulation is made. */
    synchronized void seed(long value) {
        if (simulation != null) {
            throw new IllegalStateException("the simulation was made before its seed was known");
        }
        seed = OptionalLong.of(value);
    }

    synchronized Simulation simulation() {
        if (simulation == null) {
            simulation = new Simulation(SimulatedSettings.of(context).settings(TestFolder.of(context), seed),
                    this::started);
        }
        return simulation;
    }

    /** The run of the program that {@link Simulated#program} names, started when it is first asked for. */
    synchronized Run run() {
        if (run == null) {
            Class<?> program = SimulatedSettings.of(context).program()
                    .orElseThrow(() -> new ExtensionConfigurationException(
                    "a parameter of type Run needs @Simulated(program = ….class); or take a Simulation and start the "
                    + "program yourself"));
            run = simulation().start(program);
        }
        return run;
    }

    private synchronized void started(Run started) {
        runs.add(started);
    }

    /** Closes the runs; if the test failed, tells what they were. */
    void close(Optional<Throwable> failure) {
        List<Run> all;
        synchronized (this) {
            all = List.copyOf(runs);
        }
        for (Run each : all) {
            boolean open = !each.ended();
            each.close();
            failure.ifPresent(thrown -> RunStory.of(each, open).ifPresent(story -> tell(story, thrown)));
        }
    }

    private void tell(String story, Throwable failure) {
        System.err.println(context.getRequiredTestClass().getSimpleName() + "." + context.getRequiredTestMethod()
                .getName() + " failed: " + story);
        failure.addSuppressed(new SimulationStory(story));
    }
}
