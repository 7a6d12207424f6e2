package haltere.core.format.internal.aedat2;

import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingFile;
import haltere.core.format.internal.decoding.SensorGuess;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.List;

/**
 * Number of address words of an AEDAT-2.0 file that each layout explains, over all records.
 *
 * <p>A lost byte shifts all records after it. If no layout explains two blocks of records, they are
 * read again at the shift at which they match a DVS128 and times ascend; DAVIS words have too few
 * constant zero bits to detect a shift.
 *
 * <p>Thread rule: one thread.
 */
final class AddressEvidence {
  private static final int RECORD_BYTES = RecordDecoder.AEDAT2_BYTES;
  private static final int BLOCK_RECORDS = 32;
  private static final int BLOCK_BYTES = BLOCK_RECORDS * RECORD_BYTES;
  private static final int PIECE_BYTES = 4096 * BLOCK_BYTES;

  /** Minimum share of the words that an accepted layout explains. */
  private static final double MIN_EXPLAINED = 0.6;

  /** Minimum share of the words of an undamaged block that one layout explains. */
  private static final double MIN_EXPLAINED_IN_BLOCK = 0.9;

  /** Counts of words. */
  private static final class Tally {
    private long words;
    private long dvs128Events;
    private long dvs128Words;
    private long davisEvents;
    private long davisWords;
    private int maxX;
    private int maxY;

    static Tally of(ByteBuffer records, int from, int to) {
      Tally tally = new Tally();
      for (int at = from; at + RECORD_BYTES <= to; at += RECORD_BYTES) {
        tally.add(records.getInt(at));
      }
      return tally;
    }

    private void add(int word) {
      words++;
      if ((word & 0xffff_8000) == 0) {
        dvs128Events++;
        dvs128Words++;
      } else if ((word & 0x7fff_7fff) == 0) {
        dvs128Words++;
      }
      if (word < 0 || (word & 0x400) != 0) {
        // a sample, or an external input, which uses only the lowest bits
        davisWords += word < 0 || (word & 0x3f8) == 0 ? 1 : 0;
      } else if ((word & 0x3ff) == 0) {
        davisWords++;
        davisEvents++;
        maxX = Math.max(maxX, word >>> 12 & 0x3ff);
        maxY = Math.max(maxY, word >>> 22);
      }
    }

    void add(Tally other) {
      words += other.words;
      dvs128Events += other.dvs128Events;
      dvs128Words += other.dvs128Words;
      davisEvents += other.davisEvents;
      davisWords += other.davisWords;
      maxX = Math.max(maxX, other.maxX);
      maxY = Math.max(maxY, other.maxY);
    }

    boolean isDvs128() {
      return dvs128Words >= MIN_EXPLAINED_IN_BLOCK * words;
    }

    boolean isDavis() {
      return davisWords >= MIN_EXPLAINED_IN_BLOCK * words;
    }
  }

  private final RecordingFile file;
  private final long start;
  private final ByteBuffer piece = ByteBuffer.allocate(PIECE_BYTES);
  private final Tally all = new Tally();
  private final Tally undamaged = new Tally();
  private long pieceOffset;

  private AddressEvidence(RecordingFile file, long start) {
    this.file = file;
    this.start = start;
    piece.limit(0);
  }

  /**
   * Reads all records of a file.
   *
   * @param file of AEDAT-2.0
   * @param offset of its first record
   * @return the counts
   * @throws IOException if the file cannot be read
   */
  static AddressEvidence of(RecordingFile file, long offset) throws IOException {
    file.requireFile(SensorGuess.ADVICE);
    AddressEvidence evidence = new AddressEvidence(file, offset);
    long at = offset;
    while (file.size() - at >= RECORD_BYTES) {
      at = evidence.addBlock(at);
    }
    return evidence;
  }

  /** Counts the block at an offset; returns the offset of the next one. */
  private long addBlock(long offset) throws IOException {
    if (offset + 2 * BLOCK_BYTES + RECORD_BYTES > pieceOffset + piece.limit()) {
      pieceOffset = Math.max(start, offset - BLOCK_BYTES);
      file.read(piece, pieceOffset);
    }
    int from = (int) (offset - pieceOffset);
    Tally block = Tally.of(piece, from, end(from));
    boolean isShifted = !isExplained(block, from) && !isExplained(end(from));
    for (int shift = 1; shift < RECORD_BYTES && isShifted; shift++) {
      int to = end(from + shift);
      Tally shifted = Tally.of(piece, from + shift, to);
      if (shifted.isDvs128() && to - from - shift == BLOCK_BYTES && ascends(from + shift, to)) {
        from += shift;
        block = shifted;
        isShifted = false;
      }
    }
    all.add(block);
    if (isExplained(block, from)) {
      undamaged.add(block);
    }
    return pieceOffset + end(from);
  }

  private int end(int from) {
    return from + Math.min(BLOCK_BYTES, (piece.limit() - from) / RECORD_BYTES * RECORD_BYTES);
  }

  private boolean isExplained(int from) {
    return isExplained(Tally.of(piece, from, end(from)), from);
  }

  /** Any word with its highest bit set is valid for a DAVIS, so the times must ascend too. */
  private boolean isExplained(Tally block, int from) {
    return block.isDvs128() || block.isDavis() && ascends(from, end(from));
  }

  /** The last block of a file may be short; its times are checked with records before it. */
  private boolean ascends(int from, int to) {
    int missing = Math.min(from, BLOCK_BYTES - (to - from)) / RECORD_BYTES;
    int first = from - missing * RECORD_BYTES;
    return AedatHeader.clockAscends(piece.array(), first, to, RECORD_BYTES, BLOCK_RECORDS);
  }

  /** The layout that explains most words, preferably one that yields events. */
  AedatSensor.AddressLayout layout(boolean isLarge) {
    long dvs128 = all.dvs128Events == 0 ? 0 : all.dvs128Words;
    long davis = all.davisEvents == 0 ? 0 : all.davisWords;
    if (dvs128 == davis) {
      return isLarge ? AedatSensor.AddressLayout.DAVIS : AedatSensor.AddressLayout.DVS128;
    }
    return dvs128 > davis ? AedatSensor.AddressLayout.DVS128 : AedatSensor.AddressLayout.DAVIS;
  }

  /** Whether a layout yields events and explains the words; true without words. */
  boolean isExplained(AedatSensor.AddressLayout layout) {
    boolean isDvs128 = layout == AedatSensor.AddressLayout.DVS128;
    return all.words == 0
        || (isDvs128 ? all.dvs128Events : all.davisEvents) > 0
            && explained(layout) >= MIN_EXPLAINED;
  }

  /** Share of the words that a layout explains, 0 to 1. */
  double explained(AedatSensor.AddressLayout layout) {
    long words = layout == AedatSensor.AddressLayout.DVS128 ? all.dvs128Words : all.davisWords;
    return all.words == 0 ? 1 : (double) words / all.words;
  }

  /** The first of some sizes that holds the undamaged events of a DAVIS. */
  SensorGeometry smallest(List<SensorGeometry> sizes) {
    Tally events = undamaged.davisEvents > 0 ? undamaged : all;
    return sizes.stream()
        .filter(size -> size.contains(events.maxX, events.maxY))
        .findFirst()
        .orElseThrow();
  }
}
