package haltere.filters.object;

import haltere.filters.estimation.GaussianState;
import haltere.filters.trail.Ellipse;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;

/** An object: components, identity (once decided) and extent. */
final class TrackedObject {
  final List<Component> components = new ArrayList<>(1);

  /** Rows from before its identity was decided, oldest first. */
  final ArrayDeque<ObjectTrack> undecided = new ArrayDeque<>();

  /** 0 before it is decided. */
  int id;

  long bornUs;

  /** Time since which all others are separate from this one. */
  long apartUs;

  long activeUs;

  /** Speed in its last motion, px/s. */
  double speed;

  double events;

  /** Whether it is lost, and only its identity is kept. */
  boolean isLost;

  private double lowX;
  private double highX;
  private double lowY;
  private double highY;

  TrackedObject(Component first, long nowUs) {
    bornUs = nowUs;
    apartUs = nowUs;
    activeUs = nowUs;
    add(first);
  }

  void add(Component component) {
    component.object = this;
    components.add(component);
  }

  void absorb(TrackedObject other) {
    other.components.forEach(this::add);
    bornUs = Math.min(bornUs, other.bornUs);
    events += other.events;
  }

  boolean isDecided() {
    return id > 0;
  }

  /** Whether it is reported, or was observed for longer than rows are kept. */
  boolean isSettled() {
    return isDecided() || age() * ObjectTracker.TICK_S > ObjectTrackerFilter.UNDECIDED_S;
  }

  boolean isMoving() {
    boolean isMoving = false;
    for (int i = 0; i < components.size(); i++) {
      isMoving |= components.get(i).isMoving();
    }
    return isMoving;
  }

  double novelty() {
    double sum = 0;
    for (int i = 0; i < components.size(); i++) {
      sum += components.get(i).novelty;
    }
    return sum;
  }

  /** Age of its first component, ticks. */
  int age() {
    return components.get(0).age;
  }

  /** Probability that one of its components is there. */
  double existence() {
    return 1 - components.stream().mapToDouble(c -> c.presence.gone()).reduce(1, (a, b) -> a * b);
  }

  /** Computes the box around its components. */
  void measure() {
    lowX = Double.POSITIVE_INFINITY;
    highX = Double.NEGATIVE_INFINITY;
    lowY = Double.POSITIVE_INFINITY;
    highY = Double.NEGATIVE_INFINITY;
    for (Component c : components) {
      lowX = Math.min(lowX, c.middleX() - c.shape.halfX);
      highX = Math.max(highX, c.middleX() + c.shape.halfX);
      lowY = Math.min(lowY, c.middleY() - c.shape.halfY);
      highY = Math.max(highY, c.middleY() + c.shape.halfY);
    }
  }

  double middleX() {
    return 0.5 * (lowX + highX);
  }

  double middleY() {
    return 0.5 * (lowY + highY);
  }

  double halfX() {
    return 0.5 * (highX - lowX);
  }

  double halfY() {
    return 0.5 * (highY - lowY);
  }

  double size() {
    return 2 * Math.max(halfX(), halfY());
  }

  /** Row of the lower edge of moving components, pixels. */
  private double lowEdge() {
    double low = Double.POSITIVE_INFINITY;
    for (Component c : components) {
      if (c.isMoving() || components.size() == 1) {
        low = Math.min(low, c.y() + c.shape.lowEdge);
      }
    }
    return low == Double.POSITIVE_INFINITY ? lowY : low;
  }

  /** Mean over its components, weighted by their events. */
  private double mean(ToDoubleFunction<GaussianState> of) {
    double sum = 0;
    double all = 0;
    for (int i = 0; i < components.size(); i++) {
      Component c = components.get(i);
      double weight = c.activeRate();
      sum += weight * of.applyAsDouble(c.state);
      all += weight;
    }
    return sum / all;
  }

  double vx() {
    return mean(state -> state.mean(1));
  }

  double vy() {
    return mean(state -> state.mean(3));
  }

  /** Half the normalised squared difference of its velocity and another. */
  double unlike(Component other) {
    double sum = 0;
    for (int i = 1; i < 4; i += 2) {
      int entry = i;
      double apart = mean(state -> state.mean(entry)) - other.state.mean(entry);
      double variance =
          mean(state -> state.covariance(entry, entry)) + other.state.covariance(entry, entry);
      sum += 0.5 * apart * apart / variance;
    }
    return sum;
  }

  /** Standard deviation of a predicted coordinate, with the variance of its sides. */
  private double sdOfPosition(int position, double s, double side) {
    double pp = mean(state -> state.covariance(position, position));
    double pv = mean(state -> state.covariance(position, position + 1));
    double vv = mean(state -> state.covariance(position + 1, position + 1));
    return Math.sqrt(pp + side + s * (2 * pv + s * vv));
  }

  /** The inscribed ellipse of its box with the correlation of its events. */
  private Ellipse ellipse() {
    double xx = 0;
    double xy = 0;
    double yy = 0;
    for (Component c : components) {
      double weight = c.activeRate();
      double dx = c.middleX() - middleX();
      double dy = c.middleY() - middleY();
      xx += weight * (dx * dx + c.shape.varianceX);
      xy += weight * (dx * dy + c.shape.covarianceXy);
      yy += weight * (dy * dy + c.shape.varianceY);
    }
    double correlation = xx > 0 && yy > 0 ? xy / Math.sqrt(xx * yy) : 0;
    return Ellipse.of(halfX() * halfX(), correlation * halfX() * halfY(), halfY() * halfY());
  }

  /** Shifts all components without a registration. */
  void shift(double dx, double dy) {
    for (Component component : components) {
      component.shift(dx, dy);
    }
  }

  /**
   * The row of a time at or after the last tick.
   *
   * @param nowUs end of the last tick
   * @param timeUs of the row
   * @param deform standard deviation of a side, as a share of the extent
   */
  ObjectTrack row(long nowUs, long timeUs, int widthPx, int heightPx, double deform) {
    measure();
    double s = (timeUs - nowUs) * 1e-6;
    double vx = vx();
    double vy = vy();
    double rate = 0;
    double cell = 0;
    for (Component c : components) {
      rate += c.activeRate();
      cell = Math.max(cell, c.shape.cellPx);
    }
    // the sides of the extent are known to a cell of the template; the middle is that of both sides
    double side = cell * cell / 4;
    double middle = 2 * deform * deform;
    Ellipse ellipse = ellipse();
    return new ObjectTrack(
        timeUs,
        id,
        Math.max(0, Math.min(widthPx - 1, middleX() + vx * s)),
        Math.max(0, Math.min(heightPx - 1, middleY() + vy * s)),
        vx,
        vy,
        sdOfPosition(0, s, side + middle * halfX() * halfX()),
        sdOfPosition(2, s, side + middle * halfY() * halfY()),
        Math.sqrt(mean(state -> state.covariance(1, 1))),
        Math.sqrt(mean(state -> state.covariance(3, 3))),
        Math.round(events),
        ellipse.majorPx(),
        ellipse.minorPx(),
        ellipse.angleRad(),
        existence(),
        rate / ObjectTracker.TICK_S,
        (timeUs - bornUs) * 1e-6,
        lowEdge() + vy * s);
  }
}
