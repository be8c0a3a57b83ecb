package brickless.world.svg;

import brickless.world.DescriptionException;
import brickless.world.Placement;
import java.util.List;

/** Reads a robot's place: origin and +x direction of the group or {@code use} that carries {@code data-robot}. */
final class PlacementReader {
    private PlacementReader() {}

    static Placement read(SvgDocument document, SvgElement element, Scope scope, List<Placement> earlier)
            throws DescriptionException, MalformedValueException {
        String name = scope.meaning().name("data-robot");
        if (!element.name().equals("g") && !element.name().equals("use")) {
            throw new MalformedValueException("data-robot on <" + element.name()
                    + ">; allowed on: g, use (their transform is the start pose)");
        }
        if (scope.toPage().determinant() <= 1e-9) {
            throw new MalformedValueException("the robot " + name + " is mirrored or squeezed flat by its transform");
        }
        if (earlier.stream().anyMatch(placement -> placement.name().equals(name))) {
            throw new MalformedValueException("two robots are called " + name + "; give each its own data-robot name");
        }
        Meaning own = Meaning.none(document).with(element);
        return new Placement(name, WorldAssembler.pose(scope.toPage()), own.text("data-model"),
                own.text("data-program"));
    }
}
