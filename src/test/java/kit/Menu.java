package kit;

import lejos.hardware.lcd.LCD;
import lejos.utility.TextMenu;

/** A menu, and what was chosen. */
public final class Menu {
    private Menu() {}

    public static void main(String[] args) {
        TextMenu menu = new TextMenu(new String[] {"drive", "turn", "stop"}, 1, "choose");
        LCD.drawInt(menu.select(), 0, 6);
    }
}
