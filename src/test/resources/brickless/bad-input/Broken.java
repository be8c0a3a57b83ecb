import lejos.hardware.Sound;

public class Broken {
    public static void main(String[] args) {
        Sound.beep(;
    }
}
