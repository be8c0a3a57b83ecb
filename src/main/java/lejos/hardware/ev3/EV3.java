package lejos.hardware.ev3;

import lejos.hardware.Brick;

/** An EV3 brick. */
public interface EV3 extends Brick {}
