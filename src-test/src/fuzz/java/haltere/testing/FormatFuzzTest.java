package haltere.testing;

import com.code_intelligence.jazzer.junit.FuzzTest;
import haltere.core.format.Recordings;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Has a fuzzer look for bytes that a format cannot cope with; one test for each format, by its
 * name, since it takes a method for each.
 */
class FormatFuzzTest {
  private static final String TIME = "10m";

  private static Path file;

  private static void check(String format, byte[] bytes) throws IOException {
    if (file == null) {
      file = Files.createTempFile("haltere-fuzz", ".recording");
      file.toFile().deleteOnExit();
    }
    FormatFuzzer.check(Recordings.formats().get(format), bytes, file);
  }

  @FuzzTest(maxDuration = TIME)
  void aedat1(byte[] bytes) throws IOException {
    check("aedat1", bytes);
  }

  @FuzzTest(maxDuration = TIME)
  void aedat2(byte[] bytes) throws IOException {
    check("aedat2", bytes);
  }

  @FuzzTest(maxDuration = TIME)
  void aedat3(byte[] bytes) throws IOException {
    check("aedat3", bytes);
  }

  @FuzzTest(maxDuration = TIME)
  void aedat4(byte[] bytes) throws IOException {
    check("aedat4", bytes);
  }

  @FuzzTest(maxDuration = TIME)
  void csv(byte[] bytes) throws IOException {
    check("csv", bytes);
  }

  @FuzzTest(maxDuration = TIME)
  void dat(byte[] bytes) throws IOException {
    check("dat", bytes);
  }

  @FuzzTest(maxDuration = TIME)
  void es(byte[] bytes) throws IOException {
    check("es", bytes);
  }

  @FuzzTest(maxDuration = TIME)
  void evt2(byte[] bytes) throws IOException {
    check("evt2", bytes);
  }

  @FuzzTest(maxDuration = TIME)
  void evt21(byte[] bytes) throws IOException {
    check("evt21", bytes);
  }

  @FuzzTest(maxDuration = TIME)
  void evt3(byte[] bytes) throws IOException {
    check("evt3", bytes);
  }

  @FuzzTest(maxDuration = TIME)
  void hdf5(byte[] bytes) throws IOException {
    check("hdf5", bytes);
  }

  @FuzzTest(maxDuration = TIME)
  void mcap(byte[] bytes) throws IOException {
    check("mcap", bytes);
  }

  @FuzzTest(maxDuration = TIME)
  void nmnist(byte[] bytes) throws IOException {
    check("nmnist", bytes);
  }

  @FuzzTest(maxDuration = TIME)
  void npz(byte[] bytes) throws IOException {
    check("npz", bytes);
  }

  @FuzzTest(maxDuration = TIME)
  void rosbag(byte[] bytes) throws IOException {
    check("rosbag", bytes);
  }

  @FuzzTest(maxDuration = TIME)
  void rosbag2(byte[] bytes) throws IOException {
    check("rosbag2", bytes);
  }
}
