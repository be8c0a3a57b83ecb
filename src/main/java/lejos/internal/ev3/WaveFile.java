package lejos.internal.ev3;

import java.io.File;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;

/**
 * What a WAV file says about itself.
 *
 * @param error 0, or the negative error number of {@link lejos.hardware.Audio#playSample(File, int)}
 * @param durationMillis length of the sound
 */
record WaveFile(int error, int durationMillis) {
    private static final int HEADER_BYTES = 44;
    private static final int FORMAT_AT = 12;
    private static final int CHUNK_HEADER_BYTES = 8;
    private static final int PCM = 1;
    private static final int MIN_RATE = 8000;
    private static final int MAX_RATE = 48_000;
    private static final long MILLIS_PER_SECOND = 1000;

    /** Reads the header; blocks for as long as the file system needs, which takes no simulated time. */
    static WaveFile read(File file) {
        if (file.length() < HEADER_BYTES) {
            return failed(-9);
        }
        try {
            return parse(ByteBuffer.wrap(Files.readAllBytes(file.toPath())).order(ByteOrder.LITTLE_ENDIAN));
        } catch (IOException unreadable) {
            return failed(-1);
        }
    }

    private static WaveFile parse(ByteBuffer wave) {
        int error = error(wave);
        if (error != 0) {
            return failed(error);
        }
        int bytesPerSample = wave.getShort(34) / 8;
        int rate = wave.getInt(24);
        if (rate < MIN_RATE) {
            throw new UnsupportedOperationException("a sample rate of " + rate + " Hz is below 8 kHz");
        }
        return new WaveFile(0, (int) (dataBytes(wave) * MILLIS_PER_SECOND / ((long) rate * bytesPerSample)));
    }

    private static int error(ByteBuffer wave) {
        int bits = wave.getShort(34);
        if (!tag(wave, 0).equals("RIFF")) {
            return -1;
        } else if (!tag(wave, 8).equals("WAVE")) {
            return -2;
        } else if (!tag(wave, FORMAT_AT).equals("fmt ")) {
            return -3;
        } else if (wave.getShort(20) != PCM) {
            return -4;
        } else if (wave.getShort(22) != 1) {
            return -5;
        } else if (bits != 8 && bits != 16) {
            return -6;
        }
        return wave.getInt(24) > MAX_RATE ? -7 : 0;
    }

    /** Length of the data chunk, or of everything behind the header if there is none. */
    private static long dataBytes(ByteBuffer wave) {
        long at = FORMAT_AT;
        while (at + CHUNK_HEADER_BYTES <= wave.limit()) {
            long length = wave.getInt((int) at + 4) & 0xffffffffL;
            if (tag(wave, (int) at).equals("data")) {
                return Math.min(length, wave.limit() - at - CHUNK_HEADER_BYTES);
            }
            at += CHUNK_HEADER_BYTES + length;
        }
        return wave.limit() - HEADER_BYTES;
    }

    private static String tag(ByteBuffer wave, int at) {
        return new String(wave.array(), at, 4, StandardCharsets.US_ASCII);
    }

    private static WaveFile failed(int error) {
        return new WaveFile(error, 0);
    }
}
