package haltere.testing.objects;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.stream.EventSource;
import haltere.testing.Recorded;
import haltere.testing.SceneEvents;
import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class CompositesTest {
  @BeforeAll
  static void needsTheRecordings() {
    LabelledRecording.all().forEach(recording -> Recorded.file(recording.file()));
  }

  static EventPacket events(ObjectScene scene) throws IOException {
    try (EventSource source = scene.events().open()) {
      return SceneEvents.of(source);
    }
  }

  @ParameterizedTest
  @EnumSource
  void eventsAreDenserInObjectBoxesThanElsewhere(Composites.Arrangement kind) throws IOException {
    ObjectScene scene = Composites.scene(kind, 7);
    assertEquals(3, scene.objects());
    assertTrue(EventDensity.of(scene).ratio() > 4, () -> kind + " has its events elsewhere");
  }

  @Test
  void sameSeedGivesTheSameComposite() throws IOException {
    ObjectScene first = Composites.scene(Composites.Arrangement.CROSSING, 11);
    ObjectScene again = Composites.scene(Composites.Arrangement.CROSSING, 11);
    assertEquals(first.truth(), again.truth());
    assertEquals(events(first), events(again));
  }

  @Test
  void onlyCrossingObjectsOverlap() throws IOException {
    assertTrue(minGap(Composites.Arrangement.CROSSING) < 0);
    assertTrue(minGap(Composites.Arrangement.APART) > 0);
    assertTrue(minGap(Composites.Arrangement.BESIDE) > 0);
  }

  private static double minGap(Composites.Arrangement kind) throws IOException {
    double least = Double.POSITIVE_INFINITY;
    for (TruthMoment moment : Composites.scene(kind, 3).truth()) {
      List<TrueObject> there = moment.objects();
      for (int i = 0; i < there.size(); i++) {
        for (int j = 0; j < i; j++) {
          least = Math.min(least, there.get(i).box().gapTo(there.get(j).box()));
        }
      }
    }
    return least;
  }
}
