package lejos.robotics.localization;

import lejos.robotics.DirectionFinder;
import lejos.robotics.navigation.MoveProvider;
import lejos.robotics.navigation.Pose;

/** Dead reckoning whose poses have the heading of a compass; locations are added up without it. */
public class CompassPoseProvider extends OdometryPoseProvider {
    private final DirectionFinder compass;

    /** Begins at the origin and listens to the moves of a pilot. */
    public CompassPoseProvider(MoveProvider mp, DirectionFinder compass) {
        super(mp);
        this.compass = compass;
    }

    @Override
    public Pose getPose() {
        Pose pose = super.getPose();
        pose.setHeading(compass.getDegreesCartesian());
        return pose;
    }
}
