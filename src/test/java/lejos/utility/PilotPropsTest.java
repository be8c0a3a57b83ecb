package lejos.utility;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class PilotPropsTest {
    private static final Path FILE = Path.of(PilotProps.PERSISTENT_FILENAME);

    @AfterEach
    void tidyUp() throws IOException {
        Files.deleteIfExists(FILE);
    }

    @Test
    void valuesAreWrittenSortedAndUndatedAndReadBack() throws IOException {
        PilotProps props = new PilotProps();
        props.loadPersistentValues();
        assertThat(props).as("without a file").isEmpty();
        props.setProperty(PilotProps.KEY_WHEELDIAMETER, "4.0");
        props.setProperty(PilotProps.KEY_LEFTMOTOR, "B");
        props.storePersistentValues();
        assertThat(Files.readString(FILE)).isEqualTo("leftMotor=B\nwheelDiameter=4.0\n");
        PilotProps read = new PilotProps();
        read.loadPersistentValues();
        assertThat(read).isEqualTo(props);
    }

    @Test
    void otherLettersHaveNoMotor() {
        assertThat(PilotProps.getMotor("E")).isNull();
    }
}
