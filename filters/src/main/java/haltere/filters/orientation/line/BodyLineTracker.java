package haltere.filters.orientation.line;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.filters.estimation.Angles;
import java.util.Arrays;
import java.util.Objects;
import java.util.function.Consumer;

/**
 * Tracks one elongated body in the events of a camera by their second moments: position, angle,
 * length and width of an ellipse.
 *
 * <p>A moving body causes events of one polarity in front and of the other behind. Along the
 * outline their density is proportional to its projection across the motion; for an ellipse with
 * the matrix S (points p with pᵀ S⁻¹ p = 1) that moves in any direction, the covariance W of one
 * polarity about its own mean, and the difference δ of the two means, then satisfy
 *
 * <pre>
 * S = 3 W + (3/4 − 4/π²) δ δᵀ
 * </pre>
 *
 * <p>(a circle has E cos² = 2/3, E sin² = 1/3 and E |cos| = π/4 under the density |cos|; any
 * ellipse is an affine image of it, with its density). Plain second moments, W + δ δᵀ / 4, would be
 * biased towards the motion. The order of the polarities is irrelevant.
 *
 * <p>Moments are computed in a frame that moves with the body, with a memory in events. Without a
 * body, one starts at many events within 48 x 48 pixels.
 *
 * <p>Thread rule: one thread at a time. Nothing is allocated per event, and results do not depend
 * on the packets.
 */
public final class BodyLineTracker {
  /** Factor of δ δᵀ. */
  private static final double BETWEEN = 0.75 - 4 / (Math.PI * Math.PI);

  private static final int CELL_SHIFT = 4;

  /** Events in 3 x 3 cells at which a body starts. */
  private static final double START_EVENTS = 40;

  private static final double CELL_DECAY = 0.6;
  private static final double START_RADIUS_PX = 20;
  private static final double MAX_STEP_S = 0.02;
  private static final double VELOCITY_GAIN = 0.25;

  /** Events between the start and the first report, in outlines. */
  private static final double WARM_UP = 1.5;

  private final SensorGeometry geometry;
  private final Consumer<? super BodyLine> listener;
  private final int columns;
  private final float[] cells;
  private BodyLineSettings settings;
  private long periodUs;

  private boolean hasTime;
  private long nextUs;
  private boolean following;
  private long lastUs;
  private long movedUs;
  private double x;
  private double y;
  private double vx;
  private double vy;

  /** By polarity: mean and covariance in the moving frame, number of events. */
  private final double[] meanX = new double[2];

  private final double[] meanY = new double[2];
  private final double[] covXx = new double[2];
  private final double[] covXy = new double[2];
  private final double[] covYy = new double[2];
  private final double[] seen = new double[2];

  private double sxx;
  private double sxy;
  private double syy;
  private double gateXx;
  private double gateXy;
  private double gateYy;
  private double gain;
  private double total;
  private int sinceReport;

  /**
   * A tracker without a body.
   *
   * @param geometry the sensor
   * @param settings of the tracker
   * @param listener receives each report
   */
  public BodyLineTracker(
      SensorGeometry geometry, BodyLineSettings settings, Consumer<? super BodyLine> listener) {
    this.geometry = Objects.requireNonNull(geometry, "geometry");
    this.listener = Objects.requireNonNull(listener, "listener");
    columns = (geometry.width() >> CELL_SHIFT) + 1;
    cells = new float[columns * ((geometry.height() >> CELL_SHIFT) + 1)];
    apply(settings);
  }

  BodyLineSettings settings() {
    return settings;
  }

  /** Applies new settings; a tracked body is kept. */
  void apply(BodyLineSettings newSettings) {
    settings = newSettings;
    periodUs = Math.max(1, Math.round(1e6 / newSettings.rateHz()));
    hasTime = false;
  }

  /** Returns to the initial state. */
  public void reset() {
    hasTime = false;
    lose();
  }

  private void lose() {
    following = false;
    Arrays.fill(cells, 0);
  }

  /**
   * Processes events, which are not changed.
   *
   * @param packet events in order of time
   */
  public void track(EventPacket packet) {
    int size = packet.size();
    for (int i = 0; i < size; i++) {
      long timeUs = packet.timeUs(i);
      if (!hasTime || timeUs >= nextUs) {
        tick(timeUs);
      }
      if (following) {
        take(timeUs, packet.x(i), packet.y(i), packet.isOn(i) ? 1 : 0);
      } else {
        cells[(packet.y(i) >> CELL_SHIFT) * columns + (packet.x(i) >> CELL_SHIFT)]++;
      }
    }
  }

  private void tick(long timeUs) {
    if (hasTime) {
      if (following && timeUs - lastUs > settings.timeoutUs()) {
        lose();
      } else if (following) {
        follow(nextUs);
      } else {
        search();
      }
    }
    hasTime = true;
    nextUs = Math.floorDiv(timeUs, periodUs) * periodUs + periodUs;
  }

  private void take(long timeUs, int eventX, int eventY, int polarity) {
    double stepS = Math.min(MAX_STEP_S, (timeUs - movedUs) * 1e-6);
    movedUs = timeUs;
    x += vx * stepS;
    y += vy * stepS;
    double dx = eventX - x;
    double dy = eventY - y;
    if (gateXx * dx * dx + 2 * gateXy * dx * dy + gateYy * dy * dy > 1) {
      return;
    }
    lastUs = timeUs;
    total++;
    sinceReport++;
    double count = ++seen[polarity];
    double g = count * gain < 1 ? 1 / count : gain;
    double offX = dx - meanX[polarity];
    double offY = dy - meanY[polarity];
    meanX[polarity] += g * offX;
    meanY[polarity] += g * offY;
    covXx[polarity] += g * ((1 - g) * offX * offX - covXx[polarity]);
    covXy[polarity] += g * ((1 - g) * offX * offY - covXy[polarity]);
    covYy[polarity] += g * ((1 - g) * offY * offY - covYy[polarity]);
  }

  /** Moves the frame to the middle of both polarities, computes the ellipse, and reports. */
  private void follow(long atUs) {
    if (sinceReport < settings.minEvents() || seen[0] < 4 || seen[1] < 4) {
      return;
    }
    double middleX = 0.5 * (meanX[0] + meanX[1]);
    double middleY = 0.5 * (meanY[0] + meanY[1]);
    x += middleX;
    y += middleY;
    // the means lag, so that the correction of the velocity is spread over the lag
    double perS = VELOCITY_GAIN * 1e6 / periodUs * Math.min(1, sinceReport * gain);
    vx += perS * middleX;
    vy += perS * middleY;
    for (int polarity = 0; polarity < 2; polarity++) {
      meanX[polarity] -= middleX;
      meanY[polarity] -= middleY;
    }
    shape();
    if (!following) {
      return;
    }
    int events = sinceReport;
    sinceReport = 0;
    double half = 0.5 * (sxx - syy);
    double root = Math.sqrt(half * half + sxy * sxy);
    double mean = 0.5 * (sxx + syy);
    double longAxis = Math.sqrt(mean + root);
    double shortAxis = Math.sqrt(Math.max(0.25, mean - root));
    if (total > WARM_UP / gain && geometry.contains((int) Math.round(x), (int) Math.round(y))) {
      double lateS = Math.min(MAX_STEP_S, (atUs - movedUs) * 1e-6);
      listener.accept(
          new BodyLine(
              atUs,
              x + vx * lateS,
              y + vy * lateS,
              Angles.wrapHalfPi(0.5 * Math.atan2(2 * sxy, sxx - syy)),
              Math.PI * longAxis * shortAxis,
              Math.max(1, longAxis / shortAxis),
              vx,
              vy,
              events));
    }
  }

  private void shape() {
    double deltaX = meanX[0] - meanX[1];
    double deltaY = meanY[0] - meanY[1];
    double min = settings.minRadiusPx() * settings.minRadiusPx();
    sxx = 1.5 * (covXx[0] + covXx[1]) + BETWEEN * deltaX * deltaX;
    sxy = 1.5 * (covXy[0] + covXy[1]) + BETWEEN * deltaX * deltaY;
    syy = 1.5 * (covYy[0] + covYy[1]) + BETWEEN * deltaY * deltaY;
    sxx = Math.max(min, sxx);
    syy = Math.max(min, syy);
    double bound = Math.sqrt(sxx * syy) * 0.999;
    sxy = Math.max(-bound, Math.min(bound, sxy));
    double largest = 0.5 * (sxx + syy) + Math.sqrt(0.25 * (sxx - syy) * (sxx - syy) + sxy * sxy);
    if (!(largest < settings.maxRadiusPx() * settings.maxRadiusPx())) {
      lose();
      return;
    }
    setGate();
  }

  private void setGate() {
    // a margin of a pixel, and space for rotation
    double wide = settings.gateRadii() * settings.gateRadii();
    double gxx = wide * sxx + 2;
    double gyy = wide * syy + 2;
    double gxy = wide * sxy;
    double determinant = gxx * gyy - gxy * gxy;
    gateXx = gyy / determinant;
    gateXy = -gxy / determinant;
    gateYy = gxx / determinant;
    // Ramanujan's first term is sufficient for the number of pixels along the outline
    double mean = 0.5 * (sxx + syy);
    double outline = 2 * Math.PI * Math.sqrt(mean);
    gain = 1 / Math.max(8, 0.5 * settings.eventsPerOutlinePx() * outline);
  }

  /** Starts a body where the most events are, if there are enough; older ones count less. */
  private void search() {
    double max = 0;
    int best = 0;
    for (int i = 0; i < cells.length; i++) {
      double sum = cells[i] * 9 > max ? around(i, 1, 0, 0) : 0;
      if (sum > max) {
        max = sum;
        best = i;
      }
    }
    if (max >= START_EVENTS) {
      double size = 1 << CELL_SHIFT;
      start(
          size * (around(best, 0, 1, 0) / max + 0.5) - 0.5,
          size * (around(best, 0, 0, 1) / max + 0.5) - 0.5);
    }
    for (int i = 0; i < cells.length; i++) {
      cells[i] = cells[i] < 0.01f ? 0 : (float) (cells[i] * CELL_DECAY);
    }
  }

  /** Sum of a linear function of column and row over the events of 3 x 3 cells. */
  private double around(int cell, double one, double byColumn, double byRow) {
    int row = cell / columns;
    int column = cell % columns;
    double sum = 0;
    for (int r = Math.max(0, row - 1); r <= row + 1 && r * columns < cells.length; r++) {
      for (int c = Math.max(0, column - 1); c <= Math.min(columns - 1, column + 1); c++) {
        sum += cells[r * columns + c] * (one + byColumn * c + byRow * r);
      }
    }
    return sum;
  }

  private void start(double atX, double atY) {
    x = atX;
    y = atY;
    vx = 0;
    vy = 0;
    Arrays.fill(meanX, 0);
    Arrays.fill(meanY, 0);
    Arrays.fill(covXx, 0);
    Arrays.fill(covXy, 0);
    Arrays.fill(covYy, 0);
    Arrays.fill(seen, 0);
    total = 0;
    sinceReport = 0;
    double radius = Math.min(START_RADIUS_PX, settings.maxRadiusPx() / 2);
    sxx = radius * radius;
    sxy = 0;
    syy = sxx;
    setGate();
    following = true;
    lastUs = nextUs;
    movedUs = nextUs;
  }
}
