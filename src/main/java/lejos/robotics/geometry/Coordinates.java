package lejos.robotics.geometry;

/** Hash codes that agree with equality by coordinates, in which the two zeros are one. */
final class Coordinates {
    private Coordinates() {}

    static int hash(double... coordinates) {
        int hash = 1;
        for (double coordinate : coordinates) {
            hash = 31 * hash + Double.hashCode(coordinate + 0.0);
        }
        return hash;
    }
}
