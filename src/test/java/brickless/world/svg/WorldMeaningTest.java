package brickless.world.svg;

import static brickless.world.svg.Drawings.world;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import brickless.world.Beacon;
import brickless.world.DescriptionException;
import brickless.world.Lamp;
import brickless.world.Obstacle;
import brickless.world.Placement;
import brickless.world.Point2;
import brickless.world.Pose2;
import brickless.world.World;
import brickless.world.Zone;
import org.junit.jupiter.api.Test;

class WorldMeaningTest {
    @Test
    void pageIsTheViewBoxInMillimetres() throws DescriptionException {
        World world = SvgWorldReader.readText("a/b/table.svg",
                "<svg width='20cm' height='7' viewBox='-100 -50 2000 1500'/>");
        assertThat(world.name()).isEqualTo("table");
        assertThat(new double[] {world.minX(), world.minY(), world.width(), world.height()})
                .containsExactly(-0.1, -0.05, 2, 1.5);
    }

    @Test
    void withoutAViewBoxWidthAndHeightCount() throws DescriptionException {
        World world = SvgWorldReader.readText("w", "<svg width='210mm' height='29.7cm'/>");
        assertThat(world.width()).isEqualTo(0.21);
        assertThat(world.height()).isEqualTo(0.297);
        assertThat(SvgWorldReader.readText("w", "<svg width='800' height='600px'/>").width()).isEqualTo(0.8);
    }

    @Test
    void zonesAreNeitherSeenNorFelt() {
        World world = world("<rect data-zone='goal' x='100' y='100' width='50' height='50' fill='red'/>"
                + "<line data-zone='finish' x1='0' y1='10' x2='100' y2='10' stroke='red' stroke-width='10'/><g "
                        + "data-zone='goal'><circle r='20'/></g>");
        assertThat(world.zones()).extracting(Zone::name).containsExactly("goal", "finish", "goal");
        assertThat(world.zones().get(0).region().contains(0.149, 0.101)).isTrue();
        assertThat(world.zones().get(0).region().contains(0.151, 0.101)).isFalse();
        assertThat(world.zones().get(1).region().contains(0.05, 0.014)).isTrue();
        assertThat(world.floor()).isEmpty();
        assertThat(world.obstacles()).isEmpty();
    }

    @Test
    void zoneNeedsNoFill() {
        assertThat(world("<path data-zone='z' fill='none' d='M0,0h100v100'/>").zones().get(0).region()
                .contains(0.09, 0.05)).isTrue();
    }

    @Test
    void tableTopIsAnEdgeAndIsPaintedToo() {
        World world = world("<rect data-edge='cliff' x='100' y='100' width='800' height='600' fill='#eeddcc'/>");
        assertThat(world.table()).hasValueSatisfying(table -> {
            assertThat(table.contains(0.5, 0.5)).isTrue();
            assertThat(table.contains(0.05, 0.5)).isFalse();
        });
        assertThat(world.floor()).hasSize(1);
        assertThat(world("<rect width='5' height='5'/>").table()).isEmpty();
    }

    @Test
    void severalTablesAddUp() {
        World world = world("<g data-edge='cliff'><rect width='100' height='100'/><rect x='200' width='100' "
                + "height='100'/></g>");
        assertThat(world.table()).hasValueSatisfying(table -> {
            assertThat(table.contains(0.05, 0.05)).isTrue();
            assertThat(table.contains(0.15, 0.05)).isFalse();
            assertThat(table.contains(0.25, 0.05)).isTrue();
        });
    }

    @Test
    void beaconsAndLampsSitInTheMiddleOfTheirShapes() {
        World world = world("<circle id='b' data-beacon='3' cx='200' cy='300' r='20'/>"
                + "<rect id='l' data-lamp-lux='450.5' x='10' y='20' width='40' height='20' "
                        + "transform='translate(100,0)'/>");
        assertThat(world.beacons()).containsExactly(new Beacon("b", 3, new Point2(0.2, 0.3)));
        assertThat(world.lamps()).containsExactly(new Lamp("l", 450.5, new Point2(0.13, 0.03)));
        assertThat(world.floor()).isEmpty();
    }

    @Test
    void beaconMayAlsoBeABody() {
        World world = world("<circle id='b' data-beacon='1' data-solid='fixed' cx='200' cy='300' r='20'/>");
        assertThat(world.beacons()).extracting(Beacon::id).containsExactly("b");
        assertThat(world.obstacles()).extracting(Obstacle::id).containsExactly("b");
    }

    @Test
    void roomIsAsBrightAsTheDrawingSays() throws DescriptionException {
        assertThat(SvgWorldReader.readText("night", "<svg viewBox='0 0 9 9' data-ambient-lux='2.5'/>").ambientLux())
                .isEqualTo(2.5);
        assertThat(SvgWorldReader.readText("room", "<svg viewBox='0 0 9 9'/>").ambientLux()).isEqualTo(100);
    }

    @Test
    void drawnSymbolOfALampIsOneLamp() {
        World world = world("<defs><g id='bulb'><circle r='10'/><rect x='-5' y='10' width='10' height='10'/></g></defs>"
                + "<use href='#bulb' x='100' y='100' data-lamp-lux='300'/>");
        assertThat(world.lamps()).hasSize(1);
        assertThat(world.lamps().get(0).position().y()).isCloseTo(0.105, within(1e-12));
    }

    @Test
    void robotsStandAtTheOriginOfTheirGroupFacingItsXAxis() {
        World world = world("<defs><path id='mark' d='M0,0h10'/></defs><g transform='translate(100,200)'>"
                + "<g data-robot='a' transform='rotate(90)' data-model='../robots/sumo.svg' "
                        + "data-program='Pusher.java'><rect width='50' height='50'/></g></g>"
                + "<use data-robot='b' href='#mark' x='500' y='600'/>");
        assertThat(world.placements()).hasSize(2);
        Placement first = world.placements().get(0);
        assertThat(first.name()).isEqualTo("a");
        assertThat(first.start()).isEqualTo(new Pose2(0.1, 0.2, Math.PI / 2));
        assertThat(first.model()).contains("../robots/sumo.svg");
        assertThat(first.program()).contains("Pusher.java");
        assertThat(world.placements().get(1).start()).isEqualTo(new Pose2(0.5, 0.6, 0));
        assertThat(world.floor()).as("the mark of a robot is not paint").isEmpty();
    }

    @Test
    void drawingProgramsNamesForShapesAreIgnored() {
        assertThat(world("<rect data-name='Layer 1' width='5' height='5'/>").floor()).hasSize(1);
    }

    @Test
    void drawingIsKeptForPictures() {
        assertThat(world("<rect width='5' height='5'/>").svg())
                .isEqualTo(Drawings.worldText("<rect width='5' height='5'/>"));
    }
}
