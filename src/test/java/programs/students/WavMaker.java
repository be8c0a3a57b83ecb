package programs.students;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.File;
import java.io.FileOutputStream;
import java.io.IOException;
import lejos.hardware.Sound;
import lejos.hardware.lcd.LCD;

/** Makes a sound file, plays it twice, and removes it. */
public class WavMaker {
    private static final int RATE = 8000;

    public static void main(String[] args) throws IOException {
        File file = new File("wavmaker-siren.wav");
        write(file, siren(0.75));
        LCD.drawString(file.getName(), 0, 0);
        long begin = System.currentTimeMillis();
        int result = Sound.playSample(file);
        long first = System.currentTimeMillis() - begin;
        result += Sound.playSample(file, 30);
        System.out.println("result " + result);
        System.out.println("hundredths " + first / 10);
        System.out.println("bytes " + file.length());
        System.out.println("removed " + file.delete());
        System.out.println("missing " + Sound.playSample(file));
        byte[] raw = siren(0.25);
        System.out.println("raw " + Sound.playSample(raw, 0, raw.length, RATE, 50));
    }

    private static byte[] siren(double seconds) {
        byte[] samples = new byte[(int) (seconds * RATE)];
        for (int i = 0; i < samples.length; i++) {
            double pitch = 400 + 200 * Math.sin(i * 2 * Math.PI / RATE);
            samples[i] = (byte) (128 + 100 * Math.sin(i * 2 * Math.PI * pitch / RATE));
        }
        return samples;
    }

    private static void write(File file, byte[] samples) throws IOException {
        ByteArrayOutputStream header = new ByteArrayOutputStream();
        header.write("RIFF".getBytes("US-ASCII"));
        little(header, 36 + samples.length, 4);
        header.write("WAVEfmt ".getBytes("US-ASCII"));
        little(header, 16, 4);
        little(header, 1, 2);
        little(header, 1, 2);
        little(header, RATE, 4);
        little(header, RATE, 4);
        little(header, 1, 2);
        little(header, 8, 2);
        header.write("data".getBytes("US-ASCII"));
        little(header, samples.length, 4);
        DataOutputStream out = new DataOutputStream(new FileOutputStream(file));
        try {
            out.write(header.toByteArray());
            out.write(samples, 0, samples.length);
        } finally {
            out.close();
        }
    }

    private static void little(ByteArrayOutputStream out, int value, int bytes) {
        for (int i = 0; i < bytes; i++) {
            out.write(value >> (8 * i));
        }
    }
}
