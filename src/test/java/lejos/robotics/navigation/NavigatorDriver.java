package lejos.robotics.navigation;

import java.util.List;
import java.util.Map;
import java.util.Random;
import lejos.Agreement.Sightings;
import lejos.robotics.geometry.Point;
import lejos.robotics.localization.OdometryPoseProvider;

/** Leads a fake pilot along random paths and notes what it was told and what listeners heard. */
final class NavigatorDriver {
    private NavigatorDriver() {}

    static Map<String, Double> play(int seed) {
        Random random = new Random(seed);
        FakeController pilot = new FakeController(seed % 4 == 3 ? 15 : 0);
        Navigator navigator = new Navigator(pilot, new OdometryPoseProvider(pilot));
        Journal journal = new Journal();
        navigator.addNavigationListener(journal);
        int count = 1 + random.nextInt(5);
        for (int i = 0; i < count; i++) {
            addWaypoint(navigator, random, seed % 4 == 2);
        }
        navigator.singleStep(seed % 4 == 1);
        Sightings seen = new Sightings();
        for (int leg = 0; leg < count && !navigator.pathCompleted(); leg++) {
            navigator.followPath();
            seen.note("complete " + leg, navigator.waitForStop());
        }
        navigator.stop();
        note(seen, "told", pilot.calls());
        note(seen, "heard", journal.lines());
        Pose pose = navigator.getPoseProvider().getPose();
        return seen.note("x", pose.getX()).note("y", pose.getY()).note("moving", navigator.isMoving());
    }

    private static void addWaypoint(Navigator navigator, Random random, boolean heading) {
        float x = random.nextInt(400) - 200;
        float y = random.nextInt(400) - 200;
        if (heading) {
            int size = navigator.getPath().size();
            Point last = size == 0 ? new Point(0, 0) : navigator.getPath().get(size - 1);
            navigator.addWaypoint(x, y, last.angleTo(new Point(x, y)) + random.nextInt(120) - 60);
        } else {
            navigator.addWaypoint(x, y);
        }
    }

    private static void note(Sightings seen, String label, List<String> lines) {
        for (int i = 0; i < lines.size(); i++) {
            String[] words = lines.get(i).split(" ");
            for (int j = 0; j < words.length; j++) {
                boolean number = words[j].matches("[-0-9.]+,?");
                String name = label + " " + i + " word " + j;
                seen.note(name, number ? Double.parseDouble(words[j].replace(",", "")) : words[j].hashCode());
            }
        }
    }
}
