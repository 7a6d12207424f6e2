/**
 * Shared by formats with compressed data: a window over a file, and payloads that are decompressed
 * piece by piece (LZ4 and Zstandard frames, or stored).
 *
 * <p>Blocks of LZ4 and the checksums of its frames are lz4-java's; the frames are read here, since
 * no library for the JVM reads the dependent blocks that DV writes. Zstandard is zstd-jni, with a
 * window of at most 32 MiB unless a small size is stated. Memory is independent of stated sizes.
 */
package haltere.core.format.internal.compression;
