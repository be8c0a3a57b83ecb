package brickless.physics;

import brickless.world.Point2;
import java.util.List;

/** How a robot's weight is shared among its supports, at rest on level ground. */
final class SupportLoads {
    /** Below this a system of supports counts as standing on one line, m⁴. */
    private static final double SINGULAR = 1e-9;

    private SupportLoads() {}

    /**
     * The shares of the weight: the flattest (minimum norm) solution of the balance of force and moments. Supports that
     * would be pulled up carry nothing; if all stand on one line, they share evenly.
     *
     * @param supports contact points
     * @param centre centre of mass in the same frame
     * @return one share per support, 0 to 1, together 1
     */
    static double[] shares(List<Point2> supports, Point2 centre) {
        int n = supports.size();
        double[] shares = new double[n];
        double mx = 0;
        double my = 0;
        for (Point2 p : supports) {
            mx += p.x() / n;
            my += p.y() / n;
        }
        double sxx = 0;
        double sxy = 0;
        double syy = 0;
        for (Point2 p : supports) {
            sxx += (p.x() - mx) * (p.x() - mx);
            sxy += (p.x() - mx) * (p.y() - my);
            syy += (p.y() - my) * (p.y() - my);
        }
        double det = sxx * syy - sxy * sxy;
        double bx = centre.x() - mx;
        double by = centre.y() - my;
        double sum = 0;
        for (int i = 0; i < n; i++) {
            double tilt = 0;
            if (det > SINGULAR * SINGULAR) {
                double dx = supports.get(i).x() - mx;
                double dy = supports.get(i).y() - my;
                tilt = (dx * (syy * bx - sxy * by) + dy * (sxx * by - sxy * bx)) / det;
            }
            shares[i] = Math.max(0, 1.0 / n + tilt);
            sum += shares[i];
        }
        for (int i = 0; i < n; i++) {
            shares[i] /= sum;
        }
        return shares;
    }
}
