package haltere.device.usb;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/**
 * The file of libusb that usb4java writes into a temporary folder of its own. usb4java removes it
 * at a normal exit, but not if the program is stopped by Ctrl+C, as a recording is.
 */
final class LibusbFiles {
  private static final Path MAPS = Path.of("/proc/self/maps");

  private LibusbFiles() {}

  /** The files from which this process has loaded libusb; none if the system does not tell. */
  static List<Path> loaded() throws IOException {
    if (!Files.isReadable(MAPS)) {
      return List.of();
    }
    try (Stream<String> mapped = Files.lines(MAPS)) {
      return mapped
          .filter(line -> line.matches(".* /.*/usb4java\\d+\\.tmp/libusb4java\\.so"))
          .map(line -> Path.of(line.substring(line.indexOf('/'))))
          .distinct()
          .toList();
    }
  }

  /** Removes what is loaded: Linux keeps a mapped file until the process ends. */
  static void remove() {
    try {
      for (Path file : loaded()) {
        Files.deleteIfExists(file);
        Files.deleteIfExists(file.getParent());
      }
    } catch (IOException kept) {
      // usb4java removes it at a normal exit
    }
  }
}
