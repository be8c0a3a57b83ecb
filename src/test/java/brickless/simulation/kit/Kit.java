package brickless.simulation.kit;

import brickless.simulation.Run;
import brickless.simulation.Simulation;
import brickless.simulation.SimulationSettings;
import brickless.simulation.StimuliReader;
import brickless.world.DescriptionException;
import brickless.world.RobotModel;
import brickless.world.World;
import brickless.world.svg.SvgRobotReader;
import brickless.world.svg.SvgWorldReader;
import java.time.Duration;
import java.util.List;
import java.util.function.UnaryOperator;

/** Worlds, robots and runs for programs that try one thing. */
final class Kit {
    /** A table with nothing on it; the robot stands in the middle and looks to the right. */
    static final String EMPTY = world("");

    /** A robot that carries: a bare large motor on A, wheels on B and C, a claw of 0 to 90 degrees on D. */
    static final String BENCH = robot("<g data-part='turret' id='bare' data-port='A' data-motor='large'/>"
            + "<g data-part='claw' id='claw' data-port='D' data-motor='medium' data-min-degrees='0' "
                    + "data-max-degrees='90'>"
            + "<rect x='60' y='-40' width='50' height='8'/></g>");

    private Kit() {}

    /** Two by two metres with what {@code body} adds to the empty white floor; the robot's axle stands at 1000,1000. */
    static String world(String body) {
        return "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 2000 2000'><rect width='2000' height='2000' "
                + "fill='white'/>" + body
                + "</svg>";
    }

    /** A heavy chassis on two wheels, with more parts. */
    static String robot(String parts) {
        return "<svg xmlns='http://www.w3.org/2000/svg'><rect data-part='chassis' x='-100' y='-40' width='150' "
                + "height='80' data-mass-kg='1'/>"
                + "<circle data-part='caster' id='ball' cx='-80' cy='0' r='8'/>"
                + "<rect data-part='wheel' id='left' data-port='B' data-motor='large' x='-28' y='-70' width='56' "
                        + "height='26' data-diameter-mm='56'/>"
                + "<rect data-part='wheel' id='right' data-port='C' data-motor='large' x='-28' y='44' width='56' "
                        + "height='26' data-diameter-mm='56'/>"
                + parts + "</svg>";
    }

    static World worldOf(String svg) {
        try {
            return SvgWorldReader.readText("kit.svg", svg);
        } catch (DescriptionException e) {
            throw new IllegalArgumentException(e);
        }
    }

    static RobotModel robotOf(String svg) {
        try {
            return SvgRobotReader.readText("robot.svg", svg);
        } catch (DescriptionException e) {
            throw new IllegalArgumentException(e);
        }
    }

    /** A finished run of a program, at most 60 s. */
    static Run run(Class<?> program, String world, String robot, UnaryOperator<SimulationSettings.Builder> settings) {
        SimulationSettings.Builder builder = SimulationSettings.builder(worldOf(world)).robot(robotOf(robot))
                .limit(Duration.ofSeconds(60)).pressButtons(false);
        Run run = new Simulation(settings.apply(builder).build()).start(program);
        run.toEnd();
        return run;
    }

    /** Stimuli in the words of a stimuli file. */
    static UnaryOperator<SimulationSettings.Builder> stimuli(String... lines) {
        return builder -> {
            try {
                return builder.stimuli(StimuliReader.readText("stimuli", String.join("\n", lines)));
            } catch (DescriptionException e) {
                throw new IllegalArgumentException(e);
            }
        };
    }

    /** What a finished run printed. */
    static Printed printed(Run run) {
        return new Printed(List.copyOf(run.robot().printedLines()));
    }
}
