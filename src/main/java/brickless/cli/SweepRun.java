package brickless.cli;

/** One run of a sweep: a world as {@code --world} takes it, and a seed. */
record SweepRun(String world, long seed) {}
