package brickless.simulation;

import brickless.world.Pose2;
import java.util.List;
import java.util.Optional;

/**
 * What can be seen of a robot from outside while the run is held or over. Angles in degrees, clockwise on the page;
 * lengths in metres.
 */
public final class RobotView {
    private final RobotSession session;

    RobotView(RobotSession session) {
        this.session = session;
    }

    /** Name in its world. */
    public String name() {
        return session.name();
    }

    /** Position and heading. */
    public Pose2 pose() {
        return session.body().pose();
    }

    /** X in metres. */
    public double xMetres() {
        return session.body().xMetres();
    }

    /** Y in metres, down the page. */
    public double yMetres() {
        return session.body().yMetres();
    }

    /** Heading in degrees, clockwise, not wrapped. */
    public double headingDegrees() {
        return StrictMath.toDegrees(session.body().headingRadians());
    }

    /** Length of the driven path in metres. */
    public double distanceMetres() {
        return session.body().distanceMetres();
    }

    /** Encoder of a motor in degrees; {@code port} is A to D. */
    public int tachoDegrees(char port) {
        return session.devices().motor(port - 'A').encoder();
    }

    /** The screen read as text in the medium font, rows separated by line ends. */
    public String screenText() {
        return session.panel().screen().asText();
    }

    /** The same in the small font, as exceptions are shown. */
    public String smallScreenText() {
        return session.panel().screen().asSmallText();
    }

    /** The screen as a PNG file. */
    public byte[] screenPng() {
        return session.panel().screen().asPng();
    }

    /** LED pattern, 0 to 9. */
    public int ledPattern() {
        return session.panel().leds().pattern();
    }

    /** What the program has printed so far, one entry per complete line. */
    public List<String> printedLines() {
        return session.console().lines();
    }

    /** Class name of the behaviour that the program's arbitrator made active last, empty when none is. */
    public Optional<String> activeBehaviour() {
        return session.console().activeBehaviour();
    }

    /** Text for the summary about what was done for this robot. */
    List<String> notes() {
        return session.notes();
    }
}
