package haltere.core.format.internal.bag;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.github.luben.zstd.Zstd;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.testing.EventPackets;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The reader of a bag states the compression of its event messages. */
class BagCompressionTest {
  @TempDir Path folder;

  private Optional<String> compression(Path file) throws IOException {
    try (RecordingReader reader = Recordings.open(file)) {
      return reader.compression();
    }
  }

  @ParameterizedTest
  @CsvSource({
    "array-lz4.bag, lz4",
    "array-bz2.bag, bzip2",
    "libcaer.bag, none",
    "array-zstd.mcap, zstd",
    "libcaer_cmp-lz4.mcap, lz4",
    "libcaer-flat.mcap, none"
  })
  void compressionIsThatOfTheChunks(String name, String method) throws IOException {
    Path file = Files.write(folder.resolve(name), BagResources.bytes(name));
    assertEquals(Optional.of(method), compression(file));
  }

  @Test
  void compressionIsThatOfMessagesWithoutChunks() throws IOException {
    SensorGeometry sensor = new SensorGeometry(346, 260, Origin.TOP);
    Path file = folder.resolve("messages.db3");
    Files.write(
        file,
        SqliteBagFile.of(
            9000, Zstd::compress, sensor, EventPackets.uniform(sensor, 1, 9000, 0, 30)));
    assertEquals(Optional.of("zstd"), compression(file));
  }
}
