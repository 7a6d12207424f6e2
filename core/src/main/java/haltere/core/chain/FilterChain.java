package haltere.core.chain;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.event.SensorSample;
import haltere.core.overlay.OverlayLayer;
import haltere.core.settings.SettingsSchema;
import haltere.core.stream.Reset;
import haltere.core.stream.SharedWork;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * A sequence of filters: each packet passes the enabled ones in order, and each notification goes
 * to all. A chain is itself a filter, so chains nest.
 *
 * <p>Events whose pixel is not on the sensor, or whose time is more than {@value #MAX_TIME_US} us
 * (73,000 years) from 0, are dropped before the first filter and counted. A filter may rely on
 * their absence, so sums and differences of its times do not overflow.
 *
 * <p>Thread rule: all changes and all processing on one thread; {@link #stages()} and the numbers
 * in it may be read from any thread.
 *
 * @since 0.1
 */
public final class FilterChain implements EventFilter, StreamHandler, AutoCloseable {
  private static final long MAX_TIME_US = 1L << 61;

  private final SensorGeometry geometry;
  private final CopyOnWriteArrayList<ChainStage> stages = new CopyOnWriteArrayList<>();
  private volatile long outsideSensor;
  private volatile long atImpossibleTimes;
  private volatile Thread busy;
  private volatile boolean closed;
  private SharedWork work = SharedWork.ALONE;

  /** The chain that this one is nested in, or null. */
  private FilterChain outer;

  private long changes;
  private boolean runUp;

  /**
   * An empty chain.
   *
   * @param geometry the sensor whose events it will see
   */
  public FilterChain(SensorGeometry geometry) {
    this.geometry = Objects.requireNonNull(geometry, "geometry");
  }

  /**
   * The sensor of the chain.
   *
   * @return its geometry
   */
  public SensorGeometry geometry() {
    return geometry;
  }

  /**
   * The stages in order.
   *
   * @return an unmodifiable live view that any thread may read
   */
  public List<ChainStage> stages() {
    return Collections.unmodifiableList(stages);
  }

  /**
   * The stages in order, with those of a nested chain in place of the chain.
   *
   * @return a snapshot that any thread may take
   */
  public List<ChainStage> innermostStages() {
    return stages.stream()
        .flatMap(
            stage ->
                stage.filter() instanceof FilterChain nested
                    ? nested.innermostStages().stream()
                    : Stream.of(stage))
        .toList();
  }

  /**
   * Events dropped before the first filter because their pixel is not on the sensor.
   *
   * @return a count since the chain was created
   */
  public long outsideSensor() {
    return outsideSensor;
  }

  /**
   * Events dropped before the first filter because their time is impossible, more than 73,000 years
   * from 0, although their pixel is on the sensor.
   *
   * @return a count since the chain was created
   * @since 0.1
   */
  public long atImpossibleTimes() {
    return atImpossibleTimes;
  }

  /**
   * Adds a filter with default settings at the end.
   *
   * @param provider creates the filter
   * @return the new stage
   */
  public ChainStage add(FilterProvider<?> provider) {
    EventFilter filter = Filters.create(provider, () -> provider.create(geometry));
    return add(provider.name(), filter, true, stages.size());
  }

  /**
   * Adds a filter at the end.
   *
   * @param kind the provider's name, or a name for a filter that has none
   * @param filter the filter, which the chain owns from now on
   * @return the new stage
   */
  public ChainStage add(String kind, EventFilter filter) {
    return add(kind, filter, true, stages.size());
  }

  /**
   * Adds a filter.
   *
   * @param kind the provider's name, or a name for a filter that has none
   * @param filter the filter, which the chain owns from now on
   * @param enabled whether it is enabled
   * @param position 0 for the first position
   * @return the new stage
   * @throws ChainProblem if the filter is in this chain already, or is a chain for another sensor
   */
  public ChainStage add(String kind, EventFilter filter, boolean enabled, int position) {
    if (filter instanceof FilterChain nested && !nested.sameSize(geometry)) {
      throw new ChainProblem(
          "a chain for " + nested.geometry + " pixels does not fit into one for " + geometry);
    }
    requireUsable();
    if (contains(filter) || filter instanceof FilterChain nested && nested.contains(this)) {
      throw new ChainProblem(
          "the filter of " + kind + " is in this chain already; create another one");
    }
    ChainStage stage = new ChainStage(freeName(kind, this), kind, filter, enabled);
    if (filter instanceof FilterChain nested) {
      rename(nested);
      nested.outer = this;
    }
    filter.share(work);
    stages.add(position, stage);
    changes++;
    return stage;
  }

  private boolean sameSize(SensorGeometry other) {
    return other.width() == geometry.width() && other.height() == geometry.height();
  }

  /** Gives other names to stages of a chain that have the names of stages of this chain. */
  private void rename(FilterChain nested) {
    for (ChainStage stage : nested.innermostStages()) {
      if (outermost().has(stage.name())) {
        stage.rename(freeName(stage.kind(), nested));
      }
    }
  }

  private FilterChain outermost() {
    return outer == null ? this : outer.outermost();
  }

  /** A name that no stage of the outermost chain and of another one has. */
  private String freeName(String kind, FilterChain other) {
    String name = kind;
    for (int number = 2; outermost().has(name) || other.has(name); number++) {
      name = kind + "-" + number;
    }
    return name;
  }

  private boolean has(String name) {
    return hasStage(stage -> stage.name().equals(name));
  }

  private ChainStage find(String name) {
    for (ChainStage stage : stages) {
      if (stage.name().equals(name)) {
        return stage;
      }
    }
    return null;
  }

  /**
   * The stage of a name.
   *
   * @param name as {@link ChainStage#name()}
   * @return the stage
   * @throws ChainProblem if there is none
   */
  public ChainStage stage(String name) {
    ChainStage stage = find(name);
    if (stage == null) {
      throw new ChainProblem("the chain has no stage named " + name + ", it has " + stages);
    }
    return stage;
  }

  /**
   * Removes a stage and closes its filter.
   *
   * @param stage a stage of this chain
   */
  public void remove(ChainStage stage) {
    require(stage);
    changes = changes() + 1;
    stages.remove(stage);
    if (stage.filter() instanceof FilterChain nested) {
      nested.outer = null;
    }
    stage.filter().close();
  }

  /**
   * Moves a stage to another position. It and the filters from the first of the two positions on
   * receive another stream from now on, so they are reset.
   *
   * @param stage a stage of this chain
   * @param position its new position, 0 for the first
   */
  public void move(ChainStage stage, int position) {
    require(stage);
    List<ChainStage> order = new ArrayList<>(stages);
    int from = order.indexOf(stage);
    order.remove(stage);
    order.add(position, stage);
    changes++;
    // In one step, so that another thread never sees a chain with a stage missing.
    stages.sort(Comparator.comparingInt(order::indexOf));
    for (int i = Math.min(from, position); i < order.size(); i++) {
      order.get(i).notified(new Reset(Reset.Cause.USER));
    }
  }

  /**
   * Enables or disables a stage. A stage that is enabled again receives a reset before its next
   * packet.
   *
   * @param stage a stage of this chain or of a chain nested in it
   * @param enabled whether packets go through it
   */
  public void setEnabled(ChainStage stage, boolean enabled) {
    requireUsable();
    if (!hasStage(own -> own == stage)) {
      require(stage);
    }
    stage.setEnabled(enabled);
    changes++;
  }

  /**
   * Number of changes: filters added, removed, moved, enabled, disabled or with new settings, in
   * nested chains too.
   *
   * @return a count that never decreases
   */
  public long changes() {
    long all = changes;
    for (ChainStage stage : stages) {
      all += stage.filter() instanceof FilterChain nested ? nested.changes() : 0;
    }
    return all;
  }

  /** {@inheritDoc} Filters of a chain settle in parallel, so it is the longest memory of all. */
  @Override
  public long memoryUs() {
    long longest = 0;
    for (ChainStage stage : stages) {
      longest = stage.isEnabled() ? Math.max(longest, stage.filter().memoryUs()) : longest;
    }
    return longest;
  }

  /**
   * Begins or ends a run-up: its events only restore the state of the filters, and outlets publish
   * only to subscribers of {@link Outlet#follow}.
   *
   * @param on whether a run-up comes next
   */
  public void setRunUp(boolean on) {
    runUp = on;
    outlets().forEach(outlet -> outlet.setRunUp(on));
  }

  /**
   * Whether a run-up is under way. On the processing thread.
   *
   * @return true from its begin to its end
   */
  public boolean isRunUp() {
    return runUp;
  }

  private boolean contains(EventFilter filter) {
    return filter == this || hasStage(stage -> stage.filter() == filter);
  }

  /** Whether a stage of this chain or of a chain nested in it fulfils a condition. */
  private boolean hasStage(Predicate<ChainStage> condition) {
    return stages.stream()
        .anyMatch(
            own ->
                condition.test(own)
                    || own.filter() instanceof FilterChain nested && nested.hasStage(condition));
  }

  /** Fails if the chain is closed or another thread uses it. */
  private void requireUsable() {
    if (closed) {
      throw new ChainProblem("the chain is closed; create another one");
    }
    Thread other = busy;
    if (other != null && other != Thread.currentThread()) {
      throw new ChainProblem(
          "the chain is at work on the thread "
              + other.getName()
              + " and cannot be used from "
              + Thread.currentThread().getName()
              + "; queue changes with ChainRunner.edit or Player.edit");
    }
  }

  private void require(ChainStage stage) {
    requireUsable();
    if (!stages.contains(stage)) {
      throw new ChainProblem("stage " + stage.name() + " is not in this chain");
    }
  }

  /**
   * Changes one setting of a filter.
   *
   * @param stage name of a stage of this chain
   * @param setting name of a setting, such as {@code output.rateHz}
   * @param value its value, a number, a truth value, a text or an enum constant
   * @throws ChainProblem if there is no such stage, or it takes no settings
   * @throws haltere.core.settings.SettingsProblem if there is no such setting, or the value is
   *     outside of its range
   */
  public void set(String stage, String setting, Object value) {
    ChainStage found = stage(stage);
    if (!(found.filter() instanceof ConfigurableFilter<?> configurable)) {
      throw new ChainProblem("stage " + stage + " takes no settings");
    }
    apply(found, with(configurable.settings(), setting + "=" + value));
  }

  @SuppressWarnings("unchecked")
  private static <S extends Record> S with(S settings, String assignment) {
    return SettingsSchema.of((Class<S>) settings.getClass())
        .withAssignments(settings, List.of(assignment));
  }

  /**
   * Applies new settings to a filter.
   *
   * @param stage a stage of this chain
   * @param settings a record of the type that the filter takes
   * @throws ChainProblem if the filter takes no such record
   */
  public void apply(ChainStage stage, Record settings) {
    require(stage);
    if (!(stage.filter() instanceof ConfigurableFilter<?> configurable)
        || configurable.settings().getClass() != settings.getClass()) {
      throw new ChainProblem(
          "stage " + stage.name() + " does not take " + settings.getClass().getSimpleName());
    }
    applyUnchecked(configurable, settings);
    changes++;
  }

  @SuppressWarnings("unchecked")
  private static <S extends Record> void applyUnchecked(
      ConfigurableFilter<S> filter, Record settings) {
    filter.apply((S) settings);
  }

  @Override
  public void process(EventPacket packet) {
    Thread before = enter();
    try {
      dropOutside(packet);
      for (ChainStage stage : stages) {
        if (stage.isEnabled()) {
          stage.process(packet);
        }
      }
    } finally {
      busy = before;
    }
  }

  /** Claims the chain for this thread; what is given back ends that. */
  private Thread enter() {
    requireUsable();
    Thread before = busy;
    busy = Thread.currentThread();
    return before;
  }

  private void dropOutside(EventPacket packet) {
    int[] addresses = packet.addresses();
    int size = packet.size();
    int lastX = geometry.width() - 1;
    int lastY = geometry.height() - 1;
    int outside = 0;
    // A difference is negative outside of the sensor. The loop ORs them all, which the compiler
    // vectorises; a search for the largest coordinates takes six times as long.
    for (int i = 0; i < size; i++) {
      int address = addresses[i];
      outside |= lastY - EventAddress.y(address) | lastX - EventAddress.x(address);
    }
    boolean isPossible =
        size == 0 || isPossible(packet.firstTimeUs()) && isPossible(packet.lastTimeUs());
    if (outside >= 0 && isPossible) {
      return;
    }
    int passed = 0;
    int impossible = 0;
    for (int i = 0; i < size; i++) {
      if (!geometry.contains(packet.x(i), packet.y(i))) {
        continue;
      }
      if (isPossible(packet.timeUs(i))) {
        packet.move(i, passed++);
      } else {
        impossible++;
      }
    }
    outsideSensor += size - passed - impossible;
    atImpossibleTimes += impossible;
    packet.truncate(passed);
  }

  private static boolean isPossible(long timeUs) {
    return timeUs >= -MAX_TIME_US && timeUs <= MAX_TIME_US;
  }

  @Override
  public void packet(EventPacket packet) {
    process(packet);
  }

  @Override
  public void notified(StreamNotification notification) {
    if (notification instanceof StreamStarted started && !sameSize(started.geometry())) {
      throw new ChainProblem(
          "the chain was made for a sensor of "
              + geometry
              + " pixels, the source has "
              + started.geometry());
    }
    Thread before = enter();
    try {
      notifyStages(notification);
    } finally {
      busy = before;
    }
  }

  private void notifyStages(StreamNotification notification) {
    FilterFailure first = null;
    for (ChainStage stage : stages) {
      try {
        stage.notified(notification);
      } catch (FilterFailure failure) {
        first = first == null ? failure : first;
      }
    }
    if (first != null) {
      throw first;
    }
  }

  @Override
  public void sample(SensorSample sample) {
    Thread before = enter();
    try {
      for (ChainStage stage : stages) {
        if (stage.isEnabled()) {
          stage.sample(sample);
        }
      }
    } finally {
      busy = before;
    }
  }

  @Override
  public void reset() {
    notified(new Reset(Reset.Cause.USER));
  }

  /**
   * {@inheritDoc} Results do not depend on it, and it is not saved with the chain. The caller
   * closes it, after the chain.
   */
  @Override
  public void share(SharedWork with) {
    requireUsable();
    work = with;
    stages.forEach(stage -> stage.filter().share(with));
  }

  @Override
  public List<Outlet<?>> outlets() {
    List<Outlet<?>> outlets = new ArrayList<>();
    for (ChainStage stage : stages) {
      outlets.addAll(stage.filter().outlets());
    }
    return outlets;
  }

  /** {@inheritDoc} A line for each enabled filter with a status. */
  @Override
  public String status() {
    return stages.stream()
        .filter(ChainStage::isEnabled)
        .map(ChainStage::status)
        .filter(line -> !line.isEmpty())
        .collect(Collectors.joining("\n"));
  }

  /**
   * The outlet where results of a kind are published.
   *
   * @param name the outlet's name
   * @param type class of its results
   * @param <T> type of its results
   * @return the first one in the order of the stages
   * @throws ChainProblem if there is none, listing those that there are
   */
  public <T> Outlet<T> outlet(String name, Class<T> type) {
    List<String> names = new ArrayList<>();
    for (Outlet<?> outlet : outlets()) {
      if (outlet.name().equals(name) && outlet.type() == type) {
        return typed(outlet);
      }
      names.add(outlet.name() + " (" + outlet.type().getSimpleName() + ")");
    }
    throw new ChainProblem(
        "the chain has no outlet named "
            + name
            + " for "
            + type.getSimpleName()
            + (names.isEmpty() ? ", it has none" : "; it has " + String.join(", ", names)));
  }

  @SuppressWarnings("unchecked")
  private static <T> Outlet<T> typed(Outlet<?> outlet) {
    return (Outlet<T>) outlet;
  }

  @Override
  public List<OverlayLayer<?>> overlays() {
    List<OverlayLayer<?>> overlays = new ArrayList<>();
    for (ChainStage stage : stages) {
      if (stage.isEnabled()) {
        overlays.addAll(stage.filter().overlays());
      }
    }
    return overlays;
  }

  /** Closes the filters; the chain accepts nothing more. A second call has no effect. */
  @Override
  public void close() {
    if (closed) {
      return;
    }
    requireUsable();
    closed = true;
    for (ChainStage stage : stages) {
      stage.filter().close();
    }
  }
}
