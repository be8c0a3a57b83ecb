package brickless.world.svg;

import brickless.world.DescriptionException;
import java.io.StringReader;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import javax.xml.stream.Location;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;

/**
 * XML text to a tree of SVG elements. Foreign namespaces (Inkscape's own, RDF) are skipped; entities are never
 * expanded.
 */
final class SvgDocumentParser {
    private static final String SVG = "http://www.w3.org/2000/svg";
    private static final String XLINK = "http://www.w3.org/1999/xlink";

    private final String file;
    private final String text;
    private final TagLines lines;
    private final Map<String, SvgElement> byId = new HashMap<>();
    private SvgElement root;
    private SvgElement current;
    private int foreignDepth;
    private int depth;
    private int elements;

    private SvgDocumentParser(String file, String text) {
        this.file = file;
        this.text = text;
        this.lines = new TagLines(text);
    }

    static SvgDocument parse(String file, Optional<Path> folder, String text) throws DescriptionException {
        SvgDocumentParser parser = new SvgDocumentParser(file, text);
        try {
            parser.run();
        } catch (XMLStreamException e) {
            throw parser.notXml(e);
        }
        return new SvgDocument(file, folder, text, parser.root, parser.byId);
    }

    private static XMLInputFactory factory() {
        XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
        factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
        factory.setProperty(XMLInputFactory.IS_REPLACING_ENTITY_REFERENCES, false);
        factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
        factory.setXMLResolver((publicId, systemId, baseUri, namespace) -> {
            throw new XMLStreamException("external entities are not read");
        });
        return factory;
    }

    private void run() throws XMLStreamException, DescriptionException {
        XMLStreamReader xml = factory().createXMLStreamReader(new StringReader(text));
        while (xml.hasNext()) {
            switch (xml.next()) {
                case XMLStreamConstants.START_ELEMENT -> start(xml);
                case XMLStreamConstants.END_ELEMENT -> end();
                case XMLStreamConstants.CHARACTERS, XMLStreamConstants.CDATA -> characters(xml.getText());
                case XMLStreamConstants.DTD, XMLStreamConstants.ENTITY_DECLARATION -> refuseDeclarations(xml);
                case XMLStreamConstants.ENTITY_REFERENCE -> throw new DescriptionException(file,
                        xml.getLocation().getLineNumber(), "",
                        "entity references are not supported; write the character itself");
                default -> { }
            }
        }
        if (root == null) {
            throw new DescriptionException(file, 0, "", "holds no svg element");
        }
    }

    private void refuseDeclarations(XMLStreamReader xml) throws DescriptionException {
        int start = text.indexOf("<!DOCTYPE");
        int end = text.indexOf('>', Math.max(start, 0));
        int bracket = text.indexOf('[', Math.max(start, 0));
        if (start < 0 || bracket >= 0 && bracket < end) {
            throw new DescriptionException(file, xml.getLocation().getLineNumber(), "",
                    "a DOCTYPE with declarations is not supported; save the drawing as plain SVG");
        }
    }

    private void start(XMLStreamReader xml) throws DescriptionException {
        int line = lines.next();
        if (++elements > Limits.ELEMENTS || ++depth > Limits.NESTING) {
            throw new DescriptionException(file, line, "", depth > Limits.NESTING ? "elements are nested deeper than "
                    + Limits.NESTING
                    : "more than " + Limits.ELEMENTS + " elements");
        }
        String namespace = xml.getNamespaceURI();
        boolean foreign = namespace != null && !namespace.isEmpty() && !namespace.equals(SVG);
        if (foreignDepth > 0 || foreign && root != null) {
            foreignDepth++;
            return;
        }
        if (root == null && (foreign || !xml.getLocalName().equals("svg"))) {
            throw new DescriptionException(file, line, "<" + xml.getLocalName() + ">",
                    "is not a drawing; the outermost element must be svg");
        }
        SvgElement element = new SvgElement(xml.getLocalName(), line, current);
        copyAttributes(xml, element);
        if (root == null) {
            root = element;
        }
        if (!element.id().isEmpty()) {
            byId.putIfAbsent(element.id(), element);
        }
        current = element;
    }

    private static void copyAttributes(XMLStreamReader xml, SvgElement element) {
        for (int i = 0; i < xml.getAttributeCount(); i++) {
            String namespace = xml.getAttributeNamespace(i);
            String name = xml.getAttributeLocalName(i);
            if (namespace == null || namespace.isEmpty()) {
                element.put(name, xml.getAttributeValue(i));
            } else if (namespace.equals(XLINK) && name.equals("href") && !element.has("href")) {
                element.put("href", xml.getAttributeValue(i));
            }
        }
    }

    private void end() {
        depth--;
        if (foreignDepth > 0) {
            foreignDepth--;
        } else {
            current = current.parent();
        }
    }

    private void characters(String characters) {
        if (foreignDepth == 0 && current != null && current.name().equals("style")) {
            current.append(characters);
        }
    }

    private DescriptionException notXml(XMLStreamException e) {
        Location location = e.getLocation();
        String message = String.valueOf(e.getMessage());
        int start = message.indexOf("Message:");
        String reason = (start < 0 ? message : message.substring(start + 8)).strip().replaceAll("\\s+", " ");
        return new DescriptionException(file, location == null ? 0 : Math.max(0, location.getLineNumber()), "",
                "is not well-formed XML: " + reason);
    }
}
