package lejos.robotics.mapping;

import java.io.InputStream;
import java.util.ArrayList;
import java.util.List;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import lejos.robotics.geometry.Line;
import lejos.robotics.geometry.Rectangle;

/** Reads the {@code line} elements of an SVG drawing as a map. Transformations are not applied. */
public class SVGMapLoader {
    private static final float HIGHEST_START = 10_000;

    private final InputStream in;

    /** A loader of one map. */
    public SVGMapLoader(InputStream in) {
        this.in = in;
    }

    /**
     * The map, turned so that y points up. Its rectangle reaches from the least to the greatest coordinates.
     *
     * @throws XMLStreamException if the drawing is not well-formed
     * @throws NumberFormatException if a coordinate has a unit
     * @throws NullPointerException if a line lacks a coordinate
     */
    public LineMap readLineMap() throws XMLStreamException {
        XMLInputFactory factory = XMLInputFactory.newInstance();
        factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
        XMLStreamReader reader = factory.createXMLStreamReader(in);
        List<Line> lines = new ArrayList<>();
        while (reader.hasNext()) {
            if (reader.next() == XMLStreamConstants.START_ELEMENT && reader.getLocalName().equals("line")) {
                lines.add(new Line(
                        number(reader, "x1"), number(reader, "y1"), number(reader, "x2"), number(reader, "y2")));
            }
        }
        return new LineMap(lines.toArray(new Line[0]), extent(lines)).flip();
    }

    private static float number(XMLStreamReader reader, String attribute) {
        return Float.parseFloat(reader.getAttributeValue(null, attribute));
    }

    private static Rectangle extent(List<Line> lines) {
        float minX = HIGHEST_START;
        float minY = HIGHEST_START;
        float maxX = 0;
        float maxY = 0;
        for (Line line : lines) {
            minX = Math.min(minX, Math.min(line.x1, line.x2));
            minY = Math.min(minY, Math.min(line.y1, line.y2));
            maxX = Math.max(maxX, Math.max(line.x1, line.x2));
            maxY = Math.max(maxY, Math.max(line.y1, line.y2));
        }
        return new Rectangle(minX, minY, maxX - minX, maxY - minY);
    }
}
