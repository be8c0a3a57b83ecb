package lejos.utility;

import lejos.hardware.BrickFinder;
import lejos.hardware.Button;
import lejos.hardware.lcd.TextLCD;

/**
 * A list on the text screen to choose from: UP and DOWN move, ENTER chooses, ESCAPE gives up. Row 0 of the screen is
 * never used for items, so at most seven are visible at a time; longer lists scroll.
 */
public class TextMenu {
    /** Marks the selected item. */
    protected static final char SEL_CHAR = '>';
    /** Time between two looks at the keys in milliseconds. */
    protected static final int BUTTON_POLL_INTERVAL = 10;

    private static final int ESCAPED = -1;
    private static final int QUIT = -2;
    private static final int TIMED_OUT = -3;
    private static final int ROWS = 8;

    /** First row of the items. */
    protected int _topRow;
    /** Number of rows of the items. */
    protected int _height = ROWS;
    /** Title on the row above the items, null for none. */
    protected String _title;
    /** The items. */
    protected String[] _items;
    /** Number of items. */
    protected int _length;
    /** Index of the first visible item. */
    protected int _topIndex;
    /** Whether another thread wants the choice to end. */
    protected boolean _quit;
    /** Start of the time limit in milliseconds. */
    protected int _startTime;
    /** The screen. */
    protected TextLCD lcd = BrickFinder.getDefault().getTextLCD();

    /** A menu from row 1. */
    public TextMenu(String[] items) {
        this(items, 1, null);
    }

    /**
     * A menu from a row.
     *
     * @throws IllegalArgumentException if the row is negative
     */
    public TextMenu(String[] items, int topRow) {
        this(items, topRow, null);
    }

    /**
     * A menu with a title on the row above.
     *
     * @param items the items, up to the first null
     * @param topRow first row of the items; 0 counts as 1
     * @throws IllegalArgumentException if the row is negative, or 0 with a title
     */
    public TextMenu(String[] items, int topRow, String title) {
        if (topRow < 0 || topRow == 0 && title != null) {
            throw new IllegalArgumentException("illegal topRow argument");
        }
        _topRow = topRow;
        setTitle(title);
        setItems(items);
    }

    /** Sets the title; null removes its text, but its row stays reserved. */
    public void setTitle(String title) {
        _title = title;
        _topRow = Math.max(1, _topRow);
        _height = Math.max(0, Math.min(_height, ROWS - _topRow));
    }

    /** Sets the items: those up to the first null. */
    public void setItems(String[] items) {
        _items = items;
        _length = 0;
        while (items != null && _length < items.length && items[_length] != null) {
            _length++;
        }
        _height = Math.max(0, Math.min(_length, ROWS - _topRow));
    }

    /** Lets the user choose, starting at the first item; see {@link #select(int, int)}. */
    public int select() {
        return select(0, 0);
    }

    /** Lets the user choose; see {@link #select(int, int)}. */
    public int select(int selectedIndex) {
        return select(selectedIndex, 0);
    }

    /**
     * Lets the user choose; blocks.
     *
     * @param selectedIndex item to start at, limited to those that are there
     * @param timeout limit in milliseconds, 0 = none
     * @return index of the chosen item; −1 after ESCAPE, −2 after {@link #quit}, −3 after the time limit
     */
    public int select(int selectedIndex, int timeout) {
        int selected = Math.max(0, Math.min(selectedIndex, _length - 1));
        _quit = false;
        resetTimeout();
        showRowOf(selected);
        while (true) {
            display(selected, _topIndex);
            int button = awaitButton(timeout);
            if (button < 0) {
                return button;
            } else if (button == Button.ID_ESCAPE) {
                return ESCAPED;
            } else if (button == Button.ID_ENTER && _length > 0) {
                return selected;
            } else if (_length > 0) {
                selected = Math.floorMod(selected + step(button), _length);
                showRowOf(selected);
            }
        }
    }

    /** The next press, or the negative result that ends the choice. */
    private int awaitButton(int timeout) {
        int button = 0;
        while (button == 0) {
            if (_quit) {
                return QUIT;
            }
            if (timeout > 0 && now() - _startTime >= timeout) {
                return TIMED_OUT;
            }
            button = Button.waitForAnyPress(BUTTON_POLL_INTERVAL);
            if (button == 0 && Thread.currentThread().isInterrupted()) {
                return QUIT;
            }
        }
        return button;
    }

    private static int step(int button) {
        if (button == Button.ID_DOWN) {
            return 1;
        }
        return button == Button.ID_UP ? -1 : 0;
    }

    /** Scrolls just as far as needed. */
    private void showRowOf(int selected) {
        if (selected < _topIndex) {
            _topIndex = selected;
        } else if (selected >= _topIndex + _height) {
            _topIndex = selected - _height + 1;
        }
        _topIndex = Math.max(0, _topIndex);
    }

    /** Ends a choice that runs on another thread. */
    public void quit() {
        _quit = true;
    }

    /** Draws title and items. */
    protected void display(int selectedIndex, int topIndex) {
        if (_title != null) {
            lcd.clear(_topRow - 1);
            lcd.drawString(_title, 0, _topRow - 1);
        }
        for (int i = 0; i < _height; i++) {
            int item = topIndex + i;
            lcd.clear(_topRow + i);
            if (item < _length) {
                lcd.drawString((item == selectedIndex ? SEL_CHAR : ' ') + _items[item], 0, _topRow + i);
            }
        }
        lcd.refresh();
    }

    /** The items. */
    public String[] getItems() {
        return _items;
    }

    /** Starts the time limit anew. */
    public void resetTimeout() {
        _startTime = now();
    }

    private static int now() {
        return (int) System.currentTimeMillis();
    }
}
