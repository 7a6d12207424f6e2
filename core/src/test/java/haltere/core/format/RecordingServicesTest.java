package haltere.core.format;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.testing.ServiceFiles;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** Formats are found as services. */
class RecordingServicesTest {
  @Test
  void serviceFileNamesEveryFormat() {
    assertEquals(
        ServiceFiles.implementations(RecordingFormat.class, Recordings.class),
        ServiceFiles.registered(RecordingFormat.class));
  }

  @Test
  void everyFormatIsFoundByItsName() {
    assertEquals(
        Set.of(
            "aedat1", "aedat2", "aedat3", "aedat4", "csv", "dat", "es", "evt2", "evt21", "evt3",
            "hdf5", "mcap", "nmnist", "npz", "rosbag", "rosbag2"),
        Recordings.formats().keySet());
    Recordings.formats().forEach((name, format) -> assertEquals(name, format.name()));
  }
}
