package haltere.filters.noise;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.simulation.internal.dots.MovingDotsScene;
import haltere.core.simulation.internal.dots.MovingDotsSettings;
import haltere.core.stream.EventSource;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.testing.EventPackets;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** The support time selected from the noise. */
class AutomaticSupportTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);
  private static final BackgroundActivitySettings AUTOMATIC = BackgroundActivitySettings.defaults();

  /** Result of a scene. */
  private record Run(
      double keptOfObjects, double keptOfNoise, List<BackgroundActivityShare> shares) {}

  private record Event(long timeUs, int address) {}

  @Test
  void sparseObjectsKeepNineTenthsOfTheirEvents() throws IOException {
    for (int seed = 1; seed <= 3; seed++) {
      for (int speed : new int[] {80, 150, 600}) {
        Run run = run(AUTOMATIC, seed, 0.2, "dots.eventsPerPixel=0.5", "dots.speedPxS=" + speed);
        String message = "seed " + seed + ", " + speed + " px/s: " + run.keptOfObjects;
        assertTrue(run.keptOfObjects >= 0.9, message);
        assertTrue(run.keptOfNoise < 0.4, message + ", of the noise " + run.keptOfNoise);
      }
    }
  }

  @Test
  void denseObjectsHaveAShortTimeAndLittleNoise() throws IOException {
    Run run = run(AUTOMATIC, 4, 0.2, "dots.eventsPerPixel=3", "dots.speedPxS=150");
    assertTrue(run.keptOfObjects > 0.97, "of the objects " + run.keptOfObjects);
    BackgroundActivityShare last = run.shares.get(run.shares.size() - 1);
    assertTrue(last.correlationUs() < 100_000, last.toString());
    assertTrue(run.keptOfNoise < 0.2, "of the noise " + run.keptOfNoise);
  }

  @Test
  void fivePercentOfNoisePass() {
    for (double rateHz : new double[] {0.05, 0.2, 1, 5}) {
      double stepUs = 1e6 / (rateHz * SENSOR.pixels());
      int events = (int) (5e6 / stepUs);
      EventPacket noise = EventPackets.uniform(SENSOR, 5, events, 0, stepUs);
      int half = noise.size() / 2;
      BackgroundActivity filter = new BackgroundActivity(SENSOR, AUTOMATIC);
      filter.filter(EventPackets.part(noise, 0, half));
      EventPacket rest = EventPackets.part(noise, half, noise.size());
      double all = rest.size();
      filter.filter(rest);
      assertEquals(0.05, rest.size() / all, 0.02, rateHz + " Hz");
    }
  }

  @Test
  void moreNeighboursLengthenTheTimeAtTheSameShareOfNoise() {
    double stepUs = 1e6 / (0.5 * SENSOR.pixels());
    EventPacket noise = EventPackets.uniform(SENSOR, 6, 80_000, 0, stepUs);
    BackgroundActivity filter =
        new BackgroundActivity(SENSOR, new BackgroundActivitySettings(0, 2, true));
    filter.filter(EventPackets.part(noise, 0, 40_000));
    EventPacket rest = EventPackets.part(noise, 40_000, 80_000);
    filter.filter(rest);
    assertEquals(0.05, rest.size() / 40_000.0, 0.02);
  }

  @Test
  void eventsOfAMovingPictureAreNotTakenForNoise() {
    EventPacket bars = EventPackets.movingBars(SENSOR, 7, 2_000_000, 0);
    // the noise of 1 Hz a pixel is not wanted
    double moving = bars.size() - 2 * SENSOR.pixels();
    new BackgroundActivity(SENSOR, AUTOMATIC).filter(bars);
    assertTrue(bars.size() > 0.98 * moving, "kept " + bars.size() / moving);
  }

  @Test
  void hotPixelsDoNotShortenTheTime() {
    double stepUs = 1e6 / (0.2 * SENSOR.pixels());
    EventPacket noise = EventPackets.uniform(SENSOR, 8, 16_000, 0, stepUs);
    int[] hot = new int[10];
    Arrays.setAll(hot, i -> EventAddress.pack(7 + 12 * i, 10 + 11 * i, true));
    List<BackgroundActivityShare> without = new ArrayList<>();
    List<BackgroundActivityShare> with = new ArrayList<>();
    new BackgroundActivity(SENSOR, AUTOMATIC, without::add).filter(EventPackets.copy(noise));
    new BackgroundActivity(SENSOR, AUTOMATIC, with::add)
        .filter(EventPackets.withHotPixels(noise, 100, hot));
    int expectedUs = without.get(without.size() - 1).correlationUs();
    assertEquals(expectedUs, with.get(with.size() - 1).correlationUs(), 0.35 * expectedUs);
  }

  @Test
  void removedShareIsPublishedEveryTenthOfASecond() throws IOException {
    Run run = run(AUTOMATIC, 9, 1, "dots.eventsPerPixel=1");
    assertEquals(39, run.shares.size(), 1);
    for (BackgroundActivityShare share : run.shares) {
      assertEquals(0, share.timeUs() % 100_000);
      assertEquals(1, share.passedShare() + share.removedShare(), 1e-9);
      assertTrue(share.removedShare() > 0.1 && share.removedShare() < 1, share.toString());
      assertTrue(share.correlationUs() >= 1_000 && share.correlationUs() <= 500_000);
      assertTrue(share.events() > 100, share.toString());
    }
  }

  @Test
  void explicitTimesAreKept() throws IOException {
    Run run = run(new BackgroundActivitySettings(25_000, 1, false), 10, 1);
    assertTrue(run.shares.stream().allMatch(share -> share.correlationUs() == 25_000));
  }

  private static Run run(
      BackgroundActivitySettings settings, int seed, double noiseHz, String... assignments)
      throws IOException {
    List<String> all = new ArrayList<>(List.of(assignments));
    all.addAll(List.of("run.seed=" + seed, "run.durationS=4", "noise.leakHz=0"));
    all.add("noise.shotHz=0");
    Set<Event> objects = new HashSet<>(events(scene(all)));
    all.set(all.size() - 1, "noise.shotHz=" + noiseHz);
    EventPacket packet = packet(scene(all));
    double fromObjects = count(packet, objects);
    double fromNoise = packet.size() - fromObjects;
    List<BackgroundActivityShare> shares = new ArrayList<>();
    new BackgroundActivity(SENSOR, settings, shares::add).filter(packet);
    double kept = count(packet, objects);
    return new Run(kept / fromObjects, (packet.size() - kept) / fromNoise, shares);
  }

  private static MovingDotsScene scene(List<String> assignments) {
    return new MovingDotsScene(
        MovingDotsSettings.defaults().with(assignments.toArray(String[]::new)));
  }

  private static double count(EventPacket packet, Set<Event> wanted) {
    return events(packet).stream().filter(wanted::contains).count();
  }

  private static List<Event> events(EventSource source) throws IOException {
    return events(packet(source));
  }

  private static List<Event> events(EventPacket packet) {
    List<Event> events = new ArrayList<>();
    for (int i = 0; i < packet.size(); i++) {
      events.add(new Event(packet.timeUs(i), packet.address(i)));
    }
    return events;
  }

  private static EventPacket packet(EventSource source) throws IOException {
    EventPacket all = new EventPacket(0);
    source.drainTo(
        new StreamHandler() {
          @Override
          public void packet(EventPacket packet) {
            all.append(packet, 0, packet.size());
          }

          @Override
          public void notified(StreamNotification notification) {
            // nothing breaks a scene
          }
        });
    return all;
  }
}
