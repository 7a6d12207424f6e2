package haltere.ui.space;

import haltere.core.playback.Playable;
import haltere.core.playback.ScenePlayable;
import haltere.core.simulation.FlightCamera;
import haltere.core.simulation.FlightScene;
import haltere.core.simulation.FlightSettings;
import haltere.filters.orientation.CameraModel;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/**
 * Several event cameras that look at one body on one clock: the first one's events are played, the
 * others' are pulled along.
 *
 * <p>Thread rule: as its playables.
 *
 * @param cameras calibrated, in order
 * @param first the events of the first camera
 * @param others the events of the others; each can go back to its start
 */
public record CameraRig(List<CameraModel> cameras, Playable first, List<Playable> others)
    implements AutoCloseable {
  /** Copies, and checks the numbers. */
  public CameraRig {
    cameras = List.copyOf(cameras);
    others = List.copyOf(others);
    if (cameras.size() != others.size() + 1) {
      throw new IllegalArgumentException(
          "there are " + cameras.size() + " cameras, and events of " + (others.size() + 1));
    }
  }

  /**
   * A simulated flight before all its cameras.
   *
   * @param settings the flight; which camera is chosen does not matter
   * @return cameras and scenes
   */
  public static CameraRig simulated(FlightSettings settings) {
    List<CameraModel> cameras = new ArrayList<>();
    List<Playable> scenes = new ArrayList<>();
    for (FlightCamera each : new FlightScene(settings.with("view.camera=0")).cameras()) {
      FlightSettings own = settings.with("view.camera=" + cameras.size());
      scenes.add(new ScenePlayable(() -> new FlightScene(own), "Flight, " + each.id()));
      double[] matrix =
          each.matrix().stream().flatMap(List::stream).mapToDouble(Double::doubleValue).toArray();
      cameras.add(
          CameraModel.of(each.id(), matrix, new double[0], each.widthPx(), each.heightPx()));
    }
    return new CameraRig(cameras, scenes.get(0), scenes.subList(1, scenes.size()));
  }

  /** Closes the others; the first belongs to its player. */
  @Override
  public void close() throws IOException {
    for (Playable other : others) {
      other.close();
    }
  }
}
