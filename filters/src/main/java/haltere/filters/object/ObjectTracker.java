package haltere.filters.object;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.stream.ReportClock;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.LongConsumer;

/**
 * Tracks moving objects. Events change one grid; every 10 ms of their time the grid is shared among
 * the components and clutter, which updates all states. {@code docs/objects.md} has the model.
 */
final class ObjectTracker {
  /** Length of a tick: at 1000 px/s an edge moves ten pixels, less than a template's cells. */
  static final long TICK_US = 10_000;

  static final double TICK_S = TICK_US * 1e-6;

  /** Components at most, so that the work of a tick is bounded. */
  static final int MAX_COMPONENTS = 400;

  /** Ticks between two comparisons of the components. */
  private static final int COMPARE_TICKS = 2;

  /** Prior of the rate of new objects: that at which one vanishes. */
  private static final double PRIOR_S = 1 / Presence.VANISH_HZ;

  /**
   * Standard deviation of a return, as a share of the size and of the distance since the last
   * event.
   */
  private static final double RETURN_SHARE = 0.25;

  private static final long UNDECIDED_US = Math.round(ObjectTrackerFilter.UNDECIDED_S * 1e6);

  private final SensorGeometry geometry;
  private final Consumer<ObjectTrack> listener;
  private final LongConsumer ticked;
  private final BooleanSupplier isWatched;
  private final ActivityGrid grid;
  private final ClutterMap clutter;
  private final BirthDetector births;
  private final EventAssociation association;
  private final ObjectRelations relations;
  private final ReportClock reports = new ReportClock();
  private final List<Component> components = new ArrayList<>();
  private final List<TrackedObject> objects = new ArrayList<>();

  /** Components by their slots, and those that are not in use. */
  private final List<Component> pool = new ArrayList<>();

  private final ArrayDeque<Component> free = new ArrayDeque<>();
  private ObjectTrackerSettings settings;
  private MotionModel motion = new MotionModel();
  private boolean isStarted;
  private long tickStartUs;
  private int passed;
  private long ticks;
  private int ids;
  private int decided;
  private long startUs;

  /**
   * A tracker in its initial state.
   *
   * @param listener receives each row
   * @param ticked receives the time after the rows of a report
   * @param isWatched whether rows are requested
   */
  ObjectTracker(
      SensorGeometry geometry,
      ObjectTrackerSettings settings,
      Consumer<ObjectTrack> listener,
      LongConsumer ticked,
      BooleanSupplier isWatched) {
    this.geometry = geometry;
    this.listener = listener;
    this.ticked = ticked;
    this.isWatched = isWatched;
    grid = new ActivityGrid(geometry);
    clutter = new ClutterMap(geometry, grid);
    births = new BirthDetector(grid, clutter);
    relations = new ObjectRelations(clutter.alarmNat());
    association = new EventAssociation(grid, clutter, births);
    apply(settings);
    apply(motion);
    reset();
  }

  ObjectTrackerSettings settings() {
    return settings;
  }

  /** Whether an object was confirmed since the start. */
  boolean hasObjects() {
    return isStarted && decided > 0;
  }

  void apply(ObjectTrackerSettings newSettings) {
    settings = newSettings;
    relations.apply(newSettings);
    reports.setRate(newSettings.reportRateHz());
  }

  void apply(MotionModel model) {
    motion = model;
    relations.apply(model);
  }

  /** Removes all objects; assigned identities are not reused. */
  void reset() {
    clutter.reset();
    births.reset();
    grid.next();
    free.clear();
    free.addAll(pool);
    components.clear();
    objects.clear();
    isStarted = false;
    passed = 1;
    ticks = 0;
  }

  /** Restarts identities from the first one. */
  void restartIdentities() {
    ids = 0;
  }

  void track(EventPacket packet) {
    for (int i = 0; i < packet.size(); i++) {
      long timeUs = packet.timeUs(i);
      if (timeUs >= tickStartUs + TICK_US || !isStarted) {
        advance(timeUs);
      }
      int address = packet.address(i);
      grid.add(EventAddress.x(address), EventAddress.y(address), (int) (timeUs - tickStartUs));
    }
  }

  private void advance(long timeUs) {
    if (!isStarted) {
      tickStartUs = Math.floorDiv(timeUs, TICK_US) * TICK_US;
      reports.skipTo(tickStartUs);
      startUs = tickStartUs;
      decided = 0;
      isStarted = true;
      return;
    }
    while (timeUs >= tickStartUs + TICK_US) {
      update(tickStartUs + TICK_US);
      report(tickStartUs + TICK_US);
      if (objects.isEmpty()) {
        // nothing happens until the tick of this event
        passed = (int) Math.min(1_000_000, (timeUs - tickStartUs) / TICK_US);
        tickStartUs = Math.floorDiv(timeUs, TICK_US) * TICK_US;
      } else {
        passed = 1;
        tickStartUs += TICK_US;
      }
    }
  }

  /** Ends the stream: pending identities are decided. */
  void finish() {
    if (isStarted) {
      update(tickStartUs + TICK_US);
      decideIdentities(tickStartUs + TICK_US, true);
    }
  }

  private void update(long nowUs) {
    clutter.begin(passed);
    births.begin(passed);
    association.associate(components);
    clutter.end();
    for (int i = 0; i < components.size(); i++) {
      Component component = components.get(i);
      component.endTick(nowUs, inside(component));
      component.object.events += component.weight;
    }
    for (int[] cells : births.find()) {
      begin(cells, nowUs);
    }
    if (++ticks % RegionFinder.CHECK_TICKS == 0) {
      splitComponents();
    }
    if (ticks % COMPARE_TICKS == 0) {
      relations.compare(components, COMPARE_TICKS * TICK_S);
      splitObjects();
      joinObjects();
      fuseComponents();
    }
    updateLifetimes(nowUs);
    decideIdentities(nowUs, false);
    grid.next();
  }

  /** Share of a component's extent that is within the picture shortly after now. */
  private double inside(Component c) {
    double s = ClutterMap.BIRTH_S;
    return within(c.middleX() + c.vx() * s, c.shape.halfX, geometry.width())
        * within(c.middleY() + c.vy() * s, c.shape.halfY, geometry.height());
  }

  private static double within(double middle, double half, double size) {
    double low = Math.max(0, middle - half);
    double high = Math.min(size - 1, middle + half);
    return Math.max(0, high - low) / (2 * half);
  }

  // births and returns

  private Component newComponent(Component like, long nowUs) {
    Component component = free.poll();
    if (component == null) {
      component = new Component(pool.size());
      pool.add(component);
    }
    component.begin(nowUs, motion);
    relations.begin(component.slot, like);
    return component;
  }

  private boolean isFull() {
    return free.isEmpty() && pool.size() == MAX_COMPONENTS;
  }

  private void begin(int[] cells, long nowUs) {
    if (isFull()) {
      return;
    }
    Component component = newComponent(null, nowUs);
    if (!births.begin(cells, component)) {
      free.push(component);
      return;
    }
    motion.begin(component.state);
    TrackedObject returned = returned(component, nowUs);
    if (returned == null) {
      objects.add(new TrackedObject(component, nowUs));
      components.add(component);
    } else {
      resume(returned, component, nowUs);
    }
  }

  /**
   * The resting or lost object that returns with a component, or null: odds of a normal density
   * about its position, whose width grows with time, speed and size, against a new object anywhere
   * in the picture. The rate of new ones has a Gamma prior of shape 1, as clutter; a returning
   * object moves for the mean duration of a motion at most.
   */
  private TrackedObject returned(Component component, long nowUs) {
    TrackedObject best = null;
    double max = 0;
    double area = geometry.width() * (double) geometry.height();
    double bornHz = (decided + 1) / ((nowUs - startUs) * 1e-6 + PRIOR_S);
    for (TrackedObject object : objects) {
      boolean isMoving = object.isMoving();
      if (isMoving && !object.isDecided()) {
        continue;
      }
      object.measure();
      double quietS =
          isMoving ? 0 : Math.min(1 / Presence.STOP_HZ, (nowUs - object.activeUs) * 1e-6);
      double size = Math.max(object.size(), component.shape.size());
      double speed = motion.coasts() ? 0 : object.speed;
      double sd = RETURN_SHARE * (size + Math.max(size, speed) * quietS);
      double dx =
          ObjectRelations.outside(
              component.middleX() - object.middleX(), component.shape.halfX + object.halfX());
      double dy =
          ObjectRelations.outside(
              component.middleY() - object.middleY(), component.shape.halfY + object.halfY());
      double log =
          -Math.log(bornHz)
              + Math.log(area / (2 * Math.PI * sd * sd + size * size))
              - (dx * dx + dy * dy) / (2 * sd * sd)
              - (motion.coasts() ? object.unlike(component) : 0);
      if (log > max) {
        max = log;
        // near a moving object the component is compared with that one
        best = isMoving ? null : object;
      }
    }
    return best;
  }

  /** Continues an object, moved so that the observed component lies within it. */
  private void resume(TrackedObject object, Component seen, long nowUs) {
    object.shift(
        clamp(seen.middleX() - object.middleX(), object.halfX() - seen.shape.halfX),
        clamp(seen.middleY() - object.middleY(), object.halfY() - seen.shape.halfY));
    Component nearest = null;
    double min = ShapeTemplate.MIN_CELL_PX * 2;
    for (Component component : object.components) {
      double d = component.boxDistance(seen);
      if (d < min) {
        min = d;
        nearest = component;
      }
      if (object.isLost) {
        components.add(component);
      }
    }
    object.isLost = false;
    object.activeUs = nowUs;
    if (nearest == null) {
      object.add(seen);
      components.add(seen);
      return;
    }
    double rate = Math.max(seen.rate, nearest.rate);
    nearest.absorb(seen);
    nearest.rate = rate;
    if (!motion.coasts()) {
      nearest.setVelocity(seen.vx(), seen.vy());
      nearest.state.covariance().setTo(seen.state.covariance());
    }
    nearest.presence.begin();
    free.push(seen);
  }

  /** Displacement of an interval until it contains a position. */
  private static double clamp(double distance, double reach) {
    return Math.signum(distance) * ObjectRelations.outside(distance, Math.max(0, reach));
  }

  // splits and joins

  private void splitComponents() {
    int count = components.size();
    for (int i = 0; i < count && !isFull(); i++) {
      Component component = components.get(i);
      if (component.isMoving() && component.weight > 0) {
        RegionFinder.ShapeRegion region = component.regions.findApart(component.shape);
        if (region != null) {
          split(component, region);
        }
      }
    }
  }

  private void split(Component from, RegionFinder.ShapeRegion region) {
    Component to = newComponent(from, from.activeUs);
    to.state.set(from.state);
    to.shape.clear(from.shape.cellPx);
    from.regions.move(region, from.shape, to.shape);
    double total = ShapeTemplate.sum(to.shape.mass);
    double share = total / (total + ShapeTemplate.sum(from.shape.mass));
    to.rate = from.rate * share;
    to.novelty = from.novelty * share;
    from.rate -= to.rate;
    from.novelty -= to.novelty;
    to.presence.set(from.presence);
    from.refresh();
    to.refresh();
    from.object.add(to);
    components.add(to);
  }

  private void splitObjects() {
    for (int i = objects.size() - 1; i >= 0; i--) {
      TrackedObject object = objects.get(i);
      for (Component c = relations.leaving(object); c != null; c = relations.leaving(object)) {
        object.components.remove(c);
        TrackedObject other = new TrackedObject(c, object.activeUs);
        other.bornUs = object.bornUs;
        objects.add(other);
      }
    }
  }

  private void joinObjects() {
    for (int i = 0; i < objects.size(); i++) {
      TrackedObject a = objects.get(i);
      for (int j = objects.size() - 1; j > i; j--) {
        TrackedObject b = objects.get(j);
        if (relations.areOne(a, b)) {
          boolean isFirst = a.isDecided() && (!b.isDecided() || a.id < b.id) || !b.isDecided();
          TrackedObject survivor = isFirst ? a : b;
          survivor.absorb(isFirst ? b : a);
          objects.remove(j);
          objects.set(i, survivor);
          a = survivor;
        }
      }
    }
  }

  private void fuseComponents() {
    for (int k = 0; k < objects.size(); k++) {
      TrackedObject object = objects.get(k);
      List<Component> parts = object.components;
      for (int i = 0; i < parts.size() && !object.isLost; i++) {
        for (int j = parts.size() - 1; j > i; j--) {
          Component a = parts.get(i);
          Component b = parts.get(j);
          if (relations.areFused(a, b)) {
            boolean isFirst = a.rate * a.age >= b.rate * b.age;
            Component survivor = isFirst ? a : b;
            Component from = isFirst ? b : a;
            survivor.absorb(from);
            parts.set(i, survivor);
            parts.remove(j);
            end(from);
          }
        }
      }
    }
  }

  private void end(Component component) {
    components.remove(component);
    free.push(component);
  }

  // lifetimes

  private void updateLifetimes(long nowUs) {
    for (int i = objects.size() - 1; i >= 0; i--) {
      TrackedObject object = objects.get(i);
      double silentS = (nowUs - object.activeUs) * 1e-6;
      if (object.isMoving() && !object.isLost) {
        object.activeUs = nowUs;
        coastComponents(object, nowUs);
      } else if (!mayRest(object)
          || object.isLost && silentS > settings.coastTimeS()
          || motion.coasts() && object.components.stream().allMatch(c -> inside(c) == 0)) {
        object.components.forEach(this::end);
        objects.remove(i);
      } else if (object.isLost && motion.coasts()) {
        object.components.forEach(Component::predict);
      } else if (!object.isLost && object.existence() < 0.5) {
        object.isLost = true;
        components.removeAll(object.components);
      }
    }
  }

  private void decideIdentities(long nowUs, boolean isLast) {
    for (int i = 0; i < objects.size(); i++) {
      TrackedObject object = objects.get(i);
      if (object.isDecided()) {
        continue;
      }
      boolean isApart = isApart(object, Double.POSITIVE_INFINITY);
      if (!isApart) {
        object.apartUs = nowUs;
      }
      // a single error is in all displacements over a window and must not be decisive
      int window = object.apartUs > object.bornUs ? object.components.get(0).window : 0;
      double watchS = Math.max(settings.confirmS(), window * TICK_S);
      boolean isObserved =
          isLast ? isApart : object.isMoving() && (nowUs - object.apartUs) * 1e-6 >= watchS;
      if (isObserved && isEvident(object)) {
        decide(object);
      }
    }
  }

  /** Moves components without events with the others, and ends them after a while. */
  private void coastComponents(TrackedObject object, long nowUs) {
    double vx = object.vx();
    double vy = object.vy();
    object.speed = Math.hypot(vx, vy);
    for (int i = object.components.size() - 1; i >= 0; i--) {
      Component component = object.components.get(i);
      if (component.isMoving()) {
        continue;
      }
      component.setVelocity(vx, vy);
      if ((nowUs - component.activeUs) * 1e-6 > ShapeTemplate.MEMORY_S
          || component.presence.gone() > 0.5) {
        object.components.remove(i);
        end(component);
      }
    }
  }

  /** Whether a silent object is kept: it is decided, or evident and never part of another. */
  private boolean mayRest(TrackedObject object) {
    return object.isDecided()
        || isEvident(object)
            && object.existence() >= 0.5
            && object.apartUs == object.bornUs
            && isApart(object, clutter.alarmNat());
  }

  private boolean isEvident(TrackedObject object) {
    return object.novelty() >= clutter.alarmNat();
  }

  /** Whether it is separate from all decided objects, and from others of at least a novelty. */
  private boolean isApart(TrackedObject object, double leastNovelty) {
    for (int i = 0; i < objects.size(); i++) {
      TrackedObject other = objects.get(i);
      boolean counts = other.isDecided() || other.novelty() >= leastNovelty;
      if (other != object && counts && !other.isLost && !relations.areApart(object, other)) {
        return false;
      }
    }
    return true;
  }

  /** Decides the identity of an object, and publishes all its rows since its start. */
  private void decide(TrackedObject object) {
    object.id = ++ids;
    decided++;
    for (ObjectTrack row : object.undecided) {
      listener.accept(row.withId(object.id));
    }
    object.undecided.clear();
  }

  private void report(long nowUs) {
    if (reports.nextUs() < nowUs) {
      reports.skipTo(nowUs);
    }
    double deform = motion.deformationShare();
    for (; reports.nextUs() < nowUs + TICK_US; reports.advance()) {
      long timeUs = reports.nextUs();
      for (int i = 0; i < objects.size(); i++) {
        TrackedObject object = objects.get(i);
        if (object.isLost || !isWatched.getAsBoolean()) {
          continue;
        }
        ObjectTrack row = object.row(nowUs, timeUs, geometry.width(), geometry.height(), deform);
        if (object.isDecided()) {
          listener.accept(row);
        } else {
          object.undecided.add(row);
          while (object.undecided.peekFirst().timeUs() < timeUs - UNDECIDED_US) {
            object.undecided.removeFirst();
          }
        }
      }
      ticked.accept(timeUs);
    }
  }
}
