package brickless.viewer;

import brickless.trace.JsonFields;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;

/** A viewer in a test: reads the stream of events on a thread of its own and keeps all messages. */
final class Spectator implements AutoCloseable {
    /** Patience of a test with a busy machine. */
    private static final Duration PATIENCE = Duration.ofSeconds(40);

    /** One message. */
    record Message(String name, String json) {
        JsonFields fields() {
            return JsonFields.parse(json);
        }
    }

    private final InputStream stream;
    private final List<Message> messages = new ArrayList<>();
    private final List<String> events = new ArrayList<>();
    private boolean over;
    private int eventsLooked;
    private int looked;

    private Spectator(InputStream stream) {
        this.stream = stream;
        Thread reader = new Thread(this::read, "spectator");
        reader.setDaemon(true);
        reader.start();
    }

    /** Joins a view. */
    static Spectator of(LiveView view) throws IOException, InterruptedException {
        HttpResponse<InputStream> response = HttpClient.newHttpClient().send(
                HttpRequest.newBuilder(URI.create(view.address() + "events")).build(),
                HttpResponse.BodyHandlers.ofInputStream());
        if (response.statusCode() != 200) {
            throw new IOException("status " + response.statusCode());
        }
        return new Spectator(response.body());
    }

    private void read() {
        try (BufferedReader lines = new BufferedReader(new InputStreamReader(stream, StandardCharsets.UTF_8))) {
            String name = "";
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                if (line.startsWith("event: ")) {
                    name = line.substring(7);
                } else if (line.startsWith("data: ")) {
                    add(new Message(name, line.substring(6)));
                }
            }
        } catch (IOException e) {
            // The stream was cut off, by the view or by this viewer: for a spectator that is an end like any other.
            add(new Message("cut", "{}"));
        } finally {
            end();
        }
    }

    private synchronized void add(Message message) {
        messages.add(message);
        if (message.name().equals("events")) {
            events.addAll(List.of(message.json().split("(?<=\\}),(?=\\{\"t\")")));
        }
        notifyAll();
    }

    private synchronized void end() {
        over = true;
        notifyAll();
    }

    /** Waits for the next message of a name that fulfils a condition; every message is looked at once. */
    synchronized Message await(String name, Predicate<JsonFields> condition) throws InterruptedException {
        long end = System.nanoTime() + PATIENCE.toNanos();
        while (true) {
            while (looked < messages.size()) {
                Message message = messages.get(looked++);
                if (message.name().equals(name) && condition.test(message.fields())) {
                    return message;
                }
            }
            long left = (end - System.nanoTime()) / 1_000_000;
            if (over || left <= 0) {
                throw new AssertionError((over ? "the stream ended" : "nothing came in time") + " without the expected "
                        + name + "; last: " + messages.subList(Math.max(0, messages.size() - 3), messages.size()));
            }
            wait(left);
        }
    }

    Message await(String name) throws InterruptedException {
        return await(name, fields -> true);
    }

    /** Waits for a state in which so much simulated time has passed. */
    JsonFields awaitTime(double seconds) throws InterruptedException {
        return await("state", state -> state.number("t") >= seconds).fields();
    }

    /**
     * Waits for the next event whose line holds a text; every event is looked at once, however many came in one
     * message.
     */
    synchronized void awaitEvent(String part) throws InterruptedException {
        long end = System.nanoTime() + PATIENCE.toNanos();
        while (true) {
            while (eventsLooked < events.size()) {
                if (events.get(eventsLooked++).contains(part)) {
                    return;
                }
            }
            long left = (end - System.nanoTime()) / 1_000_000;
            if (over || left <= 0) {
                throw new AssertionError("no event with " + part + "; events were " + events);
            }
            wait(left);
        }
    }

    /** Waits until the stream ends. */
    synchronized void awaitEnd() throws InterruptedException {
        long end = System.nanoTime() + PATIENCE.toNanos();
        while (!over) {
            long left = (end - System.nanoTime()) / 1_000_000;
            if (left <= 0) {
                throw new AssertionError("the stream did not end");
            }
            wait(left);
        }
    }

    /** All messages so far. */
    synchronized List<Message> messages() {
        return List.copyOf(messages);
    }

    @Override
    public void close() throws IOException {
        stream.close();
    }
}
