package brickless.viewer;

import java.security.SecureRandom;
import java.util.Base64;
import java.util.Optional;

/**
 * Where and how a run is shown.
 *
 * @param port port on the loopback interface, 0 for any that is free
 * @param token secret part of the address: at least {@value #SHORTEST_TOKEN} characters that need no escape in an
 *         address
 * @param speed simulated seconds per second, 0.1 to 100 or infinite
 */
public record ViewOptions(int port, String token, double speed) {
    /** Fewest characters of a token. */
    public static final int SHORTEST_TOKEN = 16;
    private static final int TOKEN_BYTES = 16;

    public ViewOptions {
        if (port < 0 || port > 65_535) {
            throw new IllegalArgumentException("a port is 0 to 65535, not " + port);
        }
        if (!token.matches("[A-Za-z0-9_-]{" + SHORTEST_TOKEN + ",100}")) {
            throw new IllegalArgumentException("a token is " + SHORTEST_TOKEN + " to 100 letters, digits, - and _");
        }
        Speed.check(speed);
    }

    /** With a new random token of 128 bits unless one is given. */
    public static ViewOptions of(int port, Optional<String> token, double speed) {
        return new ViewOptions(port, token.orElseGet(ViewOptions::randomToken), speed);
    }

    private static String randomToken() {
        byte[] bytes = new byte[TOKEN_BYTES];
        new SecureRandom().nextBytes(bytes);
        return Base64.getUrlEncoder().withoutPadding().encodeToString(bytes);
    }
}
