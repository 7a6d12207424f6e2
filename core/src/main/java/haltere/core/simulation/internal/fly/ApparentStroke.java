package haltere.core.simulation.internal.fly;

/**
 * The apparent stroke of a wing. Its long axis is the mean of both edges, which lies behind the
 * pitch axis, so the apparent stroke has a centre, an amplitude and a phase of its own.
 *
 * <p>Thread rule: immutable.
 */
final class ApparentStroke {
  private static final int GRID = 720;
  private static final int HALVINGS = 40;

  private final WingPlanform planform;
  private final WingPitch pitch;
  private final Waveform waveform;
  private final double[] stroke = new double[GRID];
  private final double[] behind = new double[GRID];
  private final double meanBehind;

  ApparentStroke(WingPlanform planform, WingPitch pitch, Waveform waveform) {
    this.planform = planform;
    this.pitch = pitch;
    this.waveform = waveform;
    double sum = 0;
    for (int i = 0; i < GRID; i++) {
      double phase = 2 * Math.PI * i / GRID;
      stroke[i] = waveform.at(phase);
      behind[i] = middleRad(phase);
      sum += behind[i];
    }
    meanBehind = sum / GRID;
  }

  private double edgeRad(double phase, double share) {
    return planform.edgeRad(pitch.projection(phase), share);
  }

  /** Angle of the wing's long axis from the pitch axis. */
  private double middleRad(double phase) {
    return (edgeRad(phase, 0) + edgeRad(phase, 1)) / 2;
  }

  /** Stroke angle of the long axis from its mean over the cycle, linear between grid points. */
  private double fromCentre(double amplitude, double phase) {
    double position = FlyTruth.wrapped(phase) / (2 * Math.PI) * GRID;
    int low = (int) position % GRID;
    int high = (low + 1) % GRID;
    double share = position - (int) position;
    return amplitude * (stroke[low] + share * (stroke[high] - stroke[low]))
        + behind[low]
        + share * (behind[high] - behind[low])
        - meanBehind;
  }

  /** The truth about a wing in a pose. */
  FlyTruth.Wing at(FlyPose pose, int side) {
    double amplitude = pose.amplitude[side];
    double phase = 2 * Math.PI * (pose.cycles[side] - Math.floor(pose.cycles[side]));
    double centre = pose.centre[side] + meanBehind;
    double axis = pose.centre[side] + amplitude * waveform.at(phase);
    double first = edgeRad(phase, 0);
    double second = edgeRad(phase, 1);
    double step = Math.PI / GRID;
    boolean towardsTail = fromCentre(amplitude, phase + step) > fromCentre(amplitude, phase - step);
    double ahead = towardsTail ? Math.max(first, second) : Math.min(first, second);
    return new FlyTruth.Wing(
        FlyTruth.wrapped(axis + (first + second) / 2),
        FlyTruth.wrapped(axis + ahead),
        FlyTruth.wrapped(axis + first + second - ahead),
        centre,
        halfOfPeakToPeak(amplitude),
        FlyTruth.wrapped(phase - crossing(amplitude)),
        pose.frequencyHz[side]);
  }

  private double halfOfPeakToPeak(double amplitude) {
    double min = Double.POSITIVE_INFINITY;
    double max = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < GRID; i++) {
      double angle = amplitude * stroke[i] + behind[i];
      min = Math.min(min, angle);
      max = Math.max(max, angle);
    }
    return (max - min) / 2;
  }

  /** Phase of the stroke at which the long axis passes its centre towards the tail. */
  private double crossing(double amplitude) {
    double before = -Math.PI / 2;
    double after = Math.PI / 2;
    for (int i = 0; i < HALVINGS; i++) {
      double middle = (before + after) / 2;
      if (fromCentre(amplitude, middle) < 0) {
        before = middle;
      } else {
        after = middle;
      }
    }
    return (before + after) / 2;
  }
}
