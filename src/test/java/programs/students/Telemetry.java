package programs.students;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.ArrayList;
import java.util.List;
import lejos.hardware.port.SensorPort;
import lejos.hardware.sensor.EV3UltrasonicSensor;
import lejos.robotics.SampleProvider;

/** Sends distances to a listener, which here runs on another thread of the same program. */
public class Telemetry {
    private static class Listener implements Runnable {
        private final int port;
        private final List<Float> heard = new ArrayList<Float>();
        private String greeting = "";

        Listener(int port) {
            this.port = port;
        }

        @Override
        public void run() {
            try (Socket socket = new Socket("localhost", port);
                    DataInputStream in = new DataInputStream(socket.getInputStream())) {
                greeting = in.readUTF();
                while (true) {
                    int number = in.readInt();
                    float value = in.readFloat();
                    if (number == heard.size()) {
                        heard.add(value);
                    }
                }
            } catch (EOFException e) {
                System.out.println("listener: end of data");
            } catch (IOException e) {
                System.out.println("listener: " + e.getMessage());
            }
        }
    }

    public static void main(String[] args) throws Exception {
        EV3UltrasonicSensor sensor = new EV3UltrasonicSensor(SensorPort.S4);
        SampleProvider distance = sensor.getDistanceMode();
        float[] sample = new float[distance.sampleSize()];
        ServerSocket server = new ServerSocket(0);
        Listener listener = new Listener(server.getLocalPort());
        Thread thread = new Thread(listener);
        thread.start();
        Socket client = server.accept();
        DataOutputStream out = new DataOutputStream(client.getOutputStream());
        out.writeUTF("hello from the brick");
        for (int i = 0; i < 10; i++) {
            distance.fetchSample(sample, 0);
            out.writeInt(i);
            out.writeFloat(sample[0]);
            out.flush();
            Thread.sleep(50);
        }
        client.close();
        server.close();
        thread.join();
        System.out.println(listener.greeting);
        System.out.println("values " + listener.heard.size());
        sensor.close();
    }
}
