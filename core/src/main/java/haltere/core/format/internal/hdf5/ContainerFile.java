package haltere.core.format.internal.hdf5;

import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingProblem;
import java.io.IOException;

/**
 * An HDF5 file as a container: superblock, and metadata by position.
 *
 * <p>Thread rule: one thread.
 */
final class ContainerFile {
  /** The undefined position. */
  static final long NOWHERE = -1;

  /** Maximum size of a piece of metadata. */
  static final int MAX_PIECE_BYTES = 4 << 20;

  private static final byte[] SIGNATURE = {(byte) 0x89, 'H', 'D', 'F', '\r', '\n', 0x1a, '\n'};
  private static final int MAX_USER_BLOCK = 1 << 20;
  private static final int SUPERBLOCK_BYTES = 256;

  private final RecordingFile bytes;
  private int offsetBytes = 8;
  private int lengthBytes = 8;
  private long base;
  private long end;
  private long root;

  private ContainerFile(RecordingFile bytes) {
    this.bytes = bytes;
  }

  /** Reads the superblock. */
  static ContainerFile open(RecordingFile bytes) throws IOException {
    ContainerFile file = new ContainerFile(bytes);
    long start = signatureAt(bytes);
    if (start < 0) {
      throw new RecordingProblem(
          bytes.path(), 0, "this is not an HDF5 file: its signature is missing");
    }
    byte[] head = bytes.read(start, SUPERBLOCK_BYTES);
    file.superblock(new Metadata(file, head, SIGNATURE.length, head.length, start), start);
    return file;
  }

  /** Offset of the signature, which may follow other data; −1 for a file without one. */
  static long signatureAt(RecordingFile bytes) throws IOException {
    for (long start = 0; start <= MAX_USER_BLOCK; start = start == 0 ? 512 : 2 * start) {
      if (isSignature(bytes.read(start, SIGNATURE.length), 0)) {
        return start;
      }
    }
    return -1;
  }

  /** Whether the signature of HDF5 is at an index. */
  static boolean isSignature(byte[] head, int at) {
    return head.length >= at + SIGNATURE.length
        && java.util.Arrays.equals(head, at, at + SIGNATURE.length, SIGNATURE, 0, SIGNATURE.length);
  }

  private void superblock(Metadata block, long start) throws RecordingProblem {
    int version = block.u1();
    if (version > 3) {
      throw block.unknown("version " + version + " of the superblock");
    }
    if (version < 2) {
      block.skip(4);
    }
    offsetBytes = size(block);
    lengthBytes = size(block);
    if (version < 2) {
      block.skip(version == 1 ? 13 : 9);
    } else {
      block.skip(1);
    }
    // positions are relative to the signature, which may follow other data
    base = start;
    block.skip(offsetBytes);
    block.position();
    end = block.position();
    if (version < 2) {
      block.position();
      block.skip(offsetBytes);
    }
    root = block.position();
  }

  private static int size(Metadata block) throws RecordingProblem {
    int size = block.u1();
    if (size != 2 && size != 4 && size != 8) {
      throw block.problem("offsets or lengths of " + size + " bytes");
    }
    return size;
  }

  RecordingFile bytes() {
    return bytes;
  }

  int offsetBytes() {
    return offsetBytes;
  }

  int lengthBytes() {
    return lengthBytes;
  }

  /** Position of the root group's header. */
  long root() {
    return root;
  }

  /** Whether the file is shorter than stated. */
  boolean isCutOff() {
    return end > bytes.size();
  }

  /** A position; undefined if all bits are set. */
  long position(long raw) {
    boolean none = offsetBytes == 8 ? raw == -1 : raw == (1L << 8 * offsetBytes) - 1;
    return none || raw < 0 ? NOWHERE : raw;
  }

  /** File offset of a position. */
  long offsetOf(long position) {
    return position > Long.MAX_VALUE - base ? Long.MAX_VALUE : position + base;
  }

  /** Metadata of a known size; throws if the file ends before. */
  Metadata at(long position, long size) throws IOException {
    long offset = offsetOf(position);
    if (position == NOWHERE || size > MAX_PIECE_BYTES || size > bytes.size() - offset) {
      throw new RecordingProblem(
          bytes.path(),
          Math.min(bytes.size(), Math.max(0, position == NOWHERE ? 0 : offset)),
          size > MAX_PIECE_BYTES
              ? "damaged: a piece of the file's structure claims " + size + " bytes"
              : "damaged: the file ends before a piece of its structure; it was cut off, or its"
                  + " writer did not close it");
    }
    byte[] piece = bytes.read(offset, (int) size);
    return new Metadata(this, piece, 0, piece.length, offset);
  }

  /** Metadata up to a size; fewer bytes at the end of the file. */
  Metadata upTo(long position, int size) throws IOException {
    long there = position == NOWHERE ? 0 : bytes.size() - offsetOf(position);
    return at(position, Math.max(1, Math.min(size, there)));
  }

  RecordingProblem unknown(long offset, String what) {
    return new RecordingProblem(
        bytes.path(),
        offset,
        what + " is not read here; rewrite the file with h5repack (HDF5 tools) or h5py");
  }
}
