package brickless.viewer;

import brickless.trace.JsonText;
import com.sun.net.httpserver.Headers;
import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.Semaphore;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicInteger;

/** The server on the loopback interface: gives out the page and the stream of events, takes commands. */
final class ViewServer {
    /** Most viewers at a time. */
    static final int MOST_VIEWERS = 16;
    /** Longest body of a command, bytes. */
    static final int LONGEST_BODY = 4_096;
    /** Threads for requests that are answered at once, besides one per viewer. */
    private static final int OTHER_REQUESTS = 8;
    private static final int BACKLOG = 50;
    private static final Duration PATIENCE = Duration.ofSeconds(30);
    private static final Duration FAREWELL = Duration.ofSeconds(1);
    private static final String JSON = "application/json";
    private static final byte[] NOTHING = {};

    private final HttpServer server;
    private final ThreadPoolExecutor threads;
    private final Gatekeeper gatekeeper;
    private final Driver driver;
    private final Restarter restarter;
    private final String token;
    private final byte[] page = LivePage.html().getBytes(StandardCharsets.UTF_8);
    private final Semaphore seats = new Semaphore(MOST_VIEWERS);
    private final AtomicInteger viewers = new AtomicInteger();

    /** Binds the port. */
    ViewServer(ViewOptions options, Driver driver, Restarter restarter) throws IOException {
        setDefault("sun.net.httpserver.nodelay", "true");
        setDefault("sun.net.httpserver.maxReqTime", "20");
        this.driver = driver;
        this.restarter = restarter;
        token = options.token();
        server = HttpServer.create(new InetSocketAddress(InetAddress.getByAddress(new byte[] {127, 0, 0, 1}),
                options.port()), BACKLOG);
        gatekeeper = new Gatekeeper(server.getAddress().getPort(), token);
        int most = MOST_VIEWERS + OTHER_REQUESTS;
        threads = new ThreadPoolExecutor(most, most, 10, TimeUnit.SECONDS, new LinkedBlockingQueue<>(), work -> {
            Thread thread = new Thread(work, "brickless-view-http");
            thread.setDaemon(true);
            return thread;
        });
        threads.allowCoreThreadTimeOut(true);
        server.setExecutor(threads);
        server.createContext("/", this::handle);
    }

    /**
     * The JDK's server reads its settings from the system: answers without delay, requests that never end are cut off.
     */
    private static void setDefault(String property, String value) {
        if (System.getProperty(property) == null) {
            System.setProperty(property, value);
        }
    }

    void start() {
        server.start();
    }

    /** The address of the page. */
    String address() {
        return "http://127.0.0.1:" + server.getAddress().getPort() + "/" + token + "/";
    }

    /** Sends what is still to be sent, for a moment, and closes everything. The driver must have ended. */
    void stop() {
        threads.shutdown();
        awaitThreads();
        server.stop(0);
        threads.shutdownNow();
        awaitThreads();
    }

    private void awaitThreads() {
        try {
            threads.awaitTermination(FAREWELL.toMillis(), TimeUnit.MILLISECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void handle(HttpExchange exchange) throws IOException {
        if (!gatekeeper.ours(exchange.getRequestHeaders()) || !gatekeeper.knowsToken(exchange.getRequestURI())) {
            refuse(exchange, 403, "not allowed");
            return;
        }
        try {
            answer(exchange, Gatekeeper.resource(exchange.getRequestURI()));
        } catch (InterruptedException e) {
            exchange.close();
            Thread.currentThread().interrupt();
        }
    }

    private void answer(HttpExchange exchange, Optional<String> resource) throws IOException, InterruptedException {
        if (resource.isEmpty()) {
            exchange.getResponseHeaders().set("Location", "/" + token + "/");
            answer(exchange, 301, "text/plain", NOTHING);
            return;
        }
        switch (resource.get()) {
            case "" -> get(exchange, () -> answer(exchange, 200, "text/html; charset=utf-8", page));
            case "events" -> get(exchange, () -> events(exchange));
            case "stimuli" -> get(exchange, () -> stimuli(exchange));
            case "do" -> command(exchange);
            default -> refuse(exchange, 404, "no such page");
        }
    }

    private interface Answer {
        void give() throws IOException, InterruptedException;
    }

    private static void get(HttpExchange exchange, Answer answer) throws IOException, InterruptedException {
        if (allowed(exchange, "GET")) {
            answer.give();
        }
    }

    private static boolean allowed(HttpExchange exchange, String method) throws IOException {
        if (exchange.getRequestMethod().equals(method)) {
            return true;
        }
        exchange.getResponseHeaders().set("Allow", method);
        refuse(exchange, 405, "only " + method + " is allowed here");
        return false;
    }

    private void stimuli(HttpExchange exchange) throws IOException, InterruptedException {
        try {
            String file = await(driver.submit(() -> driver.session().stimuli()));
            exchange.getResponseHeaders().set("Content-Disposition", "attachment; filename=\"stimuli.txt\"");
            answer(exchange, 200, "text/plain; charset=utf-8", file.getBytes(StandardCharsets.UTF_8));
        } catch (RefusedException e) {
            refuse(exchange, 503, e.getMessage());
        }
    }

    /** Sends events until the viewer goes away or the view ends. */
    private void events(HttpExchange exchange) throws IOException, InterruptedException {
        if (!seats.tryAcquire()) {
            refuse(exchange, 503, MOST_VIEWERS + " viewers watch already");
            return;
        }
        Mailbox mailbox = new Mailbox(viewers.incrementAndGet());
        try {
            headers(exchange, "text/event-stream");
            exchange.sendResponseHeaders(200, 0);
            OutputStream out = exchange.getResponseBody();
            join(mailbox);
            while (!mailbox.finished()) {
                List<byte[]> messages = mailbox.take();
                if (messages.isEmpty()) {
                    join(mailbox);
                }
                for (byte[] message : messages) {
                    out.write(message);
                }
                out.flush();
            }
        } finally {
            seats.release();
            driver.submit(() -> driver.leave(mailbox));
            exchange.close();
        }
    }

    private void join(Mailbox mailbox) {
        driver.submit(() -> driver.join(mailbox)).exceptionally(refused -> {
            mailbox.close();
            return null;
        });
    }

    private void command(HttpExchange exchange) throws IOException, InterruptedException {
        if (!allowed(exchange, "POST")) {
            return;
        }
        String type = String.valueOf(exchange.getRequestHeaders().getFirst("Content-Type"));
        if (!type.split(";")[0].strip().equalsIgnoreCase(JSON)) {
            refuse(exchange, 415, "commands are " + JSON);
            return;
        }
        byte[] body = exchange.getRequestBody().readNBytes(LONGEST_BODY + 1);
        if (body.length > LONGEST_BODY) {
            refuse(exchange, 413, "commands are at most " + LONGEST_BODY + " bytes long");
            return;
        }
        try {
            perform(CommandReader.read(new String(body, StandardCharsets.UTF_8)));
            answer(exchange, 204, JSON, NOTHING);
        } catch (RefusedException e) {
            refuse(exchange, 400, e.getMessage());
        }
    }

    private void perform(Command command) throws InterruptedException {
        await(command instanceof Command.Restart restart ? restarter.restart(restart.seed())
                : driver.submit(() -> driver.perform(command)));
    }

    /** Waits for the driver; one that is busy for long, because the program is, is not waited for. */
    private static <T> T await(CompletableFuture<T> done) throws InterruptedException {
        try {
            return done.get(PATIENCE.toMillis(), TimeUnit.MILLISECONDS);
        } catch (ExecutionException e) {
            if (e.getCause() instanceof RefusedException refused) {
                throw refused;
            }
            throw new IllegalStateException(e.getCause());
        } catch (TimeoutException e) {
            throw new RefusedException("the run is busy");
        }
    }

    private static void refuse(HttpExchange exchange, int status, String message) throws IOException {
        answer(exchange, status, JSON, JsonText.object(line -> line.text("error", message))
                .getBytes(StandardCharsets.UTF_8));
    }

    private static void answer(HttpExchange exchange, int status, String type, byte[] body) throws IOException {
        headers(exchange, type);
        exchange.sendResponseHeaders(status, body.length == 0 ? -1 : body.length);
        try (OutputStream out = exchange.getResponseBody()) {
            out.write(body);
        }
    }

    private static void headers(HttpExchange exchange, String type) {
        Headers headers = exchange.getResponseHeaders();
        headers.set("Content-Type", type);
        headers.set("Cache-Control", "no-store");
        headers.set("X-Content-Type-Options", "nosniff");
        headers.set("Referrer-Policy", "no-referrer");
        headers.set("X-Frame-Options", "DENY");
        headers.set("Cross-Origin-Resource-Policy", "same-origin");
    }
}
