package brickless.world.svg;

import static brickless.world.svg.Drawings.worldError;
import static brickless.world.svg.Drawings.worldText;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import brickless.world.DescriptionException;
import brickless.world.World;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Files that are broken, hostile or too large are refused with one line. */
class FileSafetyTest {
    @TempDir Path folder;

    private Path file(String name, byte[] bytes) throws IOException {
        return Files.write(folder.resolve(name), bytes);
    }

    private static String error(Path path) {
        return catchThrowableOfType(DescriptionException.class, () -> SvgWorldReader.read(path)).getMessage();
    }

    @Test
    void missingFileAndFolder() {
        assertThat(error(folder.resolve("none.svg"))).isEqualTo(folder.resolve("none.svg") + ": no such file");
        assertThat(error(folder)).isEqualTo(folder + ": cannot be read as a file");
    }

    @Test
    void emptyAndForeignFiles() throws IOException {
        assertThat(error(file("empty.svg", new byte[0]))).contains("empty.svg:1: is not well-formed XML");
        assertThat(error(file("page.svg", "<html></html>".getBytes(StandardCharsets.UTF_8))))
                .endsWith("page.svg:1: <html>: is not a drawing; the outermost element must be svg");
        assertThat(error(file("png.svg", new byte[] {(byte) 0x89, 'P', 'N', 'G', 13, 10, 26, 10})))
                .endsWith("is not valid UTF-8 text");
    }

    @Test
    void unclosedTagIsLocated() {
        assertThat(worldError("<svg viewBox='0 0 9 9'>\n<g>\n</svg>"))
                .startsWith("test.svg:3: is not well-formed XML: ").doesNotContain("\n");
    }

    @Test
    void encodingsOfTheDeclarationAreUnderstood() throws IOException, DescriptionException {
        String text = "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?><svg viewBox='0 0 9 9'><rect data-zone='Küche' "
                + "width='5' height='5'/></svg>";
        assertThat(SvgWorldReader.read(file("l.svg", text.getBytes(StandardCharsets.ISO_8859_1))).zones().get(0).name())
                .isEqualTo("Küche");
        String wide = text.replace("ISO-8859-1", "UTF-16");
        assertThat(SvgWorldReader.read(file("w.svg", wide.getBytes(StandardCharsets.UTF_16))).zones().get(0).name())
                .isEqualTo("Küche");
        String marked = "\uFEFF" + text.replace("ISO-8859-1", "UTF-8");
        assertThat(SvgWorldReader.read(file("m.svg", marked.getBytes(StandardCharsets.UTF_8))).zones().get(0).name())
                .isEqualTo("Küche");
        assertThat(error(file("k.svg", text.replace("ISO-8859-1", "KOI8-R").getBytes(StandardCharsets.US_ASCII))))
                .endsWith("k.svg:1: encoding \"koi8-r\" is not supported; allowed: UTF-8, UTF-16, ISO-8859-1, "
                        + "US-ASCII");
    }

    @Test
    void plainDoctypeIsAcceptedButDeclarationsAreNot() throws DescriptionException {
        String doctype = "<!DOCTYPE svg PUBLIC \"-//W3C//DTD SVG 1.1//EN\" "
                + "\"http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd\">";
        World world = SvgWorldReader.readText("t", doctype
                + "<svg viewBox='0 0 9 9'><rect width='5' height='5'/></svg>");
        assertThat(world.floor()).hasSize(1);
        assertThat(worldError("<!DOCTYPE svg [<!ENTITY lol \"lol\">]><svg viewBox='0 0 9 9'/>"))
                .contains("a DOCTYPE with declarations is not supported");
        assertThat(worldError("<!DOCTYPE svg [<!ENTITY x SYSTEM \"file:///etc/passwd\">]><svg viewBox='0 0 9 "
                + "9'><style>&x;</style></svg>"))
                .contains("a DOCTYPE with declarations is not supported");
        assertThat(worldError("<svg viewBox='0 0 9 9'><style>&x;</style></svg>")).startsWith("test.svg:1: ");
    }

    @Test
    void imagesOutsideTheFolderAreNotOpened() throws IOException {
        Path inner = Files.createDirectory(folder.resolve("worlds"));
        Files.write(folder.resolve("secret.png"), new byte[] {1, 2, 3});
        Files.createSymbolicLink(inner.resolve("link.png"), folder.resolve("secret.png"));
        for (String href : new String[] {"../secret.png", folder.resolve("secret.png").toString(), "file:///etc/passwd",
                "http://localhost/x.png",
            "https://example.org/x.png", "link.png", "..\\secret.png", "//host/x.png"}) {
            Path world = Files.writeString(inner.resolve("w.svg"),
                    worldText("<image href='" + href + "' width='9' height='9'/>"));
            assertThat(error(world)).as(href)
                    .matches(".*w\\.svg:2: <image>: the image .*(lies outside the drawing's folder|cannot be read); "
                            + "allowed: .*");
        }
    }

    @Test
    void deepNestingIsRefused() {
        assertThat(worldError("<svg viewBox='0 0 9 9'>" + "<g>".repeat(5_000) + "</g>".repeat(5_000) + "</svg>"))
                .isEqualTo("test.svg:1: elements are nested deeper than 80");
    }

    @Test
    void tooManyElementsAreRefused() {
        assertThat(worldError(worldText("<g/>".repeat(50_001)))).contains("more than 50000 elements");
    }

    @Test
    void multiplicationByUseIsRefused() {
        StringBuilder body = new StringBuilder("<defs><rect id='x0' width='1' height='1'/>");
        for (int i = 1; i <= 20; i++) {
            body.append("<g id='x").append(i).append("'>").append(("<use href='#x" + (i - 1) + "'/>").repeat(8))
                    .append("</g>");
        }
        assertThat(worldError(worldText(body + "</defs><use href='#x20'/>")))
                .contains("more than 200000 elements after use is expanded");
    }

    @Test
    void endlesslyFineDashesAreRefused() {
        assertThat(worldError(worldText("<line x2='1000' stroke='red' stroke-dasharray='1e-7'/>")))
                .contains("more than 1000000 points");
    }

    @Test
    void longPathIsRefused() {
        assertThat(worldError(worldText("<path d='M0,0" + " 5,5 9,0".repeat(500_001) + "'/>")))
                .contains("more than 1000000 points");
    }

    @Test
    void scriptsAndForeignElementsAreIgnored() {
        World world = Drawings.world("<script>alert(1)</script><x:thing xmlns:x='urn:x'><rect width='5' "
                + "height='5'/></x:thing>"
                + "<foreignObject><p xmlns='http://www.w3.org/1999/xhtml'>hi</p></foreignObject>");
        assertThat(world.floor()).isEmpty();
    }
}
