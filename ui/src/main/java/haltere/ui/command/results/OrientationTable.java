package haltere.ui.command.results;

import haltere.core.format.AtomicFile;
import haltere.core.format.internal.hdf5.Hdf5TableWriter;
import haltere.core.format.internal.hdf5.Hdf5TableWriter.Hdf5Column;
import haltere.core.format.internal.hdf5.Hdf5TableWriter.NumberType;
import haltere.core.pipeline.ResultFiles;
import haltere.core.sink.TableMetadata;
import haltere.core.sink.TableSink;
import haltere.core.sink.internal.Unchecked;
import haltere.filters.orientation.OrientationEstimate;
import haltere.filters.orientation.camera.ObservationFile;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BiConsumer;

/**
 * The output of {@code haltere orient}: CSV, Parquet, or HDF5 with Flydra's table {@code
 * ML_estimates}. For observations with frames, it has the frame and {@code hz_line0} to {@code
 * hz_line5}.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class OrientationTable implements BiConsumer<String, OrientationEstimate>, Closeable {
  private final ResultFiles files;
  private BiConsumer<String, OrientationEstimate> rows;

  /**
   * Starts a temporary file, which is moved to its path when it is {@link #finish finished}: HDF5
   * by its extension, with frames if the observations have them.
   */
  public OrientationTable(
      Path out, ObservationFile observations, boolean overwrite, TableMetadata metadata)
      throws IOException {
    files =
        ResultFiles.open(
            file -> AtomicFile.create(file, overwrite),
            metadata,
            all -> {
              if (isHdf5(out)) {
                Hdf5TableWriter table =
                    Hdf5TableWriter.create(out, "ML_estimates", columns(), overwrite);
                all.add(table, table::finish);
                rows =
                    (object, now) -> append(table, object, now, observations.frame(now.timeUs()));
              } else if (observations.hasFrames()) {
                TableSink<FrameOrientationRow> table = all.table(out, FrameOrientationRow.class);
                rows =
                    (object, now) ->
                        table.accept(
                            FrameOrientationRow.of(object, now, observations.frame(now.timeUs())));
              } else {
                TableSink<OrientationRow> table = all.table(out, OrientationRow.class);
                rows = (object, now) -> table.accept(OrientationRow.of(object, now));
              }
            });
  }

  /** Whether a file will be HDF5: true for .h5, .hdf5 and .hdf. */
  public static boolean isHdf5(Path out) {
    return out.toString().toLowerCase(java.util.Locale.ROOT).matches(".*\\.(h5|hdf5?)");
  }

  /** Names and types as in Flydra's table, then additional columns. */
  private static List<Hdf5Column> columns() {
    List<Hdf5Column> columns = new ArrayList<>();
    columns.add(new Hdf5Column("obj_id", NumberType.U32));
    columns.add(new Hdf5Column("frame", NumberType.I64));
    for (String name : List.of("x", "y", "z")) {
      columns.add(new Hdf5Column(name, NumberType.F32));
    }
    for (int i = 0; i < 6; i++) {
      columns.add(new Hdf5Column("hz_line" + i, NumberType.F32));
    }
    columns.add(new Hdf5Column("timestamp", NumberType.F64));
    columns.add(new Hdf5Column("sd_axis_rad", NumberType.F32));
    columns.add(new Hdf5Column("used", NumberType.U32));
    columns.add(new Hdf5Column("rejected", NumberType.U32));
    return columns;
  }

  @Override
  public void accept(String object, OrientationEstimate now) {
    rows.accept(object, now);
  }

  private static void append(
      Hdf5TableWriter table, String object, OrientationEstimate now, long frame) {
    double[] line = now.hzLine();
    Unchecked.write(
        () ->
            table.append(
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
                now.rejected()));
  }

  private static double number(String object) throws IOException {
    if (!object.matches("\\d{1,9}")) {
      throw new IOException(
          "the body \"" + object + "\" has no number for obj_id; choose a .csv as output");
    }
    return Integer.parseInt(object);
  }

  /** Completes the file and moves it to its path. */
  public void finish() throws IOException {
    files.finish();
  }

  @Override
  public void close() throws IOException {
    files.close();
  }
}
