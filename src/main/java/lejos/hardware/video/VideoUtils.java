package lejos.hardware.video;

/** Codes of video formats. */
public class VideoUtils {
    /** Creates an object nobody needs: all methods are static. */
    public VideoUtils() {}

    /** The four characters of a format code as a number, the first one in the lowest byte. */
    public static int fourcc(char a, char b, char c, char d) {
        return a & 0xff | (b & 0xff) << 8 | (c & 0xff) << 16 | (d & 0xff) << 24;
    }
}
