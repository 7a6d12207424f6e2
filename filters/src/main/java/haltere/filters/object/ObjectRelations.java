package haltere.filters.object;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * Decides which components are one object by the log odds of one against two. The prior decreases
 * with their gap. The evidence, with exponential memory, is the log ratio of the densities of the
 * difference of their displacements (track-to-track association: Bar-Shalom, IEEE TAC 26, 1981).
 * Under "one" the variance is that of errors, deformation and rotation; under "two" that of their
 * own motions as well.
 */
final class ObjectRelations {
  /** Prior log odds of touching components: four of five are one object. */
  private static final double TOUCH_NAT = Math.log(4);

  /**
   * Gap with half the prior, and deformation within {@link #WATCH_S}, as shares of the size: gaps
   * within an object have a Cauchy distribution, and one in ten is larger than the components.
   */
  static final double GAP_SHARE = 1 / Math.tan(0.9 * Math.PI / 2);

  /** Least log odds to join two objects: odds of e. */
  private static final double JOIN_NAT = 1;

  /** Error probability of an irreversible decision: that usual for tests. */
  static final double ERROR = 0.05;

  /** Log odds of such a decision: a component leaves its object, or two identities become one. */
  static final double DECISIVE_NAT = -Math.log(ERROR);

  /** Least time over which displacements are compared, seconds. */
  static final double WATCH_S = ShapeTemplate.MEMORY_S;

  /** Least time of usable displacements, and until touching objects are joined. */
  private static final double FIRST_S = 0.1;

  /** Memory of the evidence, seconds: the duration of a motion. */
  private static final double EVIDENCE_S = 1 / Presence.STOP_HZ;

  /** Variance of a displacement from the cells of the template, px². */
  private static final double CELL_VARIANCE = ShapeTemplate.MIN_CELL_PX * ShapeTemplate.MIN_CELL_PX;

  /** Squared gap at which the prior is that of two wrong decisions. */
  private static final double FAR_SQUARES = Math.expm1(TOUCH_NAT + 2 * DECISIVE_NAT);

  /** Log odds of pairs that are too far apart to be compared. */
  private static final double FAR = Double.NEGATIVE_INFINITY;

  private static final int SLOTS = ObjectTracker.MAX_COMPONENTS;

  private final double[][] gap = new double[SLOTS][SLOTS];
  private final double[][] evidence = new double[SLOTS][SLOTS];

  /** {@link ClutterMap#alarmNat}; half of it is required of a component. */
  private final double alarmNat;

  private double scalePx;

  /** Usual size of a component, pixels: geometric mean by their events; 0 without events. */
  private double usualSize;

  private MotionModel motion;

  ObjectRelations(double alarmNat) {
    this.alarmNat = alarmNat;
  }

  void apply(ObjectTrackerSettings settings) {
    scalePx = settings.scalePx();
  }

  void apply(MotionModel model) {
    motion = model;
  }

  /** Clears the evidence of a slot, or copies that of another component. */
  void begin(int slot, Component like) {
    for (int i = 0; i < SLOTS; i++) {
      double known = like == null || like.slot == i ? 0 : evidence[like.slot][i];
      evidence[slot][i] = known;
      evidence[i][slot] = known;
      gap[slot][i] = FAR;
      gap[i][slot] = FAR;
    }
  }

  /**
   * Compares all pairs.
   *
   * @param seconds since the last comparison
   */
  void compare(List<Component> components, double seconds) {
    double fade = Math.exp(-seconds / EVIDENCE_S);
    for (int i = 0; i < components.size(); i++) {
      components.get(i).watch(WATCH_S, EVIDENCE_S);
    }
    usualSize = usualSize(components);
    for (int i = 0; i < components.size(); i++) {
      Component a = components.get(i);
      for (int j = i + 1; j < components.size(); j++) {
        Component b = components.get(j);
        double prior = gapLog(a, b);
        double sum = evidence[a.slot][b.slot];
        if (prior == FAR) {
          if (sum == 0 && gap[a.slot][b.slot] == FAR) {
            continue;
          }
          sum = 0;
        } else if (a.isMoving() && b.isMoving()) {
          sum *= fade;
          int known = Math.min(a.knownTicks(), b.knownTicks());
          int ticks = Math.min(known, Math.max(a.window, b.window));
          double windowS = ticks * ObjectTracker.TICK_S;
          if (windowS > FIRST_S) {
            sum += motionLog(a, b, ticks) * seconds / Math.max(WATCH_S, windowS);
            // motion alone is limited to the certainty of two decisions
            sum = Math.max(-2 * DECISIVE_NAT, Math.min(2 * DECISIVE_NAT, sum));
          }
        }
        gap[a.slot][b.slot] = prior;
        gap[b.slot][a.slot] = prior;
        evidence[a.slot][b.slot] = sum;
        evidence[b.slot][a.slot] = sum;
      }
    }
  }

  private double gapLog(Component a, Component b) {
    double shares = a.boxDistance(b) / (GAP_SHARE * sizeOf(a, b));
    double squares = shares * shares;
    return squares > FAR_SQUARES ? FAR : TOUCH_NAT - Math.log1p(squares);
  }

  private static double usualSize(List<Component> components) {
    double logs = 0;
    double weights = 0;
    for (int i = 0; i < components.size(); i++) {
      double weight = components.get(i).activeRate();
      logs += weight * Math.log(components.get(i).shape.size());
      weights += weight;
    }
    return weights > 0 ? Math.exp(logs / weights) : 0;
  }

  /**
   * Size of the object that two components would be: at least theirs, for they are its parts, and
   * as far as that of others in the picture is larger, between both.
   */
  private double sizeOf(Component a, Component b) {
    double meanSize = Math.sqrt(a.shape.size() * b.shape.size());
    return scalePx > 0 ? scalePx : Math.max(meanSize, Math.sqrt(meanSize * usualSize));
  }

  static double outside(double distance, double reach) {
    return Math.max(0, Math.abs(distance) - reach);
  }

  /** Log ratio of the difference of two displacements under one object and under two. */
  private double motionLog(Component a, Component b, int ticks) {
    double ax = a.displacement(0, ticks);
    double ay = a.displacement(1, ticks);
    double bx = b.displacement(0, ticks);
    double by = b.displacement(1, ticks);
    // approaching components move apart
    double growth = Math.sqrt(a.growth(ticks) * b.growth(ticks)) - 1;
    double dx = ax - bx + growth * (b.middleX() - bx - a.middleX() + ax);
    double dy = ay - by + growth * (b.middleY() - by - a.middleY() + ay);
    double unlike = motion.unlikeShare();
    double own = 0.5 * unlike * unlike * (ax * ax + ay * ay + bx * bx + by * by);
    double bend = GAP_SHARE * sizeOf(a, b);
    double turn = Math.max(a.turnRadS(), b.turnRadS()) * ticks * ObjectTracker.TICK_S;
    double lineX = turn * (b.middleX() - a.middleX() - 0.5 * (bx - ax));
    double lineY = turn * (b.middleY() - a.middleY() - 0.5 * (by - ay));
    double both = bend * bend + CELL_VARIANCE;
    // positions at both ends; a rotation is perpendicular to the mean of both lines between them
    double xx = 2 * (a.state.covariance(0, 0) + b.state.covariance(0, 0)) + both + lineY * lineY;
    double xy = 2 * (a.state.covariance(0, 2) + b.state.covariance(0, 2)) - lineX * lineY;
    double yy = 2 * (a.state.covariance(2, 2) + b.state.covariance(2, 2)) + both + lineX * lineX;
    return logDensity(dx, dy, xx, xy, yy) - logDensity(dx, dy, xx + own, xy, yy + own);
  }

  /** Of a normal distribution with mean zero, up to a constant. */
  private static double logDensity(double dx, double dy, double xx, double xy, double yy) {
    double det = xx * yy - xy * xy;
    return -0.5 * (Math.log(det) + (yy * dx * dx - 2 * xy * dx * dy + xx * dy * dy) / det);
  }

  /** Log odds that two sets of components are one object: the least gap, the mean evidence. */
  double score(List<Component> a, List<Component> b) {
    double prior = FAR;
    double sum = 0;
    double weights = 0;
    for (int i = 0; i < a.size(); i++) {
      Component one = a.get(i);
      for (int j = 0; j < b.size(); j++) {
        Component other = b.get(j);
        if (one != other) {
          prior = Math.max(prior, gap[one.slot][other.slot]);
          double weight = one.activeRate() * other.activeRate();
          sum += weight * evidence[one.slot][other.slot];
          weights += weight;
        }
      }
    }
    return weights > 0 && prior > FAR ? prior + sum / weights + oneLog(a, b) : FAR;
  }

  /** Log prior that the box of two sets of components is that of one object. */
  private double oneLog(List<Component> a, List<Component> b) {
    double lowX = Double.POSITIVE_INFINITY;
    double highX = Double.NEGATIVE_INFINITY;
    double lowY = Double.POSITIVE_INFINITY;
    for (int i = 0; i < a.size() + b.size(); i++) {
      Component c = i < a.size() ? a.get(i) : b.get(i - a.size());
      lowX = Math.min(lowX, c.middleX() - c.shape.halfX);
      highX = Math.max(highX, c.middleX() + c.shape.halfX);
      lowY = Math.min(lowY, c.middleY() - c.shape.halfY);
    }
    return motion.oneLog(lowX, highX, lowY);
  }

  /** Whether two objects are separate. */
  boolean areApart(TrackedObject a, TrackedObject b) {
    return score(a.components, b.components) < -DECISIVE_NAT;
  }

  /** Whether two objects are to be joined. */
  boolean areOne(TrackedObject a, TrackedObject b) {
    if (!mayJoin(a) || !mayJoin(b)) {
      return false;
    }
    double odds = score(a.components, b.components);
    if (a.isSettled() && b.isSettled()) {
      return odds > DECISIVE_NAT;
    }
    double watched = Math.min(a.age(), b.age()) * ObjectTracker.TICK_S;
    return watched > WATCH_S ? odds > JOIN_NAT : watched > FIRST_S && odds >= TOUCH_NAT;
  }

  private boolean mayJoin(TrackedObject object) {
    return !object.isLost
        && (object.isMoving() || object.isDecided())
        && object.novelty() >= 0.5 * alarmNat;
  }

  /** The component that leaves an object of several, or null. */
  Component leaving(TrackedObject object) {
    if (object.isLost || object.components.size() < 2) {
      return null;
    }
    List<Component> byRate = new ArrayList<>(object.components);
    byRate.removeIf(component -> !component.isMoving());
    byRate.sort(Comparator.comparingDouble(component -> component.rate));
    for (Component component : byRate) {
      if (byRate.size() > 1 && score(List.of(component), byRate) < -DECISIVE_NAT) {
        return component;
      }
    }
    return null;
  }

  /** Whether two components of one object are to be merged: they touch without evidence of two. */
  boolean areFused(Component a, Component b) {
    return gap[a.slot][b.slot] >= TOUCH_NAT && evidence[a.slot][b.slot] > -JOIN_NAT;
  }
}
