package programs.files;

import java.io.EOFException;
import java.io.IOException;
import java.io.RandomAccessFile;

/** A table in a file that is read and written anywhere. */
public class RandomAccess {
    public static void main(String[] args) throws IOException {
        try (RandomAccessFile table = new RandomAccessFile("table.bin", "rw")) {
            for (int i = 0; i < 5; i++) {
                table.writeInt(i * i);
                table.writeDouble(i / 2.0);
            }
            table.seek(3 * 12);
            System.out.println(table.readInt() + " " + table.readDouble() + " at " + table.getFilePointer() + " of "
                    + table.length());
            table.seek(12);
            table.writeInt(-1);
            table.seek(table.length());
            table.writeBytes("line\r\nnext\n");
            table.writeUTF("ü");
            table.writeChars("xy");
            table.seek(12);
            System.out.println(table.readInt() + " " + table.skipBytes(44) + " " + table.readLine() + " "
                    + table.readLine()
                    + " " + table.readUTF() + " " + table.readChar() + table.readChar() + " " + table.read());
            table.setLength(6);
            table.seek(4);
            System.out.println(table.length() + " " + table.readShort());
            table.readInt();
        } catch (EOFException e) {
            System.out.println("end of file");
        }
        try (RandomAccessFile table = new RandomAccessFile("table.bin", "r")) {
            table.write(1);
        } catch (IOException | RuntimeException e) {
            System.out.println(e.getClass().getSimpleName());
        }
        try {
            new RandomAccessFile("absent", "r").close();
        } catch (IOException e) {
            System.out.println(e.getMessage());
        }
    }
}
