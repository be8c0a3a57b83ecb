package brickless.simulation;

import brickless.device.RobotDevices;
import brickless.device.sensor.Surroundings;
import brickless.kernel.Kernel;
import brickless.kernel.KernelSettings;
import brickless.kernel.ProgramEnd;
import brickless.loading.hints.HintFinder;
import brickless.physics.Arena;
import brickless.physics.RobotBody;
import brickless.trace.RobotSample;
import brickless.world.RobotModel;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** One robot of a run: its body, its devices, its brick, and the kernel its program runs on. */
final class RobotSession {
    private final String name;
    private final RobotModel model;
    private final boolean fitted;
    private final RobotBody body;
    private final Kernel kernel;
    private final ProgramConsole console;
    private final Panel panel;
    private final RobotDevices devices;
    private final RunTimeFitting fitting = new RunTimeFitting();
    private final PlugNotes plugs = new PlugNotes();
    private final RobotRealm realm;
    private boolean poweredOff;

    RobotSession(SimulationSettings settings, Crew.Member member, Arena arena, Surroundings surroundings,
            Recorder recorder, Stimulator stimulator, Optional<ProgramBody> programBody) {
        name = member.name();
        model = member.model();
        fitted = member.fitted();
        body = arena.robot(name).orElseThrow();
        kernel = new Kernel(kernelSettings(settings, arena));
        console = new ProgramConsole(name, recorder, settings.console(), kernel::nowNanos, kernel::exit);
        panel = new Panel(name, kernel, recorder, settings.pressButtons(), stimulator::keyPressesToCome, this::endByKeys);
        boolean open = fitted || programBody.isPresent();
        devices = new RobotDevices(body, surroundings, kernel, open ? fitting : plugs, open ? fitting : plugs);
        if (open) {
            fitting.plugMotors(HintFinder.find(new ProgramClasses(member.program()).files()).motors(), devices);
        }
        realm = new RobotRealm(member.program(), kernel, new VirtualBrick("EV3", devices, panel, console), programBody);
    }

    private KernelSettings kernelSettings(SimulationSettings settings, Arena arena) {
        KernelSettings kernelSettings = KernelSettings.defaults().withName(name).withSeed(settings.seed()).withStepNanos(arena.stepNanos())
                .withLimitNanos(settings.limit().toNanos()).withBackend(settings.backend());
        return settings.scheduleSeed().isPresent() ? kernelSettings.withScheduleSeed(settings.scheduleSeed().getAsLong()) : kernelSettings;
    }

    /** The keys DOWN and ENTER were held together: the brick's menu ends the program. */
    private void endByKeys() {
        realm.end(1);
    }

    String name() {
        return name;
    }

    RobotModel model() {
        return model;
    }

    boolean fitted() {
        return fitted;
    }

    RobotBody body() {
        return body;
    }

    Kernel kernel() {
        return kernel;
    }

    ProgramConsole console() {
        return console;
    }

    Panel panel() {
        return panel;
    }

    RobotDevices devices() {
        return devices;
    }

    void beforeStep(long nowNanos) {
        if (!poweredOff && kernel.end() != null) {
            poweredOff = true;
            devices.powerOff();
        }
        devices.beforeStep(nowNanos);
    }

    void afterStep(long nowNanos) {
        devices.afterStep(nowNanos);
        panel.step(nowNanos);
        console.step(nowNanos);
    }

    RobotSample sample(long nowNanos) {
        List<RobotSample.MotorSample> motors = new ArrayList<>();
        List<RobotSample.SensorSample> sensors = new ArrayList<>();
        for (int port = 0; port < 4; port++) {
            if (devices.motor(port).type() != null) {
                motors.add(new RobotSample.MotorSample((char) ('A' + port), devices.motor(port).encoder(),
                        devices.motor(port).shaftDegreesPerSecond(), devices.motor(port).dutyPercent(), devices.motor(port).batteryAmperes()));
            }
            if (devices.sensor(port).mount() != null) {
                sensors.add(new RobotSample.SensorSample(port + 1, devices.sensor(port).connected(), devices.sensor(port).reading(nowNanos)));
            }
        }
        return new RobotSample(name, body.pose(), motors, sensors, devices.battery().terminalVolts());
    }

    /** Brings what was still under way into the record. */
    void finish(ProgramEnd end) {
        panel.screen().settle();
        console.finish();
    }

    List<String> notes() {
        List<String> notes = new ArrayList<>();
        if (fitted) {
            notes.add(RobotFitter.describe(model));
        }
        if (!fitting.plugged().isEmpty()) {
            notes.add("plugged in because the program uses it: " + String.join(", ", fitting.plugged()));
        }
        notes.addAll(plugs.notes());
        if (panel.automaticPresses() > 0) {
            notes.add("keys pressed for the program while it waited: " + panel.automaticPresses() + " (--buttons none to leave it waiting)");
        }
        return notes;
    }

    /** Lets go of the program's classes. */
    void release() {
        realm.release();
    }
}
