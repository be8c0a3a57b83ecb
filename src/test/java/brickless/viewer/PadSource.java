package brickless.viewer;

import brickless.program.Program;
import brickless.program.ProgramException;
import brickless.program.ProgramFinder;
import brickless.simulation.Library;
import brickless.simulation.Run;
import brickless.simulation.RunReport;
import brickless.simulation.SetupException;
import brickless.simulation.Simulation;
import brickless.simulation.SimulationSettings;
import brickless.simulation.StimuliReader;
import brickless.world.DescriptionException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;

/** A program that shows what happens to its brick, in a folder where it can be edited. */
final class PadSource implements RunSource {
    /** Shown by the program itself: not to be taken for markup. */
    static final String NASTY = "<img src=x onerror=alert(1)> &amp; <b>bold</b>";
    private static final Path HOME = Path.of(System.getProperty("brickless.home"));
    private static final String PROGRAM = """
            import lejos.hardware.Button;
            import lejos.hardware.Key;
            import lejos.hardware.Sound;
            import lejos.hardware.lcd.LCD;
            import lejos.hardware.port.SensorPort;
            import lejos.hardware.sensor.EV3TouchSensor;
            import lejos.utility.Delay;

            public class Pad {
                static final Key[] KEYS = {Button.ENTER, Button.LEFT, Button.RIGHT, Button.UP, Button.DOWN};

                public static void main(String[] args) {
                    EV3TouchSensor bumper = new EV3TouchSensor(SensorPort.S1);
                    float[] sample = new float[1];
                    boolean[] down = new boolean[KEYS.length + 1];
                    LCD.clear();
                    System.out.println("HELLO");
                    while (Button.ESCAPE.isUp()) {
                        bumper.fetchSample(sample, 0);
                        boolean[] now = new boolean[down.length];
                        for (int i = 0; i < KEYS.length; i++) {
                            now[i] = KEYS[i].isDown();
                        }
                        now[KEYS.length] = sample[0] > 0;
                        for (int i = 0; i < now.length; i++) {
                            if (now[i] != down[i]) {
                                changed(i < KEYS.length ? KEYS[i].getName() : "bumper", now[i]);
                            }
                        }
                        down = now;
                        Delay.msDelay(5);
                    }
                }

                static void changed(String name, boolean down) {
                    System.out.println(name + (down ? " down" : " up"));
                    if (down && name.equals("Up")) {
                        LCD.drawString("Up and away", 2, 3);
                        LCD.setPixel(177, 127, 1);
                    }
                    if (down && name.equals("Left")) {
                        Button.LEDPattern(2);
                        Sound.playTone(440, 300);
                    }
                    if (down && name.equals("Right")) {
                        System.out.println("%s");
                    }
                }
            }
            """.formatted(NASTY);

    private final Path file;
    private final Path out;
    private final Duration limit;

    PadSource(Path folder, Duration limit) throws IOException {
        this.file = folder.resolve("Pad.java");
        this.out = folder.resolve("run");
        this.limit = limit;
        Files.writeString(file, PROGRAM);
    }

    @Override
    public Prepared prepare(OptionalLong seed) {
        try {
            Program program = new ProgramFinder(file.getParent(), List.of(), Optional.empty()).find(file.toString());
            return new Prepared(program, settings(seed.orElse(1)), List.of(file),
                    time -> "brickless run Pad.java --stimuli stimuli.txt");
        } catch (ProgramException | DescriptionException e) {
            throw new SetupException(e.getMessage());
        }
    }

    private SimulationSettings settings(long seed) throws DescriptionException {
        Library library = new Library(HOME);
        return SimulationSettings.builder(library.world("sim/worlds/pen.svg"))
                .robot(library.robot("sim/robots/educator.svg")).seed(seed).attended(true)
                .pressButtons(false).limit(limit).out(Optional.of(out)).build();
    }

    /** The folder of the run's files, written when it is over. */
    Path out() {
        return out;
    }

    /** Replaces words of the program. */
    void edit(String words, String others) throws IOException {
        String text = Files.readString(file);
        if (!text.contains(words)) {
            throw new AssertionError("the program does not contain " + words);
        }
        Files.writeString(file, text.replace(words, others));
    }

    /** Runs the program without anybody watching. */
    RunReport headless(String stimuli) throws Exception {
        try (Program program = new ProgramFinder(file.getParent(), List.of(), Optional.empty()).find(file.toString());
                Run run = new Simulation(settings(1).toBuilder().stimuli(StimuliReader.readText("stimuli", stimuli))
                        .out(Optional.empty()).build()).start(program)) {
            run.toEnd();
            return run.report();
        }
    }
}
