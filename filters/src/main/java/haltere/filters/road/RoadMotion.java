package haltere.filters.road;

import haltere.filters.estimation.GaussianState;
import haltere.filters.object.MotionModel;
import haltere.filters.plane.PlaneJacobian;
import haltere.filters.plane.PlaneMapping;
import java.util.Objects;
import org.ejml.data.DMatrixRMaj;

/**
 * Motion of vehicles in the picture of a camera that looks along a road: a nearly constant velocity
 * in metres. A point above the road is at the pixel of a road point that is s times as far away and
 * s times as fast. Its velocity there is constant as well, so the prediction needs no height.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class RoadMotion extends MotionModel {
  /**
   * Standard deviation of the rate at which a vehicle turns, rad/s: a side friction factor of 0.16
   * at 50 km/h or of 0.15 at 60 km/h (AASHTO, Geometric Design of Highways and Streets, 2001,
   * Exhibit 3-14) times gravity, over the speed.
   */
  private static final double TURN_RAD_S = 0.1;

  /**
   * Standard deviation of the difference of two speeds on a road as a share of their mean: √2 times
   * 0.14, as of 52 ± 7 and 71 ± 11 mph (FHWA, Speed Concepts: Informational Guide, 2009, Figure 6).
   */
  private static final double UNLIKE_SHARE = 0.2;

  /** Error of a width in the picture, as a share of it: a pixel on each side of twenty. */
  private static final double WIDTH_SHARE = 0.1;

  private final PlaneMapping mapping;
  private final VehiclePrior prior;
  private final double[] row = new double[4];
  private final DMatrixRMaj transition = new DMatrixRMaj(4, 4);

  /**
   * Motions on a road.
   *
   * @param mapping pixels to the road
   * @param prior of vehicles
   */
  public RoadMotion(PlaneMapping mapping, VehiclePrior prior) {
    this.mapping = Objects.requireNonNull(mapping, "mapping");
    this.prior = Objects.requireNonNull(prior, "prior");
  }

  @Override
  protected void begin(GaussianState state) {
    if (mapping.seesPlane(state.mean(0), state.mean(2))) {
      PlaneJacobian j = mapping.jacobian(state.mean(0), state.mean(2));
      expectNone(state, j.xu(), j.xv(), prior.driftMS());
      expectNone(state, j.yu(), j.yv(), prior.speedMS());
    }
  }

  /** Updates with the prior that a velocity on the road is 0 with a standard deviation. */
  private void expectNone(GaussianState state, double byVx, double byVy, double sd) {
    row[1] = byVx;
    row[3] = byVy;
    state.project(row);
    state.correct(-byVx * state.mean(1) - byVy * state.mean(3), sd * sd);
  }

  /** {@inheritDoc} Beyond the horizon the motion is free. */
  @Override
  protected double predict(GaussianState state, double sizePx, double dtS) {
    double x = state.mean(0);
    double y = state.mean(2);
    if (!mapping.seesPlane(x, y)) {
      return super.predict(state, sizePx, dtS);
    }
    PlaneJacobian here = mapping.jacobian(x, y);
    double vx = here.x(state.mean(1), state.mean(3));
    double vy = here.y(state.mean(1), state.mean(3));
    double nextX = mapping.planeX(x, y) + vx * dtS;
    double nextY = mapping.planeY(x, y) + vy * dtS;
    if (!mapping.isSeen(nextX, nextY)) {
      return super.predict(state, sizePx, dtS);
    }
    state.setMean(0, mapping.pixelX(nextX, nextY));
    state.setMean(2, mapping.pixelY(nextX, nextY));
    PlaneJacobian there = mapping.jacobian(state.mean(0), state.mean(2));
    PlaneJacobian back = there.inverse();
    state.setMean(1, back.x(vx, vy));
    state.setMean(3, back.y(vx, vy));
    state.shearCovariance(0, 1, dtS);
    state.shearCovariance(2, 3, dtS);
    for (int i = 0; i < 2; i++) {
      transition.set(i, i, back.x(here.xu(), here.yu()));
      transition.set(i, i + 2, back.x(here.xv(), here.yv()));
      transition.set(i + 2, i, back.y(here.xu(), here.yu()));
      transition.set(i + 2, i + 2, back.y(here.xv(), here.yv()));
    }
    state.transform(transition);
    // along: uniform prior of accelerations up to braking; across: a drift that comes and goes
    double along = 2 * prior.brakingMS2() * prior.brakingMS2() / 3 * Vehicle.LASTS_S;
    double across = 2 * prior.driftMS() * prior.driftMS() / Vehicle.LASTS_S;
    state.addAcceleration(0, 0, back.xx(across, 0, along), dtS);
    state.addAcceleration(0, 2, back.xy(across, 0, along), dtS);
    state.addAcceleration(2, 2, back.yy(across, 0, along), dtS);
    return here.xu() / there.xu();
  }

  @Override
  protected boolean coasts() {
    return true;
  }

  @Override
  protected double turnRadS() {
    return TURN_RAD_S;
  }

  /** {@inheritDoc} Vehicles are rigid. */
  @Override
  protected double deformationShare() {
    return 0;
  }

  @Override
  protected double unlikeShare() {
    return UNLIKE_SHARE;
  }

  /** {@inheritDoc} A box wider than the widest vehicle is several vehicles. */
  @Override
  protected double oneLog(double lowXPx, double highXPx, double lowYPx) {
    double middle = 0.5 * (lowXPx + highXPx);
    if (!mapping.seesPlane(middle, lowYPx)) {
      return 0;
    }
    double widthM = (highXPx - lowXPx) * mapping.jacobian(middle, lowYPx).xu();
    double over = Math.max(0, widthM / prior.widthM() - 1) / WIDTH_SHARE;
    return -0.5 * over * over;
  }
}
