package lejos.utility;

import static org.assertj.core.api.Assertions.assertThat;

import lejos.Agreement;
import org.junit.jupiter.api.Test;

class EndianToolsTest {
    @Test
    void agreesWithThePublishedClasses() {
        Agreement.check(EndianDriver.class, 200, 0, EndianDriver::play);
    }

    @Test
    void mostSignificantByteComesFirstInBigEndian() {
        byte[] bytes = {(byte) 0xff, 0x01, 0x02, 0x03};
        assertThat(EndianTools.decodeUIntBE(bytes, 0)).isEqualTo(0xff010203L);
        assertThat(EndianTools.decodeIntLE(bytes, 0)).isEqualTo(0x030201ff);
        assertThat(EndianTools.decodeShortBE(bytes, 0)).isEqualTo((short) 0xff01);
        EndianTools.encodeShortLE(0x1234, bytes, 2);
        assertThat(bytes).containsExactly(0xff, 0x01, 0x34, 0x12);
    }
}
