package haltere.filters.cluster;

import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import java.util.Random;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;

/**
 * Squares of 50 pixels on a sensor of 1280 by 720, all pixels along an edge of which fire at once.
 */
class LargeThingsTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(1280, 720);
  private static final double HALF_SIDE_PX = 25;
  private static final double SPEED_PX_PER_S = 600;
  private static final long DURATION_US = 600_000;
  private static final long STEP_US = 200;

  private static final int PIXEL_BITS = 20;

  /** Contrast over threshold: how many events a pixel makes as an edge passes. */
  private static final int EVENTS_OF_AN_EDGE = 4;

  @Test
  void aSquareIsOneClusterInWhateverDirectionItMoves() {
    int squares = 12;
    long whole = 0;
    for (int i = 0; i < squares; i++) {
      whole += isOneCluster(new Random(i)) ? 1 : 0;
    }
    assertTrue(whole >= squares - 1, whole + " of " + squares + " squares were one cluster");
  }

  /** Whether one cluster is at the square at each report from 50 ms on, with one identity. */
  private static boolean isOneCluster(Random random) {
    double direction = 2 * Math.PI * random.nextDouble();
    double turned = 2 * Math.PI * random.nextDouble();
    EventPacket packet = square(random, direction, turned);
    LongStream.Builder identities = LongStream.builder();
    int[] others = new int[1];
    ClusterTracker[] tracker = new ClusterTracker[1];
    tracker[0] =
        new ClusterTracker(
            SENSOR,
            ClusterTrackerSettings.defaults(),
            timeUs -> {
              if (timeUs >= 50_000 && timeUs < DURATION_US) {
                tracker[0].tracks().forEach(track -> identities.add(track.id()));
                others[0] += tracker[0].tracks().size() == 1 ? 0 : 1;
              }
            });
    tracker[0].track(packet);
    return others[0] == 0 && identities.build().distinct().count() == 1;
  }

  private static EventPacket square(Random random, double direction, double turned) {
    LongStream.Builder codes = LongStream.builder();
    double cos = Math.cos(turned);
    double sin = Math.sin(turned);
    int reach = (int) (1.5 * HALF_SIDE_PX) + 2;
    boolean[] covered = new boolean[SENSOR.width() * SENSOR.height()];
    for (long timeUs = 0; timeUs < DURATION_US; timeUs += STEP_US) {
      double way = SPEED_PX_PER_S * (timeUs - 0.5 * DURATION_US) * 1e-6;
      double middleX = 640 + way * Math.cos(direction);
      double middleY = 360 + way * Math.sin(direction);
      for (int y = (int) middleY - reach; y <= middleY + reach; y++) {
        for (int x = (int) middleX - reach; x <= middleX + reach; x++) {
          boolean inside = isInside(x - middleX, y - middleY, cos, sin);
          int pixel = y * SENSOR.width() + x;
          for (int k = 0; timeUs > 0 && inside != covered[pixel] && k < EVENTS_OF_AN_EDGE; k++) {
            long eventUs = timeUs + random.nextInt((int) STEP_US);
            codes.add((eventUs << PIXEL_BITS | pixel) << 1 | (inside ? 0 : 1));
          }
          covered[pixel] = inside;
        }
      }
    }
    return inTime(codes.build());
  }

  private static EventPacket inTime(LongStream codes) {
    EventPacket packet = new EventPacket(1 << 16);
    codes
        .sorted()
        .forEach(
            code -> {
              int pixel = (int) (code >> 1) & (1 << PIXEL_BITS) - 1;
              int width = SENSOR.width();
              packet.ensureCapacity(packet.size() + 1);
              packet.append(code >> PIXEL_BITS + 1, pixel % width, pixel / width, (code & 1) != 0);
            });
    return packet;
  }

  private static boolean isInside(double x, double y, double cos, double sin) {
    double along = x * cos + y * sin;
    double across = y * cos - x * sin;
    return Math.max(Math.abs(along), Math.abs(across)) < HALF_SIDE_PX;
  }
}
