package brickless.world.svg;

import static brickless.world.svg.Drawings.outline;
import static brickless.world.svg.Drawings.outlines;
import static brickless.world.svg.Drawings.world;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import brickless.world.Obstacle;
import brickless.world.Rgb;
import brickless.world.World;
import java.util.List;
import org.junit.jupiter.api.Test;

class SolidsTest {
    private static final String FRAME = "d='M0,0h100v60h-100z M20,20v20h60v-20z'";

    private static double area(World world) {
        return world.obstacles().get(0).outlines().stream().mapToDouble(Drawings::area).sum();
    }

    @Test
    void lineAroundAFilledSolidDoesNotMakeItLarger() {
        assertThat(outline("<rect data-solid='fixed' width='10' height='10' stroke='black' stroke-width='8'/>"))
                .isEqualTo("0,0 10,0 10,10 0,10");
    }

    @Test
    void frameWithAHoleIsCutIntoPiecesWithoutHoles() {
        World world = world("<path data-solid='fixed' fill-rule='evenodd' " + FRAME + "/>");
        assertThat(world.obstacles().get(0).outlines()).hasSize(2);
        assertThat(area(world)).isCloseTo(100 * 60 - 60 * 20, within(1e-6));
    }

    @Test
    void nonZeroRuleMakesAHoleOnlyOfARingThatRunsTheOtherWay() {
        assertThat(area(world("<path data-solid='fixed' " + FRAME + "/>"))).isCloseTo(4800, within(1e-6));
        assertThat(outline("<path data-solid='fixed' d='M0,0h100v60h-100z M20,20h60v20h-60z'/>"))
                .isEqualTo("0,0 100,0 100,60 0,60");
    }

    @Test
    void islandInAHoleIsPartOfTheBody() {
        World world = world("<path data-solid='fixed' fill-rule='evenodd' d='M0,0h100v100h-100z M10,10h80v80h-80z "
                + "M40,40h20v20h-20z'/>");
        assertThat(area(world)).isCloseTo(10_000 - 6_400 + 400, within(1e-6));
    }

    @Test
    void groupHandsItsMeaningToEveryShape() {
        World world = world("<g data-solid='movable' data-mass-kg='0.5' data-height-mm='40' data-friction='0.2' "
                + "data-sound-absorbing='true'>"
                + "<rect id='a' width='10' height='10'/><g><circle id='b' cx='50' cy='50' r='9'/></g></g>");
        assertThat(world.obstacles()).extracting(Obstacle::id).containsExactly("a", "b");
        assertThat(world.obstacles()).allSatisfy(one -> {
            assertThat(one.movable()).isTrue();
            assertThat(one.massKilograms()).isEqualTo(0.5);
            assertThat(one.heightMetres()).isEqualTo(0.04);
            assertThat(one.friction()).isEqualTo(0.2);
            assertThat(one.soundAbsorbing()).isTrue();
        });
    }

    @Test
    void defaultsOfASolid() {
        Obstacle box = world("<rect data-solid='movable' width='200' height='100' fill='#ff8000'/>").obstacles().get(0);
        assertThat(box.heightMetres()).isEqualTo(0.1);
        assertThat(box.massKilograms()).as("0.2 m x 0.1 m x 0.1 m at 100 kg per cubic metre")
                .isCloseTo(0.2, within(1e-12));
        assertThat(box.friction()).isEqualTo(0.5);
        assertThat(box.soundAbsorbing()).isFalse();
        assertThat(box.colour()).isEqualTo(new Rgb(255, 128, 0));
        assertThat(box.id()).isEqualTo("rect-line-2");
    }

    @Test
    void solidsAreNotPaintOnTheFloor() {
        assertThat(world("<rect data-solid='fixed' width='10' height='10' fill='red' stroke='blue'/>").floor())
                .isEmpty();
    }

    @Test
    void useOfAGroupIsOneBodyAndCopiesHaveIdsOfTheirOwn() {
        World world = world("<defs><g id='can' data-solid='movable'><rect width='20' height='20' fill='teal'/><rect "
                + "x='30' width='20' height='20'/>"
                + "<circle data-solid='none' cx='10' cy='10' r='4' fill='white'/></g></defs>"
                + "<use href='#can' x='100'/><use id='second' href='#can' x='200' y='5'/><use id='third' href='#can' "
                        + "y='300'/>");
        assertThat(world.obstacles()).extracting(Obstacle::id).containsExactly("use-line-2", "second", "third");
        assertThat(world.obstacles().get(1).outlines().stream().map(Drawings::text))
                .containsExactly("200,5 220,5 220,25 200,25", "230,5 250,5 250,25 230,25");
        assertThat(world.obstacles().get(1).colour()).isEqualTo(new Rgb(0, 128, 128));
        assertThat(world.floor()).as("decoration on a body is not on the floor").isEmpty();
    }

    @Test
    void groupThatSaysSoIsOneBody() {
        List<String> outlines = outlines(
                "<g id='t' data-body='one' data-solid='movable'><rect width='10' height='30'/><rect x='10' "
                        + "width='10' height='10'/></g>");
        assertThat(outlines).containsExactly("0,0 10,0 10,30 0,30", "10,0 20,0 20,10 10,10");
    }

    @Test
    void anElementsOwnMeaningReplacesThatOfItsGroups() {
        World world = world("<g data-solid='fixed'><rect width='10' height='10'/><rect data-zone='yard' width='5' "
                + "height='5'/>"
                + "<rect data-solid='none' width='5' height='5'/></g>");
        assertThat(world.obstacles()).hasSize(1);
        assertThat(world.zones()).hasSize(1);
        assertThat(world.floor()).hasSize(1);
    }

    @Test
    void hiddenThingsDoNotExist() {
        World world = world("<rect data-solid='fixed' width='9' height='9' display='none'/><g "
                + "style='display:none'><rect width='9' height='9'/></g>"
                + "<g visibility='hidden'><rect width='9' height='9'/><rect id='seen' visibility='visible' width='9' "
                        + "height='9'/></g>");
        assertThat(world.obstacles()).isEmpty();
        assertThat(world.floor()).hasSize(1);
        assertThat(world.floor().get(0).id()).isEqualTo("seen");
    }
}
