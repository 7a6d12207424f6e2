package haltere.ui.command.results;

import haltere.core.format.internal.hdf5.Hdf5TableWriter;
import haltere.core.format.internal.hdf5.Hdf5TableWriter.Column;
import haltere.core.format.internal.hdf5.Hdf5TableWriter.Kind;
import haltere.core.sink.TableMetadata;
import haltere.core.sink.TableSink;
import haltere.core.sink.Tables;
import haltere.filters.orientation.OrientationEstimate;
import haltere.filters.orientation.camera.ObservationFile;
import java.io.Closeable;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BiConsumer;

/**
 * The file that {@code haltere orient} writes: CSV, Parquet, or HDF5 with the table {@code
 * ML_estimates} of Flydra. Where the observations have frames, both have the frame and {@code
 * hz_line0} to {@code hz_line5}.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class OrientationTable implements BiConsumer<String, OrientationEstimate>, Closeable {
  private final ObservationFile observations;
  private TableSink<OrientationRow> rows;
  private TableSink<FrameOrientationRow> frameRows;
  private Hdf5TableWriter estimates;

  /**
   * Starts a file beside its place, where it appears when it is {@link #finish finished}.
   *
   * @param out where it will be; HDF5 by the end of its name
   * @param observations whose frames are written
   * @param overwrite whether a file that is there may be replaced
   * @param metadata kept in a table whose format can hold it
   * @throws IOException if the file cannot be written
   */
  public OrientationTable(
      Path out, ObservationFile observations, boolean overwrite, TableMetadata metadata)
      throws IOException {
    this.observations = observations;
    if (isHdf5(out)) {
      estimates = Hdf5TableWriter.create(out, "ML_estimates", columns(), overwrite);
    } else if (observations.hasFrames()) {
      frameRows = Tables.create(out, FrameOrientationRow.class, overwrite, metadata);
    } else {
      rows = Tables.create(out, OrientationRow.class, overwrite, metadata);
    }
  }

  /**
   * Whether a file will be HDF5.
   *
   * @param out where it will be
   * @return true for .h5, .hdf5 and .hdf
   */
  public static boolean isHdf5(Path out) {
    return out.toString().toLowerCase(java.util.Locale.ROOT).matches(".*\\.(h5|hdf5?)");
  }

  /** Names and types as in Flydra's table, then what it has not. */
  private static List<Column> columns() {
    List<Column> columns = new ArrayList<>();
    columns.add(new Column("obj_id", Kind.U32));
    columns.add(new Column("frame", Kind.I64));
    for (String name : List.of("x", "y", "z")) {
      columns.add(new Column(name, Kind.F32));
    }
    for (int i = 0; i < 6; i++) {
      columns.add(new Column("hz_line" + i, Kind.F32));
    }
    columns.add(new Column("timestamp", Kind.F64));
    columns.add(new Column("sd_axis_rad", Kind.F32));
    columns.add(new Column("used", Kind.U32));
    columns.add(new Column("rejected", Kind.U32));
    return columns;
  }

  @Override
  public void accept(String object, OrientationEstimate now) {
    if (rows != null) {
      rows.accept(OrientationRow.of(object, now));
      return;
    }
    long frame = observations.frame(now.timeUs());
    if (frameRows != null) {
      frameRows.accept(FrameOrientationRow.of(object, now, frame));
      return;
    }
    double[] line = now.hzLine();
    try {
      estimates.append(
          number(object),
          frame,
          now.xM(),
          now.yM(),
          now.zM(),
          line[0],
          line[1],
          line[2],
          line[3],
          line[4],
          line[5],
          now.timeUs() * 1e-6,
          now.sdAxisRad(),
          now.used(),
          now.rejected());
    } catch (IOException thrown) {
      throw new UncheckedIOException(thrown);
    }
  }

  private static double number(String object) throws IOException {
    if (!object.matches("\\d{1,9}")) {
      throw new IOException(
          "the body \"" + object + "\" has no number for obj_id; choose a .csv as output");
    }
    return Integer.parseInt(object);
  }

  /**
   * Completes the file and puts it in its place.
   *
   * @throws IOException if that fails
   */
  public void finish() throws IOException {
    if (rows != null) {
      rows.finish();
    } else if (frameRows != null) {
      frameRows.finish();
    } else {
      estimates.finish();
    }
  }

  @Override
  public void close() throws IOException {
    if (rows != null) {
      rows.close();
    } else if (frameRows != null) {
      frameRows.close();
    } else {
      estimates.close();
    }
  }
}
