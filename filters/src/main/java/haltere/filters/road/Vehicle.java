package haltere.filters.road;

import haltere.filters.estimation.Gate;
import haltere.filters.estimation.GaussianState;
import haltere.filters.object.ObjectTrack;
import haltere.filters.plane.PlaneJacobian;
import haltere.filters.plane.PlanePoint;
import haltere.filters.plane.RoadMapping;
import java.util.Arrays;
import java.util.Optional;

/**
 * A vehicle on a road: an extended Kalman filter of the position of its nearer end, its velocity,
 * and the heights of its visible parts above the road.
 *
 * <p>A camera at a height H sees a point at a height z and a distance d at the pixel of the road at
 * s d, with s = H/(H − z), and a speed v as s v. Two points are measured, the lower edge and the
 * middle of the extent; their relative motion determines their heights together with the prior.
 * {@code docs/road.md} has the equations.
 */
final class Vehicle {
  // entries of the state, metres and m/s: position and velocity across and along the road, heights
  // of the lower edge and of the middle of the extent, distance of the middle behind the nearer end
  private static final int X = 0;
  private static final int VX = 1;
  static final int Y = 2;
  static final int VY = 3;
  static final int LOW = 4;
  static final int MIDDLE = 5;
  static final int BEHIND = 6;
  static final int SIZE = 7;

  /** Memory of an extent in the picture and duration of its errors, seconds. */
  private static final double EXTENT_S = 0.3;

  /** Least distance of an edge from the lower border of the picture, pixels. */
  private static final double BORDER_PX = 1.5;

  /** Duration of an acceleration, seconds (Singer, IEEE TAES 6, 1970). */
  static final double LASTS_S = 1;

  /** Mean normalised innovation squared above which a vehicle brakes: 95 % quantile of χ². */
  private static final double BRAKES = Gate.probability(0.95).threshold(1);

  /** The same above which the track has gone over to another vehicle: 99.9 % quantile. */
  private static final double IS_OTHER = Gate.probability(0.999).threshold(1);

  /** Least height of the camera above a visible point, as a share of its height. */
  private static final double MIN_CLEARANCE = 0.1;

  private final RoadMapping mapping;
  private final VehiclePrior prior;
  private final GaussianState state = new GaussianState(SIZE);
  private final double[] row = new double[SIZE];
  private long timeUs;

  /** Time since which the lower edge is in the picture. */
  private long insideUs;

  private boolean isStarted;

  /** Recent mean normalised innovation squared; of the vehicle before until this one starts. */
  private double meanNis = 1;

  /**
   * A vehicle that has not been measured.
   *
   * @param timeUs time of its first row, microseconds
   */
  Vehicle(RoadMapping mapping, VehiclePrior prior, long timeUs) {
    this.mapping = mapping;
    this.prior = prior;
    this.timeUs = timeUs;
    insideUs = timeUs;
  }

  GaussianState state() {
    return state;
  }

  /** Processes a row of its track; {@return its position, empty until its extent is known} */
  Optional<PlanePoint> update(ObjectTrack track) {
    double seconds = (track.timeUs() - timeUs) * 1e-6;
    timeUs = track.timeUs();
    if (isStarted) {
      predict(seconds);
    }
    boolean isWhole = track.lowYPx() > BORDER_PX && mapping.seesPlane(track.xPx(), track.yPx());
    if (!isWhole) {
      insideUs = timeUs;
    } else if (seconds > 0 && (timeUs - insideUs) * 1e-6 >= EXTENT_S) {
      if (isStarted) {
        measure(track, seconds);
      } else {
        start(track);
      }
    }
    return isStarted ? Optional.of(PlanePoint.of(timeUs, track.id(), state)) : Optional.empty();
  }

  private void start(ObjectTrack track) {
    isStarted = true;
    double low = track.lowYPx();
    state.setMean(VX, 0);
    state.setMean(VY, 0);
    state.setMean(LOW, prior.lowEdgeM());
    state.setMean(MIDDLE, prior.heightM() / 2);
    state.setMean(BEHIND, prior.lengthM() / 2);
    state.setMean(X, mapping.planeX(track.xPx(), low) / scale(LOW));
    state.setMean(Y, mapping.planeY(track.xPx(), low) / scale(LOW));
    double byHeight = prior.lowEdgeM() * state.mean(Y) / mapping.heightM();
    double byRow = track.sdYPx() * mapping.jacobian(track.xPx(), low).yv();
    state.setVariances(
        square(prior.widthM()),
        square(prior.driftMS()),
        square(byRow) + square(byHeight),
        square(prior.speedMS()),
        square(prior.lowEdgeM()),
        square(prior.heightM() / 4),
        square(prior.lengthM() / 4));
    state.addNoise(Y, LOW, -byHeight * prior.lowEdgeM());
    // The velocity is used once: later ones have the errors of the positions, and after a change of
    // the vehicle the track still has that of the vehicle before.
    if (meanNis <= IS_OTHER) {
      PlaneJacobian j = mapping.jacobian(track.xPx(), track.yPx());
      double variance = square(track.sdVyPxS() * j.yv());
      correct(VY, 0, MIDDLE, j.y(track.vxPxS(), track.vyPxS()), variance);
    }
    meanNis = 1;
  }

  private void predict(double dt) {
    double acceleration = meanNis > BRAKES ? prior.brakingMS2() : prior.accelerationMS2();
    double q = 2 * square(acceleration) * LASTS_S;
    state.shear(X, VX, dt);
    state.shear(Y, VY, dt);
    state.decay(VX, 0, 1 - Math.exp(-dt / LASTS_S), prior.driftMS());
    state.addAcceleration(Y, Y, q, dt);
  }

  /** Errors of extents last for a time T: of n rows in a second, 1 / (2 T) are independent. */
  private void measure(ObjectTrack track, double seconds) {
    double rows = Math.max(1, 2 * EXTENT_S / seconds);
    double x = track.xPx();
    double y = track.yPx();
    double low = track.lowYPx();
    double rowVariance = square(track.sdYPx()) * rows;
    double yv = mapping.jacobian(x, low).yv();
    double nis = correct(Y, 0, LOW, mapping.planeY(x, low), rowVariance * square(yv));
    meanNis += (nis * rows - meanNis) / rows;
    PlaneJacobian j = mapping.jacobian(x, y);
    correct(Y, 1, MIDDLE, mapping.planeY(x, y), rowVariance * square(j.yv()));
    double columnVariance = square(track.sdXPx() * j.xu()) * rows;
    correct(X, 0, MIDDLE, mapping.planeX(x, y), columnVariance);
    if (meanNis > IS_OTHER) {
      isStarted = false;
      insideUs = timeUs;
    }
  }

  /**
   * Updates with the apparent road position or speed of a point at a height, 1 or 0 times the entry
   * BEHIND behind the nearer end; {@return the normalised innovation squared}
   */
  private double correct(int at, int behind, int height, double seen, double variance) {
    double s = scale(height);
    double position = state.mean(at) + behind * state.mean(BEHIND);
    Arrays.fill(row, 0);
    row[at] = s;
    row[BEHIND] = behind * s;
    row[height] = position * s * s / mapping.heightM();
    double innovation = seen - s * position;
    double expected = state.project(row) + variance;
    state.correct(innovation, variance);
    return innovation * innovation / expected;
  }

  /** H / (H − z). */
  private double scale(int height) {
    return 1 / Math.max(MIN_CLEARANCE, 1 - state.mean(height) / mapping.heightM());
  }

  private static double square(double value) {
    return value * value;
  }
}
