package brickless.world.svg;

import brickless.world.Point2;

/** Reads path data: M L H V C S Q T A Z, absolute and relative, with implicit repetition. */
final class PathParser {
    private static final String COMMANDS = "MmLlHhVvCcSsQqTtAaZz";

    private final NumberScanner in;
    private final Flattener out;
    private Point2 lastCubicControl;
    private Point2 lastQuadControl;

    private PathParser(String text, Flattener out) {
        this.in = new NumberScanner(text);
        this.out = out;
    }

    static void parse(String text, Flattener out) throws MalformedValueException {
        if (!text.isBlank() && !text.strip().equals("none")) {
            new PathParser(text, out).run();
        }
    }

    private void run() throws MalformedValueException {
        char command = '\0';
        in.skipSpace();
        while (!in.atEnd()) {
            int start = in.position();
            if (COMMANDS.indexOf(in.peek()) >= 0) {
                char before = command;
                command = in.take();
                if (before == '\0' && Character.toUpperCase(command) != 'M') {
                    throw new MalformedValueException("path data must begin with M");
                }
            } else if (command == '\0' || Character.toUpperCase(command) == 'Z' || !in.numberAhead()) {
                throw new MalformedValueException("path data: a command is expected at " + in.quoteFrom(start)
                        + "; allowed: " + COMMANDS);
            } else if (Character.toUpperCase(command) == 'M') {
                command = command == 'M' ? 'L' : 'l';
            }
            in.skipSpace();
            draw(Character.toUpperCase(command), Character.isLowerCase(command));
            in.skipSeparator();
        }
    }

    private void draw(char command, boolean relative) throws MalformedValueException {
        Point2 origin = relative ? out.pen() : new Point2(0, 0);
        Point2 cubic = null;
        Point2 quad = null;
        switch (command) {
            case 'M' -> out.moveTo(point(origin));
            case 'L' -> out.lineTo(point(origin));
            case 'H' -> out.lineTo(new Point2(origin.x() + number(), out.pen().y()));
            case 'V' -> out.lineTo(new Point2(out.pen().x(), origin.y() + number()));
            case 'C' -> {
                Point2 first = point(origin);
                cubic = point(origin);
                out.cubicTo(first, cubic, point(origin));
            }
            case 'S' -> {
                Point2 first = mirrored(lastCubicControl);
                cubic = point(origin);
                out.cubicTo(first, cubic, point(origin));
            }
            case 'Q' -> {
                quad = point(origin);
                out.quadTo(quad, point(origin));
            }
            case 'T' -> {
                quad = mirrored(lastQuadControl);
                out.quadTo(quad, point(origin));
            }
            case 'A' -> arc(origin);
            default -> out.close();
        }
        lastCubicControl = cubic;
        lastQuadControl = quad;
    }

    private void arc(Point2 origin) throws MalformedValueException {
        double rx = Math.abs(number());
        double ry = Math.abs(number());
        double degrees = number();
        boolean large = in.flag();
        in.skipSeparator();
        boolean sweep = in.flag();
        in.skipSeparator();
        EndpointArc.draw(out, rx, ry, degrees, large, sweep, point(origin));
    }

    private Point2 mirrored(Point2 control) {
        Point2 pen = out.pen();
        return control == null ? pen : new Point2(2 * pen.x() - control.x(), 2 * pen.y() - control.y());
    }

    private Point2 point(Point2 origin) throws MalformedValueException {
        double x = number();
        return new Point2(origin.x() + x, origin.y() + number());
    }

    private double number() throws MalformedValueException {
        double value = in.number();
        in.skipSeparator();
        return value;
    }
}
