package haltere.core.event;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class SensorGeometryTest {
  @Test
  void sensorContainsPixelsFromZeroToSizeMinusOne() {
    SensorGeometry sensor = new SensorGeometry(3, 2);
    assertTrue(sensor.contains(0, 0) && sensor.contains(2, 1));
    assertFalse(sensor.contains(3, 0) || sensor.contains(0, 2));
    assertFalse(sensor.contains(-1, 0) || sensor.contains(0, -1));
    assertEquals(6, sensor.pixels());
    assertEquals(3, sensor.longerSide());
    assertEquals(Origin.BOTTOM, sensor.origin());
    assertEquals("3x2", sensor.toString());
  }

  @Test
  void sensorSizesOutOfRangeAreRejected() {
    assertThrows(IllegalArgumentException.class, () -> new SensorGeometry(0, 5));
    assertThrows(IllegalArgumentException.class, () -> new SensorGeometry(5, -1));
    assertThrows(IllegalArgumentException.class, () -> new SensorGeometry(32_769, 5));
    assertEquals(1 << 30, new SensorGeometry(32_768, 32_768).pixels());
  }
}
