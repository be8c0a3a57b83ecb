package programs.passing.host;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.util.Scanner;

/**
 * System.in, out and err are the robot's console and can be redirected by the program.
 *
 * @input 12 apples
 * @input last
 * @expected exited 0
 * @prints 12 of apples
 * @prints last
 * @prints captured: hidden
 * @prints error
 */
public class Console {
    public static void main(String[] args) {
        Scanner scanner = new Scanner(System.in);
        System.out.println(scanner.nextInt() + " of " + scanner.next());
        scanner.nextLine();
        System.out.println(scanner.nextLine());
        PrintStream console = System.out;
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        System.setOut(new PrintStream(bytes));
        System.out.print("hidden");
        System.setOut(console);
        System.out.println("captured: " + bytes);
        System.err.println("error");
    }
}
