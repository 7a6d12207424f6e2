package haltere.core.format.internal.aedat3;

import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingProblem;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * The text header of an AEDAT-3 file: lines that begin with {@code #}, up to {@code #!END-HEADER}
 * or, in files of version 3.0, up to the first byte that does not begin a line.
 *
 * @param version as written, such as 3.1; empty without a version line
 * @param format as written, empty for {@code RAW}
 * @param source name of the camera
 * @param dataOffset where the packets start
 * @param cutOff whether the file ends within the header
 */
record Aedat3Header(
    String version, String format, Optional<String> source, int dataOffset, boolean cutOff) {
  static final String VERSION = "#!AER-DAT";

  private static final int MAX_BYTES = 1024 * 1024;
  private static final String END = "#!END-HEADER";
  private static final String FORMAT = "#Format:";
  private static final Map<String, SensorGeometry> CAMERAS =
      Map.of(
          "DVS128", new SensorGeometry(128, 128),
          "DAVIS240", new SensorGeometry(240, 180),
          "DAVIS346", new SensorGeometry(346, 260),
          "DAVIS640", new SensorGeometry(640, 480),
          "DAVISRGB", new SensorGeometry(640, 480),
          "DAVISHET", new SensorGeometry(640, 480),
          "DAVIS208", new SensorGeometry(208, 192),
          "DAVIS128", new SensorGeometry(128, 128));

  static Aedat3Header read(RecordingFile file) throws IOException {
    byte[] bytes = file.read(0, MAX_BYTES);
    Aedat3Header header = parse(bytes, bytes.length == file.size());
    if (header.cutOff && bytes.length < file.size()) {
      throw new RecordingProblem(
          file.path(), MAX_BYTES, "the text header does not end; this is not an AEDAT recording");
    }
    return header;
  }

  static Aedat3Header parse(byte[] bytes, boolean whole) {
    List<String> lines = new ArrayList<>();
    int offset = 0;
    boolean cutOff = false;
    while (offset < bytes.length && bytes[offset] == '#') {
      int end = offset;
      while (end < bytes.length && bytes[end] != '\n') {
        end++;
      }
      String line = new String(bytes, offset, end - offset, StandardCharsets.ISO_8859_1).strip();
      cutOff = end == bytes.length;
      offset = Math.min(bytes.length, end + 1);
      lines.add(line);
      if (line.equals(END)) {
        break;
      }
    }
    cutOff |= offset == bytes.length && !(whole && !lines.isEmpty() && last(lines).equals(END));
    return new Aedat3Header(
        value(lines, VERSION).orElse(""),
        value(lines, FORMAT).filter(name -> !name.equalsIgnoreCase("RAW")).orElse(""),
        lines.stream()
            .filter(line -> line.matches("#Source \\d+:.*"))
            .map(line -> line.substring(line.indexOf(':') + 1).strip())
            .findFirst(),
        offset,
        cutOff);
  }

  private static String last(List<String> lines) {
    return lines.get(lines.size() - 1);
  }

  private static Optional<String> value(List<String> lines, String key) {
    return lines.stream()
        .filter(line -> line.startsWith(key))
        .map(line -> line.substring(key.length()).strip())
        .findFirst();
  }

  boolean isVersion3() {
    return version.matches("3(\\.\\d)?");
  }

  /** Whether addresses are laid out as in version 3.0. */
  boolean isOldLayout() {
    return version.equals("3.0") || version.equals("3");
  }

  /** The camera's size, with rows counted upwards. */
  Optional<SensorGeometry> size() {
    String name = source.orElse("").toUpperCase(Locale.ROOT);
    return CAMERAS.entrySet().stream()
        .filter(camera -> name.startsWith(camera.getKey()))
        .map(Map.Entry::getValue)
        .findFirst();
  }
}
