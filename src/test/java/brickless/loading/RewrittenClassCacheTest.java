package brickless.loading;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.loading.ClassSummary.Initialisation;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** Entries fit only where the same is true about other classes, and old ones make room. */
class RewrittenClassCacheTest {
    private static final ClassSummary HARMLESS =
            new ClassSummary("java/lang/Object", List.of(), false, false, Set.of(), Set.of(), Set.of(),
                    Initialisation.HARMLESS);
    private static final ClassSummary BLOCKING =
            new ClassSummary("java/lang/Object", List.of(), false, false, Set.of(), Set.of(), Set.of(),
                    Initialisation.MAY_BLOCK);

    private final RewrittenClassCache cache = new RewrittenClassCache(100);

    @Test
    void bytesAreFoundWhereTheSameIsTrue() {
        RewrittenClass stored = new RewrittenClass(new byte[10], null);
        cache.store("key", stored, Map.of("Other", HARMLESS));
        assertThat(cache.find("key", name -> HARMLESS)).isSameAs(stored);
        assertThat(cache.find("key", name -> BLOCKING)).isNull();
        assertThat(cache.find("key", name -> null)).isNull();
        assertThat(cache.find("other key", name -> HARMLESS)).isNull();
    }

    @Test
    void theLeastRecentlyUsedEntryMakesRoom() {
        cache.store("a", new RewrittenClass(new byte[40], null), Map.of());
        cache.store("b", new RewrittenClass(new byte[40], null), Map.of());
        cache.find("a", name -> null);
        cache.store("c", new RewrittenClass(new byte[40], null), Map.of());
        assertThat(cache.find("a", name -> null)).isNotNull();
        assertThat(cache.find("b", name -> null)).isNull();
        assertThat(cache.find("c", name -> null)).isNotNull();
    }

    @Test
    void keysDependOnContent() {
        assertThat(RewrittenClassCache.key(new byte[] {1})).isNotEqualTo(RewrittenClassCache.key(new byte[] {2}))
                .hasSize(64);
    }
}
