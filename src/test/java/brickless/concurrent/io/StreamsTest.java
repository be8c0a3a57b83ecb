package brickless.concurrent.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import brickless.concurrent.locks.Waiting;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.io.UnsupportedEncodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

@Timeout(30)
class StreamsTest {
    private static final int PIPE_SIZE = 4;

    private final ByteArrayOutputStream target = new ByteArrayOutputStream();

    private static void script(PrintStream out) throws IOException {
        out.print(true);
        out.print('c');
        out.print(1);
        out.print(2L);
        out.print(1.5f);
        out.print(2.5);
        out.print(new char[] {'x', 'y'});
        out.print("s\u00e4");
        out.print((String) null);
        out.print((Object) null);
        out.println();
        out.println(false);
        out.println('d');
        out.println(3);
        out.println(4L);
        out.println(0.25f);
        out.println(0.125);
        out.println(new char[] {'z'});
        out.println("line");
        out.println((Object) "object");
        out.printf("%d%%n %s%n", 5, "text").format(Locale.GERMANY, "%.1f|%n", 1.5);
        out.append('a').append("bc").append("defg", 1, 3).append(null);
        out.write(65);
        out.write(new byte[] {66, 67});
        out.write(new byte[] {68, 69, 70}, 1, 1);
        out.writeBytes(new byte[] {71});
        out.flush();
    }

    @Test
    void printsWhatTheJdksPrintStreamPrints() throws IOException {
        ByteArrayOutputStream expected = new ByteArrayOutputStream();
        script(new PrintStream(expected, false, StandardCharsets.UTF_8));
        script(new ProgramPrintStream(target));
        String text = expected.toString(StandardCharsets.UTF_8).replace(System.lineSeparator(), "\n");
        assertThat(target.toString(StandardCharsets.UTF_8)).isEqualTo(text).contains("5%n text\n1,5|\n");
    }

    @Test
    void encodingIsThatOfTheConstructor() throws IOException {
        new ProgramPrintStream(target, true, "ISO-8859-1").print('\u00e4');
        assertThat(target.toByteArray()).containsExactly(0xe4);
        assertThatThrownBy(() -> new ProgramPrintStream(target, true, "no such encoding"))
                .isInstanceOf(UnsupportedEncodingException.class);
        assertThatThrownBy(() -> new ProgramPrintStream((OutputStream) null)).isInstanceOf(NullPointerException.class);
    }

    @Test
    void filesAreWrittenAtOnce(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("printed.txt");
        PrintStream out = new ProgramPrintStream(file.toString(), "UTF-8");
        out.println("one");
        assertThat(Files.readString(file)).isEqualTo("one\n");
        out.close();
        assertThatThrownBy(() -> new ProgramPrintStream(folder.resolve("other").toString(), "no such encoding"))
                .isInstanceOf(UnsupportedEncodingException.class);
        assertThat(folder.resolve("other")).doesNotExist();
    }

    @Test
    void autoFlushFlushesAfterLinesAndArrays() {
        int[] flushes = new int[1];
        PrintStream out = new ProgramPrintStream(new ByteArrayOutputStream() {
            @Override
            public void flush() {
                flushes[0]++;
            }
        }, true);
        out.print("no line");
        out.write('x');
        assertThat(flushes[0]).isZero();
        out.println();
        out.print("a\nb");
        out.write('\n');
        out.write(new byte[] {1}, 0, 1);
        assertThat(flushes[0]).isEqualTo(4);
    }

    @Test
    void failuresShowInCheckErrorOnly() {
        PrintStream out = new ProgramPrintStream(new OutputStream() {
            @Override
            public void write(int b) throws IOException {
                throw b == 'i' ? new InterruptedIOException() : new IOException("full");
            }
        });
        out.write('i');
        assertThat(Thread.interrupted()).isTrue();
        assertThat(out.checkError()).isFalse();
        out.write('x');
        assertThat(out.checkError()).isTrue();
        PrintStream closed = new ProgramPrintStream(target);
        closed.close();
        closed.close();
        assertThat(closed.checkError()).isFalse();
        closed.print("late");
        assertThat(closed.checkError()).isTrue();
        assertThat(target.size()).isZero();
    }

    @Test
    void targetIsCalledWithNoOtherMonitorThanTheStreams() {
        ProgramPrintStream[] stream = new ProgramPrintStream[1];
        boolean[] held = new boolean[1];
        stream[0] = new ProgramPrintStream(new OutputStream() {
            @Override
            public void write(int b) {
                held[0] = Thread.holdsLock(stream[0]);
            }
        });
        stream[0].println("x");
        assertThat(held[0]).isTrue();
    }

    @Test
    void pipeCarriesBytesAndBlocksWhenFull() throws Exception {
        PipedInputStream in = new PipedInputStream(PIPE_SIZE);
        PipedOutputStream out = new PipedOutputStream(in);
        Waiting writer = Waiting.in(() -> {
            out.write(new byte[] {1, 2, 3, 4, -1, 6});
            out.close();
        });
        assertThat(in.available()).isEqualTo(PIPE_SIZE);
        byte[] read = new byte[10];
        int count = in.read(read, 0, 4);
        writer.ends();
        count += in.read(read, count, 6);
        assertThat(count).isEqualTo(6);
        assertThat(read).startsWith(1, 2, 3, 4, -1, 6);
        assertThat(in.read()).isEqualTo(-1);
        assertThat(in.read(read, 0, 0)).isZero();
    }

    @Test
    void readerWaitsForTheWriter() throws Exception {
        PipedReader in = new PipedReader();
        PipedWriter out = new PipedWriter(in);
        Waiting reader = Waiting.in(() -> assertThat(in.read()).isEqualTo('\u00e4'));
        out.write('\u00e4');
        reader.ends();
        assertThatThrownBy(() -> out.write('b')).hasMessage("Read end dead");
    }

    @Test
    void readerIsReadyWhenThereIsSomethingToRead() throws IOException {
        PipedReader in = new PipedReader();
        PipedWriter out = new PipedWriter(in);
        assertThat(in.ready()).isFalse();
        out.write("bcd");
        assertThat(in.ready()).isTrue();
        char[] two = new char[2];
        assertThat(in.read(two)).isEqualTo(2);
        assertThat(two).containsExactly('b', 'c');
        assertThat(in.ready()).isTrue();
    }

    @Test
    void unconnectedClosedAndBrokenPipesAreErrors() throws Exception {
        assertThatThrownBy(new PipedInputStream()::read).isInstanceOf(IOException.class);
        assertThatThrownBy(() -> new PipedOutputStream().write(1)).isInstanceOf(IOException.class);
        assertThatThrownBy(() -> new PipedInputStream(0)).isInstanceOf(IllegalArgumentException.class);
        PipedInputStream in = new PipedInputStream();
        PipedOutputStream out = new PipedOutputStream(in);
        assertThatThrownBy(() -> in.connect(out)).isInstanceOf(IOException.class);
        assertThatThrownBy(() -> in.connect(new PipedOutputStream())).isInstanceOf(IOException.class);
        Waiting.started(() -> out.write(1)).ends();
        assertThat(in.read()).isEqualTo(1);
        assertThatThrownBy(in::read).hasMessage("Write end dead");
        in.close();
        assertThatThrownBy(() -> out.write(2)).hasMessage("Pipe closed");
        assertThat(in.available()).isZero();
    }

    @Test
    void interruptEndsTheWaitAtAPipe() throws InterruptedException {
        PipedInputStream in = new PipedInputStream();
        Waiting reader = Waiting.in(() -> {
            new PipedOutputStream(in);
            in.read();
        });
        assertThat(reader.interrupted().outcome()).isInstanceOf(InterruptedIOException.class);
    }
}
