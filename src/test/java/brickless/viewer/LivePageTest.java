package brickless.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.util.Base64;
import org.junit.jupiter.api.Test;

/** The live page as text; what it does in a browser is {@code LiveViewPageTest}'s. */
class LivePageTest {
    private static String script() {
        String page = LivePage.html();
        return page.substring(page.lastIndexOf("<script>") + 8, page.lastIndexOf("</script>"));
    }

    @Test
    void onlyItsOwnScriptRunsAndItTalksToItsOwnServerOnly() throws GeneralSecurityException {
        String hash = Base64.getEncoder()
                .encodeToString(MessageDigest.getInstance("SHA-256").digest(script().getBytes(StandardCharsets.UTF_8)));
        assertThat(LivePage.html())
                .contains("default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'sha256-" + hash
                + "'; connect-src 'self'; base-uri 'none'; form-action 'none'");
    }

    @Test
    void nothingIsLoadedFromAnywhere() {
        assertThat(LivePage.html().replace("http://www.w3.org/2000/svg", "")).doesNotContain("http:")
                .doesNotContain("https:").doesNotContain("@import");
    }

    @Test
    void noScriptMakesMarkupOfText() {
        assertThat(script()).doesNotContain("innerHTML").doesNotContain("outerHTML")
                .doesNotContain("insertAdjacentHTML").doesNotContain("document.write")
                .doesNotContain("createContextualFragment").doesNotContain("eval(");
    }

    @Test
    void noPlaceOfThePageIsLeftUnfilled() {
        assertThat(LivePage.html()).doesNotContainPattern("%[A-Z_]+%");
        assertThat(LivePage.html().split("<script", -1)).hasSize(2);
    }
}
