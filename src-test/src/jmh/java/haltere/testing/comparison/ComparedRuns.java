package haltere.testing.comparison;

import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import haltere.core.format.internal.aedat4.Aedat4Compression;
import haltere.core.format.internal.aedat4.Aedat4Writer;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;

/**
 * Reads and writes recordings as an embedder would, and prints a line for each run: events and
 * seconds. Before that it does the same for some seconds, so that the JVM has compiled what it
 * runs. The last line is {@code peak} and the most memory that the process has had, in KiB.
 *
 * <pre>
 * read FILE RUNS [WxH]                     reads to the end with drainTo; WxH is the sensor if no search is wanted
 * write FROM FORMAT TO RUNS                the events of FROM, from memory; FORMAT as of the command line, or
 *                                          aedat4-none, aedat4-lz4, aedat4-zstd
 * repeat FROM FORMAT TO COPIES             the events of FROM one after the other, for inputs
 * dense FORMAT TO EVENTS                   rows of a sensor of 1280x720 that fire together, for inputs
 * idle                                     nothing: what an empty program takes
 * </pre>
 */
public final class ComparedRuns {
  private static final int PACKET = 8192;
  private static final long GAP_US = 1000;
  private static final double WARM_SECONDS = Double.parseDouble(System.getProperty("warm", "5"));

  private ComparedRuns() {}

  /** Counts events and touches each packet. */
  private static final class Sum implements StreamHandler {
    private long events;
    private long lastUs;

    @Override
    public void packet(EventPacket packet) {
      events += packet.size();
      lastUs += packet.lastTimeUs();
    }

    @Override
    public void notified(StreamNotification notification) {}
  }

  /**
   * Runs what is asked for.
   *
   * @param arguments as above
   * @throws IOException if a file cannot be read or written
   */
  public static void main(String[] arguments) throws IOException {
    switch (arguments[0]) {
      case "read" ->
          read(
              Path.of(arguments[1]),
              Integer.parseInt(arguments[2]),
              arguments.length > 3 ? stating(arguments[3]) : ReadOptions.DEFAULT);
      case "write" ->
          write(
              Path.of(arguments[1]),
              arguments[2],
              Path.of(arguments[3]),
              Integer.parseInt(arguments[4]));
      case "repeat" ->
          repeat(
              Path.of(arguments[1]),
              arguments[2],
              Path.of(arguments[3]),
              Integer.parseInt(arguments[4]));
      case "dense" -> dense(arguments[1], Path.of(arguments[2]), Long.parseLong(arguments[3]));
      case "idle" -> {
        // The peak alone is wanted.
      }
      default -> throw new IllegalArgumentException(arguments[0]);
    }
    System.out.println("peak " + peakKibibytes());
  }

  /** Reads or writes a file once and says how many events that were. */
  @FunctionalInterface
  private interface Run {
    long events() throws IOException;
  }

  private static void time(Run run, int runs) throws IOException {
    long warmNs = System.nanoTime() + (long) (WARM_SECONDS * 1e9);
    do {
      run.events();
    } while (System.nanoTime() < warmNs);
    for (int i = 0; i < runs; i++) {
      long startNs = System.nanoTime();
      long events = run.events();
      double seconds = (System.nanoTime() - startNs) / 1e9;
      System.out.println(String.format(Locale.ROOT, "run %d %.6f", events, seconds));
    }
  }

  private static ReadOptions stating(String sensor) {
    String[] sides = sensor.split("x");
    return ReadOptions.DEFAULT.withSensor(
        new SensorGeometry(Integer.parseInt(sides[0]), Integer.parseInt(sides[1]), Origin.TOP));
  }

  private static void read(Path file, int runs, ReadOptions options) throws IOException {
    Sum sum = new Sum();
    time(
        () -> {
          sum.events = 0;
          try (RecordingReader reader = Recordings.open(file, options)) {
            reader.drainTo(sum);
          }
          return sum.events;
        },
        runs);
    if (sum.lastUs == Long.MIN_VALUE) {
      throw new IllegalStateException("no times");
    }
  }

  private static RecordingWriter writer(String format, Path to, SensorGeometry sensor)
      throws IOException {
    WriteOptions options = WriteOptions.of(sensor).withOverwrite(true);
    if (format.startsWith("aedat4-")) {
      String compression = format.substring("aedat4-".length()).toUpperCase(Locale.ROOT);
      return Aedat4Writer.create(to, options, Aedat4Compression.valueOf(compression));
    }
    return Recordings.formats().get(format).create(to, options).orElseThrow();
  }

  private static List<EventPacket> packets(Path from) throws IOException {
    List<EventPacket> packets = new ArrayList<>();
    try (RecordingReader reader = Recordings.open(from)) {
      reader.drainTo(
          new StreamHandler() {
            @Override
            public void packet(EventPacket packet) {
              packets.add(packet.copy());
            }

            @Override
            public void notified(StreamNotification notification) {}
          });
    }
    return packets;
  }

  private static SensorGeometry sensor(Path file) throws IOException {
    try (RecordingReader reader = Recordings.open(file)) {
      return reader.geometry();
    }
  }

  private static void write(Path from, String format, Path to, int runs) throws IOException {
    SensorGeometry sensor = sensor(from);
    List<EventPacket> packets = packets(from);
    long events = packets.stream().mapToLong(EventPacket::size).sum();
    time(
        () -> {
          Files.deleteIfExists(to);
          try (RecordingWriter writer = writer(format, to, sensor)) {
            for (EventPacket packet : packets) {
              writer.write(packet);
            }
            writer.finish();
          }
          return events;
        },
        runs);
  }

  private static void repeat(Path from, String format, Path to, int copies) throws IOException {
    SensorGeometry sensor = sensor(from);
    List<EventPacket> packets = packets(from);
    long firstUs = packets.get(0).firstTimeUs();
    long spanUs = packets.get(packets.size() - 1).lastTimeUs() - firstUs + GAP_US;
    EventPacket shifted = new EventPacket(PACKET);
    try (RecordingWriter writer = writer(format, to, sensor)) {
      for (int copy = 0; copy < copies; copy++) {
        long shiftUs = copy * spanUs - Math.floorDiv(firstUs, 1_000_000L) * 1_000_000L;
        for (EventPacket packet : packets) {
          shifted.clear();
          for (int i = 0; i < packet.size(); i++) {
            shifted.append(packet.timeUs(i) + shiftUs, packet.address(i));
          }
          writer.write(shifted);
        }
      }
      writer.finish();
    }
  }

  private static void dense(String format, Path to, long events) throws IOException {
    SensorGeometry sensor = new SensorGeometry(1280, 720, haltere.core.event.Origin.TOP);
    SplittableRandom random = new SplittableRandom(1);
    EventPacket packet = new EventPacket(PACKET);
    long timeUs = 0;
    long written = 0;
    try (RecordingWriter writer = writer(format, to, sensor)) {
      while (written < events) {
        packet.clear();
        while (packet.size() < PACKET - sensor.width()) {
          int row = random.nextInt(sensor.height());
          int from = random.nextInt(sensor.width() - 100);
          boolean on = random.nextBoolean();
          for (int column = from; column < from + 64; column++) {
            if (random.nextInt(3) < 2) {
              packet.append(timeUs, column, row, on);
            }
          }
          timeUs += 2;
        }
        written += packet.size();
        writer.write(packet);
      }
      writer.finish();
    }
  }

  private static long peakKibibytes() throws IOException {
    Path status = Path.of("/proc/self/status");
    if (Files.isReadable(status)) {
      for (String line : Files.readAllLines(status)) {
        if (line.startsWith("VmHWM")) {
          return Long.parseLong(line.replaceAll("\\D", ""));
        }
      }
    }
    return 0;
  }
}
