package haltere.ui.viewer;

import haltere.core.chain.ConfigurableFilter;
import haltere.core.chain.FilterChain;
import haltere.core.chain.Filters;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.playback.BufferedPlayable;
import haltere.core.playback.Playable;
import haltere.core.playback.Player;
import haltere.core.playback.PlayerOptions;
import haltere.core.playback.PlayerStatus.State;
import haltere.core.playback.ScenePlayable;
import haltere.core.playback.SliceSink;
import haltere.core.playback.Slicing;
import haltere.core.simulation.internal.fly.FlyScene;
import haltere.core.simulation.internal.fly.FlySceneSettings;
import haltere.filters.DefaultChain;
import haltere.testing.Waiting;
import haltere.ui.rendering.ColourMap;
import haltere.ui.rendering.DisplayMode;
import haltere.ui.rendering.Gradient;
import haltere.ui.viewer.picture.DisplayOptions;
import haltere.ui.viewer.picture.DisplaySink;
import haltere.ui.viewer.picture.Overlays;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.Optional;
import java.util.concurrent.Semaphore;
import java.util.function.Function;

/**
 * Prints how long a pause takes to show a change, and a jump to show its moment: from the request
 * until the picture has been painted, with the chains that the buttons of the viewer make, and the
 * CPU time of the chain meanwhile.
 */
public final class MomentBenchmark implements AutoCloseable {
  private static final int RUNS = 15;
  private static final Overlays OVERLAYS = new Overlays(true, Optional.empty(), Optional.empty());
  private static final long MOMENT_US = 4_000_000;
  private static final long PLAYED_US = 5_000_000;

  private final FilterChain chain;
  private final DisplaySink display;
  private final Player player;
  private final Semaphore held = new Semaphore(0);

  /** Events of run-ups and slices so far; read behind those that were passed on. */
  private volatile long events;

  private MomentBenchmark(Playable playable, Function<SensorGeometry, FilterChain> chains) {
    chain = chains.apply(playable.geometry());
    display = DisplaySink.onOwnThread(playable.geometry(), chain, options(DisplayMode.POLARITY));
    player =
        new Player(
            playable,
            chain,
            PlayerOptions.defaults()
                .withSlicing(new Slicing.ByTime(8_333))
                .withSpeed(Double.POSITIVE_INFINITY));
    player.addRawSink(display.beforeChain());
    player.addSink(display);
    player.addRawSink(
        new SliceSink() {
          @Override
          public void packet(EventPacket packet) {
            events += packet.size();
          }

          @Override
          public void sliceEnd(long fromUs, long toUs) {
            // a slice that is held is complete
          }

          @Override
          public void sliceHeld() {
            held.release();
          }
        });
  }

  private static DisplayOptions options(DisplayMode mode) {
    return new DisplayOptions(
        mode, ColourMap.DARK, Gradient.CIVIDIS, DisplayOptions.FOLLOW_SLICES, 0);
  }

  /** Plays, and pauses at the moment. */
  private void begin() {
    player.start().join();
    Waiting.until("some seconds", () -> player.status().elapsedUs() > PLAYED_US);
    player.pause().join();
    Waiting.until("the pause", () -> player.status().state() == State.PAUSED);
    measure(() -> player.seek(MOMENT_US).join());
  }

  /** Milliseconds until the moment is painted once more. */
  private double measure(Runnable change) {
    // what was asked for before has been painted by then
    player.read(all -> {}).join();
    display.picture(OVERLAYS);
    held.drainPermits();
    long nanos = System.nanoTime();
    change.run();
    held.acquireUninterruptibly();
    player.read(all -> display.picture(OVERLAYS)).join();
    return (System.nanoTime() - nanos) * 1e-6;
  }

  private void print(String what, Runnable... changes) {
    double[] millis = new double[RUNS];
    double[] cpuMillis = new double[RUNS];
    for (int run = 0; run < RUNS; run++) {
      double before = cpuMillis();
      millis[run] = measure(changes[run % changes.length]);
      cpuMillis[run] = cpuMillis() - before;
    }
    Arrays.sort(millis);
    Arrays.sort(cpuMillis);
    System.out.printf(
        "  %-28s median %5.0f ms, longest %5.0f ms; CPU median %5.0f ms, longest %5.0f ms%n",
        what, millis[RUNS / 2], millis[RUNS - 1], cpuMillis[RUNS / 2], cpuMillis[RUNS - 1]);
  }

  /** CPU time of the thread of the chain, which does not depend on other programs. */
  private static double cpuMillis() {
    return Thread.getAllStackTraces().keySet().stream()
            .filter(thread -> thread.getName().equals("haltere-player"))
            .mapToLong(
                thread -> ManagementFactory.getThreadMXBean().getThreadCpuTime(thread.getId()))
            .sum()
        * 1e-6;
  }

  private void show(DisplayMode mode) {
    display.renderer().setOptions(options(mode));
    player.refresh();
  }

  private void setEnabled(boolean on) {
    player.edit(all -> all.setEnabled(all.stages().get(0), on));
  }

  private void reapply() {
    player.edit(
        all -> {
          ConfigurableFilter<?> first = (ConfigurableFilter<?>) all.stages().get(0).filter();
          all.apply(all.stages().get(0), (Record) first.settings());
        });
  }

  private void run() {
    begin();
    long before = events;
    measure(() -> player.seek(MOMENT_US));
    System.out.printf("  %,d events before and in the moment%n", events - before);
    print("jump", () -> player.seek(MOMENT_US));
    print(
        "display mode",
        () -> show(DisplayMode.COUNTS),
        () -> show(DisplayMode.FREQUENCY),
        () -> show(DisplayMode.POLARITY));
    show(DisplayMode.POLARITY);
    if (!chain.stages().isEmpty()) {
      print("filter off and on", () -> setEnabled(false), () -> setEnabled(true));
      setEnabled(true);
      print("setting", this::reapply);
    }
    print(
        "filter added and removed",
        () -> player.edit(all -> all.add(Filters.named("refractory"))),
        () -> player.edit(all -> all.remove(all.stage("refractory"))));
  }

  @Override
  public void close() {
    player.close();
    display.close();
    chain.close();
  }

  private static FilterChain denoised(SensorGeometry geometry) {
    FilterChain chain = new FilterChain(geometry);
    chain.add(Filters.named("background-activity"));
    chain.add(Filters.named("hot-pixels"));
    return chain;
  }

  private static FilterChain objects(SensorGeometry geometry) {
    FilterChain chain = denoised(geometry);
    chain.add(Filters.named("object-tracker"));
    return chain;
  }

  private static Playable busy(double millionEps) {
    SensorGeometry sensor = new SensorGeometry(346, 260);
    return new BufferedPlayable(
        new ScenePlayable(() -> new BusySource(sensor, millionEps), "busy source"), 6_000_000);
  }

  private static Playable fly() {
    return new BufferedPlayable(
        new ScenePlayable(() -> new FlyScene(FlySceneSettings.defaults()), "Fly scene"), 6_000_000);
  }

  private static void run(
      String name, Playable playable, Function<SensorGeometry, FilterChain> chains) {
    System.out.println(name);
    try (MomentBenchmark benchmark = new MomentBenchmark(playable, chains)) {
      benchmark.run();
    }
  }

  /** Measures at 0.5 million events a second, or as many as the argument says. */
  public static void main(String[] args) {
    double millionEps = args.length > 0 ? Double.parseDouble(args[0]) : 0.5;
    run("no filter", busy(millionEps), FilterChain::new);
    run("Denoise", busy(millionEps), MomentBenchmark::denoised);
    run("Track objects", busy(millionEps), DefaultChain::create);
    run("Denoise and Track objects", busy(millionEps), MomentBenchmark::objects);
    run("fly with its wing tracker", fly(), DefaultChain::forFly);
  }
}
