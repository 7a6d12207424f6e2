package haltere.testing.memory;

import haltere.core.event.EventPacket;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * A process of its own with little memory: reads each file of a list as the format that stands
 * before it, prints format, events and the most memory that the process has had so far in KiB.
 * Without a list, an empty program.
 */
public final class MemoryProbe {
  private MemoryProbe() {}

  /**
   * Reads.
   *
   * @param arguments name of a file with a line for each recording: format, space, path
   * @throws IOException if a file cannot be read
   */
  public static void main(String[] arguments) throws IOException {
    List<String> lines =
        arguments.length == 0 ? List.of() : Files.readAllLines(Path.of(arguments[0]));
    for (String line : lines) {
      int space = line.indexOf(' ');
      String format = line.substring(0, space);
      System.out.println(
          format
              + " "
              + events(format, Path.of(line.substring(space + 1)))
              + " "
              + peakKibibytes());
    }
    System.out.println("end 0 " + peakKibibytes());
  }

  /** Events of a file; -1 if it is refused. */
  private static long events(String format, Path file) throws IOException {
    long[] events = new long[1];
    ReadOptions options = ReadOptions.DEFAULT.withFormat(format);
    try (RecordingReader reader = Recordings.open(file, options)) {
      reader.drainTo(
          new StreamHandler() {
            @Override
            public void packet(EventPacket packet) {
              events[0] += packet.size();
            }

            @Override
            public void notified(StreamNotification notification) {}
          });
      return events[0];
    } catch (RecordingProblem refused) {
      return -1;
    }
  }

  private static long peakKibibytes() throws IOException {
    for (String line : Files.readAllLines(Path.of("/proc/self/status"))) {
      if (line.startsWith("VmHWM")) {
        return Long.parseLong(line.replaceAll("\\D", ""));
      }
    }
    throw new IOException("the system does not tell how much memory a process has had");
  }
}
