package lejos.utility;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import brickless.device.panel.PanelBench;
import brickless.device.panel.ScreenText;
import lejos.hardware.Button;
import lejos.hardware.lcd.LCD;
import lejos.realm.OnPanel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

@ExtendWith(OnPanel.class)
class TextMenuTest {
    private static final String[] ITEMS = {"zero", "one", "two", "three", "four", "five", "six", "seven", "eight"};

    private PanelBench bench;

    private static String text() {
        return ScreenText.read(LCD.getDisplay());
    }

    private void presses(int... keys) {
        int at = 300;
        for (int key : keys) {
            bench.pressAt(at, key, 150);
            at += 400;
        }
    }

    @Test
    void downMovesAndEnterChooses() {
        presses(Button.ID_DOWN, Button.ID_DOWN, Button.ID_UP, Button.ID_ENTER);
        assertThat(new TextMenu(new String[] {"red", "green", "blue"}, 2, "Colour").select()).isEqualTo(1);
        assertThat(text()).isEqualTo("\nColour\n red\n>green\n blue");
    }

    @Test
    void movingWrapsAtBothEndsAndScrolls() {
        presses(Button.ID_UP, Button.ID_ENTER);
        TextMenu menu = new TextMenu(ITEMS);
        assertThat(menu.select()).isEqualTo(8);
        assertThat(text()).isEqualTo("\n two\n three\n four\n five\n six\n seven\n>eight");
        bench.pressAt((long) bench.millis() + 300, Button.ID_DOWN, 150)
                .pressAt((long) bench.millis() + 700, Button.ID_ENTER, 150);
        assertThat(menu.select(8)).isZero();
        assertThat(text()).startsWith("\n>zero\n one");
    }

    @Test
    void escapeAndQuitAndTimeLimitHaveTheirNumbers() {
        presses(Button.ID_ESCAPE);
        TextMenu menu = new TextMenu(ITEMS);
        assertThat(menu.select(3)).isEqualTo(-1);
        double before = bench.millis();
        assertThat(menu.select(3, 500)).isEqualTo(-3);
        assertThat(bench.millis() - before).isCloseTo(500, within(55.0));
        bench.at((long) bench.millis() + 200, menu::quit);
        assertThat(menu.select()).isEqualTo(-2);
    }

    @Test
    void startIndexIsLimitedAndItemsEndAtTheFirstNull() {
        presses(Button.ID_ENTER);
        assertThat(new TextMenu(new String[] {"a", "b", null, "c"}).select(99)).isEqualTo(1);
        assertThat(text()).isEqualTo("\n a\n>b");
    }

    @Test
    void rowZeroIsNeverUsedAndBadRowsAreRefused() {
        presses(Button.ID_ENTER);
        new TextMenu(new String[] {"a"}, 0).select();
        assertThat(text()).isEqualTo("\n>a");
        assertThatThrownBy(() -> new TextMenu(ITEMS, -1)).isInstanceOf(IllegalArgumentException.class)
                .hasMessage("illegal topRow argument");
        assertThatThrownBy(() -> new TextMenu(ITEMS, 0, "T")).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void emptyMenuIgnoresEnter() {
        presses(Button.ID_ENTER, Button.ID_DOWN, Button.ID_ESCAPE);
        assertThat(new TextMenu(new String[0]).select()).isEqualTo(-1);
    }

    @Test
    void itemsAndTitleCanBeReplaced() {
        presses(Button.ID_ENTER);
        TextMenu menu = new TextMenu(ITEMS, 3, "Old");
        menu.setItems(new String[] {"x", "y"});
        menu.setTitle("New");
        assertThat(menu.getItems()).containsExactly("x", "y");
        assertThat(menu.select(1)).isEqualTo(1);
        assertThat(text()).isEqualTo("\n\nNew\n x\n>y");
        menu.setTitle(null);
        LCD.clear();
        bench.pressAt((long) bench.millis() + 300, Button.ID_ENTER, 150);
        menu.select();
        assertThat(text()).as("the row of the title stays free").isEqualTo("\n\n\n>x\n y");
    }

    @Test
    void theTimeLimitCanBeginAnew() {
        TextMenu menu = new TextMenu(ITEMS);
        bench.at(400, menu::resetTimeout);
        assertThat(menu.select(0, 500)).isEqualTo(-3);
        assertThat(bench.millis()).isCloseTo(900, within(60.0));
    }

    @Test
    void otherRowsStayAsTheyAre() {
        LCD.drawString("above", 0, 0);
        LCD.drawString("below", 0, 7);
        presses(Button.ID_ENTER);
        new TextMenu(new String[] {"a"}, 3).select();
        assertThat(text()).isEqualTo("above\n\n\n>a\n\n\n\nbelow");
    }

    @Test
    void debugMessagesFillRowsAndLoseTheOneThatFindsNone() {
        DebugMessages messages = new DebugMessages();
        for (int i = 0; i < 8; i++) {
            messages.echo(i);
        }
        assertThat(text()).isEqualTo("0\n1\n2\n3\n4\n5\n6\n7");
        messages.echo("lost");
        assertThat(text()).isEmpty();
        messages.echo("next");
        assertThat(text()).isEqualTo("next");
    }
}
