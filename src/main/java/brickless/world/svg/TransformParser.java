package brickless.world.svg;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/** Reads a {@code transform} attribute. */
final class TransformParser {
    private static final Set<String> NAMES = Set.of("matrix", "translate", "scale", "rotate", "skewX", "skewY");

    private TransformParser() {}

    static Affine parse(String text) throws MalformedValueException {
        NumberScanner in = new NumberScanner(text);
        Affine result = Affine.IDENTITY;
        in.skipSeparator();
        if (text.strip().equals("none")) {
            return result;
        }
        while (!in.atEnd()) {
            result = result.then(one(in));
            in.skipSeparator();
        }
        if (!result.isFinite()) {
            throw new MalformedValueException("transform is out of range");
        }
        return result;
    }

    private static Affine one(NumberScanner in) throws MalformedValueException {
        int start = in.position();
        String name = in.word();
        if (!NAMES.contains(name)) {
            throw new MalformedValueException("transform: " + in.quoteFrom(start)
                    + " is not known; allowed: matrix, translate, scale, rotate, skewX, skewY");
        }
        List<Double> n = arguments(in);
        int count = n.size();
        boolean fits = switch (name) {
            case "matrix" -> count == 6;
            case "rotate" -> count == 1 || count == 3;
            case "skewX", "skewY" -> count == 1;
            default -> count == 1 || count == 2;
        };
        if (!fits) {
            throw new MalformedValueException("transform: " + name + " with " + count + " numbers");
        }
        return switch (name) {
            case "matrix" -> new Affine(n.get(0), n.get(1), n.get(2), n.get(3), n.get(4), n.get(5));
            case "translate" -> Affine.translate(n.get(0), count == 2 ? n.get(1) : 0);
            case "scale" -> Affine.scale(n.get(0), count == 2 ? n.get(1) : n.get(0));
            case "rotate" -> count == 1 ? Affine.rotate(n.get(0))
                    : Affine.translate(n.get(1), n.get(2)).then(Affine.rotate(n.get(0)))
                            .then(Affine.translate(-n.get(1), -n.get(2)));
            case "skewX" -> Affine.skewX(n.get(0));
            default -> Affine.skewY(n.get(0));
        };
    }

    private static List<Double> arguments(NumberScanner in) throws MalformedValueException {
        List<Double> numbers = new ArrayList<>();
        in.skipSpace();
        if (in.peek() != '(') {
            throw new MalformedValueException("transform: ( is expected at " + in.quoteFrom(in.position()));
        }
        in.take();
        in.skipSpace();
        while (in.numberAhead() && numbers.size() < 7) {
            numbers.add(in.number());
            in.skipSeparator();
        }
        if (in.peek() != ')') {
            throw new MalformedValueException("transform: ) is expected at " + in.quoteFrom(in.position()));
        }
        in.take();
        return numbers;
    }
}
