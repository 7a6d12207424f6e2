package haltere.filters.object;

import haltere.filters.estimation.GaussianState;
import haltere.filters.trail.Ellipse;
import java.util.Arrays;

/**
 * A part of an object that moves as one: shape, position and velocity, event rate and presence. An
 * object has one component or several, as a person with swinging limbs.
 *
 * <p>The position is the middle of the template, x and y in pixels. {@link MotionModel} predicts
 * the state (x, vx, y, vy).
 */
final class Component {
  /**
   * Effective number of independent registrations per event, since errors of neighbouring pixels
   * and ticks are correlated.
   */
  private static final double INDEPENDENT = 0.5;

  /** Ticks of the path. */
  private static final int PATH = 128;

  /** Ticks between two updates of a shape with a memory of thirty. */
  private static final int REFRESH_TICKS = 4;

  /** Largest distance of the extent's middle from that of the grid, cells. */
  private static final double RECENTRE_CELLS = 1.5;

  /** One event within the memory, events a tick. */
  private static final double MIN_RATE = ObjectTracker.TICK_S / ShapeTemplate.MEMORY_S;

  final GaussianState state = new GaussianState(4);

  /** Angular velocity, rad/s. */
  final GaussianState turn = new GaussianState(1);

  final ShapeTemplate shape = new ShapeTemplate();
  final Presence presence = new Presence();
  final RegionFinder regions = new RegionFinder();
  final int slot;
  private MotionModel motion;

  /** Its way since its birth along x and y, pixels, and the logarithm of its growth. */
  private final double[] way = new double[3];

  private final double[][] path = new double[way.length][PATH];

  private final double[] row = new double[4];
  TrackedObject object;
  long activeUs;

  /** Ticks since its birth. */
  int age;

  /** Ticks over which displacements are compared. */
  int window;

  /** Expected events of a tick. */
  double rate;

  /**
   * Log ratio of its events under motion and under repetition, at least 0 after each tick: events
   * that repeated their positions may begin to move (cumulative sum: Page, Biometrika 41, 1954).
   */
  double novelty;

  // sums of the tick
  double weight;
  double gradientX;
  double gradientY;
  double gradientTurn;
  final double[] products = new double[Presence.ATTENUATIONS.length];
  final double[] logs = new double[Presence.ATTENUATIONS.length];

  /** Expected events per tick, square pixel and unit of density. */
  double intensity;

  /** Probability of moving in the tick. */
  double active;

  /** A component that is reused, with its index. */
  Component(int slot) {
    this.slot = slot;
  }

  /** Clears everything; the caller sets state, shape and rate. */
  void begin(long nowUs, MotionModel model) {
    motion = model;
    turn.setMean(0, 0);
    turn.setVariances(model.turnRadS() * model.turnRadS());
    presence.begin();
    regions.clear();
    Arrays.fill(way, 0);
    age = 0;
    object = null;
    activeUs = nowUs;
    novelty = 0;
    weight = 0;
    window = 0;
  }

  double x() {
    return state.mean(0);
  }

  double vx() {
    return state.mean(1);
  }

  double y() {
    return state.mean(2);
  }

  double vy() {
    return state.mean(3);
  }

  double middleX() {
    return x() + shape.middleX;
  }

  double middleY() {
    return y() + shape.middleY;
  }

  /** Distance between the boxes of this and another extent, pixels; 0 where they overlap. */
  double boxDistance(Component other) {
    double dx =
        ObjectRelations.outside(middleX() - other.middleX(), shape.halfX + other.shape.halfX);
    double dy =
        ObjectRelations.outside(middleY() - other.middleY(), shape.halfY + other.shape.halfY);
    return Math.sqrt(dx * dx + dy * dy);
  }

  boolean isMoving() {
    return presence.isMoving();
  }

  /** Expected events of a tick, times the probability of moving. */
  double activeRate() {
    return rate * Math.max(presence.moving(), ObjectRelations.ERROR);
  }

  void beginTick() {
    weight = 0;
    gradientX = 0;
    gradientY = 0;
    gradientTurn = 0;
    for (int i = 0; i < logs.length; i++) {
      products[i] = 1;
      logs[i] = 0;
    }
    intensity = rate / (shape.cellPx * shape.cellPx);
    active = presence.movingNext();
  }

  /** Multiplies the likelihood ratios by those of an event: 1 + ratio. */
  void addLikelihood(double ratio) {
    for (int i = 0; i < products.length; i++) {
      double product = products[i] * (1 + ratio * Presence.ATTENUATIONS[i]);
      if (product > 1e200) {
        logs[i] += Math.log(product);
        product = 1;
      }
      products[i] = product;
    }
  }

  /** Takes the sums of a tick that ends at a time. */
  void endTick(long nowUs, double inside) {
    for (int i = 0; i < logs.length; i++) {
      logs[i] += Math.log(products[i]);
    }
    novelty = Math.max(0, novelty);
    presence.update(logs, rate, inside);
    double beforeX = x();
    double beforeY = y();
    predict();
    double moved = ObjectTracker.TICK_S * presence.moving();
    double known = ClutterMap.BIRTH_S + age * ObjectTracker.TICK_S;
    turn.decay(0, 0, ObjectTracker.TICK_S * Presence.STOP_HZ, motion.turnRadS());
    double keep = Math.exp(-moved / Math.min(ShapeTemplate.MEMORY_S, known));
    if (weight > 0.5) {
      register();
      registerTurn(Math.min(ShapeTemplate.MEMORY_S, known / 2));
      shape.decay(keep);
      if (isMoving()) {
        activeUs = nowUs;
      }
    }
    rate = Math.max(MIN_RATE, rate + (1 - keep) * (weight - rate));
    way[0] += x() - beforeX;
    way[1] += y() - beforeY;
    for (int i = 0; i < way.length; i++) {
      path[i][age % PATH] = way[i];
    }
    age++;
    if (age < REFRESH_TICKS * REFRESH_TICKS || (age + slot) % REFRESH_TICKS == 0) {
      refresh();
    }
  }

  /** Recomputes its shape, with the extent in the middle and cells that fit its size. */
  void refresh() {
    shape.refresh();
    double cell = shape.wantedCell();
    double far = Math.max(Math.abs(shape.middleX), Math.abs(shape.middleY));
    if (cell != shape.cellPx || far > RECENTRE_CELLS * shape.cellPx) {
      double dx = shape.middleX;
      double dy = shape.middleY;
      shape.resample(cell, dx, dy);
      shape.refresh();
      state.setMean(0, x() + dx);
      state.setMean(2, y() + dy);
      regions.shift(dx, dy);
    }
  }

  /** Predicts over a tick. */
  void predict() {
    double growth = motion.predict(state, shape.size(), ObjectTracker.TICK_S);
    if (growth != 1) {
      shape.grow(growth);
      rate *= growth * growth;
      way[2] += Math.log(growth);
    }
    if (!isMoving() && !motion.coasts()) {
      // mean and variance of a mixture of its velocity and of rest
      double p = presence.moving();
      state.addNoise(1, p * (1 - p) * vx() * vx());
      state.addNoise(3, p * (1 - p) * vy() * vy());
      setVelocity(p * vx(), p * vy());
    }
  }

  /**
   * Displacement of the events against the template by maximum likelihood: one step of Newton's
   * with Fisher's information (Lehmann and Casella, Theory of Point Estimation, 1998, §6.3), in the
   * two principal directions of the information. An edge has none along itself.
   */
  private void register() {
    Ellipse information = Ellipse.of(shape.infoXx, shape.infoXy, shape.infoYy);
    double cos = Math.cos(information.angleRad());
    double sin = Math.sin(information.angleRad());
    correct(information.majorPx(), cos, sin);
    correct(information.minorPx(), -sin, cos);
  }

  /** Updates with the displacement along a principal direction of the information. */
  private void correct(double root, double cos, double sin) {
    double information = weight * INDEPENDENT * root * root;
    if (information > 0) {
      row[0] = cos;
      row[2] = sin;
      state.project(row);
      state.correct(
          INDEPENDENT * (cos * gradientX + sin * gradientY) / information, 1 / information);
    }
  }

  /** Angle of the events against the template, which does not turn: that since its mean age. */
  private void registerTurn(double meanAgeS) {
    double information = weight * INDEPENDENT * shape.infoTurn;
    if (information > 0) {
      row[0] = meanAgeS;
      turn.project(row);
      double angle = INDEPENDENT * gradientTurn / information;
      turn.correct(angle - meanAgeS * turn.mean(0), 1 / information);
    }
  }

  /** Root mean square of its angular velocity. */
  double turnRadS() {
    return Math.sqrt(turn.mean(0) * turn.mean(0) + turn.covariance(0, 0));
  }

  void setVelocity(double vx, double vy) {
    state.setMean(1, vx);
    state.setMean(3, vy);
  }

  /** Moves it without a registration. */
  void shift(double dx, double dy) {
    state.setMean(0, x() + dx);
    state.setMean(2, y() + dy);
    way[0] += dx;
    way[1] += dy;
  }

  /** Displacement along x (0) or y (1) over the last ticks, at most {@link #knownTicks}, pixels. */
  double displacement(int axis, int ticks) {
    int last = age - 1;
    return last < 1 ? 0 : path[axis][last % PATH] - path[axis][(last - ticks) % PATH];
  }

  /** Growth over the last ticks by its approach, a factor. */
  double growth(int ticks) {
    return Math.exp(displacement(2, ticks));
  }

  /** Ticks over which the displacement is known. */
  int knownTicks() {
    return Math.max(0, Math.min(PATH - 1, age - 1));
  }

  /** Sets the window to the time in which it moved by its size, within two bounds in seconds. */
  void watch(double minS, double maxS) {
    int known = Math.min(knownTicks(), (int) Math.round(maxS / ObjectTracker.TICK_S));
    window = (int) Math.round(minS / ObjectTracker.TICK_S);
    for (; window < known; window++) {
      double dx = displacement(0, window);
      double dy = displacement(1, window);
      if (dx * dx + dy * dy >= shape.size() * shape.size()) {
        return;
      }
    }
  }

  /** Merges another component into this one. */
  void absorb(Component other) {
    double dx = other.x() - x();
    double dy = other.y() - y();
    double need =
        Math.max(
            Math.abs(dx) + other.shape.halfX + Math.abs(other.shape.middleX),
            Math.abs(dy) + other.shape.halfY + Math.abs(other.shape.middleY));
    while (shape.reach() < need) {
      shape.resample(shape.coarser(), 0, 0);
    }
    shape.spread(other.shape.mass, other.shape.cellPx, dx, dy);
    double share = other.rate / (other.rate + rate);
    setVelocity(vx() + share * (other.vx() - vx()), vy() + share * (other.vy() - vy()));
    rate += other.rate;
    novelty += other.novelty;
    if (other.presence.moving() > presence.moving()) {
      presence.set(other.presence);
    }
    activeUs = Math.max(activeUs, other.activeUs);
    refresh();
  }
}
