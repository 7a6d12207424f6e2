package haltere.core.format.internal.decoding;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import java.util.List;
import org.junit.jupiter.api.Test;

class WriterLossesTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(320, 240, Origin.TOP);

  @Test
  void lossesAreToldInTheSingularAndInThePlural() {
    assertEquals(List.of(), WriterLosses.outside(0, SENSOR));
    assertEquals(
        List.of("1 event outside of 320x240 was left out"), WriterLosses.outside(1, SENSOR));
    assertEquals(
        List.of("2 events outside of 320x240 were left out"), WriterLosses.outside(2, SENSOR));
    assertEquals(List.of(), WriterLosses.jumps(0, "the clock"));
    assertEquals(
        List.of("1 jump of time does not fit the clock; later times read back shifted"),
        WriterLosses.jumps(1, "the clock"));
    assertEquals(
        List.of("3 jumps of time do not fit the clock; later times read back shifted"),
        WriterLosses.jumps(3, "the clock"));
  }
}
