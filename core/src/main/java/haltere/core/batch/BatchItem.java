package haltere.core.batch;

import haltere.core.pipeline.internal.Checksums;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Objects;

/**
 * A recording of a batch.
 *
 * @param recording a file, or the folder of a bag in parts
 * @param name relative path that names the recording and its result, with / between its parts
 * @param bytes size of the recording
 */
public record BatchItem(Path recording, String name, long bytes) {
  /** Checks the values. */
  public BatchItem {
    Objects.requireNonNull(recording, "recording");
    if (name.isEmpty() || bytes < 0) {
      throw new IllegalArgumentException(recording + " has no name or no size");
    }
  }

  /**
   * The shard that works on the recording, from its name alone, so that many machines agree without
   * a coordinator.
   *
   * @param shards number of shards, 1 or more
   * @return 1 to shards
   */
  public int shard(int shards) {
    byte[] hash = Checksums.sha256(name.getBytes(StandardCharsets.UTF_8));
    long value = 0;
    for (int i = 0; i < Long.BYTES; i++) {
      value = value << Byte.SIZE | hash[i] & 0xff;
    }
    return 1 + (int) Long.remainderUnsigned(value, shards);
  }
}
