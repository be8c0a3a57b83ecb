package brickless.viewer;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BiConsumer;

/** The viewers that are there, by their mailboxes. Owned by the driver. */
final class Audience {
    private final List<Mailbox> mailboxes = new ArrayList<>();

    boolean isEmpty() {
        return mailboxes.isEmpty();
    }

    /** A viewer begins, or begins anew. */
    void join(Mailbox mailbox) {
        if (!mailboxes.contains(mailbox)) {
            mailboxes.add(mailbox);
        }
    }

    void leave(Mailbox mailbox) {
        mailboxes.remove(mailbox);
    }

    /** Puts one message into all mailboxes. */
    void tell(BiConsumer<Mailbox, byte[]> slot, byte[] message) {
        mailboxes.forEach(mailbox -> slot.accept(mailbox, message));
    }

    /** The viewers, in order of their coming. */
    List<Mailbox> all() {
        return List.copyOf(mailboxes);
    }

    void close() {
        mailboxes.forEach(Mailbox::close);
        mailboxes.clear();
    }
}
