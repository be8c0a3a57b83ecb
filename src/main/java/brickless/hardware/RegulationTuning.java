package brickless.hardware;

/**
 * Constants of the tracking loop, in percent duty per degree of error (proportional) and per control period.
 *
 * @param moveP proportional gain while moving
 * @param moveI integral gain while moving
 * @param moveD differential gain while moving
 * @param holdP proportional gain while holding
 * @param holdI integral gain while holding
 * @param holdD differential gain while holding
 * @param offsetPercent duty added in the direction of motion to overcome friction, 0 to 100
 */
public record RegulationTuning(float moveP, float moveI, float moveD, float holdP, float holdI, float holdD,
        float offsetPercent) {}
