import lejos.utility.Delay;

public class Thrower {
    public static void main(String[] args) {
        Delay.msDelay(1500);
        int[] nothing = new int[0];
        System.out.println(nothing[1]);
    }
}
