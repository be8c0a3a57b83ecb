package kit;

import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.FileOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import lejos.hardware.Button;
import lejos.hardware.Sound;
import lejos.utility.Delay;
import lejos.utility.Stopwatch;

/** LEDs and sounds, among them a sample file that the program writes itself. */
public final class Signals {
    private static final int RATE = 8000;

    private Signals() {}

    public static void main(String[] args) throws IOException {
        Button.LEDPattern(4);
        Delay.msDelay(100);
        Button.LEDPattern(0);
        System.out.println("volume " + Sound.getVolume());
        time("beep", Sound::beep);
        time("twoBeeps", Sound::twoBeeps);
        time("sequence", Sound::beepSequence);
        time("sequenceUp", Sound::beepSequenceUp);
        time("buzz", Sound::buzz);
        Sound.setVolume(50);
        time("tone", () -> Sound.playTone(440, 250, 60));
        time("absolute", () -> Sound.playTone(880, 30, -70));
        File file = File.createTempFile("sample", ".wav");
        write(file, 1.5);
        Stopwatch watch = new Stopwatch();
        System.out.println("result " + Sound.playSample(file, 100));
        System.out.println("sample " + watch.elapsed());
        System.out.println("missing " + Sound.playSample(new File(file.getPath() + ".missing")));
        System.out.println("deleted " + file.delete());
    }

    private static void time(String name, Runnable sound) {
        Stopwatch watch = new Stopwatch();
        sound.run();
        System.out.println(name + " " + watch.elapsed());
    }

    /** Eight bits, mono. */
    private static void write(File file, double seconds) throws IOException {
        int length = (int) (RATE * seconds);
        ByteBuffer header = ByteBuffer.allocate(44).order(ByteOrder.LITTLE_ENDIAN);
        header.put(ascii("RIFF")).putInt(36 + length).put(ascii("WAVE")).put(ascii("fmt ")).putInt(16);
        header.putShort((short) 1).putShort((short) 1).putInt(RATE).putInt(RATE).putShort((short) 1)
                .putShort((short) 8);
        header.put(ascii("data")).putInt(length);
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        bytes.write(header.array());
        bytes.write(new byte[length]);
        try (FileOutputStream out = new FileOutputStream(file)) {
            out.write(bytes.toByteArray());
        }
    }

    private static byte[] ascii(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }
}
