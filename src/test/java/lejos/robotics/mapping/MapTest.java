package lejos.robotics.mapping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import javax.xml.stream.XMLStreamException;
import lejos.Agreement;
import lejos.robotics.geometry.Line;
import lejos.robotics.geometry.Point;
import lejos.robotics.geometry.Rectangle;
import lejos.robotics.navigation.Pose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MapTest {
    private final LineMap square = new LineMap(new Line[] {new Line(0, 0, 100, 0), new Line(100, 0, 100, 100),
        new Line(100, 100, 0, 100), new Line(0, 100, 0, 0)}, new Rectangle(0, 0, 100, 100));

    @Test
    void mapsAnswerAsThePublishedOnes() {
        Agreement.check(MapDriver.class, 2000, 5e-3, MapDriver::play);
    }

    @Test
    void rangeIsTheDistanceToTheNearestWallAhead() {
        assertThat(square.range(new Pose(30, 40, 0))).isEqualTo(70);
        assertThat(square.range(new Pose(30, 40, 180))).isCloseTo(30, within(1e-3f));
        assertThat(square.range(new Pose(130, 40, 0))).isEqualTo(-1);
    }

    @Test
    void pointsAreInsideOrNot() {
        assertThat(square.inside(new Point(50, 50))).isTrue();
        assertThat(square.inside(new Point(150, 50))).isFalse();
        assertThat(square.inside(new Point(50, -1))).isFalse();
    }

    @Test
    void rangeAndInsideAgreeInARoom() {
        Random random = new Random(5);
        for (int i = 0; i < 10_000; i++) {
            Pose pose = new Pose(1 + random.nextFloat() * 98, 1 + random.nextFloat() * 98, random.nextFloat() * 360);
            float range = square.range(pose);
            assertThat(range).as("ray " + i).isPositive();
            Point hit = pose.pointAt(range, pose.getHeading());
            double gap = Math.min(Math.min(Math.abs(hit.x), Math.abs(hit.x - 100)),
                    Math.min(Math.abs(hit.y), Math.abs(hit.y - 100)));
            assertThat(gap).as("ray " + i).isLessThan(1e-3);
        }
    }

    @Test
    void shapefileOfOnePolygonAndAPointGivesItsSides() throws IOException {
        LineMap map = new ShapefileLoader(new ByteArrayInputStream(shapefile(0x270a))).readLineMap();
        assertThat(map.getBoundingRect()).isEqualTo(new Rectangle(1, 2, 30, 40));
        assertThat(map.getLines()).hasSize(2);
        assertThat(map.getLines()[1].getP2()).isEqualTo(new Point(31, 42));
    }

    @Test
    void otherFilesAreRefused() {
        assertThatThrownBy(() -> new ShapefileLoader(new ByteArrayInputStream(shapefile(7))).readLineMap())
                .isInstanceOf(IOException.class);
    }

    private static byte[] shapefile(int code) {
        ByteBuffer file = ByteBuffer.allocate(300);
        file.putInt(code).position(36);
        file.order(ByteOrder.LITTLE_ENDIAN).putDouble(1).putDouble(2).putDouble(31).putDouble(42).position(100);
        file.order(ByteOrder.BIG_ENDIAN).putInt(1).putInt(10);
        file.order(ByteOrder.LITTLE_ENDIAN).putInt(1).putDouble(5).putDouble(6);
        file.order(ByteOrder.BIG_ENDIAN).putInt(2).putInt(48);
        file.order(ByteOrder.LITTLE_ENDIAN).putInt(5).position(file.position() + 32);
        file.putInt(1).putInt(3).putInt(0);
        file.putDouble(1).putDouble(2).putDouble(31).putDouble(2).putDouble(31).putDouble(42);
        return Arrays.copyOf(file.array(), file.position());
    }

    @Test
    void drawingCanBeReadBack(@TempDir Path folder) throws IOException, XMLStreamException {
        Path file = folder.resolve("map.svg");
        square.createSVGFile(file.toString());
        LineMap read = new SVGMapLoader(Files.newInputStream(file)).readLineMap().flip();
        assertThat(read.getLines()).hasSize(4);
        assertThat(read.getLines()[1].getP2()).isEqualTo(new Point(100, 100));
        assertThat(read.getBoundingRect()).isEqualTo(square.getBoundingRect());
    }
}
