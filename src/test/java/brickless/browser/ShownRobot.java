package brickless.browser;

import java.util.Arrays;

/** The robot and its screen as a report or a live page shows them. */
public final class ShownRobot {
    private static final String PLACE = "document.querySelector('.layer.robot').shadowRoot"
            + ".querySelector('[data-robot-name]').getAttribute('transform')";
    private static final String PIXELS = "(() => { const c = document.querySelector('canvas.lcd');"
            + " const d = c.getContext('2d').getImageData(0, 0, 178, 128).data;"
            + " let text = ''; for (let i = 0; i < d.length; i += 4) { text += d[i] < 100 ? '#' : '.'; }"
            + " return text; })()";

    private final Browser browser;

    /** The first robot of the page that is open in a browser. */
    public ShownRobot(Browser browser) {
        this.browser = browser;
    }

    /** x, y in millimetres and heading in degrees of the drawn robot. */
    public double[] pose() {
        String numbers = ((String) browser.value(PLACE)).replaceAll("[^-0-9. ]", " ").strip();
        return Arrays.stream(numbers.split("\\s+")).mapToDouble(Double::parseDouble).toArray();
    }

    /** Waits until a condition on {@code x}, {@code y} and {@code heading} holds. */
    public void awaitPose(String condition) {
        browser.await("((x, y, heading) => " + condition + ")(..." + PLACE + ".match(/-?[0-9.]+/g).map(Number))");
    }

    /** The screen row by row, {@code #} for a dark dot. */
    public String pixels() {
        return (String) browser.value(PIXELS);
    }
}
