package haltere.filters.orientation;

import haltere.filters.estimation.FourStateEkf;
import haltere.filters.estimation.Gate;

/**
 * The error-state form: the axis u is a point of the unit sphere with two directions e₁, e₂ beside
 * it, which move along without turning about it; the state's error is (a, ȧ, b, ḃ), how far u is
 * off along e₁ and e₂ and how far its velocity is. The length of u needs no care, and the rotation
 * about u, which no camera sees, is no state and cannot be mistaken for known.
 *
 * <p>Between two times the axis goes along a great circle by the arc s = |v| g, with g = τ(1 − d)
 * and d = e^(−Δt/τ), and the velocity decays to d v. Errors along the way (t) and across it (n)
 * follow the deviation of neighbouring great circles (Jacobi's equation on the sphere):
 *
 * <pre>
 * a_t ← a_t + g ȧ_t              ȧ_t ← d ȧ_t
 * a_n ← cos s a_n + (g/s) sin s ȧ_n    ȧ_n ← d (cos s ȧ_n − (s/g) sin s a_n)
 * </pre>
 *
 * <p>The rates are driven by white noise; Q is its closed integral (Bar-Shalom, Li and Kirubarajan
 * 2001, section 8.2.3, exponentially correlated). There are two densities, calm flight and
 * saccades, with probabilities that change as those of a Markov chain: the step is made with both
 * and the results are merged (generalised pseudo-Bayesian of order one, same book, section 11.6.4).
 *
 * <p>An observation is a line of the body with probability 1 − ε and any line with ε: the nearest
 * one is taken in first, and then those that are likelier to be of the body than not, after what
 * has been taken in.
 */
final class SphereFilter implements AxisFilter {
  private static final int MODES = 2;

  /** Second-order term of the angle: what a wide prior makes of it when the body is seen end-on. */
  private static final double CURVATURE = 0.5;

  private final double[] rates;
  private final double tau;
  private final double saccadesPerS;
  private final double saccadeS;
  private final double gateRad;
  private final double outlierDensity;
  private final double inlierShare;

  private final double[] u = new double[3];
  private final double[] e1 = new double[3];
  private final double[] e2 = new double[3];
  private double va;
  private double vb;

  /** Covariance, order a, ȧ, b, ḃ. */
  private final double[] p = new double[16];

  /** Variances per unit of squared rate since the last update: place, both, velocity. */
  private double qPlace;

  private double qBoth;
  private double qRate;
  private boolean hasStepped;
  private double saccadeShare;
  private final double[] transition = new double[16];

  private final FourStateEkf[] modes = new FourStateEkf[MODES];
  private final double[] likelihoods = new double[MODES];
  private final double[] work = new double[16];
  private final double[] moved = new double[3];
  private boolean[][] used = new boolean[MODES][16];
  private double[][] nis = new double[MODES][16];

  SphereFilter(OrientationSettings settings) {
    TurningSettings turning = settings.turning();
    rates = new double[] {turning.calmRateRadS(), turning.saccadeRateRadS()};
    tau = turning.decayS();
    saccadesPerS = turning.saccadesPerS();
    saccadeS = turning.saccadeS();
    gateRad = Math.toRadians(settings.gate().angleDeg());
    boolean open = settings.gate().angleDeg() >= 90;
    double outliers = open ? 0 : settings.gate().outlierShare();
    outlierDensity = outliers / Math.PI;
    inlierShare = 1 - outliers;
    for (int mode = 0; mode < MODES; mode++) {
      modes[mode] = new FourStateEkf(Gate.OPEN, 1);
    }
  }

  @Override
  public void launch(double[] axis, double[] covariance) {
    System.arraycopy(axis, 0, u, 0, 3);
    Vectors.normalise(u);
    System.arraycopy(Vectors.orthogonalTo(u), 0, e1, 0, 3);
    Vectors.cross(u, e1, e2);
    va = 0;
    vb = 0;
    saccadeShare = saccadesPerS * saccadeS / (1 + saccadesPerS * saccadeS);
    java.util.Arrays.fill(p, 0);
    Vectors.multiply(covariance, e1, moved);
    p[0] = Vectors.dot(e1, moved);
    p[2] = Vectors.dot(e2, moved);
    p[8] = p[2];
    Vectors.multiply(covariance, e2, moved);
    p[10] = Vectors.dot(e2, moved);
    double rate = (1 - saccadeShare) * rates[0] * rates[0] + saccadeShare * rates[1] * rates[1];
    p[5] = rate;
    p[15] = rate;
    qPlace = 0;
    qBoth = 0;
    qRate = 0;
    hasStepped = false;
  }

  @Override
  public void predict(double dtS) {
    if (dtS == 0) {
      java.util.Arrays.fill(transition, 0);
      for (int i = 0; i < 4; i++) {
        transition[5 * i] = 1;
      }
      return;
    }
    double h = dtS / tau;
    double gone = -Math.expm1(-h);
    double left = 1 - gone;
    double g = tau * gone;
    double speed = Math.sqrt(va * va + vb * vb);
    double s = speed * g;
    double ta = speed > 0 ? va / speed : 1;
    double tb = speed > 0 ? vb / speed : 0;
    setTransition(-tb, ta, s, g, left, speed);
    transport(ta, tb, s);
    va *= left;
    vb *= left;
    multiplyBothSides();
    qRate = gone * (2 - gone);
    qBoth = tau * gone * gone;
    qPlace = tau * tau * placeNoise(h, gone);
    double begins = -Math.expm1(-saccadesPerS * dtS);
    double ends = -Math.expm1(-dtS / saccadeS);
    saccadeShare = saccadeShare * (1 - ends) + (1 - saccadeShare) * begins;
    hasStepped = true;
  }

  /** 2h − 3 + 4e^(−h) − e^(−2h), by its series where the terms cancel. */
  private static double placeNoise(double h, double gone) {
    if (h > 0.05) {
      return 2 * (h - gone) - gone * gone;
    }
    return h * h * h * (2.0 / 3 + h * (-0.5 + h * (7.0 / 30 + h * (-1.0 / 12 + h * 31.0 / 1260))));
  }

  private void setTransition(double na, double nb, double s, double g, double left, double speed) {
    double sinc = s < 1e-4 ? 1 - s * s / 6 : Math.sin(s) / s;
    double fall = s < 1e-4 ? -s * s / 2 : Math.cos(s) - 1;
    double placeByRate = g * (sinc - 1);
    double rateByPlace = -left * speed * Math.sin(s);
    double rateByRate = left * fall;
    double[] f = transition;
    double aa = na * na;
    double ab = na * nb;
    double bb = nb * nb;
    f[0] = 1 + fall * aa;
    f[1] = g + placeByRate * aa;
    f[2] = fall * ab;
    f[3] = placeByRate * ab;
    f[4] = rateByPlace * aa;
    f[5] = left + rateByRate * aa;
    f[6] = rateByPlace * ab;
    f[7] = rateByRate * ab;
    f[8] = f[2];
    f[9] = f[3];
    f[10] = 1 + fall * bb;
    f[11] = g + placeByRate * bb;
    f[12] = f[6];
    f[13] = f[7];
    f[14] = rateByPlace * bb;
    f[15] = left + rateByRate * bb;
  }

  /** P ← F P Fᵀ. */
  private void multiplyBothSides() {
    for (int i = 0; i < 4; i++) {
      for (int j = 0; j < 4; j++) {
        double sum = 0;
        for (int k = 0; k < 4; k++) {
          sum += transition[4 * i + k] * p[4 * k + j];
        }
        work[4 * i + j] = sum;
      }
    }
    for (int i = 0; i < 4; i++) {
      for (int j = i; j < 4; j++) {
        double sum = 0;
        for (int k = 0; k < 4; k++) {
          sum += work[4 * i + k] * transition[4 * j + k];
        }
        p[4 * i + j] = sum;
        p[4 * j + i] = sum;
      }
    }
  }

  /** Moves u by an arc towards a tangent direction, and e₁, e₂ along with it without turning. */
  private void transport(double ta, double tb, double arc) {
    if (arc < 1e-300) {
      return;
    }
    double cos = Math.cos(arc);
    double sin = Math.sin(arc);
    for (int i = 0; i < 3; i++) {
      double ahead = ta * e1[i] + tb * e2[i];
      double across = ta * e2[i] - tb * e1[i];
      double newAhead = cos * ahead - sin * u[i];
      u[i] = cos * u[i] + sin * ahead;
      e1[i] = ta * newAhead - tb * across;
    }
    Vectors.normalise(u);
    double along = Vectors.dot(e1, u);
    for (int i = 0; i < 3; i++) {
      e1[i] -= along * u[i];
    }
    Vectors.normalise(e1);
    Vectors.cross(u, e1, e2);
  }

  @Override
  public void update(LineMeasurement[] lines, int count) {
    if (count == 0 && !hasStepped) {
      return;
    }
    room(count);
    for (int i = 0; i < count; i++) {
      lines[i].residualRad = lines[i].residual(u);
    }
    int first = rates[0] == rates[1] ? MODES - 1 : 0;
    for (int mode = first; mode < MODES; mode++) {
      double square = rates[mode] * rates[mode];
      System.arraycopy(p, 0, work, 0, 16);
      work[0] += square * qPlace;
      work[10] += square * qPlace;
      work[1] += square * qBoth;
      work[4] += square * qBoth;
      work[11] += square * qBoth;
      work[14] += square * qBoth;
      work[5] += square * qRate;
      work[15] += square * qRate;
      modes[mode].setState(0, va, 0, vb);
      modes[mode].setCovariance(work);
      likelihoods[mode] = takeIn(mode, lines, count);
    }
    if (first == 0 && hasStepped) {
      double ratio = Math.exp(Math.min(500, likelihoods[1] - likelihoods[0]));
      double odds = saccadeShare / (1 - saccadeShare) * ratio;
      saccadeShare = Math.min(1 - 1e-9, Math.max(1e-9, odds / (1 + odds)));
      merge();
    } else {
      copy(modes[MODES - 1]);
    }
    int likelier = first == 0 && hasStepped && saccadeShare < 0.5 ? 0 : MODES - 1;
    for (int i = 0; i < count; i++) {
      lines[i].used = used[likelier][i];
      lines[i].nis = nis[likelier][i];
      lines[i].afterRad2 = after(lines[i]);
    }
    qPlace = 0;
    qBoth = 0;
    qRate = 0;
    hasStepped = false;
  }

  private void room(int count) {
    if (used[0].length < count) {
      used = new boolean[MODES][count];
      nis = new double[MODES][count];
    }
  }

  /** Takes lines in, nearest first; returns the logarithm of how likely they all were. */
  private double takeIn(int mode, LineMeasurement[] lines, int count) {
    FourStateEkf ekf = modes[mode];
    boolean[] mine = used[mode];
    for (int i = 0; i < count; i++) {
      mine[i] = false;
      nis[mode][i] = Double.NaN;
    }
    double logLikelihood = 0;
    int left = count;
    while (left > 0) {
      int best = -1;
      double bestNis = Double.POSITIVE_INFINITY;
      double bestY = 0;
      double bestHa = 0;
      double bestHb = 0;
      double bestR = 0;
      double p00 = ekf.covariance(0, 0);
      double p02 = ekf.covariance(0, 2);
      double p22 = ekf.covariance(2, 2);
      double a = ekf.x0();
      double b = ekf.x2();
      for (int i = 0; i < count; i++) {
        LineMeasurement line = lines[i];
        if (mine[i] || !(Math.abs(line.residualRad) < gateRad)) {
          continue;
        }
        double[] n = line.n;
        double x1 = n[0] * e1[0] + n[1] * e1[1] + n[2] * e1[2];
        double y1 = n[3] * e1[0] + n[4] * e1[1] + n[5] * e1[2];
        double x2 = n[0] * e2[0] + n[1] * e2[1] + n[2] * e2[2];
        double y2 = n[3] * e2[0] + n[4] * e2[1] + n[5] * e2[2];
        double vx = n[0] * u[0] + n[1] * u[1] + n[2] * u[2] + a * x1 + b * x2;
        double vy = n[3] * u[0] + n[4] * u[1] + n[5] * u[2] + a * y1 + b * y2;
        double squares = vx * vx + vy * vy;
        if (!(squares > 1e-12)) {
          continue;
        }
        double ha = (vx * y1 - vy * x1) / squares;
        double hb = (vx * y2 - vy * x2) / squares;
        double spread = ha * ha * p00 + 2 * ha * hb * p02 + hb * hb * p22;
        double r = line.varianceRad2 + CURVATURE * spread * spread;
        double y = line.residual(vx, vy);
        double nisNow = y * y / (spread + r);
        // Least surprising first, by the likelihood: a wide expectation may not hide an outlier.
        if (nisNow < bestNis && isLikelier(nisNow, spread + r)) {
          best = i;
          bestNis = nisNow;
          bestY = y;
          bestHa = ha;
          bestHb = hb;
          bestR = r;
        }
      }
      if (best < 0) {
        break;
      }
      ekf.update(bestY, bestHa, 0, bestHb, 0, bestR);
      double s = bestY * bestY / Math.max(bestNis, 1e-300);
      if (bestNis == 0 || !(s > 0)) {
        s = bestHa * bestHa * p00 + 2 * bestHa * bestHb * p02 + bestHb * bestHb * p22 + bestR;
      }
      logLikelihood += Math.log(inlierShare) - 0.5 * (bestNis + Math.log(2 * Math.PI * s));
      mine[best] = true;
      nis[mode][best] = bestNis;
      left--;
    }
    return logLikelihood + left * Math.log(Math.max(outlierDensity, 1e-6));
  }

  /** Whether a line with this innovation is rather the body's than any line. */
  private boolean isLikelier(double nisNow, double s) {
    return outlierDensity == 0
        || inlierShare * Math.exp(-0.5 * nisNow) > outlierDensity * Math.sqrt(2 * Math.PI * s);
  }

  private void copy(FourStateEkf from) {
    for (int i = 0; i < 4; i++) {
      for (int j = 0; j < 4; j++) {
        p[4 * i + j] = from.covariance(i, j);
      }
    }
    go(from.x0(), from.x1(), from.x2(), from.x3());
  }

  private void merge() {
    FourStateEkf calm = modes[0];
    FourStateEkf wild = modes[1];
    double w = saccadeShare;
    double[] difference = moved4;
    difference[0] = wild.x0() - calm.x0();
    difference[1] = wild.x1() - calm.x1();
    difference[2] = wild.x2() - calm.x2();
    difference[3] = wild.x3() - calm.x3();
    for (int i = 0; i < 4; i++) {
      for (int j = 0; j < 4; j++) {
        p[4 * i + j] =
            (1 - w) * calm.covariance(i, j)
                + w * wild.covariance(i, j)
                + w * (1 - w) * difference[i] * difference[j];
      }
    }
    go(
        calm.x0() + w * difference[0],
        calm.x1() + w * difference[1],
        calm.x2() + w * difference[2],
        calm.x3() + w * difference[3]);
  }

  private final double[] moved4 = new double[4];

  /** Takes the error into the state. */
  private void go(double a, double rateA, double b, double rateB) {
    double off = Math.sqrt(a * a + b * b);
    if (off > 0) {
      transport(a / off, b / off, Math.atan(off));
    }
    va = rateA;
    vb = rateB;
  }

  /** Residual after the update, squared, and the variance of the angle that is now expected. */
  private double after(LineMeasurement line) {
    if (!line.gradient(u, moved)) {
      return Double.NaN;
    }
    double ha = Vectors.dot(moved, e1);
    double hb = Vectors.dot(moved, e2);
    double y = line.residual(u);
    return y * y + ha * ha * p[0] + 2 * ha * hb * p[2] + hb * hb * p[10];
  }

  @Override
  public void axis(double[] out) {
    System.arraycopy(u, 0, out, 0, 3);
  }

  @Override
  public void tipVelocity(double[] out) {
    for (int i = 0; i < 3; i++) {
      out[i] = va * e1[i] + vb * e2[i];
    }
  }

  @Override
  public double axisVariance() {
    return p[0] + p[10];
  }

  /** That of any angle at all: the frame's own rotation about the axis means nothing. */
  @Override
  public double rollSd() {
    return Math.PI / Math.sqrt(3);
  }

  @Override
  public double rollRate() {
    return 0;
  }

  @Override
  public boolean isSound() {
    return Double.isFinite(u[0] + u[1] + u[2] + va + vb + p[0] + p[5] + p[10] + p[15])
        && p[0] > 0
        && p[10] > 0;
  }

  /** Sets the velocity of the axis' tip, of which the part along the axis is left out. */
  void setTipVelocity(double[] velocity) {
    va = Vectors.dot(velocity, e1);
    vb = Vectors.dot(velocity, e2);
  }

  /** Everything that a smoother needs of the state. */
  AxisState state() {
    return new AxisState(u.clone(), e1.clone(), e2.clone(), va, vb, p.clone());
  }

  /**
   * The state before the update, with the noise of both modes in it as likely as they are; to be
   * asked for between {@link #predict} and {@link #update}.
   */
  AxisState predictedState() {
    double square =
        rates[0] == rates[1]
            ? rates[1] * rates[1]
            : (1 - saccadeShare) * rates[0] * rates[0] + saccadeShare * rates[1] * rates[1];
    double[] withNoise = p.clone();
    withNoise[0] += square * qPlace;
    withNoise[10] += square * qPlace;
    withNoise[1] += square * qBoth;
    withNoise[4] += square * qBoth;
    withNoise[11] += square * qBoth;
    withNoise[14] += square * qBoth;
    withNoise[5] += square * qRate;
    withNoise[15] += square * qRate;
    return new AxisState(u.clone(), e1.clone(), e2.clone(), va, vb, withNoise);
  }

  /** How the errors went over the last step. */
  double[] transition() {
    return transition.clone();
  }

  /** Probability that the body is in a saccade. */
  double saccadeShare() {
    return saccadeShare;
  }
}
