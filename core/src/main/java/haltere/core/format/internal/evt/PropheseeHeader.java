package haltere.core.format.internal.evt;

import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingProblem;
import haltere.core.format.internal.decoding.HeaderText;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The text header of Prophesee's RAW and DAT files: lines {@code % key value} up to the line {@code
 * % end} or the first that does not begin with a percent sign. A line is text that ends in a line
 * feed, which distinguishes it from data that begin with a percent sign.
 *
 * @param keys values by key in lower case; the first of several lines of a key
 * @param dataOffset start of the data
 * @param cutOff whether the file ends within a line
 */
public record PropheseeHeader(Map<String, String> keys, int dataOffset, boolean cutOff) {
  private static final int TYPICAL_BYTES = 64 * 1024;

  /** Maximum length of a header. */
  private static final int MAX_HEADER = 1024 * 1024;

  private static final int MAX_LINE = 4096;
  private static final Pattern SIZE = Pattern.compile("(\\d{1,5})x(\\d{1,5})");
  private static final Pattern OPTION = Pattern.compile("(\\w+)\\s*=\\s*(\\w+)");

  /**
   * A size stated in a header.
   *
   * @param width columns
   * @param height rows
   */
  public record Size(int width, int height) {}

  /** Copies the keys. */
  public PropheseeHeader {
    keys = Map.copyOf(keys);
  }

  /**
   * A header to be written.
   *
   * @return without lines
   */
  public static HeaderText text() {
    return new HeaderText("% ", "\n");
  }

  /**
   * Adds metadata of a recording to a header, in the order of the keys.
   *
   * @param text the header
   * @param metadata by key; spaces in keys become underscores
   * @param ownKeys keys that the format writes itself, which are skipped
   */
  public static void addMetadata(
      HeaderText text, Map<String, String> metadata, Set<String> ownKeys) {
    new TreeMap<>(metadata)
        .forEach(
            (name, value) -> {
              String key = name.strip().replaceAll("\\s+", "_");
              if (!key.isEmpty() && !ownKeys.contains(key.toLowerCase(Locale.ROOT))) {
                text.line(key + " " + value);
              }
            });
  }

  /**
   * Reads a header.
   *
   * @param bytes the start of a file
   * @param whole whether that is the whole file
   * @return the header; without lines if there is none
   */
  public static PropheseeHeader parse(byte[] bytes, boolean whole) {
    Map<String, String> keys = new TreeMap<>();
    int offset = 0;
    while (offset < bytes.length && bytes[offset] == '%') {
      int end = offset;
      while (end < bytes.length && end - offset < MAX_LINE && isText(bytes[end])) {
        end++;
      }
      if (end == bytes.length && whole) {
        return new PropheseeHeader(keys, end, true);
      }
      if (end == bytes.length || bytes[end] != '\n') {
        break;
      }
      String line =
          new String(bytes, offset + 1, end - offset - 1, StandardCharsets.ISO_8859_1).strip();
      offset = end + 1;
      int space = line.indexOf(' ');
      String key = (space < 0 ? line : line.substring(0, space)).toLowerCase(Locale.ROOT);
      if (key.equals("end") && space < 0) {
        break;
      }
      keys.putIfAbsent(key, space < 0 ? "" : line.substring(space + 1).strip());
    }
    return new PropheseeHeader(keys, offset, false);
  }

  private static boolean isText(byte value) {
    return value < 0 || value >= ' ' && value != 0x7f || value == '\t' || value == '\r';
  }

  /**
   * Reads the header of a file.
   *
   * @param file any file
   * @return the header; without lines if there is none
   * @throws RecordingProblem if it has no end
   * @throws IOException if the file cannot be read
   */
  public static PropheseeHeader of(RecordingFile file) throws IOException {
    byte[] bytes = file.read(0, TYPICAL_BYTES);
    if (parse(bytes, false).dataOffset() >= TYPICAL_BYTES - MAX_LINE) {
      bytes = file.read(0, MAX_HEADER);
    }
    PropheseeHeader header = parse(bytes, bytes.length >= file.size());
    if (header.dataOffset() > MAX_HEADER - MAX_LINE) {
      throw new RecordingProblem(
          file.path(), MAX_HEADER, "the text header does not end; this is not a recording");
    }
    return header;
  }

  /**
   * The value of a key.
   *
   * @param key in lower case
   * @return its text, or empty if there is no such line
   */
  public Optional<String> value(String key) {
    return Optional.ofNullable(keys.get(key));
  }

  /**
   * An option of the line {@code format}, such as {@code height} in {@code EVT3;height=720}.
   *
   * @param name in lower case
   * @return its value, or empty if there is no such option
   */
  public Optional<String> formatOption(String name) {
    Matcher option = OPTION.matcher(value("format").orElse("").toLowerCase(Locale.ROOT));
    while (option.find()) {
      if (option.group(1).equals(name)) {
        return Optional.of(option.group(2));
      }
    }
    return Optional.empty();
  }

  /**
   * The size of the sensor: options of the line {@code format}, else {@code geometry}, else the
   * lines {@code width} and {@code height}. It may be wrong.
   *
   * @return the stated size, or empty if there is none
   */
  public Optional<Size> size() {
    Optional<Size> fromOptions = size(formatOption("width"), formatOption("height"));
    if (fromOptions.isPresent()) {
      return fromOptions;
    }
    Matcher geometry = SIZE.matcher(value("geometry").orElse(""));
    if (geometry.matches()) {
      return size(Optional.of(geometry.group(1)), Optional.of(geometry.group(2)));
    }
    return size(value("width"), value("height"));
  }

  private static Optional<Size> size(Optional<String> width, Optional<String> height) {
    if (width.isEmpty() || height.isEmpty()) {
      return Optional.empty();
    }
    try {
      return Optional.of(
          new Size(Integer.parseInt(width.get().strip()), Integer.parseInt(height.get().strip())));
    } catch (NumberFormatException ignored) {
      return Optional.empty();
    }
  }
}
