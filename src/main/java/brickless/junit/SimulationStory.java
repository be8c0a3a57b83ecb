package brickless.junit;

/** Carries the story of a run into the report of a failed test; not an error of its own. */
final class SimulationStory extends RuntimeException {
    private static final long serialVersionUID = 1L;

    SimulationStory(String story) {
        super(story, null, false, false);
    }

    @Override
    public String toString() {
        return getMessage();
    }
}
