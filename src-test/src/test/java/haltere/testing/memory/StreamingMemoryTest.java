package haltere.testing.memory;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingFormat;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import haltere.testing.EventPackets;
import haltere.testing.Recorded;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/**
 * A recording is read in 64 MiB above what an empty program takes, however large it is and whatever
 * its lengths claim. A process of its own has a heap of less than that.
 */
@EnabledOnOs(OS.LINUX)
class StreamingMemoryTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(240, 180, Origin.TOP);
  private static final long BUDGET_KIB = 64 * 1024;
  private static final int PACKET_EVENTS = 50_000;

  /** 48 MB as packets in memory; in each format more than its readers buffer. */
  private static final int PACKETS = 80;

  private static final int LIES = 60;

  /** Formats that are only read, and a recording of each. */
  private static final Map<String, String> ONLY_READ =
      Map.of(
          "aedat1", "dvs128-tmpdiff128-2007.dat",
          "nmnist", "nmnist-sample.bin",
          "rosbag", "evt3-eventpacket.bag");

  @TempDir Path folder;

  /** Output of a process that reads a list of files. */
  private List<String[]> probe(List<String> lines) throws IOException, InterruptedException {
    List<String> command =
        new ArrayList<>(
            List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Xmx40m",
                "-XX:MaxDirectMemorySize=16m",
                "-XX:+UseSerialGC",
                "-XX:TieredStopAtLevel=1",
                "-cp",
                System.getProperty("java.class.path"),
                MemoryProbe.class.getName()));
    if (!lines.isEmpty()) {
      command.add(Files.write(folder.resolve("list.txt"), lines).toString());
    }
    Path errors = folder.resolve("errors.txt");
    Process process = new ProcessBuilder(command).redirectError(errors.toFile()).start();
    try (InputStream out = process.getInputStream()) {
      List<String[]> printed =
          new String(out.readAllBytes(), StandardCharsets.UTF_8)
              .lines()
              .map(line -> line.split(" "))
              .toList();
      assertTrue(process.waitFor(60, TimeUnit.SECONDS));
      assertEquals(
          0,
          process.exitValue(),
          () -> {
            String last =
                printed.isEmpty() ? "" : String.join(" ", printed.get(printed.size() - 1));
            try {
              return "behind " + last + ": " + Files.readString(errors);
            } catch (IOException e) {
              return e.getMessage();
            }
          });
      return printed;
    } finally {
      process.destroy();
    }
  }

  private static long peakKib(List<String[]> printed) {
    return Long.parseLong(printed.get(printed.size() - 1)[2]);
  }

  private Path write(RecordingFormat format, EventPacket events, int packets) throws IOException {
    Path file = folder.resolve(format.name() + "-" + packets);
    EventPacket shifted = new EventPacket(events.size());
    long spanUs = events.lastTimeUs() - events.firstTimeUs() + 1;
    try (RecordingWriter writer = format.create(file, WriteOptions.of(SENSOR)).orElseThrow()) {
      for (int i = 0; i < packets; i++) {
        shifted.clear();
        for (int k = 0; k < events.size(); k++) {
          shifted.append(events.timeUs(k) + i * spanUs, events.address(k));
        }
        writer.write(shifted);
      }
      writer.finish();
    }
    return file;
  }

  private static List<RecordingFormat> written() {
    return Recordings.formats().values().stream().filter(RecordingFormat::writable).toList();
  }

  @Test
  void largeRecordingsOfAllFormatsAreReadInLittleMemory() throws IOException, InterruptedException {
    EventPacket events = EventPackets.uniform(SENSOR, 1, PACKET_EVENTS, 1_000_000, 3);
    long emptyKib = peakKib(probe(List.of()));
    List<String> lines = new ArrayList<>();
    for (RecordingFormat format : written()) {
      lines.add(format.name() + " " + write(format, events, PACKETS));
    }
    List<String[]> printed = probe(lines);
    for (int i = 0; i < lines.size(); i++) {
      String[] line = printed.get(i);
      assertEquals((long) PACKETS * PACKET_EVENTS, Long.parseLong(line[1]), line[0]);
      long aboveKib = Long.parseLong(line[2]) - emptyKib;
      assertTrue(aboveKib <= BUDGET_KIB, line[0] + " takes " + aboveKib + " KiB");
    }
    assertTrue(lines.size() >= 9, lines.toString());
  }

  @Test
  void recordingsWithFalseSizesAreReadOrRejectedInLittleMemory()
      throws IOException, InterruptedException {
    EventPacket events = EventPackets.uniform(SENSOR, 2, 3000, 1_000_000, 3);
    List<String> lines = new ArrayList<>();
    for (RecordingFormat format : written()) {
      lies(format.name(), Files.readAllBytes(write(format, events, 1)), lines);
    }
    for (Map.Entry<String, String> recording : ONLY_READ.entrySet()) {
      if (Recordings.formats().containsKey(recording.getKey())) {
        lies(recording.getKey(), Files.readAllBytes(Recorded.file(recording.getValue())), lines);
      }
    }
    long emptyKib = peakKib(probe(List.of()));
    List<String[]> printed = probe(lines);
    assertEquals(lines.size() + 1, printed.size());
    long aboveKib = peakKib(printed) - emptyKib;
    assertTrue(aboveKib <= BUDGET_KIB, aboveKib + " KiB");
  }

  /**
   * Copies in which a number of four or eight bytes near the start is two thousand million, or
   * more.
   */
  private void lies(String format, byte[] file, List<String> lines) throws IOException {
    int length = Math.min(file.length, 200_000);
    for (int i = 0; i < LIES; i++) {
      byte[] lie = java.util.Arrays.copyOf(file, length);
      ByteBuffer bytes = ByteBuffer.wrap(lie);
      bytes.order(i % 2 == 0 ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
      int at = i < LIES / 2 ? 8 * i : (int) ((long) i * i * (length - 8L) / (LIES * LIES));
      at = Math.min(at, length - 8);
      if (i % 3 == 0) {
        bytes.putLong(at, 0x0000_0007_7fff_fff0L);
      } else {
        bytes.putInt(at, 0x7fff_fff0);
      }
      Path path = Files.write(folder.resolve(format + "-lie-" + i), lie);
      lines.add(format + " " + path);
    }
  }
}
