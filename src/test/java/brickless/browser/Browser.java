package brickless.browser;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.openqa.selenium.By;
import org.openqa.selenium.Keys;
import org.openqa.selenium.OutputType;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.chrome.ChromeDriver;
import org.openqa.selenium.chrome.ChromeDriverService;
import org.openqa.selenium.chrome.ChromeOptions;
import org.openqa.selenium.interactions.Actions;

/**
 * Chromium without a window, as Debian packages it. A machine without it fails the test: what a page shows cannot be
 * checked there.
 */
public final class Browser implements AutoCloseable {
    private static final String NEEDED =
            "Chromium and its driver are needed for this test: apt-get install chromium chromium-driver";
    private static final String AWAIT_OPEN =
            "const done = arguments[0]; const look = () => document.body && !['loading', undefined].includes("
            + "document.body.dataset.state) ? done(document.body.dataset.state) : setTimeout(look, 20); look();";
    private static final String AWAIT = "const done = arguments[0]; const look = () => (%s) "
            + "? requestAnimationFrame(() => done(true)) : setTimeout(look, 20); look();";

    private final ChromeDriver driver;

    /** Starts a browser of this size in CSS pixels with a fresh profile. */
    public Browser(int width, int height) {
        ChromeOptions options = new ChromeOptions();
        options.setBinary(program("chromium", "chromium-browser", "google-chrome").toFile());
        options.addArguments("--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
                "--disable-background-networking", "--disable-component-update", "--disable-sync",
                "--disable-dev-shm-usage", "--hide-scrollbars");
        ChromeDriverService service = new ChromeDriverService.Builder()
                .usingDriverExecutable(program("chromedriver").toFile()).build();
        driver = new ChromeDriver(service, options);
        driver.manage().timeouts().scriptTimeout(Duration.ofSeconds(30));
        driver.executeCdpCommand("Emulation.setDeviceMetricsOverride",
                Map.of("width", width, "height", height, "deviceScaleFactor", 1, "mobile", width < 600));
    }

    private static Path program(String... names) {
        List<String> folders = List.of(System.getenv("PATH").split(java.io.File.pathSeparator));
        return Stream.of(names).flatMap(name -> folders.stream().map(folder -> Path.of(folder, name)))
                .filter(Files::isExecutable).findFirst().orElseThrow(() -> new AssertionError(NEEDED));
    }

    /** Opens a page of ours and waits until it shows its run. */
    public void open(Path page, String fragment) {
        driver.get("about:blank");
        driver.get(page.toUri() + fragment);
        assertThat(driver.executeAsyncScript(AWAIT_OPEN)).as("state of the page").isEqualTo("ready");
    }

    /** Goes to an address and waits until the page shows its run. */
    public void visit(String address) {
        load(address);
        assertThat(driver.executeAsyncScript(AWAIT_OPEN)).as("state of the page").isEqualTo("ready");
    }

    /** Goes to an address, whatever is there. */
    public void load(String address) {
        driver.get("about:blank");
        driver.get(address);
    }

    /** Value of an expression in the page. */
    public Object value(String expression) {
        return driver.executeScript("return " + expression);
    }

    /** Waits until an expression in the page is true. */
    public void await(String expression) {
        assertThat(driver.executeAsyncScript(AWAIT.formatted(expression))).isEqualTo(true);
    }

    /** Runs statements in the page. */
    public void run(String statements) {
        driver.executeScript(statements);
    }

    /** Clicks on the first element that a selector finds. */
    public void click(String selector) {
        WebElement element = driver.findElement(By.cssSelector(selector));
        driver.executeScript("arguments[0].scrollIntoView({block: 'center'})", element);
        element.click();
    }

    /** Does what people do with mouse and keyboard. */
    public Actions hands() {
        return new Actions(driver);
    }

    /** The first element that a selector finds. */
    public WebElement element(String selector) {
        return driver.findElement(By.cssSelector(selector));
    }

    /** A picture of what is in view, PNG. */
    public byte[] picture() {
        return driver.getScreenshotAs(OutputType.BYTES);
    }

    /** Presses keys while the page itself has the focus. */
    public void keys(CharSequence... keys) {
        driver.findElement(By.tagName("body")).sendKeys(keys);
    }

    /** Presses keys with Shift held. */
    public void shifted(Keys key) {
        keys(Keys.chord(Keys.SHIFT, key));
    }

    @Override
    public void close() {
        driver.quit();
    }
}
