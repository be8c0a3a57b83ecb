package programs.passing.host;

import java.security.SecureRandom;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.SplittableRandom;
import java.util.UUID;
import java.util.concurrent.ThreadLocalRandom;
import java.util.function.Supplier;

/**
 * Every source of chance follows the seed; a seeded generator gives the documented numbers.
 *
 * @expected exited 0
 */
public class Randomness {
    public static void main(String[] args) {
        System.out.println(Math.random());
        System.out.println(new Random().nextInt());
        Supplier<Random> factory = Random::new;
        System.out.println(factory.get().nextInt());
        System.out.println(new SplittableRandom().nextInt());
        System.out.println(ThreadLocalRandom.current().nextInt(5, 50) + " " + ThreadLocalRandom.current()
                .nextDouble(1, 2));
        System.out.println(new SecureRandom().nextLong());
        System.out.println(UUID.randomUUID());
        List<Integer> list = new ArrayList<>(Arrays.asList(1, 2, 3, 4, 5, 6, 7, 8, 9));
        Collections.shuffle(list);
        System.out.println(list);
        if (new Random(42).nextInt() != -1170105035) {
            throw new AssertionError("seeded generator");
        }
    }
}
