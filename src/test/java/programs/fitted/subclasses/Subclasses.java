package programs.fitted.subclasses;

/** Motors, sensors and the pilot are classes of the program. */
public class Subclasses {
    public static void main(String[] args) {
        Drive drive = new Drive();
        Eye eye = new Eye();
        drive.travel(40);
        drive.rotate(90);
        drive.travel(20);
        System.out.println(eye.red() > 0.5f ? "white" : "black");
    }
}
