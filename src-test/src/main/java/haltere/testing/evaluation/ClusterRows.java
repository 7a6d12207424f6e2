package haltere.testing.evaluation;

import haltere.core.event.EventPacket;
import haltere.filters.cluster.ClusterTrack;
import haltere.filters.cluster.ClusterTracker;
import haltere.filters.cluster.ClusterTrackerSettings;
import haltere.filters.noise.BackgroundActivity;
import haltere.filters.noise.BackgroundActivitySettings;
import java.util.ArrayList;
import java.util.List;

/** The cluster tracker alone, as {@link TrackingScores} wants it. */
public final class ClusterRows {
  private ClusterRows() {}

  /**
   * Runs background activity and the cluster tracker, both as they are by default.
   *
   * @param scene the events
   * @return the visible clusters at the times of the scene
   */
  public static List<ObjectPoint> of(TrackingScene scene) {
    List<ObjectPoint> rows = new ArrayList<>();
    ClusterTracker[] tracker = new ClusterTracker[1];
    tracker[0] =
        new ClusterTracker(
            scene.geometry(),
            ClusterTrackerSettings.defaults(),
            timeUs -> tracker[0].tracks().forEach(track -> rows.add(point(track))));
    EventPacket events = scene.events().copy();
    new BackgroundActivity(scene.geometry(), BackgroundActivitySettings.defaults()).filter(events);
    tracker[0].track(events);
    return rows;
  }

  private static ObjectPoint point(ClusterTrack track) {
    return new ObjectPoint(
        track.timeUs(), track.id(), track.xPx(), track.yPx(), track.vxPxPerS(), track.vyPxPerS());
  }

  /**
   * Prints the scores of many scenes.
   *
   * @param args seed of the first scene, and how many
   */
  public static void main(String[] args) {
    System.out.println(
        "clusters alone, "
            + TrackingScores.of(
                Long.parseLong(args[0]), Integer.parseInt(args[1]), ClusterRows::of));
  }
}
