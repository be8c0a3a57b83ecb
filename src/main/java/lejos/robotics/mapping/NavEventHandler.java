package lejos.robotics.mapping;

import java.io.DataInputStream;
import java.io.IOException;
import java.util.Random;
import java.util.function.Consumer;
import lejos.hardware.Battery;
import lejos.hardware.Sound;
import lejos.hardware.motor.Motor;
import lejos.robotics.RangeReadings;
import lejos.robotics.RegulatedMotor;
import lejos.robotics.RotatingRangeScanner;
import lejos.robotics.localization.MCLParticleSet;
import lejos.robotics.localization.MCLPoseProvider;
import lejos.robotics.mapping.NavigationModel.NavEvent;
import lejos.robotics.navigation.ArcMoveController;
import lejos.robotics.navigation.DestinationUnreachableException;
import lejos.robotics.navigation.Pose;
import lejos.robotics.navigation.RotateMoveController;
import lejos.robotics.navigation.Waypoint;
import lejos.robotics.objectdetection.FeatureDetector;
import lejos.robotics.objectdetection.RangeFeatureDetector;
import lejos.robotics.pathfinding.Path;
import lejos.utility.PilotProps;

/** Does what a PC asks of a robot. Requests that need a part the model does not have are read and left undone. */
final class NavEventHandler {
    private static final NavEvent[] EVENTS = NavEvent.values();
    private static final float FULL_TURN = 360;
    private static final float HALF_TURN = 180;
    private static final float LOCATED_RANGE = 50;

    private final EV3NavigationModel model;
    private final DataInputStream in;
    private final Random random = new Random();

    NavEventHandler(EV3NavigationModel model) {
        this.model = model;
        this.in = model.dis;
    }

    /** Deals with an event; one that does not exist is reported and left aside. */
    void handle(int number) throws IOException {
        if (number < 0 || number >= EVENTS.length) {
            model.error("Unknown event " + number);
            return;
        }
        NavEvent event = EVENTS[number];
        if (model.debug) {
            model.log(event.name());
        }
        if (model.listener != null) {
            model.listener.eventReceived(event);
        }
        if (!drive(event) && !followPath(event) && !localize(event)) {
            configure(event);
        }
    }

    /** Moves of the pilot; false if the event is another one. */
    private boolean drive(NavEvent event) throws IOException {
        switch (event) {
            case TRAVEL -> travel(in.readFloat());
            case ROTATE -> rotate(in.readFloat());
            case ROTATE_TO -> rotate((int) shortestTurn(in.readFloat() - model.pp.getPose().getHeading()));
            case ARC -> arc(in.readFloat(), in.readFloat());
            case RANDOM_MOVE -> randomMove();
            case STOP -> stop();
            case TRAVEL_SPEED -> setTravelSpeed(in.readFloat());
            case ROTATE_SPEED -> setRotateSpeed(in.readFloat());
            default -> {
                return false;
            }
        }
        return true;
    }

    private void travel(float distance) {
        if (model.pilot != null) {
            model.pilot.travel(distance, false);
        }
    }

    private void rotate(float angle) {
        if (model.pilot instanceof RotateMoveController turner) {
            turner.rotate(angle, false);
        }
    }

    private void arc(float radius, float angle) {
        if (model.pilot instanceof ArcMoveController arcs) {
            arcs.arc(radius, angle, false);
        }
    }

    /** Drives ahead as far as there is room, or turns. */
    private void randomMove() {
        float angle = random.nextFloat() * FULL_TURN - HALF_TURN;
        float distance = random.nextFloat() * model.maxDistance;
        if (model.scanner != null && model.scanner.getRangeFinder() != null) {
            distance = Math.min(distance, model.scanner.getRangeFinder().getRange() - model.clearance);
        }
        if (distance > 0) {
            travel(distance);
        }
        rotate(angle);
    }

    private void stop() {
        if (model.navigator != null) {
            model.navigator.stop();
        }
        if (model.pilot != null) {
            model.pilot.stop();
        }
    }

    private void setTravelSpeed(float speed) {
        if (model.pilot != null) {
            model.pilot.setLinearSpeed(speed);
        }
    }

    private void setRotateSpeed(float speed) {
        if (model.pilot instanceof RotateMoveController turner) {
            turner.setAngularSpeed(speed);
        }
    }

    /** Waypoints and paths; false if the event is another one. */
    private boolean followPath(NavEvent event) throws IOException {
        switch (event) {
            case GOTO -> ifNavigating(waypoint(), way -> model.navigator.goTo(way));
            case ADD_WAYPOINT -> ifNavigating(waypoint(), way -> model.navigator.addWaypoint(way));
            case SET_TARGET -> model.setTarget(waypoint());
            case FOLLOW_PATH -> followPath();
            case START_NAVIGATOR -> ifNavigating(null, none -> model.navigator.followPath());
            case CLEAR_PATH -> ifNavigating(null, none -> model.navigator.clearPath());
            case FIND_PATH -> findPath(waypoint());
            case CALCULATE_PATH -> ifNavigating(null, none -> calculatePath());
            default -> {
                return false;
            }
        }
        return true;
    }

    private void ifNavigating(Waypoint waypoint, Consumer<Waypoint> action) {
        if (model.navigator != null) {
            action.accept(waypoint);
        }
    }

    private Waypoint waypoint() throws IOException {
        Waypoint waypoint = new Waypoint(0, 0);
        waypoint.loadObject(in);
        return waypoint;
    }

    private void followPath() throws IOException {
        Path path = new Path();
        path.loadObject(in);
        model.path = path;
        ifNavigating(null, none -> model.navigator.followPath(path));
    }

    private void findPath(Waypoint destination) {
        if (model.finder == null) {
            return;
        }
        try {
            model.path = model.finder.findRoute(model.pp.getPose(), destination);
            model.send(NavEvent.PATH, model.path);
        } catch (DestinationUnreachableException e) {
            model.send(NavEvent.PATH, () -> model.dos.writeInt(0));
        }
    }

    private void calculatePath() {
        if (model.finder != null && model.target != null) {
            findPath(model.target);
        }
    }

    /** Where the robot is and what is around it; false if the event is another one. */
    private boolean localize(NavEvent event) throws IOException {
        switch (event) {
            case LOAD_MAP -> loadMap();
            case GET_POSE -> sendPose();
            case SET_POSE -> setPose();
            case TAKE_READINGS -> takeReadings();
            case GET_READINGS -> sendReadings();
            case GET_PARTICLES -> ifLocalizing(() -> model.send(NavEvent.PARTICLE_SET, model.mcl.getParticles()));
            case PARTICLE_SET -> loadParticles();
            case FIND_CLOSEST -> findClosest(in.readFloat(), in.readFloat());
            case GET_ESTIMATED_POSE -> ifLocalizing(() -> model.send(NavEvent.ESTIMATED_POSE, model.mcl));
            case LOCALIZE -> ifLocalizing(this::localize);
            default -> {
                return false;
            }
        }
        return true;
    }

    private void ifLocalizing(Runnable action) {
        if (model.mcl != null) {
            action.run();
        }
    }

    private void loadMap() throws IOException {
        LineMap map = new LineMap();
        map.loadObject(in);
        model.map = map;
        ifLocalizing(() -> model.mcl.setMap(map));
    }

    /** To find the pose the robot may have to scan by turning: such moves are not told. */
    private void sendPose() {
        if (model.pp == null) {
            return;
        }
        boolean started = model.sendMoveStart;
        boolean stopped = model.sendMoveStop;
        model.sendMoveStart = false;
        model.sendMoveStop = false;
        model.sendPose();
        model.sendMoveStart = started;
        model.sendMoveStop = stopped;
    }

    private void setPose() throws IOException {
        Pose pose = new Pose();
        pose.loadObject(in);
        model.currentPose = pose;
        if (model.pp != null) {
            model.pp.setPose(pose);
        }
    }

    private void takeReadings() {
        if (model.scanner != null) {
            model.readings = model.scanner.getRangeValues();
            model.readings.printReadings();
            model.send(NavEvent.RANGE_READINGS, model.readings);
        }
    }

    private void sendReadings() {
        RangeReadings last = model.mcl == null ? null : model.mcl.getReadings();
        if (last != null) {
            model.readings = last;
        }
        model.send(NavEvent.RANGE_READINGS, model.readings);
    }

    private void loadParticles() throws IOException {
        MCLParticleSet loaded = new MCLParticleSet(model.map, 0, 0);
        loaded.loadObject(in);
        model.particles = loaded;
        ifLocalizing(() -> model.mcl.setParticles(loaded));
    }

    private void findClosest(float x, float y) {
        ifLocalizing(() -> model.send(NavEvent.CLOSEST_PARTICLE,
                () -> model.mcl.getParticles().dumpClosest(model.mcl.getReadings(), model.dos, x, y)));
    }

    /** Moves and scans until the guesses agree. */
    private void localize() {
        MCLPoseProvider mcl = model.mcl;
        mcl.getPose();
        while (mcl.getXRange() >= LOCATED_RANGE || mcl.getYRange() >= LOCATED_RANGE) {
            model.send(NavEvent.PARTICLE_SET, mcl.getParticles());
            randomMove();
            mcl.getPose();
        }
        model.send(NavEvent.PARTICLE_SET, mcl.getParticles());
        model.send(NavEvent.LOCATED);
    }

    /** Settings and the brick. */
    private void configure(NavEvent event) throws IOException {
        switch (event) {
            case RANDOM_MOVE_PARAMS -> model.setRandomMoveParameters(in.readFloat(), in.readFloat());
            case SOUND -> Sound.systemSound(false, in.readInt());
            case GET_BATTERY -> model.send(NavEvent.BATTERY, () -> model.dos.writeFloat(Battery.getVoltage()));
            case PILOT_PARAMS -> storePilot();
            case RANGE_FEATURE_DETECTOR_PARAMS -> setDetectors(in.readInt(), in.readFloat());
            case RANGE_SCANNER_PARAMS -> setScanner(in.readInt(), in.readInt());
            case EXIT -> System.exit(0);
            default -> model.error("Not an event for a robot: " + event);
        }
    }

    private void storePilot() throws IOException {
        PilotProps props = new PilotProps();
        props.setProperty(PilotProps.KEY_WHEELDIAMETER, Float.toString(in.readFloat()));
        props.setProperty(PilotProps.KEY_TRACKWIDTH, Float.toString(in.readFloat()));
        props.setProperty(PilotProps.KEY_LEFTMOTOR, motorLetter(in.readInt()));
        props.setProperty(PilotProps.KEY_RIGHTMOTOR, motorLetter(in.readInt()));
        props.setProperty(PilotProps.KEY_REVERSE, Boolean.toString(in.readBoolean()));
        props.storePersistentValues();
    }

    private static String motorLetter(int number) {
        return String.valueOf((char) ('A' + number));
    }

    private void setDetectors(int delay, float greatest) {
        for (FeatureDetector detector : model.detectors) {
            if (detector instanceof RangeFeatureDetector ranges) {
                ranges.setDelay(delay);
                ranges.setMaxDistance(greatest);
            }
        }
    }

    private void setScanner(int gearRatio, int motor) {
        if (model.scanner instanceof RotatingRangeScanner rotating) {
            RegulatedMotor[] motors = {Motor.A, Motor.B, Motor.C};
            rotating.setGearRatio(gearRatio);
            rotating.setHeadMotor(motors[motor]);
        }
    }

    private static float shortestTurn(float angle) {
        float turn = angle % FULL_TURN;
        if (turn > HALF_TURN) {
            return turn - FULL_TURN;
        }
        return turn < -HALF_TURN ? turn + FULL_TURN : turn;
    }
}
