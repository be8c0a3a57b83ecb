package brickless.world.svg;

import java.awt.image.BufferedImage;
import java.awt.image.ComponentSampleModel;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Iterator;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.MemoryCacheImageInputStream;

/**
 * Decoded pixels, 0xAARRGGBB. Grey and RGB samples are taken as stored, without colour management, so that PNG decodes
 * to the same numbers everywhere; JPEG may differ by a step between Java versions.
 */
record ImagePixels(int width, int height, int[] argb) {
    static ImagePixels decode(byte[] bytes) throws MalformedValueException {
        Iterator<ImageReader> readers = ImageIO.getImageReadersByFormatName(format(bytes));
        if (!readers.hasNext()) {
            throw new MalformedValueException("this Java installation cannot read " + format(bytes) + " images");
        }
        ImageReader reader = readers.next();
        try {
            reader.setInput(new MemoryCacheImageInputStream(new ByteArrayInputStream(bytes)), true, true);
            refuseHuge(reader.getWidth(0), reader.getHeight(0));
            return of(reader.read(0));
        } catch (IOException | RuntimeException e) {
            throw new MalformedValueException("the image is damaged and cannot be decoded");
        } finally {
            reader.dispose();
        }
    }

    private static String format(byte[] bytes) throws MalformedValueException {
        if (bytes.length > 8 && (bytes[0] & 0xFF) == 0x89 && bytes[1] == 'P' && bytes[2] == 'N' && bytes[3] == 'G') {
            return "png";
        }
        if (bytes.length > 3 && (bytes[0] & 0xFF) == 0xFF && (bytes[1] & 0xFF) == 0xD8) {
            return "jpeg";
        }
        throw new MalformedValueException("the image is neither PNG nor JPEG; allowed: PNG, JPEG");
    }

    private static void refuseHuge(int width, int height) throws MalformedValueException {
        if ((long) width * height > Limits.IMAGE_PIXELS) {
            throw new MalformedValueException("the image has " + width + " x " + height + " pixels; allowed: up to "
                    + Limits.IMAGE_PIXELS
                    + " pixels (1 pixel per millimetre is plenty)");
        }
    }

    private static ImagePixels of(BufferedImage image) {
        int width = image.getWidth();
        int height = image.getHeight();
        int[] argb = new int[width * height];
        boolean indexed = image.getColorModel() instanceof IndexColorModel;
        Raster raster = image.getRaster();
        int bands = raster.getNumBands();
        boolean plain = !indexed && raster.getSampleModel() instanceof ComponentSampleModel;
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                argb[y * width + x] = plain ? samples(raster, bands, x, y) : image.getRGB(x, y);
            }
        }
        return new ImagePixels(width, height, argb);
    }

    private static int samples(Raster raster, int bands, int x, int y) {
        int first = sample(raster, x, y, 0);
        boolean grey = bands <= 2;
        int green = grey ? first : sample(raster, x, y, 1);
        int blue = grey ? first : sample(raster, x, y, 2);
        int alpha = bands == 2 || bands == 4 ? sample(raster, x, y, bands - 1) : 255;
        return alpha << 24 | first << 16 | green << 8 | blue;
    }

    /** A sample scaled to 0 to 255. */
    private static int sample(Raster raster, int x, int y, int band) {
        int bits = raster.getSampleModel().getSampleSize(band);
        int value = raster.getSample(x, y, band);
        return bits == 8 ? value : bits > 8 ? value >> bits - 8 : value * 255 / ((1 << bits) - 1);
    }
}
