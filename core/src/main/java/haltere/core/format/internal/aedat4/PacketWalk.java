package haltere.core.format.internal.aedat4;

import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.compression.FileWindow;
import haltere.core.format.internal.compression.LittleEndian;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Set;

/**
 * Goes from packet to packet by their headers (number of the stream, size), and searches the next
 * one after a damaged header.
 *
 * <p>Thread rule: one thread.
 */
final class PacketWalk {
  /** Number of the stream and size. */
  static final int HEADER_BYTES = 8;

  private static final int MIN_SEARCH_BYTES = HEADER_BYTES + 12;

  private FileWindow window;
  private final Set<Integer> known;
  private final long end;
  private final boolean cutOff;
  private final ViolationCounts violations;

  /** Start and result of the last search; there is no packet between them. */
  private long searchedFrom;

  private long searchFound;
  private long looks;

  private long position;
  private int stream;
  private long size;

  /**
   * A walk.
   *
   * @param window over the file
   * @param known numbers of the stated streams
   * @param start offset of the first packet
   * @param end end of the packets
   * @param cutOff whether the file is truncated there
   * @param violations counts damage
   */
  PacketWalk(
      FileWindow window,
      Set<Integer> known,
      long start,
      long end,
      boolean cutOff,
      ViolationCounts violations) {
    this.window = window;
    this.known = known;
    this.end = end;
    this.cutOff = cutOff;
    this.violations = violations;
    position = start;
  }

  /** Offset of the packet's header. */
  long position() {
    return position;
  }

  /** Reads the file through another window. */
  void setWindow(FileWindow other) {
    window = other;
  }

  void moveTo(long offset) {
    position = offset;
  }

  int stream() {
    return stream;
  }

  /** Bytes of the payload, which starts after the header. */
  long size() {
    return size;
  }

  long payload() {
    return position + HEADER_BYTES;
  }

  long packetEnd() {
    return payload() + size;
  }

  /** Reads the header at the position, or the next possible one. */
  boolean find() throws IOException {
    while (position < end) {
      int at = end - position < HEADER_BYTES ? -1 : window.require(position, HEADER_BYTES);
      if (at >= 0) {
        stream = LittleEndian.getInt(window.bytes(), at);
        size = LittleEndian.getInt(window.bytes(), at + 4);
        boolean fits = size >= 0 && size <= end - position - HEADER_BYTES;
        if (fits && (known.contains(stream) || looksLikePacket(position))) {
          return true;
        }
      }
      long next = search(position + 1);
      boolean ends = next < 0 && (at < 0 || size > end - position - HEADER_BYTES);
      if (ends) {
        violations.addOnce(Violation.CUT_OFF, position);
      } else {
        violations.add(Violation.IMPOSSIBLE_LENGTH, position);
      }
      position = next < 0 ? end : next;
      violations.reached(position);
    }
    if (cutOff) {
      violations.addOnce(Violation.CUT_OFF, end);
    }
    return false;
  }

  /** Skips a valid packet. */
  void pass() {
    position = packetEnd();
  }

  /** Skips a packet with a damaged payload, whose size may be wrong too. */
  void passDamaged() throws IOException {
    long next = packetEnd();
    if (next < end && !looksLikePacket(next)) {
      long found = search(position + 1);
      next = found < 0 ? next : found;
    }
    position = next;
  }

  /** The first offset of a possible packet, or −1. Each damaged range is searched once. */
  private long search(long from) throws IOException {
    boolean isSearched = from >= searchedFrom && (searchFound < 0 || from <= searchFound);
    if (searchedFrom == 0 || !isSearched) {
      searchFound = -1;
      for (long at = from; at <= end - MIN_SEARCH_BYTES && searchFound < 0; at++) {
        if (looksLikePacket(at)) {
          searchFound = at;
        }
      }
      searchedFrom = from;
    }
    return searchFound;
  }

  /** Number of examined offsets. */
  long looks() {
    return looks;
  }

  private boolean looksLikePacket(long offset) throws IOException {
    looks++;
    int at = offset > end - MIN_SEARCH_BYTES ? -1 : window.require(offset, MIN_SEARCH_BYTES);
    if (at < 0) {
      return false;
    }
    byte[] bytes = window.bytes();
    long statedBytes = LittleEndian.getInt(bytes, at + 4);
    int id = LittleEndian.getInt(bytes, at);
    if (id < 0 || statedBytes <= 4 || statedBytes > end - offset - HEADER_BYTES) {
      return false;
    }
    Aedat4Compression compression = Decompressor.compression(bytes, at + HEADER_BYTES, statedBytes);
    return compression != null
        && (compression != Aedat4Compression.NONE || isIdentifier(bytes, at + HEADER_BYTES + 8));
  }

  private static boolean isIdentifier(byte[] bytes, int at) {
    String letters = new String(bytes, at, 4, StandardCharsets.ISO_8859_1);
    return letters.chars().allMatch(c -> c >= 'A' && c <= 'Z' || c >= '0' && c <= '9');
  }
}
