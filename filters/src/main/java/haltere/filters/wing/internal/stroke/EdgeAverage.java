package haltere.filters.wing.internal.stroke;

import haltere.filters.estimation.Angles;
import haltere.filters.wing.RunningAverageSettings;
import haltere.filters.wing.WingTrackerSettings;

/**
 * The weighted running average of an edge (Cardinale 2006): each event moves the edge by a share of
 * the difference. A beat ends when the edge has passed its centre, the mean of the events of the
 * previous beat, towards the tail by more than a hysteresis; the time of the passage is
 * interpolated. The average lags and underestimates the extremes.
 */
final class EdgeAverage extends EdgeEstimator {
  private static final double MAX_SILENCE_US = 30_000;
  private static final double MAX_PERIODS = 5;
  private static final double MAX_PERIOD_US = 20_000;

  private RunningAverageSettings settings;
  private double position;
  private double hysteresis;
  private double periodUs;
  private double minNow;
  private double maxNow;
  private double sum;
  private int count;
  private boolean armed;
  private double passedUs;
  private double lastPassedUs;
  private long launchedUs;

  EdgeAverage(WingTrackerSettings settings) {
    apply(settings);
  }

  @Override
  void apply(WingTrackerSettings changed) {
    settings = changed.average();
    adapt();
  }

  private void adapt() {
    hysteresis = Math.max(settings.minHysteresisRad(), settings.hysteresis() * amplitude);
  }

  @Override
  void launch(long atUs, StrokeSeed seed) {
    super.launch(atUs, seed);
    position = seed.angleAt(atUs);
    adapt();
    periodUs = 2e6 * Math.PI / omega;
    launchedUs = atUs;
    passedUs = atUs;
    lastPassedUs = Double.NaN;
    armed = false;
    beginBeat();
  }

  private void beginBeat() {
    minNow = position;
    maxNow = position;
    sum = 0;
    count = 0;
  }

  @Override
  boolean event(long timeUs, double angle) {
    double off = angle - position;
    if (off > Math.PI || off < -Math.PI) {
      off = Angles.wrapPi(off);
    }
    double share = settings.mixingFactor();
    if (settings.timeConstantUs() > 0) {
      double dt = timeUs - lastEventUs;
      share = dt / (dt + settings.timeConstantUs());
    }
    expected = position;
    double before = position;
    sum += before + off;
    count++;
    position = before + share * off;
    taken++;
    if (position < minNow) {
      minNow = position;
    } else if (position > maxNow) {
      maxNow = position;
    }
    boolean ended = follow(timeUs, before);
    lastEventUs = timeUs;
    return ended;
  }

  private boolean follow(long timeUs, double before) {
    if (position < centre - hysteresis) {
      armed = true;
    } else if (armed) {
      if (before <= centre && position > centre) {
        double share = (centre - before) / (position - before);
        passedUs = lastEventUs + share * (timeUs - lastEventUs);
      }
      if (position > centre + hysteresis) {
        endBeat();
        return true;
      }
    }
    return false;
  }

  private void endBeat() {
    armed = false;
    min = minNow;
    max = maxNow;
    if (!Double.isNaN(lastPassedUs)) {
      periodUs = passedUs - lastPassedUs;
      omega = 2e6 * Math.PI / periodUs;
      amplitude = (max - min) / 2;
      adapt();
      centre = sum / count;
    }
    lastPassedUs = passedUs;
    beginBeat();
  }

  @Override
  double angle(double atUs) {
    return position;
  }

  @Override
  double phase(double atUs) {
    return Double.isNaN(lastPassedUs) ? 0 : 2 * Math.PI * (atUs - lastPassedUs) / periodUs;
  }

  @Override
  boolean isLost(long timeUs) {
    double since = timeUs - (Double.isNaN(lastPassedUs) ? launchedUs : lastPassedUs);
    return since > Math.max(MAX_SILENCE_US, MAX_PERIODS * Math.min(periodUs, MAX_PERIOD_US));
  }
}
