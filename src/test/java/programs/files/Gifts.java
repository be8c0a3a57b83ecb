package programs.files;

import java.io.File;
import java.io.FileWriter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import lejos.hardware.Sound;

/** Looks at what it was given, changes and removes some of it. */
public class Gifts {
    public static void main(String[] args) throws IOException {
        System.out.println(Arrays.toString(new File(".").list()));
        System.out.println(Files.readString(Path.of("greeting.txt")).trim());
        try (FileWriter more = new FileWriter("greeting.txt", true)) {
            more.write("and again\n");
        }
        System.out.println(Files.readAllLines(Path.of("greeting.txt")));
        System.out.println(new File("maps/room.svg").length() + " " + new File("maps/room.svg").lastModified());
        System.out.println(new File("unwanted.txt").delete() + " " + new File("unwanted.txt").exists());
        System.out.println("sound " + Sound.playSample(new File("beep.wav")));
    }
}
