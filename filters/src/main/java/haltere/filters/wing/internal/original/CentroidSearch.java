package haltere.filters.wing.internal.original;

import haltere.core.event.EventAddress;
import haltere.core.event.SensorGeometry;
import haltere.filters.estimation.Angles;
import haltere.filters.wing.FlyGeometry;
import haltere.filters.wing.WingSearchSettings;
import haltere.filters.wing.WingTrackerState;
import haltere.filters.wing.WingTrackerState.Phase;
import haltere.filters.wing.internal.search.FlySearch;
import haltere.filters.wing.internal.search.FoundFly;
import haltere.filters.wing.internal.search.RecentEvents;
import haltere.filters.wing.internal.search.TwoMeans;
import haltere.filters.wing.internal.stroke.StrokeSeed;
import java.util.function.Consumer;

/**
 * Finds the fly as Cardinale (2006) does: two means of the pixels that the first events come from,
 * the body in the middle between both, its heading across the line through them, its size their
 * distance. A running average over the OFF events of each wing resolves head and tail. Stroke
 * angles are about the centre of the body, without hinges. The frequency is not searched.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class CentroidSearch implements FlySearch {
  /** Initial frequency of the filters if the settings have none, hertz. */
  private static final double START_HZ = 240;

  /** Weight of an event in the running average that resolves head and tail. */
  private static final double MIXING = 0.1;

  private final SensorGeometry sensor;
  private final RecentEvents recent;
  private final Consumer<WingTrackerState> steps;
  private final TwoMeans means = new TwoMeans();

  /** Pixels in the order of their first events. */
  private double[] x = {};

  private double[] y = {};
  private boolean[] on = {};
  private int size;
  private long fromUs;
  private int events;

  /**
   * A search.
   *
   * @param sensor of the events
   * @param recent the events that are searched
   * @param steps receives each step
   */
  public CentroidSearch(
      SensorGeometry sensor, RecentEvents recent, Consumer<WingTrackerState> steps) {
    this.sensor = sensor;
    this.recent = recent;
    this.steps = steps;
  }

  @Override
  public void begin(long timeUs, WingSearchSettings settings) {
    startAt(timeUs);
  }

  @Override
  public void startAt(long timeUs) {
    fromUs = timeUs;
    events = 0;
  }

  @Override
  public FoundFly look(long timeUs, WingSearchSettings settings) {
    if (timeUs < fromUs || ++events < settings.minEvents()) {
      return null;
    }
    FoundFly found = find(timeUs, settings);
    startAt(timeUs + 1);
    return found;
  }

  /** Two means always exist, also without a second wing. */
  @Override
  public FoundFly findBoth(long timeUs, WingSearchSettings settings) {
    return null;
  }

  private FoundFly find(long timeUs, WingSearchSettings settings) {
    takePixels();
    // seeds in the upper left and in the lower right corner, as in the program of 2006
    double[] at = {0, sensor.height() - 1.0, sensor.width() - 1.0, 0};
    means.divide(x, y, size, at);
    double reach = Math.hypot(at[2] - at[0], at[3] - at[1]);
    if (!(reach > 0)) {
      return null;
    }
    double bodyX = (at[0] + at[2]) / 2;
    double bodyY = (at[1] + at[3]) / 2;
    double heading = Math.atan2(at[3] - at[1], at[2] - at[0]) + Math.PI / 2;
    double left = vote(bodyX, bodyY, heading, 1, reach);
    double right = vote(bodyX, bodyY, heading, -1, reach);
    double sum = left + right;
    double all = Math.abs(left) + Math.abs(right);
    FlyGeometry fly =
        new FlyGeometry(
            bodyX,
            bodyY,
            Angles.wrapTwoPi(heading + (sum < 0 ? Math.PI : 0)),
            reach,
            bodyX,
            bodyY,
            bodyX,
            bodyY,
            all > 0 ? Math.abs(sum) / all : 0,
            timeUs);
    steps.accept(WingTrackerState.of(timeUs, Phase.TWO_MEANS, size, Double.NaN, fly, Double.NaN));
    double hz = settings.startFrequencyHz() > 0 ? settings.startFrequencyHz() : START_HZ;
    steps.accept(
        WingTrackerState.of(timeUs, Phase.HEAD_AND_TAIL, size, hz, fly, fly.headTailConfidence()));
    StrokeSeed seed = StrokeSeed.sinusoid(timeUs, Math.PI / 2, 0, 0, 2 * Math.PI * hz, 0);
    return new FoundFly(fly, reach, new StrokeSeed[] {seed, seed});
  }

  /** Takes each pixel once, with the polarity of its first event. */
  private void takePixels() {
    int[] addresses = recent.addressesSince(fromUs);
    boolean[] seen = new boolean[sensor.pixels()];
    x = new double[addresses.length];
    y = new double[addresses.length];
    on = new boolean[addresses.length];
    size = 0;
    for (int address : addresses) {
      int pixel = EventAddress.y(address) * sensor.width() + EventAddress.x(address);
      if (!seen[pixel]) {
        seen[pixel] = true;
        x[size] = EventAddress.x(address);
        y[size] = EventAddress.y(address);
        on[size++] = EventAddress.isOn(address);
      }
    }
  }

  /**
   * Amplitude of the averaged leading edge of a wing, positive if it stays nearer to the tail than
   * to the head. If the wings disagree, the larger stroke decides.
   */
  private double vote(double bodyX, double bodyY, double heading, int turn, double reach) {
    double average = Math.PI / 2;
    double min = average;
    double max = average;
    for (int i = 0; i < size; i++) {
      double dx = x[i] - bodyX;
      double dy = y[i] - bodyY;
      double angle = Angles.wrapTwoPi(turn * (Math.atan2(dy, dx) - heading));
      if (!on[i] && angle < Math.PI && Math.hypot(dx, dy) <= reach) {
        average += MIXING * (angle - average);
        min = Math.min(min, average);
        max = Math.max(max, average);
      }
    }
    return min < Math.PI - max ? min - max : max - min;
  }
}
