package brickless.viewer;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;

/**
 * What is still to be sent to one viewer. The driver puts messages in and never waits; the viewer's own thread takes
 * them out. A viewer that reads slowly gets fewer frames and samples: older ones make room. Events are never left out;
 * if too many pile up they are all replaced by a new beginning, which holds them. Guarded by its own monitor.
 */
final class Mailbox {
    private static final int MOST_SAMPLES = 64;
    /** About a minute of a talkative program. */
    private static final int MOST_EVENT_BYTES = 4 << 20;

    private final int viewer;
    private final Deque<byte[]> samples = new ArrayDeque<>();
    private final List<byte[]> events = new ArrayList<>();
    private byte[] begin;
    private byte[] frame;
    private byte[] state;
    private int eventBytes;
    private boolean overrun;
    private boolean closed;

    Mailbox(int viewer) {
        this.viewer = viewer;
    }

    /** Number of the viewer, from 1. */
    int viewer() {
        return viewer;
    }

    /** Puts a beginning in, after which nothing counts that was there before. */
    synchronized void begin(byte[] message) {
        clear();
        begin = message;
        overrun = false;
        notifyAll();
    }

    synchronized void event(byte[] message) {
        if (overrun) {
            return;
        }
        events.add(message);
        eventBytes += message.length;
        if (eventBytes > MOST_EVENT_BYTES) {
            clear();
            overrun = true;
        }
        notifyAll();
    }

    synchronized void sample(byte[] message) {
        if (overrun) {
            return;
        }
        if (samples.size() == MOST_SAMPLES) {
            samples.removeFirst();
        }
        samples.addLast(message);
        notifyAll();
    }

    synchronized void frame(byte[] message) {
        frame = overrun ? null : message;
        notifyAll();
    }

    synchronized void state(byte[] message) {
        state = overrun ? null : message;
        notifyAll();
    }

    /** Nothing more comes; what is there can still be taken. */
    synchronized void close() {
        closed = true;
        notifyAll();
    }

    /**
     * Waits for messages and takes them all, in the order in which they are to be sent.
     *
     * @return the messages; none at all if the viewer needs a new beginning
     */
    synchronized List<byte[]> take() throws InterruptedException {
        while (isEmpty() && !overrun && !closed) {
            wait();
        }
        List<byte[]> all = new ArrayList<>();
        add(all, begin);
        all.addAll(events);
        all.addAll(samples);
        add(all, frame);
        add(all, state);
        clear();
        return all;
    }

    /** Whether nothing comes any more. */
    synchronized boolean finished() {
        return closed && isEmpty();
    }

    private static void add(List<byte[]> all, byte[] message) {
        if (message != null) {
            all.add(message);
        }
    }

    private boolean isEmpty() {
        return begin == null && frame == null && state == null && samples.isEmpty() && events.isEmpty();
    }

    private void clear() {
        begin = null;
        frame = null;
        state = null;
        samples.clear();
        events.clear();
        eventBytes = 0;
    }
}
