package lejos.robotics.mapping;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import lejos.robotics.RangeReadings;
import lejos.robotics.localization.MCLParticleSet;
import lejos.robotics.localization.MCLPoseProvider;
import lejos.robotics.navigation.Move;
import lejos.robotics.navigation.Pose;
import lejos.robotics.navigation.Waypoint;
import lejos.robotics.objectdetection.RangeFeature;
import lejos.robotics.pathfinding.Path;

/** What a robot, or a PC that watches it, knows about where the robot is and goes. */
public abstract class NavigationModel {
    /** The walls; null if not known. */
    protected LineMap map;
    /** Name of the robot. */
    protected String nxtName;
    /** Events from the other side; null before there is a connection. */
    protected DataInputStream dis;
    /** Events to the other side; null before there is a connection. */
    protected DataOutputStream dos;
    /** Number of readings of a scan. */
    protected int numReadings;
    /** Where the robot is. */
    protected Pose currentPose = new Pose(0, 0, 0);
    /** Where it goes. */
    protected Waypoint target;
    /** Guesses of the localisation. */
    protected MCLParticleSet particles;
    /** The localisation. */
    protected MCLPoseProvider mcl;
    /** The last range readings. */
    protected RangeReadings readings = new RangeReadings(1);
    /** The path. */
    protected Path path;
    /** The last move that was done. */
    protected Move lastMove;
    /** The last move that was begun. */
    protected Move lastPlannedMove;
    /** The last feature that was detected. */
    protected RangeFeature feature;
    /** Whether to print what goes on. */
    protected boolean debug;

    /** Nothing is known yet. */
    public NavigationModel() {}

    /** What goes between robot and PC: a byte with the place in this list, and what belongs to it. */
    public enum NavEvent {
        /** PC: a map. */
        LOAD_MAP,
        /** PC: drive to a waypoint. */
        GOTO,
        /** PC: drive a distance. */
        TRAVEL,
        /** PC: turn by an angle. */
        ROTATE,
        /** PC: stop. */
        STOP,
        /** PC: answer with SET_POSE. */
        GET_POSE,
        /** Both ways: a pose. */
        SET_POSE,
        /** PC: move somewhere. */
        RANDOM_MOVE,
        /** PC: scan, and answer with RANGE_READINGS. */
        TAKE_READINGS,
        /** PC: answer with the last RANGE_READINGS. */
        GET_READINGS,
        /** PC: answer with the CLOSEST_PARTICLE to a place. */
        FIND_CLOSEST,
        /** Both ways: a waypoint is added. */
        ADD_WAYPOINT,
        /** PC: answer with PARTICLE_SET. */
        GET_PARTICLES,
        /** Both ways: all particles. */
        PARTICLE_SET,
        /** Robot: range readings. */
        RANGE_READINGS,
        /** Robot: a move has started. */
        MOVE_STARTED,
        /** Robot: a move has stopped. */
        MOVE_STOPPED,
        /** Robot: a waypoint is reached. */
        WAYPOINT_REACHED,
        /** Robot: one particle. */
        CLOSEST_PARTICLE,
        /** PC: answer with ESTIMATED_POSE. */
        GET_ESTIMATED_POSE,
        /** Robot: the estimate of the localisation. */
        ESTIMATED_POSE,
        /** Robot: the last waypoint is reached. */
        PATH_COMPLETE,
        /** Robot: a feature is detected. */
        FEATURE_DETECTED,
        /** PC: answer with a PATH to a waypoint. */
        FIND_PATH,
        /** Robot: a path. */
        PATH,
        /** PC: a target. */
        SET_TARGET,
        /** PC: follow a path. */
        FOLLOW_PATH,
        /** PC: turn to a heading. */
        ROTATE_TO,
        /** Robot: a path is complete. */
        PATH_GENERATED,
        /** Robot: stopped on the way. */
        PATH_INTERRUPTED,
        /** PC: forget the path. */
        CLEAR_PATH,
        /** PC: drive an arc. */
        ARC,
        /** PC: follow the path. */
        START_NAVIGATOR,
        /** PC: find out where you are, and answer with LOCATED. */
        LOCALIZE,
        /** Robot: knows where it is. */
        LOCATED,
        /** PC: end the program. */
        EXIT,
        /** PC: calculate a path. */
        CALCULATE_PATH,
        /** PC: play a sound. */
        SOUND,
        /** PC: answer with BATTERY. */
        GET_BATTERY,
        /** Robot: volts of the battery. */
        BATTERY,
        /** PC: measures of the vehicle. */
        PILOT_PARAMS,
        /** PC: delay and greatest distance of the detectors. */
        RANGE_FEATURE_DETECTOR_PARAMS,
        /** PC: gear ratio and motor of the scanner. */
        RANGE_SCANNER_PARAMS,
        /** PC: speed of driving. */
        TRAVEL_SPEED,
        /** PC: speed of turning. */
        ROTATE_SPEED,
        /** PC: greatest distance and clearance of random moves. */
        RANDOM_MOVE_PARAMS
    }

    /** Whether the walls are known. */
    public boolean hasMap() {
        return map != null;
    }

    /** The walls; null if not known. */
    public LineMap getMap() {
        return map;
    }

    /** Sets the number of readings of a scan. */
    public void setNumReadings(int numReadings) {
        this.numReadings = numReadings;
    }

    /** Where the robot is. */
    public Pose getRobotPose() {
        return currentPose;
    }

    /** Guesses of the localisation. */
    public MCLParticleSet getParticles() {
        return particles;
    }

    /** Says where the robot is. */
    public void setRobotPose(Pose p) {
        currentPose = p;
    }

    /** Sets the guesses of the localisation. */
    public void setParticleSet(MCLParticleSet particles) {
        this.particles = particles;
    }

    /** The last range readings. */
    public RangeReadings getReadings() {
        return readings;
    }

    /** Says where the robot goes. */
    public void setTarget(Waypoint target) {
        this.target = target;
    }

    /** Where the robot goes. */
    public Waypoint getTarget() {
        return target;
    }

    /** The path. */
    public Path getPath() {
        return path;
    }

    /** Turns the printing of what goes on on or off. */
    public void setDebug(boolean on) {
        debug = on;
    }
}
