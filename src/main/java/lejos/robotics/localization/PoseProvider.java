package lejos.robotics.localization;

import lejos.robotics.navigation.Pose;

/** Something that knows where the robot is. */
public interface PoseProvider {
    /** The robot's pose, as a new object. */
    Pose getPose();

    /** Tells where the robot is. */
    void setPose(Pose aPose);
}
