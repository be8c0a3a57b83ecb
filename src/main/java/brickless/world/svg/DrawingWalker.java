package brickless.world.svg;

import brickless.world.DescriptionException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

/** Walks a drawing in painting order, resolving groups, {@code use}, nested viewports, transforms and styles. */
final class DrawingWalker {
    /** Elements that draw nothing themselves, or only decoration that no sensor sees (text). */
    private static final Set<String> NOT_DRAWN = Set.of("defs", "symbol", "clipPath", "mask", "marker", "pattern",
            "linearGradient", "radialGradient", "meshgradient", "hatch", "style", "title", "desc", "metadata", "script",
            "text", "filter", "foreignObject", "view", "cursor", "font", "font-face", "animate", "animateMotion",
            "animateTransform", "set", "animateColor", "color-profile", "solidcolor", "solidColor");
    private static final Set<String> CONTAINERS = Set.of("g", "a", "svg", "use", "switch");

    private final SvgDocument document;
    private final StyleResolver styles;
    private final Viewport viewport;
    private final PointBudget budget = new PointBudget();
    private final Deque<SvgElement> expanding = new ArrayDeque<>();

    DrawingWalker(SvgDocument document, Viewport viewport) throws DescriptionException {
        this.document = document;
        this.viewport = viewport;
        StyleSheet sheet = StyleSheet.of(document);
        this.styles = new StyleResolver(sheet, new PaintServers(document, sheet), viewport);
    }

    /** Visits everything below the outermost element. */
    void walk(DrawingVisitor visitor) throws DescriptionException {
        SvgElement root = document.root();
        try {
            Style style = styles.resolve(Style.INITIAL, root);
            children(root, new Scope(Affine.IDENTITY, style, Meaning.none(document).with(root)), visitor);
        } catch (MalformedValueException e) {
            throw document.error(root, e.getMessage());
        }
    }

    /** All shapes below an element that {@code enter} was called for. */
    List<DrawnShape> shapesWithin(SvgElement element, Scope scope) throws DescriptionException {
        List<DrawnShape> shapes = new ArrayList<>();
        inside(element, scope, new DrawingVisitor() {
            @Override
            public boolean enter(SvgElement inner, Scope innerScope) {
                return false;
            }

            @Override
            public void shape(DrawnShape shape) {
                shapes.add(shape);
            }
        });
        return shapes;
    }

    /** Visits what an element holds: children of a group, target of a {@code use}, or the shape itself. */
    void inside(SvgElement element, Scope scope, DrawingVisitor visitor) throws DescriptionException {
        try {
            switch (element.name()) {
                case "g", "a" -> children(element, scope, visitor);
                case "switch" -> firstDrawn(element, scope, visitor);
                case "svg" -> nested(element, element, scope, visitor);
                case "use" -> use(element, scope, visitor);
                default -> shape(element, scope, visitor);
            }
        } catch (MalformedValueException e) {
            throw document.error(element, e.getMessage());
        }
    }

    /** What a {@code use} refers to. */
    SvgElement target(SvgElement use) throws DescriptionException {
        String href = use.attributes().getOrDefault("href", "");
        if (!href.startsWith("#")) {
            throw document.error(use, "use refers to \"" + LengthParser.shortened(href)
                    + "\"; allowed: #id of an element in the same drawing");
        }
        SvgElement target = document.byId().get(href.substring(1));
        if (target == null) {
            throw document.error(use, "use refers to " + LengthParser.shortened(href) + ", but no element has this id"
                    + Suggestion.nearest(href.substring(1), document.byId().keySet()));
        }
        return target;
    }

    private void visit(SvgElement element, Scope parent, DrawingVisitor visitor) throws DescriptionException {
        if (NOT_DRAWN.contains(element.name())) {
            return;
        }
        if (!CONTAINERS.contains(element.name()) && !ShapeGeometry.SHAPES.contains(element.name())) {
            throw unknownElement(element);
        }
        try {
            budget.visit();
            Scope scope = scope(element, parent);
            if (!scope.style().displayed() || visitor.enter(element, scope)) {
                return;
            }
            inside(element, scope, visitor);
        } catch (MalformedValueException e) {
            throw document.error(element, e.getMessage());
        }
    }

    private Scope scope(SvgElement element, Scope parent) throws MalformedValueException {
        Affine toPage = parent.toPage();
        if (element.has("transform")) {
            toPage = toPage.then(TransformParser.parse(element.attribute("transform")));
        }
        if (element.name().equals("use")) {
            toPage = toPage.then(Affine.translate(viewport.x(element, "x", 0), viewport.y(element, "y", 0)));
        }
        if (!toPage.isFinite() || Math.abs(toPage.e()) > Limits.COORDINATE || Math.abs(toPage.f()) > Limits.COORDINATE
                || toPage.greatestScale() > Limits.COORDINATE) {
            throw new MalformedValueException("its transforms lead out of range");
        }
        return new Scope(toPage, styles.resolve(parent.style(), element), parent.meaning().with(element));
    }

    private void children(SvgElement element, Scope scope, DrawingVisitor visitor) throws DescriptionException {
        for (SvgElement child : element.children()) {
            visit(child, scope, visitor);
        }
    }

    private void firstDrawn(SvgElement element, Scope scope, DrawingVisitor visitor) throws DescriptionException {
        for (SvgElement child : element.children()) {
            if (!NOT_DRAWN.contains(child.name()) && !child.has("requiredExtensions")) {
                visit(child, scope, visitor);
                return;
            }
        }
    }

    private void use(SvgElement element, Scope scope, DrawingVisitor visitor)
            throws DescriptionException, MalformedValueException {
        SvgElement target = target(element);
        if (expanding.contains(target) || expanding.size() >= Limits.NESTING) {
            throw new MalformedValueException("use of #" + target.id() + " leads back to itself");
        }
        expanding.push(target);
        if (target.name().equals("symbol")) {
            Scope inner = scope(target, scope);
            if (inner.style().displayed()) {
                nested(target, element, inner, visitor);
            }
        } else {
            visit(target, scope, visitor);
        }
        expanding.pop();
    }

    /**
     * A symbol or inner svg: its viewBox is fitted into the size given by {@code sized}. Nothing is cut off at its
     * edge.
     */
    private void nested(SvgElement element, SvgElement sized, Scope scope, DrawingVisitor visitor)
            throws DescriptionException, MalformedValueException {
        boolean symbol = element != sized;
        double x = symbol ? 0 : viewport.x(element, "x", 0);
        double y = symbol ? 0 : viewport.y(element, "y", 0);
        Affine placed = Affine.translate(x, y);
        if (element.has("viewBox")) {
            double w = size(element, sized, "width", viewport.width());
            double h = size(element, sized, "height", viewport.height());
            placed = ViewBox.parse(element.attribute("viewBox"))
                    .fitInto(x, y, w, h, element.attributes().getOrDefault("preserveAspectRatio", "xMidYMid meet"));
        }
        children(element, scope.moved(placed), visitor);
    }

    private double size(SvgElement element, SvgElement sized, String attribute, double reference)
            throws MalformedValueException {
        double first = viewport.size(sized, attribute, reference);
        double second = Double.isNaN(first) ? viewport.size(element, attribute, reference) : first;
        return Double.isNaN(second) ? reference : second;
    }

    private void shape(SvgElement element, Scope scope, DrawingVisitor visitor)
            throws DescriptionException, MalformedValueException {
        if (scope.style().visible()) {
            double scale = scope.toPage().greatestScale();
            double tolerance = scale > 0 ? Limits.FLATNESS_MILLIMETRES / scale : 1;
            visitor.shape(new DrawnShape(element, scope, ShapeGeometry.of(element, viewport, tolerance, budget),
                    tolerance, budget));
        }
    }

    private DescriptionException unknownElement(SvgElement element) {
        Set<String> known = new TreeSet<>(ShapeGeometry.SHAPES);
        known.addAll(CONTAINERS);
        return document.error(element, "<" + element.name() + "> is not an element that can be drawn"
                + Suggestion.nearest(element.name(), known)
                + "; allowed: " + String.join(", ", known));
    }
}
