package haltere.filters.orientation.camera;

import haltere.core.format.RecordingProblem;
import haltere.core.format.internal.braidz.BraidzTables;
import haltere.core.format.internal.hdf5.Hdf5Tables;
import haltere.core.format.internal.table.RecordingTables;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;

/**
 * Observations of bodies by several cameras, from a file of one of three kinds, by content: a text
 * table ({@code t_us,camera,object,x_px,y_px,angle_rad,area_px,eccentricity}), a {@code .braidz}
 * file of Braid, or HDF5 with the tables of Flydra.
 *
 * <p>Thread rule: one thread.
 */
public final class ObservationFile {
  /** Receives observations in order of time. */
  public interface Listener {
    /**
     * An observation.
     *
     * @param timeUs microseconds, not before that of the last one
     * @param object name of the body
     * @param line the observation
     */
    void observed(long timeUs, String object, LineObservation line);

    /**
     * A skipped row.
     *
     * @param where line or row of the file, for users
     * @param why the reason
     */
    void skipped(String where, String why);

    /**
     * A statement about the whole file.
     *
     * @param words for users
     */
    default void remark(String words) {}
  }

  private final Path file;
  private final boolean isBraidz;
  private final boolean isHdf5;
  private final CameraFile cameras;
  private Map<Long, Long> frames = Map.of();

  private ObservationFile(Path file, Optional<Path> calibration) throws IOException {
    this.file = file;
    isBraidz = BraidzTables.isZip(file);
    isHdf5 = !isBraidz && Hdf5Tables.isHdf5(file);
    if (calibration.isPresent()) {
      cameras = CameraFile.read(calibration.get());
    } else if (isBraidz) {
      try (BraidzTables tables = BraidzTables.open(file)) {
        cameras = CameraXml.read(tables.calibration(), file + ": calibration.xml");
      }
    } else {
      throw new RecordingProblem(file, "it has no cameras of its own; give a file of cameras");
    }
  }

  /**
   * Opens a file and reads its cameras.
   *
   * @param file the observations
   * @param calibration the cameras; may be empty for a {@code .braidz} file, which has its own
   * @return an open file, not yet read
   * @throws RecordingProblem if there are no cameras; the message names the file
   * @throws IOException if a file cannot be read
   */
  public static ObservationFile open(Path file, Optional<Path> calibration) throws IOException {
    return new ObservationFile(file, calibration);
  }

  /**
   * Whether a file contains cameras.
   *
   * @param file any file
   * @return true for a {@code .braidz} file
   * @throws IOException if it cannot be read
   */
  public static boolean hasCameras(Path file) throws IOException {
    return BraidzTables.isZip(file);
  }

  /** {@return the cameras of the given calibration, else of the file} */
  public CameraFile cameras() {
    return cameras;
  }

  /** {@return whether observations have frame numbers, as in {@code .braidz} files and HDF5} */
  public boolean hasFrames() {
    return isBraidz || isHdf5;
  }

  /**
   * Reads all observations.
   *
   * @param listener receives them, in order of time
   * @throws RecordingProblem if it is invalid or damaged; the message names it
   * @throws IOException if it cannot be read
   */
  public void read(ObservationFile.Listener listener) throws IOException {
    if (hasFrames()) {
      try (RecordingTables tables = isBraidz ? BraidzTables.open(file) : Hdf5Tables.open(file)) {
        FlydraDetections detections =
            new FlydraDetections(file, tables, cameras.cameras(), listener);
        frames = detections.read();
        detections.handOut();
      }
    } else {
      ObservationTable.read(file, cameras.cameras(), listener);
    }
  }

  /**
   * The frame number of a time.
   *
   * @param timeUs microseconds, a time of an observation
   * @return the frame
   * @throws IllegalArgumentException if the file has none of that time
   */
  public long frame(long timeUs) {
    Long frame = frames.get(timeUs);
    if (frame == null) {
      throw new IllegalArgumentException(file + " has no frame at " + timeUs + " us");
    }
    return frame;
  }
}
