package haltere.testing.objects;

import haltere.core.stream.EventSource;
import java.io.IOException;
import java.util.List;

/** A tracker that is judged. One instance judges scenes one after the other. */
public interface TrackerUnderTest {
  /**
   * Tracks a scene.
   *
   * @param scene name of the scene
   * @param events at their start; the tracker reads them to their end
   * @return rows at 100 Hz of the events' time, each from events before its time only
   * @throws IOException if the events or the tracks cannot be read
   */
  List<TrackRow> track(String scene, EventSource events) throws IOException;
}
