package haltere.ui.viewer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.ChainStage;
import haltere.core.chain.FilterChain;
import haltere.core.event.EventPacket;
import haltere.core.playback.PlayerStatus;
import haltere.core.playback.SliceSink;
import haltere.core.stream.StreamNotification;
import haltere.ui.plot.Curve;
import haltere.ui.viewer.session.SessionRequest;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** What is changed in a pause shows its effect at this very moment. */
class PauseTest {
  private final ViewerHarness viewer = new ViewerHarness();

  @AfterEach
  void close() {
    viewer.close();
  }

  /** Counts how often the moment was made anew. */
  private static final class Runs implements SliceSink {
    final AtomicInteger begun = new AtomicInteger();
    final AtomicInteger held = new AtomicInteger();

    @Override
    public void packet(EventPacket packet) {}

    @Override
    public void notified(StreamNotification notification) {}

    @Override
    public void sliceEnd(long fromUs, long toUs) {}

    @Override
    public void runUpBegins(long sliceUs) {
      begun.incrementAndGet();
    }

    @Override
    public void sliceHeld() {
      held.incrementAndGet();
    }
  }

  @Test
  void changeOfTheChainRecomputesThePausedMomentOnce() {
    playTheFlyBeyond(100_000);
    viewer.run(() -> JavaFxHarness.join(viewer.session().player().seek(100_000)));
    Runs runs = new Runs();
    viewer.session().player().addRawSink(runs);
    viewer.waitFor("it stands", () -> runs.held.get() > 0);
    FilterChain chain = viewer.session().chain();
    for (int i = 0; i < 6; i++) {
      ChainStage stage = chain.stages().get(i / 2);
      boolean on = i % 2 == 1;
      int begun = runs.begun.get();
      int held = runs.held.get();
      viewer.run(() -> viewer.session().player().edit(all -> all.setEnabled(stage, on)));
      viewer.waitFor("the moment made anew", () -> runs.held.get() > held);
      assertEquals(begun + 1, runs.begun.get(), () -> "runs for " + stage.name());
    }
  }

  @Test
  void plotsShowTheRunUpAfterASeek() {
    playTheFlyBeyond(150_000);
    viewer.run(() -> JavaFxHarness.join(viewer.session().player().seek(0)));
    viewer.waitFor("no curves", () -> newestUs() < 20_000);
    viewer.run(() -> JavaFxHarness.join(viewer.session().player().seek(140_000)));
    viewer.waitFor("curves up to the place", () -> newestUs() > 130_000);
    long samples =
        viewer
            .onFx(() -> viewer.window.context().panels().plots().table())
            .lines()
            .filter(line -> line.contains("angle_rad"))
            .count();
    assertTrue(samples > 50, samples + " samples before the place");
  }

  @Test
  void aStepBackKeepsTheSamplesOfItsSliceInThePlots() {
    playTheFlyBeyond(150_000);
    for (int i = 0; i < 3; i++) {
      viewer.run(() -> JavaFxHarness.join(viewer.session().player().step(-1)));
      PlayerStatus shown = viewer.status();
      viewer.waitFor(
          "samples up to the displayed slice",
          () -> newestUs() >= shown.timeUs() && newestUs() < shown.timeUs() + shown.sliceUs());
    }
  }

  private void playTheFlyBeyond(long elapsedUs) {
    viewer.run(() -> viewer.window.context().sessions().open(SessionRequest.scene()));
    viewer.waitUntilOpen("Fly scene");
    viewer.run(() -> viewer.window.context().playback().setSpeed(0.5));
    viewer.waitFor("some beats", () -> viewer.status().elapsedUs() > elapsedUs);
    viewer.pause();
  }

  /** Time of the newest sample in the plots, microseconds. */
  private long newestUs() {
    return viewer.window.context().panels().plots().lanes().stream()
        .flatMap(lane -> lane.curves().stream())
        .mapToLong(Curve::lastUs)
        .max()
        .orElse(0);
  }
}
