package haltere.ui.viewer;

import haltere.core.event.SensorGeometry;
import haltere.core.playback.PlayerStatus;
import haltere.core.playback.ScenePlayable;
import haltere.ui.viewer.controls.Theme;
import haltere.ui.viewer.feature.UserSettings;
import haltere.ui.viewer.session.SessionRequest;
import haltere.ui.viewer.session.ViewerSession;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadInfo;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.IntStream;
import javafx.animation.AnimationTimer;
import javafx.application.Platform;
import javafx.stage.Stage;

/**
 * Opens the real viewer on a source of two million events a second, through the default chain, and
 * prints how its frames are spread over time: {@code ./gradlew :ui:frameBenchmark}, on a display or
 * under {@code xvfb-run}.
 *
 * <p>A frame time is the time from one pulse that showed a new picture to the next. A block is the
 * time that something handed to the JavaFX thread waited for its turn.
 */
public final class FrameBenchmark {
  private static final double WARM_UP_S = 4;
  private static final long PROBE_NANOS = 2_000_000;

  /** Above the rate of pictures of JavaFX. */
  private static final int MAX_HZ = 70;

  private FrameBenchmark() {}

  /**
   * Runs.
   *
   * @param args million events a second (2), seconds (10), width and height of the sensor (128 128)
   */
  public static void main(String[] args) throws Exception {
    double millionEps = args.length > 0 ? Double.parseDouble(args[0]) : 2;
    double seconds = args.length > 1 ? Double.parseDouble(args[1]) : 10;
    SensorGeometry geometry =
        new SensorGeometry(
            args.length > 2 ? Integer.parseInt(args[2]) : 128,
            args.length > 3 ? Integer.parseInt(args[3]) : 128);
    measureStart();
    measureFrames(millionEps, seconds, geometry);
    Platform.exit();
    System.exit(0);
  }

  /** Time from the start of this program to the first events of the fly scene on the screen. */
  private static void measureStart() throws Exception {
    FutureTask<ViewerSession> first =
        new FutureTask<>(() -> SessionRequest.scene().firstSession(java.util.Optional.empty()));
    Thread ahead = new Thread(first, "haltere-first");
    ahead.setDaemon(true);
    ahead.start();
    CompletableFuture<ViewerWindow> opened = new CompletableFuture<>();
    Platform.startup(
        () -> {
          Platform.setImplicitExit(false);
          Theme.DARK.apply();
          Stage stage = new Stage();
          ViewerWindow window = new ViewerWindow(stage, UserSettings.inMemory());
          window.context().sessions().open(first, "the fly scene");
          stage.show();
          opened.complete(window);
        });
    ViewerWindow window = opened.get();
    waitUntil(() -> window.context().panels().framesShown() > 1);
    double startMs =
        System.currentTimeMillis()
            - ProcessHandle.current().info().startInstant().orElseThrow().toEpochMilli();
    Duration cpu = ProcessHandle.current().info().totalCpuDuration().orElse(Duration.ZERO);
    System.out.printf(
        Locale.ROOT,
        "first events shown %.2f s after the start of the JVM, CPU time until then %.2f s%n",
        startMs / 1000,
        cpu.toMillis() / 1e3);
    onFx(
        () -> {
          window.context().actions().run("quit");
          return null;
        });
  }

  private static void measureFrames(double millionEps, double seconds, SensorGeometry geometry)
      throws Exception {
    ViewerWindow window =
        onFx(
            () -> {
              Stage stage = new Stage();
              ViewerWindow made = new ViewerWindow(stage, UserSettings.inMemory());
              made.context()
                  .sessions()
                  .open(
                      SessionRequest.made(
                          () ->
                              new ScenePlayable(
                                  () -> new BusySource(geometry, millionEps), "busy source"),
                          "the busy source"));
              stage.show();
              return made;
            });
    waitUntil(
        () ->
            window.context().sessions().session().isPresent()
                && window.context().panels().framesShown() > 0);
    int pictures = (int) (seconds * MAX_HZ);
    Frames frames = new Frames(window, pictures);
    ScreenLatency latency = new ScreenLatency(pictures);
    onFx(
        () -> {
          window.context().sessions().session().orElseThrow().player().addRawSink(latency);
          window.context().panels().view().onFrame(frame -> latency.shown(frame.timeUs()));
          return null;
        });
    waitUntil(() -> status(window).elapsedUs() > WARM_UP_S * 1e6);
    PlayerStatus before = onFx(() -> status(window));
    onFx(
        () -> {
          frames.start();
          latency.clear();
          return null;
        });
    Map<String, Long> cpuBefore = cpuNanos();
    double[] blocks = blocks(seconds);
    Map<String, Long> cpuAfter = cpuNanos();
    PlayerStatus after = onFx(() -> status(window));
    long mostMb = mostMemoryMb();
    double[] times =
        onFx(
            () -> {
              frames.stop();
              return frames.times();
            });
    double measured = Arrays.stream(times).sum() / 1e3;
    System.out.printf(
        Locale.ROOT,
        "%s, %.2f million events/s into the default chain at %.3f of real time, lag %.1f ms%n",
        geometry,
        (after.eventsIn() - before.eventsIn()) / 1e6 / measured,
        (after.elapsedUs() - before.elapsedUs()) / 1e6 / measured,
        after.lagUs() / 1e3);
    printFrames(window, times);
    print("from the chain to the window", onFx(latency::millis));
    print("wait for the JavaFX thread", blocks);
    printMemory(times, mostMb);
    printCpu(cpuBefore, cpuAfter, times);
    onFx(
        () -> {
          window.context().actions().run("quit");
          return null;
        });
  }

  private static void printFrames(ViewerWindow window, double[] times) throws Exception {
    long conflated =
        onFx(
            () ->
                window
                    .context()
                    .sessions()
                    .session()
                    .orElseThrow()
                    .display()
                    .renderer()
                    .exchange()
                    .conflated());
    double measured = Arrays.stream(times).sum() / 1e3;
    System.out.printf(
        Locale.ROOT,
        "frames %d in %.2f s: %.1f fps, %d conflated%n",
        times.length,
        measured,
        times.length / measured,
        conflated);
    print("frame time", times);
  }

  private static void printMemory(double[] times, long mostMb) {
    System.out.printf(
        Locale.ROOT,
        "frames later than 100 ms: %d; memory of the process %d MB at most, heap after a collection"
            + " %d MB%n",
        Arrays.stream(times).filter(millis -> millis > 100).count(),
        mostMb,
        usedMb());
  }

  private static void printCpu(
      Map<String, Long> cpuBefore, Map<String, Long> cpuAfter, double[] times) {
    double measured = Arrays.stream(times).sum() / 1e3;
    System.out.println("CPU time, share of one core and per frame:");
    cpuAfter.forEach(
        (thread, nanos) -> {
          double used = (nanos - cpuBefore.getOrDefault(thread, 0L)) / 1e9;
          if (used > 0.01 * measured) {
            System.out.printf(
                Locale.ROOT,
                "  %5.1f %%  %6.2f ms  %s%n",
                100 * used / measured,
                1e3 * used / times.length,
                thread);
          }
        });
  }

  private static long usedMb() {
    System.gc();
    return Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory() >> 20;
  }

  /** As Linux counts it; 0 elsewhere. */
  private static long mostMemoryMb() throws IOException {
    Path status = Path.of("/proc/self/status");
    if (!Files.exists(status)) {
      return 0;
    }
    return Files.readAllLines(status).stream()
        .filter(line -> line.startsWith("VmHWM"))
        .mapToLong(line -> Long.parseLong(line.replaceAll("\\D", "")) >> 10)
        .findFirst()
        .orElse(0);
  }

  /** Asks the JavaFX thread for a sign of life again and again, and notes how long that took. */
  private static double[] blocks(double seconds) throws Exception {
    long end = System.nanoTime() + (long) (seconds * 1e9);
    // half as large as numbers of 64 bits, as it counts in the memory of the process
    float[] waits = new float[(int) (seconds * 1e9 / PROBE_NANOS) + 1];
    int count = 0;
    while (System.nanoTime() < end && count < waits.length) {
      long asked = System.nanoTime();
      CompletableFuture<Long> answer = new CompletableFuture<>();
      Platform.runLater(() -> answer.complete(System.nanoTime()));
      waits[count++] = (answer.get() - asked) / 1e6f;
      LockSupport.parkNanos(PROBE_NANOS);
    }
    return IntStream.range(0, count).mapToDouble(i -> waits[i]).toArray();
  }

  /** CPU time of each thread so far; threads of one name together. */
  private static Map<String, Long> cpuNanos() {
    ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    Map<String, Long> nanos = new TreeMap<>();
    for (ThreadInfo info : threads.getThreadInfo(threads.getAllThreadIds())) {
      if (info != null) {
        nanos.merge(info.getThreadName(), threads.getThreadCpuTime(info.getThreadId()), Long::sum);
      }
    }
    return nanos;
  }

  private static void print(String what, double[] millis) {
    double[] sorted = millis.clone();
    Arrays.sort(sorted);
    System.out.printf(
        Locale.ROOT,
        "%s (ms): p50 %.2f  p95 %.2f  p99 %.2f  max %.2f%n",
        what,
        quantile(sorted, 0.5),
        quantile(sorted, 0.95),
        quantile(sorted, 0.99),
        sorted[sorted.length - 1]);
  }

  private static double quantile(double[] sorted, double share) {
    return sorted[(int) Math.min(sorted.length - 1, Math.round(share * (sorted.length - 1)))];
  }

  private static PlayerStatus status(ViewerWindow window) {
    return window.context().sessions().session().orElseThrow().player().status();
  }

  private static <T> T onFx(Callable<T> call) throws Exception {
    CompletableFuture<T> result = new CompletableFuture<>();
    Platform.runLater(
        () -> {
          try {
            result.complete(call.call());
          } catch (Throwable thrown) {
            result.completeExceptionally(thrown);
          }
        });
    return result.get(60, TimeUnit.SECONDS);
  }

  private static void waitUntil(Callable<Boolean> condition) throws Exception {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(60);
    while (!onFx(condition)) {
      if (System.nanoTime() > end) {
        throw new IllegalStateException("the viewer shows nothing");
      }
      LockSupport.parkNanos(5_000_000);
    }
  }

  /** Notes the times between pulses that showed a new picture. */
  private static final class Frames extends AnimationTimer {
    private final ViewerWindow window;
    private final double[] millis;
    private int count;
    private long shown = -1;
    private long lastNanos;

    Frames(ViewerWindow window, int capacity) {
      this.window = window;
      this.millis = new double[capacity];
    }

    @Override
    public void handle(long pulse) {
      long now = System.nanoTime();
      if (window.context().panels().framesShown() == shown) {
        return;
      }
      if (shown >= 0 && count < millis.length) {
        millis[count++] = (now - lastNanos) / 1e6;
      }
      shown = window.context().panels().framesShown();
      lastNanos = now;
    }

    double[] times() {
      return Arrays.copyOf(millis, count);
    }
  }
}
