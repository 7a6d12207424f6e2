package haltere.core.format.internal.bag;

import haltere.core.format.RecordingFile;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.compression.FileWindow;
import haltere.core.format.internal.compression.Lz4Payload;
import haltere.core.format.internal.compression.Payload;
import haltere.core.format.internal.compression.StoredPayload;
import haltere.core.format.internal.compression.ZstdPayload;
import java.io.IOException;

/** Common part of the walks through bags with messages in chunks, compressed or not. */
abstract class ChunkWalk implements MessageWalk {
  final RecordingFile file;
  final BagTopics topics;
  final Wanted wanted;
  final ViolationCounts violations;

  /** Reads records between chunks. */
  final StoredPayload records;

  /** Offset of the next chunk, or of records before it. */
  long next;

  /** Decompressed bytes of the chunk before the current record. */
  long recordAt;

  /** Decompressed bytes of the chunk before the current message. */
  long messageAt;

  long messageBytes;
  long recordedNs;
  BagTopic topic;

  private final ChunkList chunks;
  private final FileWindow window;
  private final StoredPayload stored;
  private Lz4Payload lz4;
  private Bzip2Payload bzip2;
  private ZstdPayload zstd;
  private Payload payload;
  private boolean inChunk;
  private long chunk;
  private long compressedAt;
  private long compressedBytes;
  private long chunkBytes;
  private boolean cut;

  ChunkWalk(
      RecordingFile file,
      long firstRecord,
      ChunkList chunks,
      BagTopics topics,
      Wanted wanted,
      ViolationCounts violations) {
    this.file = file;
    this.chunks = chunks;
    this.topics = topics;
    this.wanted = wanted;
    this.violations = violations;
    window = new FileWindow(file);
    records = new StoredPayload(window);
    stored = new StoredPayload(window);
    payload = stored;
    next = firstRecord;
  }

  /** Opens the next chunk of the file; false at its end. */
  abstract boolean nextChunk() throws IOException;

  /**
   * Advances to the next requested message in the chunk and sets its fields; false at the end of
   * the chunk.
   */
  abstract boolean nextMessage() throws IOException, DamagedPacketException;

  @Override
  public final boolean find() throws IOException {
    while (inChunk || nextChunk()) {
      try {
        if (nextMessage()) {
          return true;
        }
        if (cut) {
          throw new DamagedPacketException("a chunk that ends too early");
        }
        inChunk = false;
      } catch (DamagedPacketException e) {
        damaged(e);
      }
    }
    return false;
  }

  /**
   * Opens the chunk at {@link #next}.
   *
   * @param compression name of the method in the file
   * @param data offset of its bytes
   * @param bytes stated size
   * @param decompressedBytes stated size after decompression
   * @return false if it is damaged from the first byte on
   */
  final boolean openChunk(String compression, long data, long bytes, long decompressedBytes)
      throws IOException {
    long rest = file.size() - data;
    chunk = next;
    compressedAt = data;
    cut = bytes < 0 || bytes > rest;
    compressedBytes = cut ? rest : bytes;
    chunkBytes = Math.max(1, decompressedBytes);
    recordAt = 0;
    messageAt = 0;
    next = cut ? Math.min(chunks.chunkAfter(chunk), file.size()) : data + compressedBytes;
    inChunk = true;
    try {
      payload = decompressing(compression);
      payload.open(compressedAt, compressedBytes);
    } catch (DamagedPacketException e) {
      damaged(e);
    }
    return inChunk;
  }

  @Override
  public final String compression() {
    return payload == bzip2 ? "bzip2" : payload == lz4 ? "lz4" : payload == zstd ? "zstd" : "none";
  }

  private Payload decompressing(String compression) throws DamagedPacketException {
    switch (compression) {
      case "none", "" -> {
        return stored;
      }
      case "lz4" -> {
        lz4 = lz4 == null ? new Lz4Payload(window) : lz4;
        return lz4;
      }
      case "bz2" -> {
        bzip2 = bzip2 == null ? new Bzip2Payload(window) : bzip2;
        return bzip2;
      }
      case "zstd" -> {
        zstd = zstd == null ? new ZstdPayload(window) : zstd;
        return zstd;
      }
      default -> throw new DamagedPacketException("a chunk of an unknown compression");
    }
  }

  /** Skips damage between chunks. */
  final void damagedBetweenChunks() {
    long at = next;
    next = chunks.chunkAfter(at);
    if (next >= chunks.end() && chunks.cutOff()) {
      violations.addOnce(Violation.CUT_OFF, at);
    } else {
      violations.add(Violation.IMPOSSIBLE_LENGTH, at);
    }
    violations.reached(Math.min(next, file.size()));
  }

  @Override
  public final BagTopic topic() {
    return topic;
  }

  @Override
  public final Payload payload() {
    return payload;
  }

  @Override
  public final long size() {
    return messageBytes;
  }

  @Override
  public final long recordedNs() {
    return recordedNs;
  }

  @Override
  public final long offset(long done) {
    return place(messageAt + done);
  }

  /** File offset of a byte of the chunk, as if it were uncompressed. */
  private long place(long at) {
    if (payload == stored) {
      return compressedAt + Math.min(at, compressedBytes);
    }
    double part = Math.min(1.0, (double) at / chunkBytes);
    return compressedAt + (long) (part * compressedBytes);
  }

  @Override
  public final long position() {
    if (inChunk) {
      return place(recordAt);
    }
    return next < chunks.end() ? next : file.size();
  }

  @Override
  public final void pass(long unused) throws IOException {
    recordAt = messageAt + messageBytes;
    try {
      payload.skip(unused);
    } catch (DamagedPacketException e) {
      damaged(e);
    }
  }

  @Override
  public final void damaged(DamagedPacketException damage) {
    long at = place(Math.max(recordAt, messageAt));
    if (cut && next >= file.size()) {
      violations.addOnce(Violation.CUT_OFF, at);
    } else {
      violations.add(cut ? Violation.IMPOSSIBLE_LENGTH : Violation.DAMAGED_PACKET, at);
    }
    inChunk = false;
    // an excessive length would skip chunks that the index lists
    next = Math.min(next, chunks.chunkAfter(chunk));
  }

  @Override
  public final void save(long[] state, int at) {
    state[at] = inChunk ? chunk : next;
    state[at + 1] = inChunk ? recordAt : 0;
  }

  @Override
  public final void restore(long[] state, int at) throws IOException {
    inChunk = false;
    next = state[at];
    long skipped = state[at + 1];
    if (skipped == 0 || !nextChunk()) {
      return;
    }
    try {
      payload.skip(skipped);
      recordAt = skipped;
    } catch (DamagedPacketException e) {
      damaged(e);
    }
  }

  @Override
  public final void close() {
    if (zstd != null) {
      zstd.close();
    }
  }
}
