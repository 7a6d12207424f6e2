package haltere.ui.viewer.picture;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.FilterChain;
import haltere.core.chain.Filters;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.Recordings;
import haltere.core.playback.BufferedPlayable;
import haltere.core.playback.Loop;
import haltere.core.playback.Playable;
import haltere.core.playback.Player;
import haltere.core.playback.PlayerOptions;
import haltere.core.playback.PlayerStatus.State;
import haltere.core.playback.RecordingPlayable;
import haltere.core.playback.ScenePlayable;
import haltere.core.playback.SliceSink;
import haltere.core.playback.Slicing;
import haltere.core.simulation.internal.fly.FlyScene;
import haltere.core.simulation.internal.fly.FlySceneSettings;
import haltere.filters.DefaultChain;
import haltere.testing.Recorded;
import haltere.testing.Waiting;
import haltere.ui.rendering.ColourMap;
import haltere.ui.rendering.DisplayMode;
import haltere.ui.rendering.Gradient;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.Arrays;
import java.util.OptionalLong;
import java.util.concurrent.Callable;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The same moment is the same picture with the same marks, however it was reached. */
@Timeout(value = 120, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class MomentsTest {
  private static final Function<SensorGeometry, FilterChain> CLUSTERS =
      geometry -> {
        FilterChain chain = new FilterChain(geometry);
        chain.add(Filters.named("background-activity"));
        chain.add(Filters.named("cluster-tracker"));
        return chain;
      };

  private static Playable recording() throws IOException {
    return recording("dvxplorer-sample.aedat4");
  }

  private static Playable recording(String name) throws IOException {
    return new RecordingPlayable(Recordings.open(Recorded.file(name)));
  }

  private static Playable scene() {
    return new BufferedPlayable(
        new ScenePlayable(() -> new FlyScene(FlySceneSettings.defaults()), "Fly scene"), 6_000_000);
  }

  private static DisplayOptions shownAs(DisplayMode mode) {
    return new DisplayOptions(
        mode, ColourMap.DARK, Gradient.CIVIDIS, DisplayOptions.FOLLOW_SLICES, 0);
  }

  /** A player with the sink that makes its pictures, as a session of the viewer has them. */
  private static final class Shown implements AutoCloseable {
    final FilterChain chain;
    final DisplaySink display;
    final Player player;
    private volatile long pauseAtUs = Long.MAX_VALUE;

    Shown(Playable playable, Function<SensorGeometry, FilterChain> chains, DisplayMode mode) {
      chain = chains.apply(playable.geometry());
      display = DisplaySink.onOwnThread(playable.geometry(), chain, shownAs(mode));
      PlayerOptions options =
          PlayerOptions.defaults()
              .withSlicing(new Slicing.ByTime(8_333))
              .withSpeed(8)
              .withPaused(true);
      player = new Player(playable, chain, options);
      player.addRawSink(display.beforeChain());
      player.addSink(display);
      player.addSink(new PauseSink(playable));
      player.start().join();
    }

    /** Pauses between two slices, so that a busy machine plays no further than an idle one. */
    private final class PauseSink implements SliceSink {
      private final Playable playable;

      PauseSink(Playable playable) {
        this.playable = playable;
      }

      @Override
      public void packet(EventPacket packet) {
        // the display shows it
      }

      @Override
      public void sliceEnd(long fromUs, long toUs) {
        if (playable.elapsedUs(toUs) >= pauseAtUs) {
          pauseAtUs = Long.MAX_VALUE;
          player.pause();
        }
      }
    }

    Shown seek(long elapsedUs) {
      player.seek(elapsedUs).join();
      return this;
    }

    Shown step(int slices) {
      player.step(slices).join();
      return this;
    }

    long elapsedUs() {
      return player.status().elapsedUs();
    }

    /** Percentage of the events of the moment that the chain removed. */
    int percentHidden() {
      return display.passed.takePercentHidden().orElseThrow();
    }

    int[] picture() {
      BufferedImage[] picture = new BufferedImage[1];
      player.read(all -> picture[0] = display.picture(PictureRendererTest.MARKS_ALONE)).join();
      BufferedImage made = picture[0];
      return made.getRGB(0, 0, made.getWidth(), made.getHeight(), null, 0, made.getWidth());
    }

    /** Waits until the picture is as expected. */
    void awaitPicture(int[] expected, String when) {
      long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(10);
      int[] now = picture();
      while (!Arrays.equals(expected, now) && System.nanoTime() < end) {
        now = picture();
      }
      assertArrayEquals(expected, now, when);
    }

    void playTo(long elapsedUs) {
      pauseAtUs = elapsedUs;
      player.play().join();
      Waiting.until("the pause", () -> player.status().state() != State.PLAYING);
      assertEquals(State.PAUSED, player.status().state());
    }

    @Override
    public void close() {
      player.close();
      display.close();
      chain.close();
    }
  }

  private static void assertOneMomentIsOnePicture(
      Callable<Playable> source,
      Function<SensorGeometry, FilterChain> chains,
      DisplayMode mode,
      long untilUs)
      throws Exception {
    try (Shown played = new Shown(source.call(), chains, mode);
        Shown other = new Shown(source.call(), chains, mode)) {
      played.playTo(untilUs);
      long momentUs = played.elapsedUs();
      if (other.player.playable().durationUs().isEmpty()) {
        // a scene cannot be sought where it has not been
        other.playTo(momentUs + 100_000);
      }
      int[] sought = other.seek(momentUs).picture();
      assertEquals(momentUs, other.elapsedUs());
      assertTrue(Arrays.stream(sought).distinct().count() > 20, "there is something to see");
      played.awaitPicture(sought, "played to " + momentUs + " us");
      int hidden = other.percentHidden();
      assertEquals(hidden, played.percentHidden());
      played.step(3);
      assertFalse(Arrays.equals(sought, played.picture()));
      played.step(-3).awaitPicture(sought, "three slices on and back");
      assertEquals(hidden, played.percentHidden());
      played.step(-2).step(1).step(1).awaitPicture(sought, "two slices back and on");
      played.player.setLoop(
          new Loop(true, OptionalLong.of(momentUs), OptionalLong.of(momentUs + 50_000)));
      played.player.rewind().join();
      played.awaitPicture(sought, "gone back to the start of a loop");
    }
  }

  @Test
  void clusterMomentsDoNotDependOnTheirHistory() throws Exception {
    assertOneMomentIsOnePicture(MomentsTest::recording, CLUSTERS, DisplayMode.POLARITY, 350_000);
    assertOneMomentIsOnePicture(MomentsTest::recording, CLUSTERS, DisplayMode.COUNTS, 300_000);
  }

  @Test
  void trackedObjectMomentsDoNotDependOnTheirHistory() throws Exception {
    assertOneMomentIsOnePicture(
        () -> recording("dvs128-pendulum.aedat"),
        DefaultChain::create,
        DisplayMode.INTENSITY,
        9_300_000);
  }

  @Test
  void wingMomentsOfTheFlySceneDoNotDependOnTheirHistory() throws Exception {
    assertOneMomentIsOnePicture(
        MomentsTest::scene, DefaultChain::forFly, DisplayMode.POLARITY, 4_350_000);
  }

  @Test
  void soughtMomentShowsHiddenEvents() throws Exception {
    Function<SensorGeometry, FilterChain> denoised =
        geometry -> {
          FilterChain chain = new FilterChain(geometry);
          chain.add(Filters.named("background-activity"));
          return chain;
        };
    try (Shown raw = new Shown(recording(), FilterChain::new, DisplayMode.POLARITY);
        Shown all = new Shown(recording(), denoised, DisplayMode.POLARITY)) {
      int[] expected = raw.seek(350_000).picture();
      assertFalse(Arrays.equals(expected, all.seek(350_000).picture()));
      all.display.setAllEvents(true);
      all.seek(350_000).awaitPicture(expected, "with all events");
    }
  }

  @Test
  void pauseAppliesChangedOptionsAndFiltersToItsMoment() throws Exception {
    try (Shown shown = new Shown(recording(), CLUSTERS, DisplayMode.POLARITY);
        Shown counts = new Shown(recording(), CLUSTERS, DisplayMode.COUNTS)) {
      int[] polarity = shown.seek(350_000).picture();
      shown.display.renderer().setOptions(shownAs(DisplayMode.COUNTS));
      shown.player.refresh();
      shown.awaitPicture(counts.seek(350_000).picture(), "events counted");
      shown.player.edit(chain -> chain.setEnabled(chain.stages().get(0), false));
      shown.display.renderer().setOptions(shownAs(DisplayMode.POLARITY));
      shown.player.refresh();
      try (Shown raw =
          new Shown(
              recording(),
              geometry -> {
                FilterChain chain = CLUSTERS.apply(geometry);
                chain.setEnabled(chain.stages().get(0), false);
                return chain;
              },
              DisplayMode.POLARITY)) {
        int[] expected = raw.seek(350_000).picture();
        assertFalse(Arrays.equals(polarity, expected));
        shown.awaitPicture(expected, "without its noise filter");
      }
      shown.player.edit(chain -> chain.setEnabled(chain.stages().get(0), true));
      shown.awaitPicture(polarity, "with its noise filter again");
    }
  }

  @Test
  void aModeOfALongerMemoryMakesTheMomentAnewOnce() throws Exception {
    AtomicInteger begun = new AtomicInteger();
    Semaphore held = new Semaphore(0);
    SliceSink runs =
        new SliceSink() {
          @Override
          public void packet(EventPacket packet) {
            // only runs are counted
          }

          @Override
          public void sliceEnd(long fromUs, long toUs) {
            // a slice that is held is complete
          }

          @Override
          public void runUpBegins(long sliceUs) {
            begun.incrementAndGet();
          }

          @Override
          public void sliceHeld() {
            held.release();
          }
        };
    try (Shown shown = new Shown(recording(), CLUSTERS, DisplayMode.POLARITY)) {
      shown.seek(350_000);
      shown.player.addRawSink(runs);
      held.acquire();
      for (DisplayMode mode : new DisplayMode[] {DisplayMode.FREQUENCY, DisplayMode.POLARITY}) {
        begun.set(0);
        shown.display.renderer().setOptions(shownAs(mode));
        shown.player.refresh();
        held.acquire();
        // each waits for what has begun
        shown.picture();
        shown.picture();
        assertEquals(1, begun.get(), () -> "runs for " + mode);
      }
    }
  }
}
