package lejos.robotics.filter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import lejos.hardware.AttachedBrick;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.RegisterExtension;

/** Samples go over the loopback network. */
@Timeout(30)
class PublishedSamplesTest {
    @RegisterExtension
    final AttachedBrick brick = new AttachedBrick();

    @Test
    void subscriberGetsWhatIsFetched() throws IOException {
        PublishFilter filter = new PublishFilter(new RandomSource(1, 3, 0), "random", 50);
        PublishedSource source = new PublishedSource("127.0.0.1", filter.publishMessage);
        assertThat(source.getName()).isEqualTo("random");
        assertThat(source.getFrequency()).isEqualTo(50);
        assertThat(source.sampleSize()).isEqualTo(3);
        assertThat(source.getKey()).isEqualTo(source.getHost() + ":" + source.getPort());
        SubscribedProvider provider = source.connect();
        float[] sent = new float[4];
        awaitSubscriber(filter);
        filter.fetchSample(sent, 1);
        float[] received = new float[4];
        provider.fetchSample(received, 1);
        assertThat(received).isEqualTo(sent);
        assertThat(provider.getTime()).matches("\\d\\d:\\d\\d:\\d\\d:\\d\\d\\d");
        assertThat(provider.isActive()).isTrue();
        source.close();
        provider.fetchSample(received, 0);
        assertThat(provider.isActive()).isFalse();
        filter.ss.close();
        filter.datagramSocket.close();
    }

    private static void awaitSubscriber(PublishFilter filter) {
        while (true) {
            synchronized (filter.subscribers) {
                if (!filter.subscribers.isEmpty()) {
                    return;
                }
            }
            Thread.onSpinWait();
        }
    }

    @Test
    void otherPacketsAreNoAnnouncements() {
        assertThatThrownBy(() -> new PublishedSource("127.0.0.1", new byte[] {0, 9, 1}))
                .isInstanceOf(IOException.class);
    }
}
