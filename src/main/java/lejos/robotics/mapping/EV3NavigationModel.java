package lejos.robotics.mapping;

import java.io.IOException;
import java.util.ArrayList;
import lejos.remote.nxt.NXTConnection;
import lejos.remote.nxt.SocketConnector;
import lejos.robotics.RangeScanner;
import lejos.robotics.Transmittable;
import lejos.robotics.localization.MCLPoseProvider;
import lejos.robotics.localization.PoseProvider;
import lejos.robotics.navigation.Move;
import lejos.robotics.navigation.MoveController;
import lejos.robotics.navigation.MoveListener;
import lejos.robotics.navigation.MoveProvider;
import lejos.robotics.navigation.NavigationListener;
import lejos.robotics.navigation.Navigator;
import lejos.robotics.navigation.Pose;
import lejos.robotics.navigation.Waypoint;
import lejos.robotics.navigation.WaypointListener;
import lejos.robotics.objectdetection.Feature;
import lejos.robotics.objectdetection.FeatureDetector;
import lejos.robotics.objectdetection.FeatureListener;
import lejos.robotics.objectdetection.RangeFeature;
import lejos.robotics.pathfinding.PathFinder;
import lejos.utility.Delay;

/**
 * The robot's side of a navigation model: does what a PC asks over the network (TCP port 8888) and tells it what
 * happens.
 *
 * <p>A thread that keeps the program alive waits for the PC from construction on and receives its events. What happens
 * is told on the threads on which it happens; the output stream's lock keeps each message in one piece. Before a PC has
 * connected, nothing is told.
 */
public class EV3NavigationModel extends NavigationModel
        implements MoveListener, NavigationListener, WaypointListener, FeatureListener {
    private static final int FATAL_DELAY_MILLIS = 5000;

    /** The navigator. */
    protected Navigator navigator;
    /** The pilot. */
    protected MoveController pilot;
    /** What knows the pose. */
    protected PoseProvider pp;
    /** Detectors of features. */
    protected ArrayList<FeatureDetector> detectors = new ArrayList<>();
    /** Finds paths; null if nothing does. */
    protected PathFinder finder;
    /** Takes range readings. */
    protected RangeScanner scanner;
    /** Told what the PC asks. */
    protected NavEventListener listener;
    /** Distance that random moves keep from what is ahead. */
    protected float clearance = 10;
    /** Greatest distance of a random move. */
    protected float maxDistance = 40;
    /** Whether to tell the pose after each move. */
    protected boolean autoSendPose = true;
    /** Whether to tell when a move starts. */
    protected boolean sendMoveStart;
    /** Whether to tell when a move stops. */
    protected boolean sendMoveStop = true;

    private volatile boolean running = true;
    private RangeFeature lastSent;

    /** Begins to wait for the PC. */
    public EV3NavigationModel() {
        new Thread(this::receive, "navigation model").start();
    }

    /** Prints a message. */
    public void log(String message) {
        System.out.println(message);
    }

    /** Prints an error message. */
    public void error(String message) {
        System.out.println(message);
    }

    /** Prints an error message, and 5 seconds later ends the program with status 1. */
    public void fatal(String message) {
        System.out.println(message);
        Delay.msDelay(FATAL_DELAY_MILLIS);
        System.exit(1);
    }

    /** Adds the navigator, and with it its pilot and pose provider. */
    public void addNavigator(Navigator navigator) {
        this.navigator = navigator;
        navigator.addNavigationListener(this);
        addPoseProvider(navigator.getPoseProvider());
        addPilot(navigator.getMoveController());
    }

    /** Adds the pilot. */
    public void addPilot(MoveController pilot) {
        this.pilot = pilot;
        pilot.addMoveListener(this);
    }

    /** Adds what knows the pose, and with a localisation its scanner. */
    public void addPoseProvider(PoseProvider pp) {
        this.pp = pp;
        if (pp instanceof MCLPoseProvider localization) {
            mcl = localization;
            scanner = localization.getScanner();
        }
    }

    /** Adds what takes range readings. */
    public void addRangeScanner(RangeScanner scanner) {
        this.scanner = scanner;
    }

    /** Adds a detector of features. */
    public void addFeatureDetector(FeatureDetector detector) {
        detectors.add(detector);
        detector.addListener(this);
    }

    /** Sets the greatest distance of random moves, and the distance they keep from what is ahead. */
    public void setRandomMoveParameters(float maxDistance, float clearance) {
        this.maxDistance = maxDistance;
        this.clearance = clearance;
    }

    /** Says whether to tell the pose after each move. */
    public void setAutoSendPose(boolean on) {
        autoSendPose = on;
    }

    /** Says whether to tell when a move starts. */
    public void setSendMoveStart(boolean on) {
        sendMoveStart = on;
    }

    /** Says whether to tell when a move stops. */
    public void setSendMoveStop(boolean on) {
        sendMoveStop = on;
    }

    /** Stops receiving, after the next event. */
    public void shutDown() {
        running = false;
    }

    /** Sets the one who is told what the PC asks. */
    public void addListener(NavEventListener listener) {
        this.listener = listener;
    }

    @Override
    public void moveStarted(Move event, MoveProvider mp) {
        lastPlannedMove = event;
        if (sendMoveStart) {
            send(NavEvent.MOVE_STARTED, event);
        }
    }

    @Override
    public void moveStopped(Move event, MoveProvider mp) {
        lastMove = event;
        if (!sendMoveStop) {
            return;
        }
        send(NavEvent.MOVE_STOPPED, event);
        if (autoSendPose && pp != null) {
            sendPose();
        }
    }

    /** Tells of a range feature; while the robot rests, only if the range is another one. */
    @Override
    public void featureDetected(Feature feature, FeatureDetector detector) {
        if (!(feature instanceof RangeFeature seen) || seen.getRangeReading().getRange() < 0) {
            return;
        }
        boolean news = lastSent == null || seen.getRangeReading().getRange() != lastSent.getRangeReading().getRange();
        if (news || pilot != null && pilot.isMoving()) {
            this.feature = seen;
            lastSent = seen;
            send(NavEvent.FEATURE_DETECTED, seen);
        }
    }

    @Override
    public void addWaypoint(Waypoint wp) {
        send(NavEvent.ADD_WAYPOINT);
    }

    @Override
    public void atWaypoint(Waypoint waypoint, Pose pose, int sequence) {
        send(NavEvent.WAYPOINT_REACHED, waypoint);
    }

    @Override
    public void pathComplete(Waypoint waypoint, Pose pose, int sequence) {
        send(NavEvent.PATH_COMPLETE);
    }

    @Override
    public void pathInterrupted(Waypoint waypoint, Pose pose, int sequence) {
        send(NavEvent.PATH_INTERRUPTED);
    }

    @Override
    public void pathGenerated() {
        send(NavEvent.PATH_GENERATED);
    }

    /** Tells where the robot is. */
    void sendPose() {
        currentPose = pp.getPose();
        send(NavEvent.SET_POSE, currentPose);
    }

    /** Sends an event with what belongs to it. */
    void send(NavEvent event, Transmittable... contents) {
        send(event, () -> {
            for (Transmittable content : contents) {
                content.dumpObject(dos);
            }
        });
    }

    /** Sends an event; what belongs to it is written by a command. */
    void send(NavEvent event, Contents contents) {
        if (dos == null) {
            return;
        }
        try {
            synchronized (dos) {
                dos.writeByte(event.ordinal());
                contents.write();
                dos.flush();
            }
        } catch (IOException e) {
            fatal("Cannot send " + event + ": " + e);
        }
    }

    /** Writes what belongs to an event. */
    interface Contents {
        /** Writes it. */
        void write() throws IOException;
    }

    private void receive() {
        NXTConnection connection = new SocketConnector().waitForConnection(0, NXTConnection.PACKET);
        if (connection == null) {
            fatal("Cannot wait for a connection");
            return;
        }
        dis = connection.openDataInputStream();
        dos = connection.openDataOutputStream();
        if (listener != null) {
            listener.whenConnected();
        }
        NavEventHandler handler = new NavEventHandler(this);
        try {
            while (running) {
                handler.handle(dis.readByte());
            }
            connection.close();
        } catch (IOException e) {
            fatal("Connection lost: " + e);
        }
    }
}
