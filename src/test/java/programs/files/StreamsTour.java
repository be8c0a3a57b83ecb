package programs.files;

import java.io.BufferedInputStream;
import java.io.BufferedReader;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.File;
import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.FileNotFoundException;
import java.io.FileOutputStream;
import java.io.FileReader;
import java.io.FileWriter;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.util.Arrays;
import java.util.Formatter;
import java.util.Scanner;
import java.util.function.Function;

/** Every way to open a file with {@code java.io}. */
public class StreamsTour {
    public static void main(String[] args) throws Exception {
        bytes();
        text();
        objects();
        missing();
        console();
        subclass();
    }

    private static void bytes() throws IOException {
        FileOutputStream raw = new FileOutputStream("data.bin");
        DataOutputStream out = new DataOutputStream(raw);
        out.writeInt(1234567);
        out.writeDouble(2.5);
        out.writeUTF("été");
        raw.getFD().sync();
        out.close();
        try (FileOutputStream more = new FileOutputStream(new File("data.bin"), true)) {
            more.write(7);
            more.write(new byte[] {8, 9});
        }
        try (FileInputStream file = new FileInputStream("data.bin");
                DataInputStream in = new DataInputStream(new BufferedInputStream(file))) {
            System.out.println("available " + file.available());
            System.out.println(in.readInt() + " " + in.readDouble() + " " + in.readUTF());
            System.out.println("rest " + in.read() + in.read() + in.read() + in.read());
        }
        try (FileInputStream in = new FileInputStream(new File("data.bin"))) {
            System.out.println("skipped " + in.skip(12) + ", then " + in.read() + ", left " + in.available());
        }
    }

    private static void text() throws Exception {
        try (PrintWriter writer = new PrintWriter("a.txt")) {
            writer.printf("%.1f %s%n", 1.25, "ä");
            writer.println(3.5);
        }
        try (PrintWriter writer = new PrintWriter(new File("b.txt"), "ISO-8859-1")) {
            writer.print("ä");
        }
        try (PrintStream stream = new PrintStream("c.txt")) {
            stream.println("printed");
        }
        try (Formatter formatter = new Formatter(new File("d.txt"))) {
            formatter.format("%d of %s", 4, "five");
        }
        System.out.println("bytes " + new File("a.txt").length() + " " + new File("b.txt").length());
        try (BufferedReader reader = new BufferedReader(new FileReader("a.txt"))) {
            System.out.println(reader.readLine() + "|" + reader.readLine() + "|" + reader.readLine());
        }
        try (Scanner scanner = new Scanner(new File("a.txt"))) {
            System.out.println(scanner.nextDouble() + " " + scanner.next() + " " + scanner.nextDouble());
        }
        try (Scanner scanner = new Scanner(new File("b.txt"), "ISO-8859-1")) {
            System.out.println(scanner.next());
        }
        System.out.println(first("c.txt") + ", " + first("d.txt"));
    }

    private static String first(String name) throws IOException {
        try (BufferedReader reader = new BufferedReader(new FileReader(new File(name)))) {
            return reader.readLine();
        }
    }

    private static void objects() throws Exception {
        File file = new File("objects.ser");
        try (ObjectOutputStream out = new ObjectOutputStream(new FileOutputStream(file))) {
            out.writeObject(new int[] {3, 1, 4});
            out.writeObject("pi");
        }
        try (ObjectInputStream in = new ObjectInputStream(new FileInputStream(file))) {
            System.out.println(Arrays.toString((int[]) in.readObject()) + " " + in.readObject());
        }
    }

    private static void missing() {
        Function<String, FileReader> opener = name -> {
            try {
                return new FileReader(name);
            } catch (FileNotFoundException e) {
                System.out.println(e.getMessage());
                return null;
            }
        };
        opener.apply("nothing.txt");
        opener.apply("/home/lejos/programs");
        opener.apply("/etc/passwd");
        try {
            new FileOutputStream("no/such/folder.txt").close();
        } catch (IOException e) {
            System.out.println(e.getMessage());
        }
        try {
            new FileOutputStream("/data.bin/x").close();
        } catch (IOException e) {
            System.out.println(e.getMessage());
        }
        try (FileInputStream in = new FileInputStream("a.txt")) {
            in.close();
            in.read();
        } catch (IOException e) {
            System.out.println(e.getMessage());
        }
    }

    private static void console() {
        PrintStream old = System.out;
        System.setOut(new PrintStream(new FileOutputStream(FileDescriptor.out), true));
        System.out.println("to the console");
        System.setOut(old);
    }

    private static void subclass() throws IOException {
        try (CsvWriter csv = new CsvWriter(new File("table.csv"))) {
            csv.row(1, 2.5, "x");
        }
        System.out.println(first("table.csv"));
    }

    /** A writer of a program's own. */
    private static final class CsvWriter extends FileWriter {
        CsvWriter(File file) throws IOException {
            super(file);
        }

        void row(Object... cells) throws IOException {
            for (int i = 0; i < cells.length; i++) {
                write((i == 0 ? "" : ";") + cells[i]);
            }
            append('\n').flush();
        }
    }
}
