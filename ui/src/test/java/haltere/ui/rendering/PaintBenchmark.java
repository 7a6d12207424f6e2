package haltere.ui.rendering;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import java.util.Arrays;
import java.util.Locale;
import java.util.SplittableRandom;

/**
 * Prints how long painting a picture of 1280 by 720 pixels takes in each mode, and what an event
 * costs: {@code ./gradlew :ui:paintBenchmark}.
 */
public final class PaintBenchmark {
  private static final SensorGeometry SENSOR = new SensorGeometry(1280, 720);
  private static final int ROUNDS = 300;

  private PaintBenchmark() {}

  /**
   * Runs.
   *
   * @param args none
   */
  public static void main(String[] args) {
    int[] argb = new int[SENSOR.pixels()];
    for (DisplayMode mode : DisplayMode.values()) {
      EventPicture picture =
          new EventPicture(
              SENSOR, new PictureStyle(mode, ColourMap.DARK, Gradient.CIVIDIS, 20_000, false));
      EventPacket packet = events();
      double[] paintMs = new double[ROUNDS];
      double[] eventNs = new double[ROUNDS];
      for (int i = 0; i < ROUNDS; i++) {
        for (int j = 0; j < packet.size(); j++) {
          packet.timesUs()[j] += 16_667;
        }
        long start = System.nanoTime();
        picture.packet(packet);
        long gathered = System.nanoTime();
        picture.paintRanked(argb);
        paintMs[i] = (System.nanoTime() - gathered) / 1e6;
        eventNs[i] = (double) (gathered - start) / packet.size();
      }
      System.out.printf(
          Locale.ROOT,
          "%-14s paint %.2f ms (95 %% below %.2f), event %.1f ns%n",
          mode.label(),
          quantile(paintMs, 0.5),
          quantile(paintMs, 0.95),
          quantile(eventNs, 0.5));
    }
  }

  /** What a sixtieth of a second brings at ten million events a second. */
  private static EventPacket events() {
    SplittableRandom random = new SplittableRandom(1);
    EventPacket packet = new EventPacket(1 << 18);
    for (int i = 0; i < 166_667; i++) {
      packet.append(
          i / 10,
          EventAddress.pack(
              random.nextInt(SENSOR.width()),
              random.nextInt(SENSOR.height()),
              random.nextBoolean()));
    }
    return packet;
  }

  /** Of the second half, when the JVM has compiled everything. */
  private static double quantile(double[] values, double share) {
    double[] late = Arrays.copyOfRange(values, values.length / 2, values.length);
    Arrays.sort(late);
    return late[(int) (share * (late.length - 1))];
  }
}
