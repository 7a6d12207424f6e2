package haltere.core.format.internal.aedat4;

import java.util.Locale;

/** Compression of the packets of an AEDAT-4 file. */
public enum Aedat4Compression {
  /** Uncompressed: fastest, 16 bytes an event. */
  NONE,
  /** LZ4 frames, as most programs write: about half the size. */
  LZ4,
  /** LZ4 frames of a slow compressor: a quarter smaller, read as fast as others. */
  LZ4_HIGH,
  /** Zstandard frames: about a third of the size, at half of the speed of LZ4. */
  ZSTD,
  /**
   * Zstandard frames of the highest level, as in DV: a fifth smaller; slow, for archives rather
   * than recording.
   */
  ZSTD_HIGH;

  static final int LZ4_MAGIC = 0x184D2204;
  static final int ZSTD_MAGIC = 0xFD2FB528;

  /** Name of the method, such as "lz4 (high)". */
  String words() {
    return name().toLowerCase(Locale.ROOT).replaceFirst("_(.*)", " ($1)");
  }

  boolean isLz4() {
    return this == LZ4 || this == LZ4_HIGH;
  }

  boolean isZstd() {
    return this == ZSTD || this == ZSTD_HIGH;
  }
}
