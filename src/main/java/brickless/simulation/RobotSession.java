package brickless.simulation;

import brickless.device.RobotDevices;
import brickless.device.panel.ButtonPolicy;
import brickless.device.sensor.SensorPortDevice;
import brickless.device.sensor.Surroundings;
import brickless.files.BrickFiles;
import brickless.hardware.BrickHardware;
import brickless.hardware.ProgramLog;
import brickless.kernel.Processor;
import brickless.loading.hints.HardwareHints;
import brickless.loading.hints.HintFinder;
import brickless.physics.Arena;
import brickless.physics.RobotBody;
import brickless.trace.RobotSample;
import brickless.world.RobotModel;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** One robot of a run: its body, its devices and its brick, whatever processor its program runs on. */
final class RobotSession {
    private static final int KEYS_NAMED = 5;

    private final String name;
    private final RobotModel model;
    private final boolean fitted;
    private final Optional<String> remark;
    private final RobotBody body;
    private final ProgramConsole console;
    private final Panel panel;
    private final RobotDevices devices;
    private final RunTimeFitting fitting = new RunTimeFitting();
    private final PlugNotes plugs = new PlugNotes();
    private final SensorModes modes;
    private final ProgramExit end;
    private Optional<String> guesses = Optional.empty();
    private Optional<BrickFiles> files = Optional.empty();
    private boolean poweredOff;

    /**
     * Creates a robot.
     *
     * @param processor of its program
     * @param open whether devices are plugged in that the program uses and the robot lacks
     * @param end how to end the program
     */
    RobotSession(SimulationSettings settings, Crew.Member member, Arena arena, Surroundings surroundings,
            Recorder recorder, Stimulator stimulator, Processor processor, boolean open, ProgramExit end) {
        name = member.name();
        model = member.model();
        fitted = member.fitted();
        remark = member.program().remark();
        body = arena.robot(name).orElseThrow();
        this.end = end;
        modes = new SensorModes((time, mode) -> recorder.event(time, name, mode));
        console = new ProgramConsole(name, recorder, settings.console(), processor::nowNanos, end::exit);
        panel = new Panel(name, processor, recorder, settings.pressButtons(), around(stimulator), end::endByKeys);
        panel.keys().setAttended(settings.attended());
        devices = new RobotDevices(body, surroundings, processor, open ? fitting : plugs, open ? fitting : plugs);
        if (open) {
            HardwareHints hints = HintFinder.find(new ProgramClasses(member.program()).ofMain());
            fitting.plugMotors(hints.motors(), devices);
            guesses = fitted ? OwnDriver.describe(hints) : Optional.empty();
        }
    }

    /** How to end the program of a robot. */
    interface ProgramExit {
        /** The program asks for its end; called by one of its threads. */
        void exit(int status);

        /**
         * The keys DOWN and ENTER were held together: the brick's menu ends the program. Called within a physics step.
         */
        void endByKeys();

        /** Whether the program has ended, while the world goes on. */
        boolean over();
    }

    private ButtonPolicy.Circumstances around(Stimulator stimulator) {
        return new ButtonPolicy.Circumstances() {
            @Override
            public boolean keyPressesToCome() {
                return stimulator.keyPressesToCome();
            }

            @Override
            public boolean stimuliToCome() {
                return stimulator.hasMoreToDo();
            }

            @Override
            public boolean motorsRest() {
                return devices.motorsRest();
            }
        };
    }

    /** The brick as the program sees it, with a log that passes on to {@link #console()}. */
    BrickHardware brick(ProgramLog log) {
        return new VirtualBrick("EV3", devices, panel, log);
    }

    /** The brick has files of its own. */
    void carry(BrickFiles brickFiles) {
        files = Optional.of(brickFiles);
    }

    /** The brick's own files, if the program does not use those of the host. */
    Optional<BrickFiles> files() {
        return files;
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
        if (!poweredOff && end.over()) {
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

    /** What the robot is like now; modes of sensors that have changed since the last time are written down before. */
    RobotSample sample(long nowNanos) {
        modes.note(nowNanos, devices);
        List<RobotSample.MotorSample> motors = new ArrayList<>();
        List<RobotSample.SensorSample> sensors = new ArrayList<>();
        for (int port = 0; port < 4; port++) {
            if (devices.motor(port).type() != null) {
                motors.add(new RobotSample.MotorSample((char) ('A' + port), devices.motor(port).encoder(),
                        devices.motor(port).shaftDegreesPerSecond(), devices.motor(port).dutyPercent(),
                        devices.motor(port).batteryAmperes()));
            }
            if (devices.sensor(port).mount() != null) {
                sensors.add(new RobotSample.SensorSample(port + 1, devices.sensor(port).connected(),
                        devices.sensor(port).reading(nowNanos)));
            }
        }
        return new RobotSample(name, body.pose(), motors, sensors, devices.battery().terminalVolts());
    }

    Frame.RobotFrame frame() {
        List<Frame.Part> parts = new ArrayList<>();
        for (int i = 0; i < model.turrets().size(); i++) {
            RobotModel.Turret turret = model.turrets().get(i);
            parts.add(new Frame.Part(turret.id(), (char) ('A' + turret.port()), body.turretAngleRadians(i)));
        }
        for (RobotModel.Claw claw : model.claws()) {
            parts.add(new Frame.Part(claw.id(), (char) ('A' + claw.port()), body.shaft(claw.port()).angleRadians()));
        }
        List<Frame.Beam> beams = new ArrayList<>();
        List<Frame.Spot> spots = new ArrayList<>();
        for (int i = 0; i < 4; i++) {
            SensorPortDevice port = devices.sensor(i);
            int number = i + 1;
            port.beam().ifPresent(b -> beams.add(new Frame.Beam(number, port.connected(), b.from(), b.ends(),
                    b.metres())));
            port.spot().ifPresent(s -> spots.add(new Frame.Spot(number, port.connected(), s.at(), s.radiusMetres(),
                    s.colour())));
        }
        return new Frame.RobotFrame(name, body.pose(), parts, beams, spots);
    }

    /** Brings what was still under way into the record. */
    void finish() {
        panel.screen().settle();
        console.finish();
        files.ifPresent(BrickFiles::end);
    }

    List<String> notes() {
        List<String> notes = new ArrayList<>();
        remark.ifPresent(notes::add);
        if (fitted) {
            notes.add(RobotFitter.describe(model));
        }
        guesses.ifPresent(notes::add);
        if (!fitting.plugged().isEmpty()) {
            notes.add("plugged in because the program uses it: " + String.join(", ", fitting.plugged()));
        }
        notes.addAll(fitting.missing());
        notes.addAll(plugs.notes());
        List<String> pressed = panel.automaticPresses();
        if (!pressed.isEmpty()) {
            notes.add("keys pressed for the program while it waited: "
                    + String.join(", ", pressed.subList(0, Math.min(pressed.size(), KEYS_NAMED)))
                    + (pressed.size() > KEYS_NAMED ? " and " + (pressed.size() - KEYS_NAMED) + " more" : "")
                    + " (--stimuli to press others, --buttons none to leave it waiting)");
        }
        files.flatMap(WrittenFiles::describe).ifPresent(notes::add);
        return notes;
    }
}
