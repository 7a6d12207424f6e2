package haltere.filters.wing.internal.stroke;

import haltere.filters.estimation.Angles;
import haltere.filters.estimation.ConstMatrix;
import haltere.filters.estimation.Gate;
import haltere.filters.estimation.GaussianState;
import haltere.filters.wing.WingFilterEdit;
import haltere.filters.wing.WingFilterState;
import haltere.filters.wing.WingFilterState.Source;
import haltere.filters.wing.WingNoiseSettings;
import haltere.filters.wing.WingPart;
import haltere.filters.wing.WingTrackerSettings;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * The extended Kalman filter of one edge of a wing: centre a, amplitude M, phase ξ, angular
 * frequency ω, with h = a + M sin ξ (Cardinale 2006, eq. 11 to 14, with a corrected Jacobian).
 * Several events may be averaged before an update.
 */
final class EdgeFilter extends EdgeEstimator {
  static final int CENTRE = 0;
  static final int AMPLITUDE = 1;
  static final int PHASE = 2;
  static final int OMEGA = 3;
  static final int SIZE = 4;

  private static final double US = 1e-6;
  private static final int LOST_AFTER = 400;
  private static final double WIDEST_GATE_SD = 30;

  /** Variance of a measurement if the settings give none, squared radians. */
  private static final double DEFAULT_VARIANCE = 0.006;

  /** Units of the process noise of an update. */
  private static final List<String> UPDATE_UNITS =
      List.of("rad\u00b2", "rad\u00b2", "rad\u00b2", "rad\u00b2/s\u00b2");

  final GaussianState belief = new GaussianState(SIZE);

  /** Consecutive innovations outside the gate. */
  private int gated;

  private final WingPart part;
  private final EdgeNoise noise;
  private final double threshold;
  private final double[] row = {1, 0, 0, 0};
  private WingNoiseSettings settings;
  private double[] q;
  private final Source[] qSources = new Source[SIZE];
  private double r;
  private Source rSource;
  private int averaged;
  private long stateUs;

  /** Lag of the events of this edge behind those of the leading edge. */
  private double lagUs;

  private double sum;

  /** Sum of the times of the averaged events, relative to the state. */
  private long ages;

  private int count;
  private double highestPhase;

  EdgeFilter(WingPart part, EdgeNoise noise, WingTrackerSettings settings) {
    this.part = part;
    this.noise = noise;
    double gateSd = settings.filter().gateSd();
    threshold = (gateSd > WIDEST_GATE_SD ? Gate.OPEN : Gate.sigmas(gateSd)).threshold(1);
    apply(settings);
  }

  @Override
  void apply(WingTrackerSettings changed) {
    averaged = changed.filter().averagedEvents();
    if (!changed.noise().equals(settings)) {
      settings = changed.noise();
      q = noise.of(settings);
      Arrays.fill(qSources, Source.SETTINGS);
      setMeasurement(0);
    }
  }

  /** Sets the variance of a measurement; 0 for that of the settings. */
  private void setMeasurement(double variance) {
    rSource = variance > 0 ? Source.MANUAL : Source.SETTINGS;
    r = variance > 0 ? variance : settings.measurement();
    r = r > 0 ? r : DEFAULT_VARIANCE;
  }

  @Override
  void launch(long atUs, StrokeSeed seed) {
    super.launch(atUs, seed);
    stateUs = atUs;
    lagUs = part == WingPart.edge(part.sideNumber(), 0) ? 0 : seed.lagS() / US;
    clearAverage();
    belief.setMean(CENTRE, centre);
    belief.setMean(AMPLITUDE, amplitude);
    belief.setMean(PHASE, Angles.wrapPi(seed.phase() + seed.omega() * (atUs - seed.timeUs()) * US));
    belief.setMean(OMEGA, omega);
    noise.launch(belief);
    copyState();
    gated = 0;
    nis = Double.NaN;
    highestPhase = Angles.wrapTwoPi(belief.mean(PHASE));
  }

  private void clearAverage() {
    sum = 0;
    ages = 0;
    count = 0;
  }

  @Override
  boolean event(long timeUs, double angle) {
    lastEventUs = timeUs;
    taken++;
    sum += count == 0 ? angle : sum / count + Angles.wrapPi(angle - sum / count);
    ages += timeUs - stateUs;
    if (++count < averaged) {
      return false;
    }
    double measured = sum / count;
    long atUs = noise.isDensity() ? stateUs + ages / count : timeUs;
    clearAverage();
    predict(atUs);
    update(measured);
    copyState();
    return hasPassed();
  }

  private void copyState() {
    centre = belief.mean(CENTRE);
    amplitude = belief.mean(AMPLITUDE);
    omega = belief.mean(OMEGA);
    min = centre - amplitude;
    max = centre + amplitude;
  }

  /** Predicts phase and covariance. */
  private void predict(long atUs) {
    double dtS = (atUs - stateUs) * US;
    if (dtS > 0) {
      belief.shear(PHASE, OMEGA, dtS);
      noise.add(belief, q, dtS);
      stateUs = atUs;
    }
  }

  /** Updates with an angle inside the gate. */
  void update(double angle) {
    double phase = Angles.wrapPi(belief.mean(PHASE));
    double sine = Math.sin(phase);
    row[AMPLITUDE] = sine;
    // the cosine, of either sign
    row[PHASE] =
        amplitude * Math.copySign(Math.sqrt(1 - sine * sine), Math.PI / 2 - Math.abs(phase));
    double innovation = angle - (centre + amplitude * sine);
    if (Math.abs(innovation) > Math.PI) {
      innovation = Angles.wrapPi(innovation);
    }
    expected = angle - innovation;
    nis = innovation * innovation / (belief.project(row) + r);
    if (nis > threshold) {
      gated++;
    } else if (belief.correct(innovation, r)) {
      gated = 0;
      normalise();
    }
  }

  /** Wraps the phase, for precision, and keeps the amplitude positive. */
  private void normalise() {
    double phase = belief.mean(PHASE);
    if (belief.mean(AMPLITUDE) < 0) {
      belief.setMean(AMPLITUDE, -belief.mean(AMPLITUDE));
      belief.scale(AMPLITUDE, -1);
      phase += Math.PI;
    }
    if (Math.abs(phase) > Math.PI) {
      phase = Angles.wrapPi(phase);
    }
    belief.setMean(PHASE, phase);
  }

  private boolean hasPassed() {
    double phase = belief.mean(PHASE);
    phase += phase < 0 ? 2 * Math.PI : 0;
    if (phase < highestPhase - Math.PI) {
      highestPhase = phase;
      return true;
    }
    if (phase - highestPhase < Math.PI) {
      highestPhase = Math.max(highestPhase, phase);
    }
    return false;
  }

  @Override
  double phase(double atUs) {
    return belief.mean(PHASE) + omega * (atUs + lagUs - stateUs) * US;
  }

  @Override
  double angle(double atUs) {
    return centre + amplitude * Math.sin(phase(atUs));
  }

  @Override
  double angleVariance(double atUs) {
    double phase = phase(atUs);
    row[AMPLITUDE] = Math.sin(phase);
    row[PHASE] = amplitude * Math.cos(phase);
    return Math.max(0, belief.project(row));
  }

  @Override
  double omegaVariance() {
    return belief.covariance(OMEGA, OMEGA);
  }

  @Override
  boolean isLost(long nowUs) {
    return gated >= LOST_AFTER;
  }

  @Override
  Optional<WingFilterState> filter() {
    return Optional.of(
        new WingFilterState(
            part,
            FilterNumbers.of(FilterNumbers.NAMES, SIZE),
            FilterNumbers.of(FilterNumbers.UNITS, SIZE),
            ConstMatrix.copyOf(belief.mean()),
            ConstMatrix.copyOf(belief.covariance()),
            ConstMatrix.column(q),
            noise.isDensity() ? FilterNumbers.of(FilterNumbers.DENSITY_UNITS, SIZE) : UPDATE_UNITS,
            List.of(qSources),
            r,
            rSource,
            nis,
            taken));
  }

  @Override
  void edit(WingFilterEdit edit) {
    int row = edit.row();
    switch (edit.table()) {
      case STATE -> {
        belief.setMean(row, row == PHASE ? Angles.wrapPi(edit.value()) : edit.value());
        copyState();
      }
      case COVARIANCE -> belief.edit(row, edit.column(), edit.value());
      case PROCESS_NOISE -> {
        q[row] = edit.restoresAutomatic() ? noise.of(settings)[row] : edit.notNegative();
        qSources[row] = edit.restoresAutomatic() ? Source.SETTINGS : Source.MANUAL;
      }
      case MEASUREMENT_NOISE -> setMeasurement(edit.restoresAutomatic() ? 0 : edit.notNegative());
    }
  }
}
