package haltere.ui.rendering;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.stream.Reset;
import org.junit.jupiter.api.Test;

/** Events in space and time. */
class SpaceTimePainterTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(100, 100);
  private static final int SIDE = 200;
  private final SpaceTimeCloud cloud = new SpaceTimeCloud(1000);
  private final SpaceTimeCloud.Points points = new SpaceTimeCloud.Points(1000);
  private final int[] argb = new int[SIDE * SIDE];

  private void event(long timeUs, int x, int y, boolean on) {
    EventPacket packet = new EventPacket(1);
    packet.append(timeUs, EventAddress.pack(x, y, on));
    cloud.packet(packet);
  }

  private static SpaceTimeView view(double turnDegrees, double sliceFrom, double sliceTo) {
    return new SpaceTimeView(Math.toRadians(turnDegrees), 0, 1, 100_000, sliceFrom, sliceTo);
  }

  private void paint(SpaceTimeView view) {
    cloud.copyTo(view.spanUs(), points);
    SpaceTimeProjection projection = new SpaceTimeProjection(view, SENSOR, SIDE, SIDE);
    new SpaceTimePainter().paint(points, projection, view, ColourMap.DARK, SIDE, SIDE, argb);
  }

  /** Middle of all pixels of a colour, or NaN. */
  private double[] middle(int colour) {
    double x = 0;
    double y = 0;
    int count = 0;
    for (int i = 0; i < argb.length; i++) {
      if (argb[i] == colour) {
        x += i % SIDE;
        y += i / SIDE;
        count++;
      }
    }
    return new double[] {x / count, y / count, count};
  }

  @Test
  void viewAlongTheTimeAxisShowsTheSensor() {
    event(1000, 75, 75, true);
    paint(view(0, 0, 1));
    double[] position = middle(ColourMap.DARK.on());
    assertEquals(SIDE * 0.72, position[0], 2, "right of the middle");
    assertEquals(SIDE * 0.28, position[1], 2, "above the middle");
  }

  @Test
  void sideViewShowsTimeHorizontally() {
    event(0, 50, 50, false);
    event(100_000, 50, 50, true);
    paint(view(90, 0, 1));
    double newest = middle(ColourMap.DARK.on())[0];
    assertTrue(newest > 0.9 * SIDE, "now is at the right, at " + newest);
    int oldest = ColourMap.DARK.colour(false, 0.35);
    assertTrue(middle(oldest)[0] < 0.1 * SIDE, "and the past at the left");
  }

  @Test
  void nearerEventHidesTheFartherOne() {
    event(0, 50, 50, false);
    event(100_000, 50, 50, true);
    paint(view(0, 0, 1));
    assertEquals(4, middle(ColourMap.DARK.on())[2], "pixels of the newer event");
    assertEquals(0, middle(ColourMap.DARK.colour(false, 0.35))[2]);
  }

  @Test
  void eventsOutsideTheSliceFade() {
    event(0, 20, 50, true);
    event(100_000, 80, 50, true);
    paint(view(0, 0.5, 1));
    assertEquals(0, middle(ColourMap.DARK.on())[2]);
    assertEquals(4, middle(ColourMap.DARK.colour(true, 0.35))[2]);
  }

  @Test
  void newestEventsAreStoredUntilASeek() {
    for (int i = 0; i < 5000; i++) {
      event(i, i % 100, 0, true);
    }
    cloud.copyTo(500, points);
    assertEquals(501, points.count());
    cloud.copyTo(1_000_000, points);
    assertEquals(1000, points.count());
    cloud.notified(new Reset(Reset.Cause.SEEK));
    cloud.copyTo(1_000_000, points);
    assertEquals(0, points.count());
  }
}
