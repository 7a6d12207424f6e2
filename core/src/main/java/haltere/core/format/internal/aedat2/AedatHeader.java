package haltere.core.format.internal.aedat2;

import haltere.core.event.SensorGeometry;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The text header of an AEDAT-1.0 or AEDAT-2.0 file, parsed as bytes: line ends may be LF or CRLF,
 * and the encoding is arbitrary.
 *
 * @param version the integer part of the version, empty without a version line
 * @param versionText the version as written, such as 2.0; empty without a version line
 * @param dataOffset where the records start
 * @param ended whether the header has its end line
 * @param cutOff whether the file ends within the header
 * @param chip class of the chip as jAER writes it
 * @param hardware name of the hardware interface
 * @param sensor size of the sensor, from Haltere's line
 * @param firstTurnUs offset of the file's 32-bit times, from Haltere's line
 */
record AedatHeader(
    OptionalInt version,
    String versionText,
    int dataOffset,
    boolean ended,
    boolean cutOff,
    Optional<String> chip,
    Optional<String> hardware,
    Optional<SensorGeometry> sensor,
    OptionalLong firstTurnUs) {
  static final String VERSION = "!AER-DAT";
  static final String END = "End Of ASCII Header";
  static final String CHIP = "AEChip:";
  static final String HARDWARE = "HardwareInterface:";
  static final String SENSOR = "Haltere sensor:";
  static final String TIME_BASE = "Haltere time base:";

  private static final int MAX_LINE = 64 * 1024;
  private static final int CLOCK_RECORDS = 32;
  private static final long CLOCK_STEP_US = 60_000_000;
  static final long MAX_BASE_US = 1L << 61;
  private static final Pattern SIZE = Pattern.compile("(\\d{1,5})x(\\d{1,5})");
  private static final Pattern BASE = Pattern.compile("(-?\\d{1,19}) us");
  private static final Pattern NUMBER = Pattern.compile("(\\d{1,4})(\\.\\S*)?");

  /**
   * Reads a header.
   *
   * @param bytes the start of the file
   * @param length number of valid bytes
   * @param whole whether the file ends there
   * @return the header, or empty if it may continue after the bytes
   */
  public static Optional<AedatHeader> parse(byte[] bytes, int length, boolean whole) {
    Lines lines = new Lines(bytes, length);
    boolean ended = false;
    int offset = 0;
    int end;
    while ((end = lines.next(offset)) > offset) {
      String text = lines.text(offset, end);
      offset = end;
      if (text.equalsIgnoreCase(END)) {
        ended = true;
        break;
      }
    }
    if (!ended && !whole && offset + MAX_LINE + CLOCK_RECORDS * 8 > length) {
      return Optional.empty();
    }
    if (ended) {
      return Optional.of(lines.header(offset, true, false));
    }
    offset = lines.firstRecord(offset);
    boolean cutOff = whole && lines.endsInText(offset);
    return Optional.of(lines.header(cutOff ? length : offset, false, cutOff));
  }

  private static final class Lines {
    private final byte[] bytes;
    private final int length;

    Lines(byte[] bytes, int length) {
      this.bytes = bytes;
      this.length = length;
    }

    /** End of the header line that starts at an offset, or the offset if there is none. */
    int next(int offset) {
      if (offset >= length || bytes[offset] != '#') {
        return offset;
      }
      int limit = (int) Math.min(length, (long) offset + MAX_LINE);
      for (int i = offset + 1; i < limit; i++) {
        int b = bytes[i] & 0xff;
        if (b == '\n') {
          return i + 1;
        }
        boolean carriageReturn = b == '\r' && i + 1 < limit && bytes[i + 1] == '\n';
        if (b < 0x20 && b != '\t' && !carriageReturn) {
          return offset;
        }
      }
      return offset;
    }

    /** The line without its number sign and surrounding blanks. */
    String text(int from, int to) {
      return new String(bytes, from + 1, to - from - 1, StandardCharsets.ISO_8859_1).strip();
    }

    /**
     * Start of the records without an end line. A record looks like a line if its first byte is a
     * number sign and no control character precedes a line feed. Read as records, it and those
     * after it have ascending times; a line of text does not.
     */
    int firstRecord(int headerEnd) {
      int recordBytes = version(headerEnd).orElse(1) == 1 ? 6 : 8;
      int offset = 0;
      while (offset < headerEnd) {
        int end = next(offset);
        if (!text(offset, end).startsWith(VERSION) && isRecord(offset, end, recordBytes)) {
          return offset;
        }
        offset = end;
      }
      return headerEnd;
    }

    private boolean isRecord(int from, int to, int recordBytes) {
      int records = (to - from + recordBytes - 1) / recordBytes + 1;
      boolean aligned = (to - from) % recordBytes == 0;
      return ascends(from, recordBytes)
          && from + records * recordBytes <= length
          && goodSteps(bytes, from, recordBytes, records) == records - 1
          && (aligned || !ascends(to, recordBytes));
    }

    private boolean ascends(int offset, int recordBytes) {
      return clockAscends(bytes, offset, length, recordBytes, CLOCK_RECORDS);
    }

    private OptionalInt version(int headerEnd) {
      String text = versionText(headerEnd);
      Matcher matcher = NUMBER.matcher(text);
      return matcher.matches()
          ? OptionalInt.of(Integer.parseInt(matcher.group(1)))
          : text.isEmpty() ? OptionalInt.empty() : OptionalInt.of(0);
    }

    private String versionText(int headerEnd) {
      return value(VERSION, headerEnd).orElse("");
    }

    private Optional<String> value(String key, int headerEnd) {
      for (int offset = 0; offset < headerEnd; ) {
        int end = next(offset);
        if (end == offset) {
          break;
        }
        String text = text(offset, end);
        if (text.startsWith(key)) {
          return Optional.of(text.substring(key.length()).strip());
        }
        offset = end;
      }
      return Optional.empty();
    }

    /** Whether the bytes from an offset on are an unterminated line. */
    boolean endsInText(int offset) {
      if (offset >= length || bytes[offset] != '#' || length - offset > MAX_LINE) {
        return false;
      }
      for (int i = offset; i < length; i++) {
        int b = bytes[i] & 0xff;
        if (b < 0x20 && b != '\t' && b != '\r') {
          return false;
        }
      }
      return !ascends(offset, version(offset).orElse(1) == 1 ? 6 : 8);
    }

    AedatHeader header(int dataOffset, boolean ended, boolean cutOff) {
      return new AedatHeader(
          version(dataOffset),
          versionText(dataOffset),
          dataOffset,
          ended,
          cutOff,
          value(CHIP, dataOffset),
          value(HARDWARE, dataOffset),
          value(SENSOR, dataOffset).flatMap(Lines::size),
          value(TIME_BASE, dataOffset).map(Lines::base).orElse(OptionalLong.empty()));
    }

    private static Optional<SensorGeometry> size(String text) {
      Matcher matcher = SIZE.matcher(text);
      if (!matcher.matches()) {
        return Optional.empty();
      }
      int width = Integer.parseInt(matcher.group(1));
      int height = Integer.parseInt(matcher.group(2));
      boolean possible =
          width >= 1
              && height >= 1
              && width <= DavisAddressDecoder.MAX_WIDTH
              && height <= DavisAddressDecoder.MAX_HEIGHT;
      return possible ? Optional.of(new SensorGeometry(width, height)) : Optional.empty();
    }

    private static OptionalLong base(String text) {
      Matcher matcher = BASE.matcher(text);
      if (!matcher.matches()) {
        return OptionalLong.empty();
      }
      try {
        long base = Long.parseLong(matcher.group(1));
        boolean possible = base >= -MAX_BASE_US && base <= MAX_BASE_US;
        return possible ? OptionalLong.of(base) : OptionalLong.empty();
      } catch (NumberFormatException e) {
        return OptionalLong.empty();
      }
    }
  }

  /**
   * Whether bytes look like records: 90 % of their times are at most a minute after the previous
   * one.
   *
   * @param bytes of a file
   * @param offset start of the first record
   * @param length number of valid bytes
   * @param recordBytes 6 or 8
   * @param records number of records to examine
   * @return true if there are at least three records and they do
   */
  static boolean clockAscends(byte[] bytes, int offset, int length, int recordBytes, int records) {
    int count = Math.min(records, (length - offset) / recordBytes);
    if (count < 3) {
      return false;
    }
    return goodSteps(bytes, offset, recordBytes, count) * 10 >= (count - 1) * 9;
  }

  /** Time of a record. */
  static int time(byte[] bytes, int offset, int recordBytes, int record) {
    int at = offset + record * recordBytes + recordBytes - 4;
    return bytes[at] << 24
        | (bytes[at + 1] & 0xff) << 16
        | (bytes[at + 2] & 0xff) << 8
        | bytes[at + 3] & 0xff;
  }

  private static int goodSteps(byte[] bytes, int offset, int recordBytes, int count) {
    int good = 0;
    int last = 0;
    for (int i = 0; i < count; i++) {
      int time = time(bytes, offset, recordBytes, i);
      int step = time - last;
      if (i > 0 && step >= 0 && step <= CLOCK_STEP_US) {
        good++;
      }
      last = time;
    }
    return good;
  }
}
