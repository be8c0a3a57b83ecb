package brickless.world.svg;

import brickless.world.Point2;
import java.util.ArrayList;
import java.util.List;

/** Cuts lines into dashes by length along the line. */
final class Dashes {
    private final List<Double> pattern;
    private final PointBudget budget;
    private final List<SubPath> out = new ArrayList<>();
    private List<Point2> dash = new ArrayList<>();
    private int index;
    private double left;

    private Dashes(List<Double> pattern, PointBudget budget) {
        this.pattern = pattern;
        this.budget = budget;
    }

    static List<SubPath> split(List<SubPath> lines, List<Double> pattern, double offset, PointBudget budget)
            throws MalformedValueException {
        Dashes dashes = new Dashes(pattern, budget);
        for (SubPath line : lines) {
            dashes.walk(line, offset);
        }
        return dashes.out;
    }

    private void walk(SubPath line, double offset) throws MalformedValueException {
        begin(offset);
        List<Point2> points = line.points();
        dash = new ArrayList<>(points.subList(0, 1));
        int count = line.closed() ? points.size() : points.size() - 1;
        for (int i = 0; i < count; i++) {
            segment(points.get(i), points.get((i + 1) % points.size()));
        }
        finish();
    }

    private void begin(double offset) {
        double period = pattern.stream().mapToDouble(Double::doubleValue).sum();
        double skip = offset - Math.floor(offset / period) * period;
        index = 0;
        left = pattern.get(0);
        while (skip >= left && skip > 0) {
            skip -= left;
            index = (index + 1) % pattern.size();
            left = pattern.get(index);
        }
        left -= skip;
    }

    private void segment(Point2 from, Point2 to) throws MalformedValueException {
        double length = Rings.distance(from, to);
        double done = 0;
        while (length - done > left) {
            done += left;
            Point2 cut = new Point2(from.x() + (to.x() - from.x()) * done / length, from.y()
                    + (to.y() - from.y()) * done / length);
            dash.add(cut);
            finish();
            budget.spend(2);
            index = (index + 1) % pattern.size();
            left = pattern.get(index);
            dash = new ArrayList<>(List.of(cut));
        }
        left -= length - done;
        dash.add(to);
    }

    /** Keeps what was collected if it is a dash, not a gap. */
    private void finish() {
        if (index % 2 == 0 && dash.size() > 1) {
            out.add(new SubPath(dash, false));
        }
        dash = new ArrayList<>();
    }
}
