package haltere.testing.objects;

import haltere.core.stream.EventSource;
import java.io.IOException;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * Events and the truth of the objects in them.
 *
 * @param name unique, fit for a file's name
 * @param kind class of scenes under which its scores are reported
 * @param events opens them at their start
 * @param truth in the order of time
 * @param matching when a track is on an object
 */
public record ObjectScene(
    String name, String kind, SceneSource events, List<TruthMoment> truth, Matching matching) {
  /** Source of the events. */
  public interface SceneSource {
    /**
     * Opens the events.
     *
     * @return a source at its start, which the caller closes
     * @throws IOException if they cannot be read
     */
    EventSource open() throws IOException;
  }

  /** Copies the truth. */
  public ObjectScene {
    truth = List.copyOf(truth);
  }

  /**
   * How many objects a tracker has to show at some time.
   *
   * @return identities
   */
  public int objects() {
    Set<Integer> ids = new HashSet<>();
    truth.forEach(moment -> moment.objects().forEach(object -> ids.add(object.id())));
    return ids.size();
  }
}
