package lejos.remote.nxt;

/** A connection to read from and write to. */
public interface StreamConnection extends InputConnection, OutputConnection {}
