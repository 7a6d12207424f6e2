package haltere.ui.space;

import haltere.core.camera.Cameras;
import haltere.core.event.SensorGeometry;
import haltere.core.playback.BufferedPlayable;
import haltere.core.playback.CameraPlayable;
import haltere.core.playback.Playable;
import haltere.core.playback.ScenePlayable;
import haltere.core.simulation.internal.flight.FlightCamera;
import haltere.core.simulation.internal.flight.FlightScene;
import haltere.core.simulation.internal.flight.FlightSettings;
import haltere.filters.orientation.camera.CameraModel;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/**
 * Several event cameras that observe one body on one clock: the first camera plays, the others
 * follow its time.
 *
 * <p>Thread rule: as its playables.
 *
 * @param cameras calibrated, in order
 * @param first the events of the first camera
 * @param others the events of the others; each can seek to its start
 */
public record CameraRig(List<CameraModel> cameras, Playable first, List<Playable> others)
    implements AutoCloseable {
  /** Events of each other simulated camera, 24 MB, for going back without another simulation. */
  private static final int BUFFERED_EVENTS = 3_000_000;

  /** Copies, and checks the numbers. */
  public CameraRig {
    cameras = List.copyOf(cameras);
    others = List.copyOf(others);
    if (cameras.size() != others.size() + 1) {
      throw new IllegalArgumentException(
          "there are " + cameras.size() + " cameras, and events of " + (others.size() + 1));
    }
  }

  /** A simulated flight before all its cameras; which one the settings choose does not matter. */
  public static CameraRig simulated(FlightSettings settings) {
    List<CameraModel> cameras = new ArrayList<>();
    List<Playable> scenes = new ArrayList<>();
    for (FlightCamera each : new FlightScene(settings.with("view.camera=0")).cameras()) {
      FlightSettings own = settings.with("view.camera=" + cameras.size());
      Playable scene = new ScenePlayable(() -> new FlightScene(own), "Flight, " + each.id());
      // its player buffers the first one
      scenes.add(scenes.isEmpty() ? scene : new BufferedPlayable(scene, BUFFERED_EVENTS));
      double[] matrix =
          each.matrix().stream().flatMap(List::stream).mapToDouble(Double::doubleValue).toArray();
      cameras.add(
          CameraModel.of(each.id(), matrix, new double[0], each.widthPx(), each.heightPx()));
    }
    return new CameraRig(cameras, scenes.get(0), scenes.subList(1, scenes.size()));
  }

  /**
   * The cameras themselves, by their ids in the calibration; they go on when they are plugged in
   * again. Their clocks are related by this computer's, to about a millisecond.
   */
  public static CameraRig live(List<CameraModel> calibrated, Cameras cameras) throws IOException {
    return open(calibrated, number -> CameraPlayable.open(cameras, calibrated.get(number).id()));
  }

  /** Opens the events of a camera. */
  @FunctionalInterface
  public interface Opening {
    /** Opens the events of a camera, counted from 0, at their start. */
    Playable open(int number) throws IOException;
  }

  /**
   * The events of each camera on one clock; none is left open if one cannot be opened or is of
   * another sensor, or if the cameras are too few.
   */
  public static CameraRig open(List<CameraModel> calibrated, Opening opening) throws IOException {
    long usable = calibrated.stream().filter(camera -> camera.problem().isEmpty()).count();
    if (usable < 2) {
      throw new IOException(
          "an orientation needs two cameras, the calibration has " + usable + " that can be used");
    }
    List<Playable> opened = new ArrayList<>();
    try {
      for (CameraModel camera : calibrated) {
        opened.add(opening.open(opened.size()));
        checkSize(camera, opened.get(opened.size() - 1));
      }
      return new CameraRig(calibrated, opened.get(0), opened.subList(1, opened.size()));
    } catch (IOException | RuntimeException problem) {
      for (Playable each : opened) {
        each.close();
      }
      throw problem;
    }
  }

  private static void checkSize(CameraModel camera, Playable events) throws IOException {
    SensorGeometry geometry = events.geometry();
    boolean isKnown = camera.widthPx() > 0 && camera.heightPx() > 0;
    if (isKnown
        && (camera.widthPx() != geometry.width() || camera.heightPx() != geometry.height())) {
      throw new IOException(
          "camera %s is calibrated for %s, but the events of %s are of %s"
              .formatted(
                  camera.id(),
                  new SensorGeometry(camera.widthPx(), camera.heightPx()),
                  events.name(),
                  geometry));
    }
  }

  /** Closes the others; the first belongs to its player. */
  @Override
  public void close() throws IOException {
    for (Playable other : others) {
      other.close();
    }
  }
}
