package haltere.ui.command;

import haltere.core.chain.EventFilter;
import haltere.core.chain.FilterProvider;
import haltere.core.chain.Filters;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import haltere.core.simulation.Scene;
import haltere.core.simulation.Scenes;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.filters.DefaultChain;
import haltere.ui.command.terminal.ProgressBar;
import haltere.ui.command.terminal.Quantities;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.function.Supplier;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/**
 * Measures the throughput of each stage alone, on one thread. Each stage warms up for the
 * measurement time and at least one round; figures are medians of the rounds.
 */
@Command(
    name = "bench",
    description =
        "Measure the throughput of each stage on this machine, in million events a second,"
            + " on a recording or on the built-in fly scene.")
final class BenchCommand extends Subcommand {
  /** Maximum number of events in memory for the filters; 48 MB. */
  private static final int MAX_EVENTS = 4_000_000;

  private static final int SCENE_EVENTS = 1_000_000;
  private static final int FEWEST_ROUNDS = 3;

  /** Less than one clock cycle per event. */
  private static final double MIN_NANOS = 0.1;

  @Parameters(arity = "0..1", paramLabel = "FILE", description = "A recording.")
  Path file;

  @Option(
      names = "--seconds",
      paramLabel = "S",
      defaultValue = "3",
      description = "Warm-up time of each stage, and measurement time after it; default 3.")
  double seconds;

  @Mixin ReadingOptions reading;

  /** A round of work on all events; gives back the nanoseconds that count. */
  private interface Round {
    long run() throws IOException;
  }

  @Override
  public Integer call() throws IOException {
    reading.checkNeeded(file);
    checkRange(seconds >= 0 && seconds <= 3600, "--seconds", seconds, "0 to 3600");
    if (file != null) {
      measure(file);
      return OK;
    }
    Path folder = Files.createTempDirectory("haltere-bench");
    Path scene = folder.resolve("fly.aedat");
    try {
      writeScene(scene);
      measure(scene);
    } finally {
      Files.deleteIfExists(scene);
      Files.deleteIfExists(folder);
    }
    return OK;
  }

  private static void writeScene(Path target) throws IOException {
    try (Scene<?> scene = Scenes.named("fly").create(List.of());
        RecordingWriter writer =
            Recordings.forWriting(target)
                .create(target, WriteOptions.of(scene.geometry()))
                .orElseThrow()) {
      Held events = new Held(SCENE_EVENTS);
      while (!events.full() && scene.next(events)) {
        checkInterrupted("measuring");
      }
      for (EventPacket packet : events.packets) {
        writer.write(packet);
      }
      writer.finish();
    }
  }

  private void measure(Path recording) throws IOException {
    Held held = new Held(MAX_EVENTS);
    SensorGeometry geometry;
    long[] skipped = new long[1];
    String format;
    try (RecordingReader reader = reading.open(recording)) {
      geometry = reader.geometry();
      format = reader.formatName();
      StreamHandler count = packet -> skipped[0] += packet.size();
      while (reader.next(held.full() ? count : held)) {
        checkInterrupted("measuring");
      }
      reading.requireComplete(reader);
      warnings(recording, reader.remarks());
      warnings(recording, reader.violations().describe(Set.of()));
    }
    long decoded = held.events + skipped[0];
    if (held.events == 0) {
      throw new CommandProblem(recording + ": it has no events to measure with");
    }
    String name = file == null ? "the built-in fly scene" : recording.toString();
    result("%s: %s, sensor %s", name, Quantities.events(decoded), geometry);
    message(
        "each stage warms up for %s s, then the median of %d or more rounds in %s s",
        seconds, FEWEST_ROUNDS, seconds);
    result("%-24s %10s %10s", "stage", "Mev/s", "ns/event");
    stage("decode " + format, decoded, () -> decode(recording));
    for (FilterProvider<?> provider : Filters.all().values()) {
      stage(provider.name(), held.events, () -> filter(held, () -> provider.create(geometry)));
    }
    stage("default chain", held.events, () -> filter(held, () -> DefaultChain.create(geometry)));
  }

  private void stage(String name, long events, Round round) throws IOException {
    try (ProgressBar bar = progressBar(name)) {
      warmUp(round);
      long[] nanos = new long[1024];
      int rounds = 0;
      double spent = 0;
      while (rounds < nanos.length && (rounds < FEWEST_ROUNDS || spent < seconds)) {
        checkInterrupted("measuring");
        nanos[rounds] = round.run();
        spent += nanos[rounds] / 1e9;
        rounds++;
        bar.events(events * rounds);
        bar.progress(Math.round(spent * 1e6), Math.round(seconds * 1e6));
      }
      Arrays.sort(nanos, 0, rounds);
      double perEvent = nanos[rounds / 2] / (double) events;
      bar.erase();
      result(
          "%-24s %10s %10.2f",
          name,
          perEvent < MIN_NANOS
              ? "no work" // a filter that passes everything as it is
              : Quantities.text("%.1f", 1e3 / perEvent),
          perEvent);
      surroundings().out().flush();
    }
  }

  private void warmUp(Round round) throws IOException {
    double spent = 0;
    do {
      checkInterrupted("measuring");
      spent += round.run() / 1e9;
    } while (spent < seconds);
  }

  private long decode(Path recording) throws IOException {
    long start = System.nanoTime();
    try (RecordingReader reader = reading.open(recording)) {
      reader.drainTo(packet -> {});
    }
    return System.nanoTime() - start;
  }

  private static long filter(Held held, Supplier<EventFilter> factory) {
    EventFilter filter = factory.get();
    EventPacket scratch = new EventPacket(0);
    long nanos = 0;
    for (EventPacket packet : held.packets) {
      scratch.clear();
      scratch.append(packet, 0, packet.size());
      long start = System.nanoTime();
      filter.process(scratch);
      nanos += System.nanoTime() - start;
    }
    filter.close();
    return nanos;
  }

  /** Keeps packets, up to a number of events and to the first break of time. */
  private static final class Held implements StreamHandler {
    private final List<EventPacket> packets = new ArrayList<>();
    private final int maxEvents;
    private long events;
    private boolean broken;

    Held(int maxEvents) {
      this.maxEvents = maxEvents;
    }

    boolean full() {
      return broken || events >= maxEvents;
    }

    @Override
    public void packet(EventPacket packet) {
      packets.add(packet.copy());
      events += packet.size();
    }

    @Override
    public void notified(StreamNotification notification) {
      broken |= notification.endsContinuity() && events > 0;
    }
  }
}
