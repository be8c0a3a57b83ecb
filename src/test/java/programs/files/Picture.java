package programs.files;

import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import javax.imageio.ImageIO;

/** Draws a picture into a file and reads it. */
public class Picture {
    public static void main(String[] args) throws IOException {
        File file = new File("picture.png");
        BufferedImage drawn = new BufferedImage(3, 2, BufferedImage.TYPE_INT_RGB);
        drawn.setRGB(2, 1, 0xff0000);
        boolean written = ImageIO.write(drawn, "png", file);
        BufferedImage read = ImageIO.read(file);
        System.out.println(written + " " + read.getWidth() + " by " + read.getHeight() + ", red "
                + Integer.toHexString(read.getRGB(2, 1) & 0xffffff));
    }
}
