/**
 * HDF5 files that hold events: the DSEC kind (lists {@code events/t}, {@code events/x}, {@code
 * events/y}, {@code events/p}, with {@code t_offset}), the Prophesee kind (a list {@code CD/events}
 * of elements with such names), what eventcv, evutils and others lay out likewise, and tables of
 * four columns.
 *
 * <p><b>Times.</b> Whatever the writer meant, plus {@code t_offset} where there is one. An
 * attribute {@code timestamp_scale_ms} or a name such as {@code t_ns} tells the unit; without one,
 * times with decimals are seconds, whole numbers microseconds, and whole numbers of 18 digits
 * nanoseconds. There are no wraps; a time that goes back starts a new segment.
 *
 * <p><b>Pixels.</b> Rows are taken to count from the top unless {@code rows_up}, which only our own
 * files have, says otherwise.
 *
 * <p><b>The container</b> is read here, not by a library (decision 6): superblocks of all versions,
 * groups as symbol tables or links, and data in the header, in one run or in chunks under any index
 * of one dimension. Chunks may be compressed with deflate, shuffle, Fletcher's checksum, LZF, LZ4,
 * Zstandard and Blosc. Memory is bounded: no size in a file is believed, and chunks that are too
 * large to be decompressed within that are refused.
 */
package haltere.core.format.internal.hdf5;
