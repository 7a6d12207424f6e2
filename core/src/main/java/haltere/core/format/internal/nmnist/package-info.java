/**
 * N-MNIST and N-Caltech101 ({@code .bin}): records of 5 bytes without a header.
 *
 * <p><b>Times.</b> Microseconds since the recording began, 23 bits, extended to 64 bits: a jump
 * back by more than half of 2<sup>23</sup> us (8.4 s) is a wrap, any other a new segment. Records
 * of row 240 are not events but advance time by 8,192 us, as in the data sets' own readers.
 *
 * <p><b>Pixels.</b> Rows count from the top in the records and from the bottom in packets. The
 * files state no size: 34x34 (N-MNIST) or 240x180 (N-Caltech101), the smallest that holds the
 * events.
 */
package haltere.core.format.internal.nmnist;
