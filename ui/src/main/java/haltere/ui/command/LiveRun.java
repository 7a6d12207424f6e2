package haltere.ui.command;

import haltere.core.camera.Camera;
import haltere.core.camera.CameraStatistics;
import haltere.core.chain.FilterChain;
import haltere.core.event.EventPacket;
import haltere.core.pipeline.ChainRunner;
import haltere.core.pipeline.OnFailure;
import haltere.core.pipeline.PipelineCounters;
import haltere.core.stream.DeviceLost;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import haltere.core.stream.internal.Daemon;
import haltere.ui.command.terminal.LiveStatus;
import haltere.ui.command.terminal.Quantities;
import java.io.IOException;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.BooleanSupplier;

/**
 * Passes a camera's events through a chain to sinks on a separate thread, until the camera is
 * closed. Chain and sinks belong to that thread from {@link #start} to the end of {@link #await}.
 *
 * <p>Thread rule: the command's thread.
 */
final class LiveRun {
  private static final long POLL_MS = 100;

  /** Maximum wait for the first events, at which a requested duration begins. */
  private static final long WARM_UP_NANOS = 1_000_000_000;

  private final Subcommand command;
  private final Camera camera;
  private final Thread thread;
  private volatile Throwable problem;
  private volatile boolean started;

  /** Losses until the camera was to stop, without those of stopping. */
  private CameraStatistics whenStopped;

  /** Shown while it runs. */
  private LiveStatus status;

  /** A run that has not started, of an open camera through a chain to sinks. */
  LiveRun(Subcommand command, Camera camera, FilterChain chain, List<StreamHandler> sinks) {
    this.command = command;
    this.camera = camera;
    ChainRunner runner =
        new ChainRunner(chain, new PipelineCounters(), OnFailure.STOP, failure -> {});
    runner.addSink(new Plugs(), true);
    sinks.forEach(sink -> runner.addSink(sink, false));
    thread = Daemon.thread(() -> work(runner), "haltere-" + camera.info().id());
  }

  private void work(ChainRunner runner) {
    try {
      while (camera.next(runner)) {
        // until it is closed
      }
    } catch (IOException | RuntimeException | Error thrown) {
      problem = thrown;
      camera.close();
    }
  }

  /**
   * Runs cameras until the duration from the first events on is over, one has ended or failed, the
   * process is to stop, or the condition holds, which is tested ten times a second. Received events
   * are still processed.
   */
  static void run(List<LiveRun> runs, OptionalDouble durationS, BooleanSupplier ended)
      throws IOException {
    long beginNanos = System.nanoTime();
    LiveStatus status =
        runs.get(0).command.liveStatus(runs.stream().map(run -> run.camera).toList());
    runs.forEach(run -> run.status = status);
    runs.forEach(run -> run.thread.start());
    try (status) {
      boolean started = false;
      while (runs.stream().allMatch(run -> run.thread.isAlive())) {
        long now = System.nanoTime();
        if (!started && now - beginNanos < WARM_UP_NANOS) {
          started = runs.stream().allMatch(run -> run.started);
          if (!started) {
            runs.get(0).thread.join(1);
            continue;
          }
          beginNanos = now;
        }
        long leftMs =
            durationS.isEmpty()
                ? POLL_MS
                : (long) (durationS.getAsDouble() * 1000) - (now - beginNanos) / 1_000_000;
        if (leftMs <= 0 || ended.getAsBoolean()) {
          break;
        }
        runs.get(0).thread.join(Math.min(leftMs, POLL_MS));
        status.show();
      }
    } catch (InterruptedException interrupted) {
      // Ctrl+C ends it
    }
    runs.forEach(LiveRun::stop);
    boolean interrupted = false;
    for (LiveRun run : runs) {
      while (run.thread.isAlive()) {
        try {
          run.thread.join();
        } catch (InterruptedException again) {
          interrupted = true;
          run.thread.interrupt();
        }
      }
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
    for (LiveRun run : runs) {
      run.rethrow();
    }
  }

  private void stop() {
    whenStopped = camera.statistics();
    camera.close();
  }

  private void rethrow() throws IOException {
    if (problem instanceof IOException thrown) {
      throw thrown;
    }
    if (problem instanceof RuntimeException thrown) {
      throw thrown;
    }
    if (problem instanceof Error thrown) {
      throw thrown;
    }
  }

  /** Prints received and lost events. */
  void summary() {
    CameraStatistics statistics = camera.statistics();
    String id = camera.info().id();
    command.message(
        "%s: %s, latency to this program %d us (median of the transfers), %d us " + "(99.9 %%)",
        id,
        Quantities.events(statistics.events()),
        statistics.medianLatencyUs(),
        statistics.latency999Us());
    if (whenStopped.lostEvents() > 0) {
      command.warning(
          "%s: lost %s in %s because this computer did not keep up",
          id,
          Quantities.events(whenStopped.lostEvents()),
          Quantities.counted(whenStopped.lostTransfers(), "transfer"));
    }
    if (whenStopped.brokenTransfers() > 0) {
      command.warning(
          "%s: %s of unknown size, by broken transfers or a simulation that is too slow",
          id, Quantities.counted(whenStopped.brokenTransfers(), "gap"));
    }
  }

  /** Reports disconnections and reconnections. */
  private final class Plugs implements StreamHandler {
    private boolean gone;

    @Override
    public void packet(EventPacket packet) {
      started = true;
    }

    @Override
    public void notified(StreamNotification notification) {
      if (notification instanceof DeviceLost lost) {
        gone = true;
        status.erase();
        command.warning(
            lost.device()
                + " was unplugged; the recording continues when it is back, Ctrl+C ends it");
      } else if (gone && notification instanceof StreamStarted) {
        gone = false;
        status.erase();
        command.message(camera.info().id() + " is back");
      }
    }
  }
}
