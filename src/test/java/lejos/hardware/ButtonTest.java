package lejos.hardware;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import brickless.device.panel.PanelBench;
import lejos.realm.OnPanel;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

@ExtendWith(OnPanel.class)
class ButtonTest {
    private static final Offset<Double> ONE_MS = within(1.0);

    private PanelBench bench;

    @Test
    void idsAreBitsAndPositionsAreNot() {
        assertThat(new int[] {
            Button.UP.getId(), Button.ENTER.getId(), Button.DOWN.getId(), Button.RIGHT.getId(), Button.LEFT.getId(),
                    Button.ESCAPE.getId()
        }).containsExactly(1, 2, 4, 8, 16, 32);
        assertThat(Button.ESCAPE.getName()).isEqualTo("Escape");
        assertThat(Key.ESCAPE).isEqualTo(5);
    }

    @Test
    void aPressDuringTheWaitIsSeenAtTheNextPollAfterDebouncingAndClicking() {
        bench.pressAt(120, Button.ID_ENTER, 300);
        assertThat(Button.waitForAnyPress()).isEqualTo(Button.ID_ENTER);
        assertThat(bench.millis()).as("poll at 150, 10 debounce, 50 click").isCloseTo(210, ONE_MS);
        assertThat(bench.events()).containsExactly("key 2 down by HAND", "tone 1000 Hz 50 ms 20 %");
    }

    @Test
    void aKeyPressedBeforeTheFirstWaitAndStillHeldReturnsAtOnce() {
        bench.keys.press(Button.ID_UP);
        assertThat(Button.waitForAnyPress()).isEqualTo(Button.ID_UP);
        assertThat(bench.millis()).isCloseTo(60, ONE_MS);
    }

    @Test
    void aKeyStillHeldAtTheNextWaitMustBePressedAgain() {
        bench.keys.press(Button.ID_UP);
        bench.at(500, () -> bench.keys.release(Button.ID_UP)).at(800, () -> bench.keys.press(Button.ID_UP));
        Button.waitForAnyPress();
        assertThat(Button.waitForAnyPress()).isEqualTo(Button.ID_UP);
        assertThat(bench.millis()).isBetween(860.0, 925.0);
    }

    @Test
    void aPressThatFallsBetweenTwoPollsIsLost() {
        bench.pressAt(110, Button.ID_ENTER, 30).pressAt(400, Button.ID_DOWN, 100);
        assertThat(Button.waitForAnyPress()).isEqualTo(Button.ID_DOWN);
    }

    @Test
    void aPressThatEndedBeforeTheWaitIsLost() {
        bench.pressAt(0, Button.ID_ENTER, 100);
        bench.processor().charge(200_000_000);
        assertThat(Button.waitForAnyPress(100)).isZero();
    }

    @Test
    void anyTimeLimitLastsWholePolls() {
        assertThat(Button.waitForAnyPress(1)).isZero();
        assertThat(bench.millis()).isCloseTo(50, ONE_MS);
        assertThat(Button.waitForAnyPress(100)).isZero();
        assertThat(bench.millis()).isCloseTo(150, ONE_MS);
        assertThat(Button.waitForAnyPress(101)).isZero();
        assertThat(bench.millis()).isCloseTo(300, ONE_MS);
    }

    @Test
    void anInterruptEndsTheWaitAndStaysMarked() {
        Thread.currentThread().interrupt();
        assertThat(Button.waitForAnyPress()).isZero();
        assertThat(Thread.currentThread().isInterrupted()).isTrue();
        Button.ENTER.waitForPress();
        assertThat(Thread.interrupted()).isTrue();
    }

    @Test
    void eventsReportReleasesInTheUpperByte() {
        bench.pressAt(100, Button.ID_ENTER, 400);
        assertThat(Button.waitForAnyEvent()).isEqualTo(Button.ID_ENTER);
        assertThat(Button.waitForAnyEvent()).isEqualTo(Button.ID_ENTER << 8);
        assertThat(Button.waitForAnyEvent(60)).isZero();
    }

    @Test
    void aSecondKeyWithinTheNextPollIsPartOfTheSameEvent() {
        bench.at(100, () -> bench.keys.press(Button.ID_ESCAPE)).at(130, () -> bench.keys.press(Button.ID_LEFT));
        assertThat(Button.waitForAnyEvent()).isEqualTo(Button.ID_ESCAPE | Button.ID_LEFT);
    }

    @Test
    void discardingTakesHeldKeysAsKnown() {
        bench.keys.press(Button.ID_UP);
        Button.discardEvents();
        assertThat(Button.waitForAnyPress(100)).isZero();
        assertThat(bench.events()).as("discarding does not click").contains("key 1 down by HAND");
    }

    @Test
    void firstLookAtAPressedKeyClicksAndLaterOnesDoNot() {
        bench.keys.press(Button.ID_LEFT);
        assertThat(Button.LEFT.isDown()).isTrue();
        assertThat(bench.millis()).isCloseTo(60, ONE_MS);
        assertThat(Button.LEFT.isUp()).isFalse();
        assertThat(Button.RIGHT.isUp()).isTrue();
        assertThat(bench.millis()).isCloseTo(80, ONE_MS);
        assertThat(bench.events()).containsExactly("key 16 down by HAND", "tone 1000 Hz 50 ms 20 %");
    }

    @Test
    void lookingAtIdleKeysCostsLittleButNotNothing() {
        for (int i = 0; i < 100; i++) {
            assertThat(Button.ESCAPE.isDown()).isFalse();
        }
        assertThat(bench.millis()).isEqualTo(2.0);
    }

    @Test
    void clickSettingsApplyToAllKeysAndZeroSilences() {
        Button.setKeyClickLength(20);
        Button.setKeyClickTone(Button.ID_UP, 440);
        Button.setKeyClickVolume(55);
        bench.keys.press(Button.ID_DOWN);
        Button.readButtons();
        Button.setKeyClickVolume(0);
        bench.keys.release(Button.ID_DOWN);
        Button.readButtons();
        bench.keys.press(Button.ID_DOWN);
        Button.readButtons();
        assertThat(bench.events().stream().filter(e -> e.startsWith("tone"))).containsExactly("tone 440 Hz 20 ms 55 %");
        assertThat(Button.getKeyClickTone(Button.ID_ESCAPE)).isEqualTo(440);
        assertThat(Button.getKeyClickLength()).isEqualTo(20);
        assertThat(Button.getKeyClickVolume()).isZero();
    }

    @Test
    void waitForPressUsesUpOtherKeys() {
        bench.pressAt(100, Button.ID_UP, 200).pressAt(500, Button.ID_ENTER, 200);
        Button.ENTER.waitForPress();
        assertThat(bench.millis()).isBetween(550.0, 625.0);
    }

    @Test
    void waitForPressAndReleaseEndsWithTheRelease() {
        bench.pressAt(100, Button.ID_ENTER, 400);
        Button.ENTER.waitForPressAndRelease();
        assertThat(bench.millis()).isBetween(550.0, 610.0);
    }

    @Test
    void simulatedKeysCountLikeRealOnes() {
        Button.ESCAPE.simulateEvent(Key.KEY_PRESSED);
        assertThat(Button.getButtons()).isEqualTo(Button.ID_ESCAPE);
        Button.ESCAPE.simulateEvent(Key.KEY_RELEASED);
        assertThat(Button.getButtons()).isZero();
        double before = bench.millis();
        Button.UP.simulateEvent(Key.KEY_PRESSED_AND_RELEASED);
        assertThat(bench.millis() - before).isCloseTo(100, ONE_MS);
        assertThat(bench.events()).contains("key 1 down by PROGRAM", "key 1 up by PROGRAM");
    }

    @Test
    void ledPatternsOutsideZeroToNineAreIgnored() {
        Button.LEDPattern(4);
        Button.LEDPattern(4);
        Button.LEDPattern(12);
        Button.LEDPattern(-1);
        Button.LEDPattern(0);
        assertThat(bench.events()).containsExactly("led 4", "led 0");
    }
}
