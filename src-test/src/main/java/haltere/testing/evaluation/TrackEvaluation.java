package haltere.testing.evaluation;

import haltere.core.chain.FilterChain;
import haltere.core.chain.Filters;
import haltere.core.event.EventPacket;
import haltere.filters.track.KalmanTracksSettings;
import haltere.filters.track.TrackUpdate;
import haltere.filters.track.kalman.KalmanTracksFilter;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * Scores Kalman tracks with their default settings, behind the background activity filter, on
 * seeded {@link TrackingScene}s: {@code ./gradlew :src-test:evaluateTracks}.
 */
public final class TrackEvaluation {
  private TrackEvaluation() {}

  /**
   * Scores and prints.
   *
   * @param arguments the first seed and the number of scenes
   */
  public static void main(String[] arguments) {
    long firstSeed = Long.parseLong(arguments[0]);
    int scenes = Integer.parseInt(arguments[1]);
    TrackConsistency consistency = new TrackConsistency();
    System.out.println(TrackingScores.of(firstSeed, scenes, scene -> tracks(scene, consistency)));
    System.out.println(consistency);
  }

  /**
   * The tracks of a scene.
   *
   * @param scene the scene
   * @return where they are at the times of the scene
   */
  public static List<ObjectPoint> tracks(TrackingScene scene) {
    return tracks(scene, new TrackConsistency());
  }

  /**
   * The tracks of a scene.
   *
   * @param scene the scene
   * @param consistency takes the steps of their filters
   * @return where they are at the times of the scene
   */
  public static List<ObjectPoint> tracks(TrackingScene scene, TrackConsistency consistency) {
    FilterChain chain = new FilterChain(scene.geometry());
    chain.add(Filters.named("background-activity"));
    KalmanTracksFilter tracks =
        new KalmanTracksFilter(scene.geometry(), KalmanTracksSettings.defaults());
    chain.add("kalman-tracks", tracks);
    Set<Long> timesUs = new HashSet<>();
    for (long timeUs : scene.timesUs()) {
      timesUs.add(timeUs);
    }
    List<ObjectPoint> rows = new ArrayList<>();
    List<TrackUpdate> updates = new ArrayList<>();
    tracks
        .points()
        .subscribe(
            at -> {
              if (timesUs.contains(at.timeUs())) {
                rows.add(
                    new ObjectPoint(
                        at.timeUs(), at.id(), at.xPx(), at.yPx(), at.vxPxS(), at.vyPxS()));
              }
            });
    tracks.updates().subscribe(updates::add);
    EventPacket copy = new EventPacket(scene.events().size());
    copy.append(scene.events(), 0, scene.events().size());
    chain.process(copy);
    chain.close();
    consistency.add(scene, rows, updates);
    return rows;
  }
}
