package programs.students;

import java.util.Random;
import lejos.hardware.Button;
import lejos.hardware.Sound;
import lejos.hardware.ev3.LocalEV3;
import lejos.hardware.lcd.Font;
import lejos.hardware.lcd.GraphicsLCD;
import lejos.hardware.lcd.Image;
import lejos.utility.Delay;

/** A ball between three walls and a paddle that LEFT and RIGHT move. */
public class Pong {
    static final GraphicsLCD g = LocalEV3.get().getGraphicsLCD();
    static final int W = g.getWidth(), H = g.getHeight(), PADDLE = 60, SIZE = 7;

    int x, y, dx = 3, dy = 4, paddle = W / 2 - PADDLE / 2, hits, frames;
    boolean lost;
    final Image ball = Image.createImage(SIZE, SIZE);

    Pong(Random random) {
        x = 20 + random.nextInt(W - 40);
        y = 30;
        ball.getGraphics().fillArc(0, 0, SIZE - 1, SIZE - 1, 0, 360);
    }

    void move() {
        x += dx;
        y += dy;
        if (x < 1 || x > W - SIZE - 1) {
            dx = -dx;
            x += dx;
        }
        if (y < 14) {
            dy = -dy;
            y += dy;
        }
        if (y > H - SIZE - 8) {
            if (x + SIZE >= paddle && x <= paddle + PADDLE) {
                dy = -Math.abs(dy);
                hits++;
                Sound.playTone(800, 10, 20);
            } else {
                lost = y > H;
            }
        }
    }

    void steer() {
        int keys = Button.getButtons();
        if ((keys & Button.ID_LEFT) != 0) {
            paddle = Math.max(0, paddle - 6);
        } else if ((keys & Button.ID_RIGHT) != 0) {
            paddle = Math.min(W - PADDLE, paddle + 6);
        } else {
            paddle = Math.max(0, Math.min(W - PADDLE, x - PADDLE / 2));
        }
    }

    void draw() {
        g.clear();
        g.drawString("hits " + hits, 2, 2, GraphicsLCD.TOP | GraphicsLCD.LEFT);
        g.drawLine(0, 12, W - 1, 12);
        g.drawRect(0, 12, W - 1, H - 13);
        g.drawImage(ball, x, y, 0);
        g.fillRect(paddle, H - 6, PADDLE, 4);
        g.refresh();
    }

    public static void main(String[] args) {
        g.setAutoRefresh(false);
        g.setFont(Font.getSmallFont());
        Pong game = new Pong(new Random(7));
        while (!game.lost && game.frames < 200 && Button.ESCAPE.isUp()) {
            game.steer();
            game.move();
            game.draw();
            game.frames++;
            Delay.msDelay(20);
        }
        System.err.println(game.lost ? "lost" : "still playing after " + game.frames);
        g.setFont(Font.getLargeFont());
        g.drawString("END", W / 2, H / 2, GraphicsLCD.HCENTER | GraphicsLCD.BASELINE, true);
        g.refresh();
    }
}
