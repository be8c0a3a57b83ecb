package kit;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import lejos.hardware.motor.Motor;
import lejos.robotics.chassis.Wheel;
import lejos.robotics.chassis.WheeledChassis;
import lejos.robotics.mapping.EV3NavigationModel;
import lejos.robotics.mapping.NavEventListener;
import lejos.robotics.mapping.NavigationModel.NavEvent;
import lejos.robotics.navigation.Move;
import lejos.robotics.navigation.MovePilot;
import lejos.robotics.navigation.Navigator;
import lejos.robotics.navigation.Pose;
import lejos.robotics.navigation.Waypoint;

/** A robot led over the network, by a thread of its own that plays the PC; centimetres. */
public final class RemoteNavigation implements NavEventListener {
    private static final int PORT = 8888;
    private static final int ATTEMPTS = 100;

    private final EV3NavigationModel model = new EV3NavigationModel();
    private DataInputStream in;
    private DataOutputStream out;

    private RemoteNavigation() {}

    public static void main(String[] args) throws Exception {
        RemoteNavigation program = new RemoteNavigation();
        program.model.addListener(program);
        try (Socket socket = connect()) {
            program.in = new DataInputStream(socket.getInputStream());
            program.out = new DataOutputStream(socket.getOutputStream());
            program.lead();
        }
        System.out.println("not reached");
    }

    private static Socket connect() throws Exception {
        for (int attempt = 1; attempt < ATTEMPTS; attempt++) {
            try {
                return new Socket(InetAddress.getLoopbackAddress(), PORT);
            } catch (IOException e) {
                Thread.sleep(100); // the robot does not listen yet
            }
        }
        return new Socket(InetAddress.getLoopbackAddress(), PORT);
    }

    @Override
    public void whenConnected() {
        Wheel left = WheeledChassis.modelWheel(Motor.B, 5.6).offset(6);
        Wheel right = WheeledChassis.modelWheel(Motor.C, 5.6).offset(-6);
        MovePilot pilot = new MovePilot(
                new WheeledChassis(new Wheel[] {left, right}, WheeledChassis.TYPE_DIFFERENTIAL));
        pilot.setLinearSpeed(20);
        pilot.setAngularSpeed(90);
        model.addNavigator(new Navigator(pilot));
    }

    @Override
    public void eventReceived(NavEvent event) {
        System.out.println("heard " + event);
    }

    private void lead() throws IOException {
        send(NavEvent.SET_POSE);
        new Pose(0, 0, 0).dumpObject(out);
        send(NavEvent.TRAVEL);
        out.writeFloat(30);
        until(NavEvent.MOVE_STOPPED);
        send(NavEvent.GOTO);
        new Waypoint(30, 20).dumpObject(out);
        until(NavEvent.PATH_COMPLETE);
        send(NavEvent.GET_BATTERY);
        until(NavEvent.BATTERY);
        send(NavEvent.EXIT);
        while (in.read() >= 0) {
            Thread.yield();
        }
    }

    private void send(NavEvent event) throws IOException {
        out.writeByte(event.ordinal());
    }

    private void until(NavEvent wanted) throws IOException {
        NavEvent told;
        do {
            told = NavEvent.values()[in.readByte()];
            if (told == NavEvent.MOVE_STOPPED) {
                new Move(0, 0, false).loadObject(in);
            } else if (told == NavEvent.SET_POSE) {
                new Pose().loadObject(in);
            } else if (told == NavEvent.WAYPOINT_REACHED) {
                new Waypoint(0, 0).loadObject(in);
            } else if (told == NavEvent.BATTERY) {
                System.out.println("volts " + in.readFloat());
            }
        } while (told != wanted);
        System.out.println("told " + told);
    }
}
