package haltere.filters.wing.stroke;

import haltere.filters.estimation.Angles;
import haltere.filters.wing.RunningAverageSettings;
import haltere.filters.wing.WingSide;
import haltere.filters.wing.WingTrackerSettings;

/**
 * The weighted running average of a wing: each event moves its edge by a share of the difference,
 * the wing is the middle of its edges. A beat ends when the wing has passed its centre, the mean of
 * the events of the beat before, towards the tail by more than a hysteresis; the time of the
 * passage is interpolated between the two events around it. It lags, and never reaches the
 * extremes.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class RunningAverage implements SideEstimator {
  private static final double LONGEST_SILENCE_US = 30_000;
  private static final double MOST_PERIODS = 5;

  private final WingSide side;
  private final StrokeFrame frame;
  private final BeatListener beats;
  private RunningAverageSettings settings;
  private final double[] edges = new double[2];
  private final long[] lastUs = new long[2];
  private final long[] taken = new long[2];
  private double expected;
  private double position;
  private double centre;
  private double amplitude;
  private double hysteresis;
  private double periodUs;
  private double least;
  private double most;
  private double sum;
  private double sumX;
  private double sumY;
  private int count;
  private boolean armed;
  private double passedUs;
  private double lastPassedUs = Double.NaN;
  private long positionUs;
  private long launchedUs;
  private long nowUs;

  /** Mean place of the events of the last beat, NaN before the first. */
  private double meanX = Double.NaN;

  private double meanY = Double.NaN;

  /**
   * An average that has to be {@link #launch launched}.
   *
   * @param side which wing
   * @param frame where it is hinged
   * @param settings of the average
   * @param beats takes the beats
   */
  public RunningAverage(
      WingSide side, StrokeFrame frame, RunningAverageSettings settings, BeatListener beats) {
    this.side = side;
    this.frame = frame;
    this.settings = settings;
    this.beats = beats;
  }

  @Override
  public void apply(WingTrackerSettings changed) {
    settings = changed.average();
    adapt();
  }

  private void adapt() {
    hysteresis = Math.max(settings.leastHysteresisRad(), settings.hysteresis() * amplitude);
  }

  /**
   * Begins where another estimate is.
   *
   * @param atUs when, microseconds
   * @param seed the other estimate
   */
  public void launch(long atUs, StrokeSeed seed) {
    position = seed.angleAt(atUs);
    edges[0] = position;
    edges[1] = position;
    lastUs[0] = atUs;
    lastUs[1] = atUs;
    centre = seed.centre();
    amplitude = seed.amplitude();
    adapt();
    periodUs = 2e6 * Math.PI / seed.omega();
    least = position;
    most = position;
    positionUs = atUs;
    launchedUs = atUs;
    nowUs = atUs;
    passedUs = atUs;
    lastPassedUs = Double.NaN;
    armed = false;
    sum = 0;
    sumX = 0;
    sumY = 0;
    count = 0;
    taken[0] = 0;
    taken[1] = 0;
    meanX = Double.NaN;
    meanY = Double.NaN;
  }

  @Override
  public boolean event(long timeUs, boolean on) {
    event(timeUs, on, frame.angle(), frame.hingeX() + frame.dx, frame.hingeY() + frame.dy);
    return true;
  }

  /**
   * Takes an event whose stroke angle is known.
   *
   * @param timeUs when, microseconds
   * @param on its polarity
   * @param angle stroke angle, whichever turn
   * @param x column
   * @param y row
   */
  public void event(long timeUs, boolean on, double angle, double x, double y) {
    nowUs = timeUs;
    int edge = on ? 1 : 0;
    double off = angle - edges[edge];
    if (off > Math.PI || off < -Math.PI) {
      off = Angles.wrapPi(off);
    }
    double share = settings.mixingFactor();
    if (settings.timeConstantUs() > 0) {
      double dt = timeUs - lastUs[edge];
      share = dt / (dt + settings.timeConstantUs());
      lastUs[edge] = timeUs;
    }
    double measured = edges[edge] + off;
    expected = edges[edge];
    edges[edge] += share * off;
    taken[edge]++;
    sum += measured;
    sumX += x;
    sumY += y;
    count++;
    double before = position;
    position = (edges[0] + edges[1]) / 2;
    if (position < least) {
      least = position;
    } else if (position > most) {
      most = position;
    }
    follow(timeUs, before);
    positionUs = timeUs;
  }

  private void follow(long timeUs, double before) {
    if (position < centre - hysteresis) {
      armed = true;
    } else if (armed) {
      if (before <= centre && position > centre) {
        double share = (centre - before) / (position - before);
        passedUs = positionUs + share * (timeUs - positionUs);
      }
      if (position > centre + hysteresis) {
        endBeat();
      }
    }
  }

  private void endBeat() {
    armed = false;
    if (!Double.isNaN(lastPassedUs)) {
      periodUs = passedUs - lastPassedUs;
      amplitude = (most - least) / 2;
      adapt();
      centre = sum / count;
    }
    meanX = sumX / count;
    meanY = sumY / count;
    beats.beat(side, passedUs, passedUs - lastPassedUs, least, most);
    lastPassedUs = passedUs;
    least = position;
    most = position;
    sum = 0;
    sumX = 0;
    sumY = 0;
    count = 0;
  }

  /**
   * Where the events of the last beat were on average.
   *
   * @return column, pixels; NaN before the end of the first beat
   */
  public double meanX() {
    return meanX;
  }

  /**
   * Where the events of the last beat were on average.
   *
   * @return row, pixels; NaN before the end of the first beat
   */
  public double meanY() {
    return meanY;
  }

  @Override
  public void advance(long timeUs) {
    nowUs = timeUs;
  }

  @Override
  public double angle() {
    return position;
  }

  @Override
  public double edgeAngle(int edge) {
    return edges[edge];
  }

  @Override
  public double centre() {
    return centre;
  }

  @Override
  public double amplitude() {
    return amplitude;
  }

  @Override
  public double phase() {
    double turns = Double.isNaN(lastPassedUs) ? 0 : (nowUs - lastPassedUs) / periodUs;
    return (turns - Math.floor(turns)) * 2 * Math.PI;
  }

  @Override
  public double phaseAt(double timeUs) {
    return phase() + 2 * Math.PI * (timeUs - nowUs) / periodUs;
  }

  @Override
  public double frequencyHz() {
    return 1e6 / periodUs;
  }

  @Override
  public double sdAngle() {
    return Double.NaN;
  }

  @Override
  public double sdFrequencyHz() {
    return Double.NaN;
  }

  @Override
  public double nis() {
    return Double.NaN;
  }

  @Override
  public long events(int edge) {
    return taken[edge];
  }

  @Override
  public double expected() {
    return expected;
  }

  @Override
  public StrokeSeed seed() {
    return new StrokeSeed(
        nowUs,
        centre,
        amplitude,
        phase(),
        2 * Math.PI * frequencyHz(),
        0.02,
        0,
        new double[0],
        new double[0]);
  }

  @Override
  public boolean isLost(long timeUs) {
    double since = timeUs - (Double.isNaN(lastPassedUs) ? launchedUs : lastPassedUs);
    return since > Math.max(LONGEST_SILENCE_US, MOST_PERIODS * Math.min(periodUs, 20_000));
  }
}
