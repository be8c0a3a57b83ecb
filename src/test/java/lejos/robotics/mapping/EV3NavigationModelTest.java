package lejos.robotics.mapping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.net.ConnectException;
import java.net.InetAddress;
import java.net.Socket;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import lejos.robotics.FakeMotor;
import lejos.robotics.mapping.NavigationModel.NavEvent;
import lejos.robotics.navigation.Move;
import lejos.robotics.navigation.MovePilot;
import lejos.robotics.navigation.Navigator;
import lejos.robotics.navigation.Pose;
import lejos.robotics.navigation.Waypoint;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A PC talks to a robot over the loopback network. */
@Timeout(30)
class EV3NavigationModelTest {
    private final List<String> heard = new CopyOnWriteArrayList<>();
    private DataInputStream in;
    private DataOutputStream out;

    @Test
    void robotDoesWhatThePcAsksAndTellsWhatHappens() throws IOException {
        EV3NavigationModel model = new EV3NavigationModel();
        model.addListener(new NavEventListener() {
            @Override
            @SuppressWarnings("deprecation")
            public void whenConnected() {
                model.addNavigator(new Navigator(new MovePilot(56, 120, new FakeMotor(), new FakeMotor())));
                heard.add("connected");
            }

            @Override
            public void eventReceived(NavEvent navEvent) {
                heard.add(navEvent.name());
            }
        });
        try (Socket socket = connected()) {
            in = new DataInputStream(socket.getInputStream());
            out = new DataOutputStream(socket.getOutputStream());
            setsAndGetsThePose();
            travels();
            goesToAWaypoint();
            model.shutDown();
            send(NavEvent.GET_POSE);
            assertThat(pose().getX()).isCloseTo(30, within(0.5f));
        }
        assertThat(heard).containsExactly("connected", "SET_POSE", "GET_POSE", "TRAVEL", "ADD_WAYPOINT",
                "START_NAVIGATOR", "GET_POSE");
    }

    @Test
    @SuppressWarnings("deprecation")
    void messagesBeforeAConnectionAreDroppedAndUnknownEventsSkipped() throws IOException {
        EV3NavigationModel model = new EV3NavigationModel();
        MovePilot pilot = new MovePilot(56, 120, new FakeMotor(), new FakeMotor());
        model.addNavigator(new Navigator(pilot));
        pilot.travel(100);
        try (Socket socket = connected()) {
            in = new DataInputStream(socket.getInputStream());
            out = new DataOutputStream(socket.getOutputStream());
            out.writeByte(NavEvent.values().length);
            out.writeByte(-1);
            send(NavEvent.GET_POSE);
            assertThat(pose().getX()).as("the first thing to be told is what was asked for")
                    .isCloseTo(99.7f, within(0.1f));
            readingsParticlesAndBattery();
            model.shutDown();
            send(NavEvent.GET_POSE);
            pose();
        }
    }

    private void readingsParticlesAndBattery() throws IOException {
        send(NavEvent.GET_READINGS);
        expect(NavEvent.RANGE_READINGS);
        assertThat(in.readInt()).as("one invalid reading").isEqualTo(1);
        assertThat(in.readFloat()).isZero();
        assertThat(in.readFloat()).isEqualTo(-1);
        send(NavEvent.TRAVEL_SPEED);
        out.writeFloat(123);
        send(NavEvent.ROTATE);
        out.writeFloat(90);
        expect(NavEvent.MOVE_STOPPED);
        Move move = new Move(0, 0, false);
        move.loadObject(in);
        assertThat(move.getTravelSpeed()).isEqualTo(123);
        assertThat(move.getAngleTurned()).isCloseTo(90, within(0.5f));
        assertThat(pose().getHeading()).isCloseTo(90, within(0.5f));
    }

    /** The robot's thread may not listen yet. */
    private static Socket connected() throws IOException {
        while (true) {
            try {
                return new Socket(InetAddress.getLoopbackAddress(), 8888);
            } catch (ConnectException e) {
                Thread.onSpinWait();
            }
        }
    }

    private void send(NavEvent event) throws IOException {
        out.writeByte(event.ordinal());
    }

    private void expect(NavEvent event) throws IOException {
        assertThat(NavEvent.values()[in.readByte()]).isEqualTo(event);
    }

    private Pose pose() throws IOException {
        expect(NavEvent.SET_POSE);
        Pose pose = new Pose();
        pose.loadObject(in);
        return pose;
    }

    private void setsAndGetsThePose() throws IOException {
        send(NavEvent.SET_POSE);
        new Pose(10, 20, 90).dumpObject(out);
        send(NavEvent.GET_POSE);
        assertThat(pose()).hasToString("X:10 Y:20 H:90");
    }

    private void travels() throws IOException {
        send(NavEvent.TRAVEL);
        out.writeFloat(100);
        expect(NavEvent.MOVE_STOPPED);
        Move move = new Move(0, 0, false);
        move.loadObject(in);
        assertThat(move.getDistanceTraveled()).isCloseTo(99.7f, within(0.1f));
        assertThat(pose().getY()).isCloseTo(119.7f, within(0.1f));
    }

    private void goesToAWaypoint() throws IOException {
        send(NavEvent.ADD_WAYPOINT);
        new Waypoint(30, 120).dumpObject(out);
        send(NavEvent.START_NAVIGATOR);
        List<NavEvent> told = new ArrayList<>();
        while (told.size() < 6) {
            told.add(nextOfTheDrive());
        }
        assertThat(told).as("the pilot tells of its moves on a thread of its own")
                .containsExactlyInAnyOrder(NavEvent.MOVE_STOPPED, NavEvent.SET_POSE, NavEvent.MOVE_STOPPED,
                        NavEvent.SET_POSE, NavEvent.WAYPOINT_REACHED, NavEvent.PATH_COMPLETE);
        assertThat(told.indexOf(NavEvent.WAYPOINT_REACHED)).isLessThan(told.indexOf(NavEvent.PATH_COMPLETE));
    }

    private NavEvent nextOfTheDrive() throws IOException {
        NavEvent event = NavEvent.values()[in.readByte()];
        switch (event) {
            case MOVE_STOPPED -> new Move(0, 0, false).loadObject(in);
            case SET_POSE -> new Pose().loadObject(in);
            case WAYPOINT_REACHED -> {
                Waypoint reached = new Waypoint(0, 0);
                reached.loadObject(in);
                assertThat(reached.x).isEqualTo(30);
            }
            default -> assertThat(event).isEqualTo(NavEvent.PATH_COMPLETE);
        }
        return event;
    }
}
