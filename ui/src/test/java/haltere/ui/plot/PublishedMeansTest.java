package haltere.ui.plot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import haltere.core.chain.FilterChain;
import haltere.core.chain.Filters;
import haltere.core.event.EventPacket;
import haltere.core.simulation.Scene;
import haltere.core.simulation.Scenes;
import haltere.core.stream.StreamHandler;
import java.io.IOException;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Means of what a chain publishes, by the time of the recording. */
class PublishedMeansTest {
  private Scene<?> scene;
  private FilterChain chain;
  private PublishedMeans means;
  private long timeUs;

  @BeforeEach
  void openDotsWithATracker() {
    scene = Scenes.named("dots").create(List.of());
    chain = chain();
    means = new PublishedMeans(chain);
  }

  @AfterEach
  void close() {
    means.close();
    chain.close();
    scene.close();
  }

  private FilterChain chain() {
    FilterChain made = new FilterChain(scene.geometry());
    made.add(Filters.named("object-tracker"));
    return made;
  }

  private void playTo(long endUs, Runnable afterEachPacket) throws IOException {
    StreamHandler through =
        packet -> {
          EventPacket copy = packet.copy();
          timeUs = packet.isEmpty() ? timeUs : packet.lastTimeUs();
          chain.process(copy);
          afterEachPacket.run();
        };
    while (timeUs < endUs && scene.next(through)) {
      // until then
    }
  }

  @Test
  void meansAreThoseOfTheMomentHoweverOftenTheyAreRead() throws IOException {
    playTo(1_500_000, () -> {});
    Map<PlotField, Double> readOnce = means.means();
    assertFalse(readOnce.isEmpty());
    close();
    timeUs = 0;
    openDotsWithATracker();
    playTo(1_500_000, () -> means.means());
    assertEquals(readOnce, means.means());
    assertEquals(readOnce, means.means());
  }

  @Test
  void meansLeaveOutWhatIsMoreThanASecondOld() throws IOException {
    playTo(1_500_000, () -> {});
    try (PublishedMeans later = new PublishedMeans(chain)) {
      playTo(2_000_000, () -> {});
      assertNotEquals(means.means(), later.means());
      playTo(3_000_000, () -> {});
      assertEquals(means.means(), later.means());
    }
  }
}
