package haltere.core.format.aedat4;

import haltere.core.format.packed.DamagedPacketException;
import java.io.StringReader;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;

/** The description of streams in a file's header: nested nodes with attributes, as XML. */
final class InfoNode {
  private static final int MAX_DEPTH = 64;
  private static final int MAX_STREAMS = 1024;
  private static final int MAX_SIDE = 32 * 1024;

  private InfoNode() {}

  /**
   * Reads the streams; external entities and document types are refused.
   *
   * @return in order of their numbers
   */
  static List<Aedat4Stream> parse(String xml) throws DamagedPacketException {
    XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
    factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
    factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
    factory.setProperty(XMLInputFactory.IS_COALESCING, true);
    factory.setXMLResolver(
        (publicId, systemId, baseUri, namespace) -> {
          throw new XMLStreamException("no external entities");
        });
    Map<Integer, Map<String, String>> found = new TreeMap<>();
    try {
      XMLStreamReader reader = factory.createXMLStreamReader(new StringReader(xml));
      try {
        read(reader, found);
      } finally {
        reader.close();
      }
    } catch (XMLStreamException | RuntimeException e) {
      throw new DamagedPacketException("no XML: " + e.getMessage());
    }
    List<Aedat4Stream> streams = new ArrayList<>();
    found.forEach((id, attributes) -> streams.add(stream(id, attributes)));
    return streams;
  }

  private static void read(XMLStreamReader reader, Map<Integer, Map<String, String>> found)
      throws XMLStreamException {
    Deque<String> path = new ArrayDeque<>();
    String key = null;
    StringBuilder text = new StringBuilder();
    while (reader.hasNext()) {
      switch (reader.next()) {
        case XMLStreamConstants.START_ELEMENT -> {
          if (path.size() >= MAX_DEPTH) {
            throw new XMLStreamException("nodes within nodes within nodes");
          }
          String name = reader.getAttributeValue(null, "name");
          boolean attribute = reader.getLocalName().equals("attr");
          key = attribute ? reader.getAttributeValue(null, "key") : null;
          text.setLength(0);
          path.addLast(attribute || name == null ? "" : name);
        }
        case XMLStreamConstants.CHARACTERS, XMLStreamConstants.CDATA ->
            text.append(reader.getText());
        case XMLStreamConstants.END_ELEMENT -> {
          path.removeLast();
          if (key != null) {
            note(List.copyOf(path), key, text.toString(), found);
            key = null;
          }
        }
        default -> {
          // Comments and the like say nothing.
        }
      }
    }
  }

  /** The path is: the document, outInfo, number of the stream, and perhaps info. */
  private static void note(
      List<String> path, String key, String value, Map<Integer, Map<String, String>> found) {
    boolean info = path.size() == 4 && path.get(3).equals("info");
    if (path.size() != 3 && !info || !path.get(1).equals("outInfo")) {
      return;
    }
    String number = path.get(2);
    if (!number.matches("\\d{1,9}") || found.size() >= MAX_STREAMS) {
      return;
    }
    found
        .computeIfAbsent(Integer.parseInt(number), id -> new TreeMap<>())
        .put(info ? "info/" + key : key, value);
  }

  private static Aedat4Stream stream(int id, Map<String, String> attributes) {
    return new Aedat4Stream(
        id,
        attributes.getOrDefault("typeIdentifier", ""),
        side(attributes.get("info/sizeX")),
        side(attributes.get("info/sizeY")),
        Optional.ofNullable(attributes.get("originalModuleName")),
        Optional.ofNullable(attributes.get("info/source")));
  }

  private static int side(String text) {
    if (text == null || !text.strip().matches("\\d{1,5}")) {
      return 0;
    }
    int side = Integer.parseInt(text.strip());
    return side <= MAX_SIDE ? side : 0;
  }

  /** Writes the description of one stream of events, as DV does. */
  static String ofEvents(
      String compression, int width, int height, String source, Map<String, String> metadata) {
    StringBuilder xml = new StringBuilder();
    xml.append("<dv version=\"2.0\">\n");
    xml.append("    <node name=\"outInfo\" path=\"/mainloop/Recorder/outInfo/\">\n");
    xml.append("        <node name=\"0\" path=\"/mainloop/Recorder/outInfo/0/\">\n");
    attribute(xml, 3, "compression", "string", compression);
    attribute(xml, 3, "originalModuleName", "string", "haltere");
    attribute(xml, 3, "originalOutputName", "string", "events");
    attribute(xml, 3, "typeDescription", "string", "Array of events (polarity ON/OFF).");
    attribute(xml, 3, "typeIdentifier", "string", Aedat4Stream.EVENTS);
    xml.append("            <node name=\"info\"");
    xml.append(" path=\"/mainloop/Recorder/outInfo/0/info/\">\n");
    attribute(xml, 4, "sizeX", "int", Integer.toString(width));
    attribute(xml, 4, "sizeY", "int", Integer.toString(height));
    attribute(xml, 4, "source", "string", source);
    attribute(xml, 4, "tsOffset", "long", "0");
    xml.append("            </node>\n");
    if (!metadata.isEmpty()) {
      xml.append("            <node name=\"metadata\"");
      xml.append(" path=\"/mainloop/Recorder/outInfo/0/metadata/\">\n");
      new TreeMap<>(metadata).forEach((key, value) -> attribute(xml, 4, key, "string", value));
      xml.append("            </node>\n");
    }
    xml.append("        </node>\n    </node>\n</dv>\n");
    return xml.toString();
  }

  private static void attribute(
      StringBuilder xml, int depth, String key, String type, String value) {
    xml.append("    ".repeat(depth)).append("<attr key=\"");
    escape(xml, key);
    xml.append("\" type=\"").append(type).append("\">");
    escape(xml, value);
    xml.append("</attr>\n");
  }

  /** What XML cannot hold at all becomes a question mark. */
  private static void escape(StringBuilder xml, String text) {
    text.codePoints()
        .forEach(
            c -> {
              switch (c) {
                case '<' -> xml.append("&lt;");
                case '>' -> xml.append("&gt;");
                case '&' -> xml.append("&amp;");
                case '"' -> xml.append("&quot;");
                default -> {
                  boolean allowed =
                      c >= 0x20 && c <= 0xD7FF || c >= 0xE000 && c <= 0xFFFD || c >= 0x10000;
                  xml.appendCodePoint(allowed ? c : c == '\n' || c == '\t' ? ' ' : '?');
                }
              }
            });
  }
}
