/**
 * HDF5 files that hold events: the DSEC kind (lists {@code events/t}, {@code events/x}, {@code
 * events/y}, {@code events/p}, with {@code t_offset}), the Prophesee kind (a list {@code CD/events}
 * of elements with such names), similar layouts of eventcv, evutils and others, and tables of four
 * columns.
 *
 * <p><b>Times.</b> {@code t_offset} is added if it exists. The unit is that of an attribute {@code
 * timestamp_scale_ms} or a name such as {@code t_ns}; without one, times with decimals are seconds,
 * whole numbers microseconds, and whole numbers of 18 digits nanoseconds. There are no wraps; a
 * time that goes back starts a new segment.
 *
 * <p><b>Pixels.</b> Rows count from the top unless {@code rows_up}, which only Haltere's files
 * have, states otherwise.
 *
 * <p><b>The container</b> is read here, not by a library (decision 6): superblocks of all versions,
 * groups as symbol tables or links, and data in the header, contiguous or in chunks with any
 * one-dimensional index. Chunks may be compressed with deflate, shuffle, Fletcher's checksum, LZF,
 * LZ4, Zstandard and Blosc. Memory is bounded: stated sizes are checked, and chunks that are too
 * large are rejected.
 */
package haltere.core.format.internal.hdf5;
