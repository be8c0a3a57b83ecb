package brickless.device.panel;

import brickless.hardware.ScreenFont;
import brickless.hardware.ScreenSocket;

/** Draws the name of a layer in large letters on a cleared band in the middle of a picture. */
final class LayerCaption {
    private LayerCaption() {}

    static void draw(String name, byte[] picture) {
        ScreenFont font = ScreenFont.large();
        int top = (ScreenSocket.HEIGHT - font.height()) / 2;
        int left = Math.max(0, (ScreenSocket.WIDTH - name.length() * font.width()) / 2);
        for (int y = 0; y < font.height(); y++) {
            for (int x = 0; x < ScreenSocket.WIDTH; x++) {
                int column = Math.floorDiv(x - left, font.width());
                boolean ink = column >= 0 && column < name.length()
                        && font.ink(name.charAt(column), x - left - column * font.width(), y);
                put(picture, x, top + y, ink);
            }
        }
    }

    private static void put(byte[] picture, int x, int y, boolean ink) {
        int index = y * ScreenSocket.ROW_BYTES + (x >> 3);
        int bit = 1 << (x & 7);
        picture[index] = (byte) (ink ? picture[index] | bit : picture[index] & ~bit);
    }
}
