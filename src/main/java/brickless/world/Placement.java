package brickless.world;

import java.util.Optional;

/**
 * A robot's place in a world.
 *
 * @param name value of {@code data-robot}
 * @param start start pose
 * @param model robot file named by {@code data-model}, as written
 * @param program program named by {@code data-program}, as written
 */
public record Placement(String name, Pose2 start, Optional<String> model, Optional<String> program) {}
