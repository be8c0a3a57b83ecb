package brickless.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class MailboxTest {
    private final Mailbox mailbox = new Mailbox(1);

    private static byte[] message(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    private List<String> taken() throws InterruptedException {
        return mailbox.take().stream().map(bytes -> new String(bytes, StandardCharsets.UTF_8)).toList();
    }

    @Test
    void messagesComeInTheOrderInWhichAPageNeedsThem() throws InterruptedException {
        mailbox.begin(message("begin"));
        mailbox.state(message("state"));
        mailbox.frame(message("frame"));
        mailbox.sample(message("sample"));
        mailbox.event(message("event"));
        assertThat(taken()).containsExactly("begin", "event", "sample", "frame", "state");
    }

    @Test
    void onlyTheNewestFrameAndStateAreKept() throws InterruptedException {
        mailbox.frame(message("old frame"));
        mailbox.state(message("old state"));
        mailbox.frame(message("frame"));
        mailbox.state(message("state"));
        assertThat(taken()).containsExactly("frame", "state");
    }

    @Test
    void oldSamplesMakeRoomAndEventsDoNot() throws InterruptedException {
        IntStream.range(0, 100).forEach(i -> mailbox.sample(message("s" + i)));
        IntStream.range(0, 100).forEach(i -> mailbox.event(message("e" + i)));
        List<String> taken = taken();
        assertThat(taken).filteredOn(text -> text.startsWith("e")).hasSize(100).startsWith("e0").endsWith("e99");
        assertThat(taken).filteredOn(text -> text.startsWith("s")).hasSize(64).startsWith("s36").endsWith("s99");
    }

    @Test
    void tooManyEventsAreReplacedByANewBeginning() throws InterruptedException {
        byte[] megabyte = new byte[1 << 20];
        IntStream.range(0, 5).forEach(i -> mailbox.event(megabyte));
        mailbox.event(message("later"));
        mailbox.frame(message("later"));
        mailbox.sample(message("later"));
        mailbox.state(message("later"));
        assertThat(taken()).as("nothing, which asks for a beginning").isEmpty();
        mailbox.begin(message("begin"));
        mailbox.event(message("event"));
        assertThat(taken()).containsExactly("begin", "event");
    }

    @Test
    void aBeginningReplacesEverythingBeforeIt() throws InterruptedException {
        mailbox.event(message("of the last run"));
        mailbox.frame(message("of the last run"));
        mailbox.begin(message("begin"));
        assertThat(taken()).containsExactly("begin");
    }

    @Test
    void whatWasThereWhenItClosedCanStillBeTaken() throws InterruptedException {
        mailbox.state(message("last"));
        mailbox.close();
        assertThat(mailbox.finished()).isFalse();
        assertThat(taken()).containsExactly("last");
        assertThat(mailbox.finished()).isTrue();
        assertThat(taken()).isEmpty();
    }
}
