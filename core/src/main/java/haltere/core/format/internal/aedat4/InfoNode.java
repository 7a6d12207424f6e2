package haltere.core.format.internal.aedat4;

import haltere.core.event.SampleKind;
import haltere.core.event.SensorGeometry;
import haltere.core.format.internal.compression.DamagedPacketException;
import java.io.StringReader;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;

/** The description of streams in a file's header: nested nodes with attributes, as XML. */
final class InfoNode {
  private static final int MAX_DEPTH = 64;
  private static final int MAX_STREAMS = 1024;
  private static final int MAX_SIDE = 32 * 1024;
  private static final String METADATA = "metadata";

  /** Names and descriptions of DV for its outputs. */
  private static final Map<String, String> OUTPUTS =
      Map.of(
          Aedat4Stream.EVENTS, "events",
          SamplePayload.FRAME, "frames",
          SamplePayload.INERTIAL, "imu",
          SamplePayload.TRIGGERS, "triggers");

  private static final Map<String, String> DESCRIPTIONS =
      Map.of(
          Aedat4Stream.EVENTS, "Array of events (polarity ON/OFF).",
          SamplePayload.FRAME, "Standard frame.",
          SamplePayload.INERTIAL, "Inertial Measurement Unit data samples.",
          SamplePayload.TRIGGERS, "External triggers and special signals.");

  private InfoNode() {}

  /**
   * Reads the streams; external entities and document types are rejected.
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
          // comments are ignored
        }
      }
    }
  }

  /** The path is: the document, outInfo, number of the stream, and perhaps info or metadata. */
  private static void note(
      List<String> path, String key, String value, Map<Integer, Map<String, String>> found) {
    String inside = path.size() == 4 ? path.get(3) : "";
    boolean known = inside.equals("info") || inside.equals(METADATA);
    if (path.size() != 3 && !known || !path.get(1).equals("outInfo")) {
      return;
    }
    String number = path.get(2);
    if (!number.matches("\\d{1,9}") || found.size() >= MAX_STREAMS) {
      return;
    }
    found
        .computeIfAbsent(Integer.parseInt(number), id -> new TreeMap<>())
        .put(known ? inside + "/" + key : key, value);
  }

  private static Aedat4Stream stream(int id, Map<String, String> attributes) {
    return new Aedat4Stream(
        id,
        attributes.getOrDefault("typeIdentifier", ""),
        side(attributes.get("info/sizeX")),
        side(attributes.get("info/sizeY")),
        Optional.ofNullable(attributes.get("originalModuleName")),
        Optional.ofNullable(attributes.get("info/source")),
        metadata(attributes));
  }

  private static Map<String, String> metadata(Map<String, String> attributes) {
    String prefix = METADATA + "/";
    Map<String, String> metadata = new TreeMap<>();
    attributes.forEach(
        (key, value) -> {
          if (key.startsWith(prefix)) {
            metadata.put(key.substring(prefix.length()), value);
          }
        });
    return metadata;
  }

  private static int side(String text) {
    if (text == null || !text.strip().matches("\\d{1,5}")) {
      return 0;
    }
    int side = Integer.parseInt(text.strip());
    return side <= MAX_SIDE ? side : 0;
  }

  /** The description of a stream of events and of sample streams, as in DV. */
  static String of(
      String compression,
      SensorGeometry sensor,
      String source,
      Map<String, String> metadata,
      Set<SampleKind> samples) {
    StringBuilder xml = new StringBuilder();
    xml.append("<dv version=\"2.0\">\n");
    xml.append("    <node name=\"outInfo\" path=\"/mainloop/Recorder/outInfo/\">\n");
    startStream(xml, 0, compression, Aedat4Stream.EVENTS);
    info(xml, 0, Optional.of(sensor), source);
    if (!metadata.isEmpty()) {
      xml.append("            <node name=\"metadata\"");
      xml.append(" path=\"/mainloop/Recorder/outInfo/0/metadata/\">\n");
      new TreeMap<>(metadata).forEach((key, value) -> attribute(xml, 4, key, "string", value));
      xml.append("            </node>\n");
    }
    xml.append("        </node>\n");
    for (SampleKind kind : new TreeSet<>(samples)) {
      int id = SamplePackets.stream(kind);
      startStream(xml, id, compression, SamplePackets.type(kind));
      info(xml, id, kind == SampleKind.FRAME ? Optional.of(sensor) : Optional.empty(), source);
      xml.append("        </node>\n");
    }
    xml.append("    </node>\n</dv>\n");
    return xml.toString();
  }

  private static void startStream(StringBuilder xml, int id, String compression, String type) {
    xml.append("        <node name=\"").append(id);
    xml.append("\" path=\"/mainloop/Recorder/outInfo/").append(id).append("/\">\n");
    attribute(xml, 3, "compression", "string", compression);
    attribute(xml, 3, "originalModuleName", "string", "haltere");
    attribute(xml, 3, "originalOutputName", "string", OUTPUTS.get(type));
    attribute(xml, 3, "typeDescription", "string", DESCRIPTIONS.get(type));
    attribute(xml, 3, "typeIdentifier", "string", type);
  }

  private static void info(
      StringBuilder xml, int id, Optional<SensorGeometry> size, String source) {
    xml.append("            <node name=\"info\"");
    xml.append(" path=\"/mainloop/Recorder/outInfo/").append(id).append("/info/\">\n");
    size.ifPresent(
        sensor -> {
          attribute(xml, 4, "sizeX", "int", Integer.toString(sensor.width()));
          attribute(xml, 4, "sizeY", "int", Integer.toString(sensor.height()));
        });
    attribute(xml, 4, "source", "string", source);
    attribute(xml, 4, "tsOffset", "long", "0");
    xml.append("            </node>\n");
  }

  private static void attribute(
      StringBuilder xml, int depth, String key, String type, String value) {
    xml.append("    ".repeat(depth)).append("<attr key=\"");
    escape(xml, key);
    xml.append("\" type=\"").append(type).append("\">");
    escape(xml, value);
    xml.append("</attr>\n");
  }

  /** Characters that XML does not allow become a question mark. */
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
