package programs.files;

import java.io.BufferedReader;
import java.io.File;
import java.io.FileReader;
import java.io.FileWriter;
import java.io.IOException;
import java.io.PrintWriter;
import lejos.hardware.motor.Motor;
import lejos.utility.Delay;

/** Drives a little, appends what the motor counted to a log, and drives the longer the more lines the log has. */
public class AppendingLogger {
    public static void main(String[] args) throws IOException {
        File log = new File("drive.log");
        Motor.B.forward();
        Motor.C.forward();
        Delay.msDelay(200 + 300 * lines(log));
        Motor.B.stop(true);
        Motor.C.stop();
        try (PrintWriter writer = new PrintWriter(new FileWriter(log, true))) {
            writer.println(System.currentTimeMillis() + " " + Motor.B.getTachoCount());
        }
        Delay.msDelay(100);
        System.out.println("lines " + lines(log));
    }

    private static int lines(File log) throws IOException {
        if (!log.exists()) {
            return 0;
        }
        try (BufferedReader reader = new BufferedReader(new FileReader(log))) {
            return (int) reader.lines().count();
        }
    }
}
