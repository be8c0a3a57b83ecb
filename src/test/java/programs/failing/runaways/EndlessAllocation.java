package programs.failing.runaways;

import java.util.ArrayList;
import java.util.List;

/**
 * A program that keeps everything it allocates ends at the time limit, because allocating takes time.
 *
 * @expected time-limit
 * @limit 1 s
 */
public class EndlessAllocation {
    public static void main(String[] args) {
        List<byte[]> kept = new ArrayList<>();
        while (true) {
            kept.add(new byte[100_000]);
        }
    }
}
