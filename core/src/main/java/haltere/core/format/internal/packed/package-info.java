/**
 * What formats share whose data are packed: a window over a file, and payloads that are unpacked
 * piece by piece (LZ4 and Zstandard frames, or not packed at all).
 *
 * <p>LZ4 is our own: the libraries for the JVM do not unpack the dependent blocks that DV writes.
 * Zstandard is zstd-jni, with a window of at most 32 MiB for what does not say that it is small. No
 * size in a file makes memory grow.
 */
package haltere.core.format.internal.packed;
