package haltere.core.format.internal.aedat4;

import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingProblem;
import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.compression.LittleEndian;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;

/**
 * The header of an AEDAT-4 file.
 *
 * @param compression stated compression of the packets
 * @param tablePosition stated position of the table of packets; below 0 while the file is open
 * @param dataOffset offset of the first packet
 * @param described whether the description of the streams could be read
 * @param streams listed in the file
 */
record Aedat4Header(
    Optional<Aedat4Compression> compression,
    long tablePosition,
    long dataOffset,
    boolean described,
    List<Aedat4Stream> streams) {
  static final String MAGIC = "#!AER-DAT4.0\r\n";
  static final int MAGIC_BYTES = 14;
  static final long OPEN = -1;
  static final String IDENTIFIER = "IOHE";

  private static final int MAX_BYTES = 4 * 1024 * 1024;
  private static final int TABLE_POSITION_FIELD = 1;

  static Aedat4Header read(RecordingFile file) throws IOException {
    byte[] start = file.read(0, MAGIC_BYTES + 4);
    if (!new String(start, StandardCharsets.ISO_8859_1).startsWith(MAGIC)) {
      throw new RecordingProblem(
          file.path(), "it does not begin with #!AER-DAT4.0; leave out --format");
    }
    if (start.length < MAGIC_BYTES + 4) {
      throw new RecordingProblem(
          file.path(), start.length, "the file ends within its header; copy it again");
    }
    long size = LittleEndian.getInt(start, MAGIC_BYTES) & 0xffff_ffffL;
    if (size > MAX_BYTES) {
      throw new RecordingProblem(
          file.path(), MAGIC_BYTES, "a header of " + size + " bytes cannot be; copy it again");
    }
    byte[] bytes = file.read(MAGIC_BYTES, (int) size + 4);
    if (bytes.length < size + 4) {
      throw new RecordingProblem(
          file.path(), file.size(), "the file ends within its header; copy it again");
    }
    try {
      return parse(bytes);
    } catch (DamagedPacketException e) {
      throw new RecordingProblem(
          file.path(),
          MAGIC_BYTES,
          "the header is damaged (" + e.getMessage() + "); copy it again");
    }
  }

  private static Aedat4Header parse(byte[] bytes) throws DamagedPacketException {
    FlatTable table = FlatTable.root(bytes, 0, bytes.length);
    int number = table.getInt(0, 0);
    Aedat4Compression[] known = Aedat4Compression.values();
    Optional<Aedat4Compression> compression =
        number >= 0 && number < known.length ? Optional.of(known[number]) : Optional.empty();
    List<Aedat4Stream> streams = List.of();
    boolean described = true;
    try {
      streams = InfoNode.parse(table.getString(2));
    } catch (DamagedPacketException e) {
      described = false;
    }
    return new Aedat4Header(
        compression,
        table.getLong(TABLE_POSITION_FIELD, OPEN),
        MAGIC_BYTES + bytes.length,
        described,
        List.copyOf(streams));
  }

  /** Offset of the table's position in the bytes of {@link #write}. */
  static final int TABLE_POSITION_OFFSET = MAGIC_BYTES + 4 + 36;

  /** A complete header for an open file, in DV's layout. */
  static byte[] write(Aedat4Compression compression, String infoNode) {
    byte[] text = infoNode.getBytes(StandardCharsets.UTF_8);
    int length = (48 + text.length + 1 + 7) / 8 * 8 + 4;
    byte[] bytes = new byte[MAGIC_BYTES + 4 + length];
    byte[] magic = (MAGIC).getBytes(StandardCharsets.ISO_8859_1);
    System.arraycopy(magic, 0, bytes, 0, MAGIC_BYTES);
    int base = MAGIC_BYTES + 4;
    LittleEndian.putInt(bytes, MAGIC_BYTES, length);
    LittleEndian.putInt(bytes, base, 24);
    System.arraycopy(IDENTIFIER.getBytes(StandardCharsets.ISO_8859_1), 0, bytes, base + 4, 4);
    int[] layout = {10, 20, 4, 12, 8};
    for (int i = 0; i < layout.length; i++) {
      LittleEndian.putShort(bytes, base + 14 + 2 * i, layout[i]);
    }
    LittleEndian.putInt(bytes, base + 24, 10);
    LittleEndian.putInt(bytes, base + 28, compression.ordinal());
    LittleEndian.putInt(bytes, base + 32, 12);
    LittleEndian.putLong(bytes, base + 36, OPEN);
    LittleEndian.putInt(bytes, base + 44, text.length);
    System.arraycopy(text, 0, bytes, base + 48, text.length);
    return bytes;
  }
}
