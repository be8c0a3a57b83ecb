package lejos.hardware.device;

/** Something that sends infrared messages to a LEGO RCX brick. */
public interface IRTransmitter {
    /** Sends the first {@code len} bytes as they are. */
    void sendBytes(byte[] data, int len);

    /** Sends a packet: adds header, complements and checksum. */
    void sendPacket(byte[] packet);

    /** Sends a command of the RCX's remote control. */
    void sendRemoteCommand(int msg);

    /** Starts a program of the RCX, 1 to 5. */
    void runProgram(int programNumber);

    /** Runs a motor of the RCX forward for a step; 0 to 2 for A to C. */
    void forwardStep(int id);

    /** Runs a motor of the RCX backward for a step; 0 to 2 for A to C. */
    void backwardStep(int id);

    /** Makes the RCX beep. */
    void beep();

    /** Stops all programs of the RCX. */
    void stopAllPrograms();
}
