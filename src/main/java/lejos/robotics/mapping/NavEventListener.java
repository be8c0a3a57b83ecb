package lejos.robotics.mapping;

/** Told what a PC asks of a robot. */
public interface NavEventListener {
    /** The PC has connected. */
    void whenConnected();

    /** The PC has sent an event, which is about to be dealt with. */
    void eventReceived(NavigationModel.NavEvent navEvent);
}
