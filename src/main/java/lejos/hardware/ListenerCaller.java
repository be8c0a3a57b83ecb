package lejos.hardware;

/** Something that passes events on to listeners. */
public interface ListenerCaller {
    /**
     * Calls the listeners.
     *
     * @return what happened, as the caller defines it
     */
    int callListeners();
}
