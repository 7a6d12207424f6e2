package haltere.filters.cluster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.filters.noise.BackgroundActivity;
import haltere.filters.noise.BackgroundActivitySettings;
import haltere.filters.trail.internal.TrailOverlay;
import haltere.filters.trail.internal.TrailSnapshot;
import haltere.testing.EventPackets;
import haltere.testing.evaluation.TrackingScene;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/**
 * Draws the picture of docs/clusters.md into build/pictures; {@code ./gradlew
 * :filters:refreshPictures} takes it over.
 */
class ClusterPictureTest {
  private static final long SHOWN_US = 1_900_000;
  private static final long EVENTS_OF_US = 25_000;

  @Test
  void pictureShowsAClusterForEachDisc() throws IOException {
    TrackingScene scene = TrackingScene.of(1021);
    EventPacket events = new EventPacket(0);
    events.append(scene.events(), 0, scene.events().indexAtOrAfter(SHOWN_US));
    new BackgroundActivity(scene.geometry(), BackgroundActivitySettings.defaults()).filter(events);
    ClusterTrackerFilter filter =
        new ClusterTrackerFilter(scene.geometry(), ClusterTrackerSettings.defaults());
    TrailSnapshot[] last = new TrailSnapshot[1];
    filter.outlets().stream()
        .filter(outlet -> outlet.type() == TrailSnapshot.class)
        .forEach(outlet -> outlet.subscribe(snapshot -> last[0] = (TrailSnapshot) snapshot));
    filter.process(EventPackets.copy(events));
    SvgCanvas canvas = new SvgCanvas(scene.geometry());
    canvas.events(events, events.indexAtOrAfter(SHOWN_US - EVENTS_OF_US));
    new TrailOverlay().draw(last[0], canvas);
    Path file = Path.of("build", "pictures", "clusters.svg");
    Files.createDirectories(file.getParent());
    Files.writeString(file, canvas.svg());
    assertTrue(Files.size(file) < 150_000, "small enough to commit: " + Files.size(file));
    long discs = scene.truth().stream().filter(point -> point.timeUs() == last[0].timeUs()).count();
    assertEquals(discs, last[0].trails().size(), 1);
  }
}
