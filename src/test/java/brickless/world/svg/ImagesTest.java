package brickless.world.svg;

import static brickless.world.svg.Drawings.world;
import static brickless.world.svg.Drawings.worldError;
import static brickless.world.svg.Drawings.worldText;
import static org.assertj.core.api.Assertions.assertThat;

import brickless.world.DescriptionException;
import brickless.world.Floor;
import brickless.world.World;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ImagesTest {
    @TempDir Path folder;

    /** Four by two pixels: red, lime, blue, grey 100 above; white, black, half-transparent red or red, yellow below. */
    private static byte[] mat(int type, String format) {
        BufferedImage image = new BufferedImage(4, 2, type);
        int[] pixels = {0xFFFF0000, 0xFF00FF00, 0xFF0000FF, 0xFF646464, 0xFFFFFFFF, 0xFF000000, 0x80FF0000, 0xFFFFFF00};
        for (int i = 0; i < pixels.length; i++) {
            image.setRGB(i % 4, i / 4, pixels[i]);
        }
        return encoded(image, format);
    }

    private static byte[] encoded(BufferedImage image, String format) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try {
            assertThat(ImageIO.write(image, format, out)).isTrue();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return out.toByteArray();
    }

    private static String data(byte[] bytes) {
        return "data:image/png;base64," + Base64.getEncoder().encodeToString(bytes);
    }

    private static String image(byte[] bytes, String rest) {
        return "<image href='" + data(bytes) + "' " + rest + "/>";
    }

    private static int colour(World world, double xMillimetres, double yMillimetres) {
        return new Floor(world).rgbAt(xMillimetres / 1000, yMillimetres / 1000);
    }

    @Test
    void pixelsLieWhereTheyAreDrawn() {
        World world = world(image(mat(BufferedImage.TYPE_INT_ARGB, "png"), "x='100' y='100' width='400' height='200'"));
        assertThat(colour(world, 101, 101)).isEqualTo(0xFF0000);
        assertThat(colour(world, 199, 199)).isEqualTo(0xFF0000);
        assertThat(colour(world, 201, 199)).isEqualTo(0x00FF00);
        assertThat(colour(world, 301, 150)).isEqualTo(0x0000FF);
        assertThat(colour(world, 450, 150)).isEqualTo(0x646464);
        assertThat(colour(world, 250, 250)).isEqualTo(0x000000);
        assertThat(colour(world, 450, 299)).isEqualTo(0xFFFF00);
        assertThat(colour(world, 450, 301)).isEqualTo(0xFFFFFF);
        assertThat(colour(world, 99, 150)).isEqualTo(0xFFFFFF);
    }

    @Test
    void transparentPixelsLetTheFloorShow() {
        World world = world("<rect width='1000' height='1000' fill='blue'/>"
                + image(mat(BufferedImage.TYPE_INT_ARGB, "png"), "width='400' height='200'"));
        assertThat(colour(world, 250, 150)).isEqualTo(0x80007F);
    }

    @Test
    void imagesTurnAndScaleWithTheirGroup() {
        World world = world("<g transform='translate(500,0) rotate(90)'>"
                + image(mat(BufferedImage.TYPE_INT_RGB, "png"), "width='400' height='200'") + "</g>");
        assertThat(colour(world, 450, 50)).isEqualTo(0xFF0000);
        assertThat(colour(world, 450, 150)).isEqualTo(0x00FF00);
        assertThat(colour(world, 350, 50)).isEqualTo(0xFFFFFF);
        assertThat(colour(world, 350, 350)).isEqualTo(0xFFFF00);
    }

    @Test
    void proportionsAreKeptUnlessTheDrawingSaysOtherwise() {
        byte[] mat = mat(BufferedImage.TYPE_INT_RGB, "png");
        World kept = world(image(mat, "width='400' height='400'"));
        assertThat(colour(kept, 50, 50)).isEqualTo(0xFFFFFF);
        assertThat(colour(kept, 50, 150)).isEqualTo(0xFF0000);
        World stretched = world(image(mat, "width='400' height='400' preserveAspectRatio='none'"));
        assertThat(colour(stretched, 50, 50)).isEqualTo(0xFF0000);
        World sliced = world(image(mat, "width='200' height='200' preserveAspectRatio='xMinYMid slice'"));
        assertThat(colour(sliced, 150, 50)).isEqualTo(0x00FF00);
        assertThat(colour(sliced, 250, 50)).isEqualTo(0xFFFFFF);
    }

    @Test
    void greyLevelsAreTakenAsStored() {
        BufferedImage grey = new BufferedImage(1, 1, BufferedImage.TYPE_BYTE_GRAY);
        grey.getRaster().setSample(0, 0, 0, 100);
        assertThat(colour(world(image(encoded(grey, "png"), "width='90' height='90'")), 50, 50)).isEqualTo(0x646464);
        BufferedImage fine = new BufferedImage(1, 1, BufferedImage.TYPE_USHORT_GRAY);
        fine.getRaster().setSample(0, 0, 0, 0xC8FF);
        assertThat(colour(world(image(encoded(fine, "png"), "width='90' height='90'")), 50, 50)).isEqualTo(0xC8C8C8);
    }

    @ParameterizedTest
    @ValueSource(ints = {BufferedImage.TYPE_3BYTE_BGR, BufferedImage.TYPE_4BYTE_ABGR, BufferedImage.TYPE_BYTE_INDEXED,
            BufferedImage.TYPE_INT_RGB})
    void pureColoursSurviveEveryStorageKind(int type) {
        World world = world(image(mat(type, "png"), "width='400' height='200'"));
        assertThat(colour(world, 50, 50)).isEqualTo(0xFF0000);
        assertThat(colour(world, 150, 50)).isEqualTo(0x00FF00);
        assertThat(colour(world, 350, 150)).isEqualTo(0xFFFF00);
    }

    @Test
    void fileBesideTheDrawing() throws IOException, DescriptionException {
        Files.createDirectory(folder.resolve("mats"));
        Files.write(folder.resolve("mats/my mat.png"), mat(BufferedImage.TYPE_INT_RGB, "png"));
        Path file = Files.writeString(folder.resolve("w.svg"),
                worldText("<image href='mats/my%20mat.png' width='400' height='200'/>"));
        assertThat(colour(SvgWorldReader.read(file), 50, 50)).isEqualTo(0xFF0000);
    }

    @Test
    void jpegIsReadNearly() {
        BufferedImage flat = new BufferedImage(16, 16, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < 256; i++) {
            flat.setRGB(i % 16, i / 16, 0xFFC86432);
        }
        int rgb = colour(world(image(encoded(flat, "jpg"), "width='160' height='160'")), 80, 80);
        assertThat(Math.abs((rgb >> 16) - 0xC8) + Math.abs((rgb >> 8 & 255) - 0x64) + Math.abs((rgb & 255) - 0x32))
                .isLessThan(12);
    }

    @Test
    void brokenImagesAreLocatedErrors() {
        byte[] cut = java.util.Arrays.copyOf(mat(BufferedImage.TYPE_INT_RGB, "png"), 40);
        assertThat(worldError(worldText(image(cut, "id='mat' width='9' height='9'"))))
                .isEqualTo("test.svg:2: mat: the image is damaged and cannot be decoded");
        assertThat(worldError(worldText(image("GIF89a......".getBytes(java.nio.charset.StandardCharsets.US_ASCII),
                "width='9' height='9'"))))
                .endsWith("the image is neither PNG nor JPEG; allowed: PNG, JPEG");
        assertThat(worldError(worldText("<image href='data:image/png,abc' width='9' height='9'/>")))
                .contains("the embedded image is not base64");
        assertThat(worldError(worldText("<image href='mat.png' width='9' height='9'/>")))
                .contains("cannot be found from a drawing that is not a file");
    }

    @Test
    void hugeImageIsRefusedBeforeItIsDecoded() {
        byte[] png = mat(BufferedImage.TYPE_INT_RGB, "png");
        java.nio.ByteBuffer.wrap(png).putInt(16, 40_000).putInt(20, 40_000);
        java.util.zip.CRC32 crc = new java.util.zip.CRC32();
        crc.update(png, 12, 17);
        java.nio.ByteBuffer.wrap(png).putInt(29, (int) crc.getValue());
        assertThat(worldError(worldText(image(png, "width='9' height='9'"))))
                .contains("the image has 40000 x 40000 pixels; allowed: up to 16000000");
    }
}
