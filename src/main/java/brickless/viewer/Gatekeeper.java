package brickless.viewer;

import com.sun.net.httpserver.Headers;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * Who is let in: requests that name this machine as their host (a page elsewhere that had its name resolved to this
 * machine does not), that come from no page or from ours, and that know the token.
 */
final class Gatekeeper {
    private static final List<String> NAMES = List.of("127.0.0.1", "localhost");

    private final byte[] token;
    private final Set<String> hosts;
    private final Set<String> origins;

    Gatekeeper(int port, String token) {
        this.token = token.getBytes(StandardCharsets.UTF_8);
        hosts = Set.of(NAMES.get(0) + ":" + port, NAMES.get(1) + ":" + port, NAMES.get(0), NAMES.get(1));
        origins = Set.of("http://" + NAMES.get(0) + ":" + port, "http://" + NAMES.get(1) + ":" + port);
    }

    /** Whether host and origin are ours. */
    boolean ours(Headers request) {
        List<String> host = request.getOrDefault("Host", List.of());
        List<String> origin = request.getOrDefault("Origin", List.of());
        return host.size() == 1 && hosts.contains(host.get(0))
                && (origin.isEmpty() || origin.size() == 1 && origins.contains(origin.get(0)));
    }

    /** Whether an address begins with the token. */
    boolean knowsToken(URI address) {
        return MessageDigest.isEqual(parts(address)[0].getBytes(StandardCharsets.UTF_8), token);
    }

    /** What comes behind the token and its slash; empty if there is not even a slash. */
    static Optional<String> resource(URI address) {
        String[] parts = parts(address);
        return parts.length < 2 ? Optional.empty() : Optional.of(parts[1]);
    }

    /** First part of the path, and the rest if there is a slash behind it. */
    private static String[] parts(URI address) {
        return String.valueOf(address.getRawPath()).replaceFirst("^/", "").split("/", 2);
    }
}
