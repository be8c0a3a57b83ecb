import lejos.hardware.ev3.LocalEV3;
import lejos.hardware.lcd.Font;
import lejos.hardware.lcd.GraphicsLCD;
import lejos.hardware.lcd.Image;
import lejos.hardware.lcd.TextLCD;

/** Draws with every operation of the graphics display, in a grid of pictures. */
public class Drawing {
    private static final GraphicsLCD G = LocalEV3.get().getGraphicsLCD();
    private static final byte[] ARROW = {0x10, 0x30, 0x7f, (byte) 0xff, 0x7f, 0x30, 0x10, 0x00};

    public static void main(String[] args) {
        text();
        lines();
        rectangles();
        arcs();
        images();
        rasters();
        copies();
        G.refresh();
    }

    private static void text() {
        G.setFont(Font.getLargeFont());
        G.drawString("Ag", 0, 0, GraphicsLCD.LEFT | GraphicsLCD.TOP);
        G.setFont(Font.getDefaultFont());
        G.drawString("Medium", 42, 0, 0);
        G.setFont(Font.getSmallFont());
        G.drawString("Small|", 104, 16, GraphicsLCD.RIGHT | GraphicsLCD.TOP);
        G.drawSubstring("a substring", 2, 3, 104, 8, 0);
        G.drawChar('X', 128, 0, GraphicsLCD.HCENTER | GraphicsLCD.TOP);
        G.drawChars(new char[] {'c', 'h', 'a', 'r'}, 0, 4, 106, 24, GraphicsLCD.LEFT | GraphicsLCD.BOTTOM);
        G.drawString("inverse", 42, 24, 0, true);
        G.drawString("base", 104, 31, GraphicsLCD.LEFT | GraphicsLCD.BASELINE);
        TextLCD grid = LocalEV3.get().getTextLCD(Font.getSmallFont());
        grid.drawString("grid", 24, 0);
        grid.drawChar('C', 24, 1);
        grid.drawInt(42, 4, 25, 1);
    }

    private static void lines() {
        for (int i = 0; i <= 30; i += 6) {
            G.drawLine(0, 36, 30, 36 + i);
        }
        G.setStrokeStyle(GraphicsLCD.DOTTED);
        G.drawLine(0, 70, 30, 70);
        G.drawLine(0, 72, 30, 80);
        G.drawRect(0, 84, 20, 10);
        G.drawArc(22, 82, 14, 14, 0, 360);
        G.setStrokeStyle(GraphicsLCD.SOLID);
        for (int i = 0; i < 16; i++) {
            G.setPixel(2 * i, 98 + i % 4, 1);
        }
        G.setPixel(0, 70, G.getPixel(1, 70));
    }

    private static void rectangles() {
        G.drawRect(36, 36, 24, 12);
        G.fillRect(38, 38, 21, 9);
        G.setColor(GraphicsLCD.WHITE);
        G.fillRect(42, 40, 13, 5);
        G.setColor(GraphicsLCD.BLACK);
        G.drawRoundRect(36, 52, 24, 16, 10, 10);
        G.translate(40, 56);
        G.drawRect(0, 0, 16, 8);
        G.drawLine(0, 0, 16, 8);
        G.translate(-40, -56);
        G.drawRect(36, 72, 24, 0);
        G.drawRect(48, 74, 0, 6);
    }

    private static void arcs() {
        G.drawArc(66, 36, 28, 28, 0, 360);
        G.drawArc(70, 40, 20, 20, 0, 90);
        G.fillArc(70, 40, 20, 20, 180, 90);
        G.fillArc(66, 68, 28, 28, 30, 300);
        G.setColor(255, 255, 255);
        G.fillArc(78, 74, 6, 6, 0, 360);
        G.setColor(0, 0, 0);
        G.drawArc(36, 84, 26, 12, 0, -270);
    }

    private static void images() {
        Image arrow = new Image(8, 8, ARROW);
        int[] transforms = {GraphicsLCD.TRANS_NONE, GraphicsLCD.TRANS_MIRROR, GraphicsLCD.TRANS_ROT90, GraphicsLCD.TRANS_ROT180,
            GraphicsLCD.TRANS_ROT270, GraphicsLCD.TRANS_MIRROR_ROT90, GraphicsLCD.TRANS_MIRROR_ROT180, GraphicsLCD.TRANS_MIRROR_ROT270};
        for (int i = 0; i < transforms.length; i++) {
            G.drawRegion(arrow, 0, 0, 8, 8, transforms[i], 100 + 10 * (i % 4), 36 + 10 * (i / 4), 0);
        }
        Image picture = Image.createImage(20, 14);
        GraphicsLCD onPicture = picture.getGraphics();
        onPicture.drawRect(0, 0, 19, 13);
        onPicture.fillArc(4, 2, 9, 9, 0, 360);
        G.drawImage(picture, 142, 36, 0);
        G.drawImage(Image.createImage(picture, 4, 2, 10, 10, GraphicsLCD.TRANS_NONE), 170, 43, GraphicsLCD.HCENTER | GraphicsLCD.VCENTER);
    }

    private static void rasters() {
        int[] operations = {GraphicsLCD.ROP_CLEAR, GraphicsLCD.ROP_AND, GraphicsLCD.ROP_ANDREVERSE, GraphicsLCD.ROP_COPY,
            GraphicsLCD.ROP_ANDINVERTED, GraphicsLCD.ROP_NOOP, GraphicsLCD.ROP_XOR, GraphicsLCD.ROP_OR, GraphicsLCD.ROP_NOR,
            GraphicsLCD.ROP_EQUIV, GraphicsLCD.ROP_INVERT, GraphicsLCD.ROP_ORREVERSE, GraphicsLCD.ROP_COPYINVERTED,
            GraphicsLCD.ROP_ORINVERTED, GraphicsLCD.ROP_NAND, GraphicsLCD.ROP_SET};
        for (int i = 0; i < operations.length; i++) {
            int x = 100 + 9 * (i % 8);
            int y = 58 + 10 * (i / 8);
            G.fillRect(x, y, 8, 4);
            G.bitBlt(ARROW, 8, 8, 0, 0, x, y, 8, 8, operations[i]);
        }
        Image arrow = new Image(8, 8, ARROW);
        G.drawRegionRop(arrow, 0, 0, 8, 8, 100, 80, 0, GraphicsLCD.ROP_COPYINVERTED);
        G.drawRegionRop(arrow, 0, 0, 8, 8, GraphicsLCD.TRANS_ROT90, 112, 80, 0, GraphicsLCD.ROP_COPY);
        byte[] memory = new byte[8];
        G.bitBlt(ARROW, 8, 8, 0, 0, memory, 8, 8, 2, 0, 6, 8, GraphicsLCD.ROP_COPY);
        G.drawImage(new Image(8, 8, memory), 124, 80, 0);
    }

    private static void copies() {
        G.copyArea(0, 0, 40, 30, 0, 104, 0);
        G.copyArea(66, 36, 30, 30, 140, 96, GraphicsLCD.HCENTER | GraphicsLCD.TOP);
        G.copyArea(0, 104, 40, 24, 50, 104, 0);
        G.drawRect(0, 0, G.getWidth() - 1, G.getHeight() - 1);
    }
}
