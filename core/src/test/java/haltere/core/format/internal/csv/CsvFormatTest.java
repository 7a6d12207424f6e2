package haltere.core.format.internal.csv;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import haltere.testing.EventPackets;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Events as text. */
class CsvFormatTest {
  @TempDir Path folder;

  private List<String> written(EventPacket packet, WriteOptions options) throws IOException {
    Path file = folder.resolve("events.csv");
    try (RecordingWriter writer =
        Recordings.forWriting(file).create(file, options.withOverwrite(true)).orElseThrow()) {
      writer.write(packet);
      boolean surprising =
          options.geometry().origin() == Origin.BOTTOM && options.origin().isEmpty();
      assertEquals(surprising ? 1 : 0, writer.losses().size(), writer.losses().toString());
      writer.finish();
    }
    return Files.readAllLines(file);
  }

  private static WriteOptions options(Origin source, Origin asked) {
    return new WriteOptions(
        new SensorGeometry(640, 480, source), false, Optional.ofNullable(asked), Map.of());
  }

  @Test
  void rowContainsTimeColumnRowAndPolarity() throws IOException {
    EventPacket packet = new EventPacket(4);
    packet.append(Long.MIN_VALUE, 0, 0, false);
    packet.append(-10, 639, 479, true);
    packet.append(0, 10, 100, true);
    packet.append(Long.MAX_VALUE, 9, 99, false);
    assertEquals(
        List.of(
            "t_us,x,y,on",
            "-9223372036854775808,0,0,0",
            "-10,639,479,1",
            "0,10,100,1",
            "9223372036854775807,9,99,0"),
        written(packet, options(Origin.BOTTOM, null)));
  }

  @Test
  void rowsKeepTheOriginOfTheSourceByDefault() throws IOException {
    EventPacket packet = new EventPacket(1);
    packet.append(5, 1, 2, true);
    assertEquals("5,1,2,1", written(packet, options(Origin.BOTTOM, null)).get(1));
    assertEquals("5,1,477,1", written(packet, options(Origin.TOP, null)).get(1));
    assertEquals("5,1,2,1", written(packet, options(Origin.TOP, Origin.BOTTOM)).get(1));
    assertEquals("5,1,477,1", written(packet, options(Origin.BOTTOM, Origin.TOP)).get(1));
  }

  @Test
  void writtenTextDoesNotDependOnTheLocale() throws IOException {
    SensorGeometry sensor = new SensorGeometry(640, 480);
    EventPacket packet = EventPackets.uniform(sensor, 1, 20_000, 1_718_925_184_590_631L, 10);
    Locale before = Locale.getDefault();
    List<String> rows;
    try {
      Locale.setDefault(Locale.forLanguageTag("ar-EG"));
      rows = written(packet, WriteOptions.of(sensor));
    } finally {
      Locale.setDefault(before);
    }
    assertEquals(20_001, rows.size());
    for (int i = 0; i < packet.size(); i++) {
      String row =
          packet.timeUs(i) + "," + packet.x(i) + "," + packet.y(i) + "," + (packet.isOn(i) ? 1 : 0);
      assertEquals(row, rows.get(i + 1));
    }
  }
}
