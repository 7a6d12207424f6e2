package haltere.testing.objects;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class RoadsTest {
  @ParameterizedTest
  @EnumSource
  void eventDensityFollowsTheNumberOfEventsPerEdge(Roads.EdgeEvents edges) throws IOException {
    ObjectScene scene = Roads.scene(Roads.Traffic.FREE, edges, 4);
    EventDensity density = EventDensity.of(scene);
    EventDensity ofTwo = EventDensity.of(Roads.scene(Roads.Traffic.FREE, Roads.EdgeEvents.TWO, 4));
    assertTrue(density.ratio() > 2, () -> edges + ": " + density);
    assertTrue(edges == Roads.EdgeEvents.FIVE == density.inBoxes() > 1.5 * ofTwo.inBoxes());
  }

  @Test
  void truthScoresOneAndTheSameSeedGivesTheSameRoad() throws IOException {
    ObjectScene scene = Roads.scene(Roads.Traffic.OVERTAKING, Roads.EdgeEvents.TWO, 8);
    ObjectScore score = ObjectScore.of(scene, LooksTest.rows(scene, 0));
    assertEquals(1, score.idf1());
    assertEquals(0, score.accuracy().relativeVelocityRmse());
    ObjectScene again = Roads.scene(Roads.Traffic.OVERTAKING, Roads.EdgeEvents.TWO, 8);
    EventPacket events = CompositesTest.events(again);
    assertEquals(CompositesTest.events(scene), events);
    assertEquals(scene.truth(), again.truth());
  }
}
