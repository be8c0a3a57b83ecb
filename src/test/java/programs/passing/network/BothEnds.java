package programs.passing.network;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintWriter;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;

/**
 * Two threads of a program talk to each other through a socket.
 *
 * @outside
 * @expected exited 0
 * @prints server heard: forward
 * @prints client heard: done forward
 * @prints end: null
 */
public class BothEnds {
    public static void main(String[] args) throws IOException, InterruptedException {
        ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
        Thread brick = new Thread(() -> serve(server));
        brick.start();
        Thread.sleep(100);
        try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.getLocalPort())) {
            PrintWriter out = new PrintWriter(socket.getOutputStream(), true);
            BufferedReader in = new BufferedReader(new InputStreamReader(socket.getInputStream()));
            out.println("forward");
            System.out.println("client heard: " + in.readLine());
            System.out.println("end: " + in.readLine());
        }
        brick.join();
        server.close();
    }

    private static void serve(ServerSocket server) {
        try (Socket socket = server.accept()) {
            BufferedReader in = new BufferedReader(new InputStreamReader(socket.getInputStream()));
            String line = in.readLine();
            System.out.println("server heard: " + line);
            new PrintWriter(socket.getOutputStream(), true).println("done " + line);
        } catch (IOException e) {
            e.printStackTrace();
        }
    }
}
