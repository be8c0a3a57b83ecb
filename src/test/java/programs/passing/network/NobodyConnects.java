package programs.passing.network;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.SocketTimeoutException;

/**
 * A thread that waits for a connection does not stop the others; its time limit is virtual.
 *
 * @expected exited 0
 * @prints other thread at 300 ms
 * @prints gave up at 1000 ms
 * @prints closed
 */
public class NobodyConnects {
    public static void main(String[] args) throws IOException, InterruptedException {
        long start = System.currentTimeMillis();
        new Thread(() -> {
            try {
                Thread.sleep(300);
            } catch (InterruptedException e) {
                return;
            }
            System.out.println("other thread at " + (System.currentTimeMillis() - start) / 100 * 100 + " ms");
        }).start();
        ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
        server.setSoTimeout(1000);
        try {
            server.accept();
        } catch (SocketTimeoutException e) {
            System.out.println("gave up at " + (System.currentTimeMillis() - start) / 100 * 100 + " ms");
        }
        server.setSoTimeout(0);
        Thread waiting = new Thread(() -> {
            try {
                server.accept();
            } catch (IOException e) {
                System.out.println("closed");
            }
        });
        waiting.start();
        Thread.sleep(100);
        server.close();
        waiting.join();
    }
}
