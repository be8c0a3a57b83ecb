package brickless.world.svg;

import static org.assertj.core.api.Assertions.assertThat;

import brickless.world.DescriptionException;
import brickless.world.Obstacle;
import brickless.world.Point2;
import brickless.world.World;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** A drawing as Inkscape saves it: own namespaces, layers, styles as CSS, nested transforms, clones. */
class InkscapeTest {
    private static World world;

    @BeforeAll
    static void read() throws URISyntaxException, DescriptionException {
        world = SvgWorldReader.read(Path.of(InkscapeTest.class.getResource("inkscape.svg").toURI()));
    }

    @Test
    void pageIsTheViewBox() {
        assertThat(world.width()).isEqualTo(1.2);
        assertThat(world.height()).isEqualTo(0.8);
    }

    @Test
    void wallsOfTheWallLayer() {
        assertThat(world.obstacles()).extracting(Obstacle::id)
                .containsExactly("rect1021", "path2044", "path3300", "use3310");
        assertThat(world.obstacles().get(0).outlines().get(0).get(0)).isEqualTo(new Point2(0.01, 0.02));
        assertThat(world.obstacles().get(1).outlines()).as("line drawn as a wall").hasSize(2);
    }

    @Test
    void clonesAreBodiesOfTheirOwn() {
        Obstacle original = world.obstacles().get(2);
        Obstacle clone = world.obstacles().get(3);
        assertThat(clone.movable()).isTrue();
        assertThat(clone.massKilograms()).isEqualTo(0.3);
        Point2 a = original.outlines().get(0).get(0);
        Point2 b = clone.outlines().get(0).get(0);
        assertThat(b.x() - a.x()).isEqualTo(0.2, org.assertj.core.api.Assertions.within(1e-12));
    }

    @Test
    void hiddenLayerIsNotThere() {
        assertThat(world.zones()).isEmpty();
    }

    @Test
    void tapeIsPaintedInItsCssColour() {
        assertThat(world.floor()).hasSize(1);
        assertThat(world.floor().get(0).colour().red()).isEqualTo(26);
    }

    @Test
    void robotStandsWhereItsGroupIs() {
        assertThat(world.placements().get(0).start().x()).isEqualTo(0.3);
    }
}
