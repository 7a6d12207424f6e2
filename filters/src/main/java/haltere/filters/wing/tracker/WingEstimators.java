package haltere.filters.wing.tracker;

import haltere.filters.wing.WingFilterEdit;
import haltere.filters.wing.WingFilterSettings;
import haltere.filters.wing.WingFilterState;
import haltere.filters.wing.WingListener;
import haltere.filters.wing.WingMethod;
import haltere.filters.wing.WingPart;
import haltere.filters.wing.WingTrackerSettings;
import haltere.filters.wing.internal.stroke.BeatListener;
import haltere.filters.wing.internal.stroke.EdgesEstimator;
import haltere.filters.wing.internal.stroke.SideEstimator;
import haltere.filters.wing.internal.stroke.StrokeFrame;
import haltere.filters.wing.internal.stroke.StrokeSeed;
import haltere.filters.wing.internal.stroke.WingEstimator;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Estimators of both wings by the settings: an estimator and a running average for each wing,
 * whether the wing is tracked, and which of its edges are used.
 */
final class WingEstimators {

  final SideEstimator[] main = new SideEstimator[2];
  final EdgesEstimator[] beside = new EdgesEstimator[2];
  final boolean[] tracked = new boolean[2];

  /** Used edges of tracked wings. */
  final boolean[] takesNow = new boolean[4];

  /** Whether the estimates are at the frequency of the beat; otherwise no beats are reported. */
  boolean locked = true;

  final FlyReport report;
  private final StrokeFrame[] frames;
  private BodyFollower follower;
  private WingTrackerSettings settings;

  WingEstimators(StrokeFrame[] frames, WingListener listener) {
    this.frames = frames;
    report = new FlyReport(listener, this);
  }

  void build(WingTrackerSettings wanted, BodyFollower body) {
    settings = wanted;
    follower = body;
    build(0);
    build(1);
    takeEdges();
  }

  private void build(int side) {
    boolean isMain = settings.filter().method() == WingMethod.WRA;
    BeatListener beats =
        (s, endUs, periodUs, min, max) -> {
          follower.beat(side);
          if (isMain) {
            report.beat(s, endUs, periodUs, min, max);
          }
        };
    beside[side] = new EdgesEstimator(frames[side], settings, beats, Optional.empty());
    main[side] = isMain ? beside[side] : TrackerParts.filter(frames[side], settings, report::beat);
  }

  private void takeEdges() {
    for (int edge = 0; edge < 4; edge++) {
      takesNow[edge] =
          tracked[edge / 2] && settings.output().uses(WingPart.edge(edge / 2, edge % 2));
    }
  }

  boolean isTracked() {
    return tracked[0] || tracked[1];
  }

  /** Number of tracked wings. */
  int count() {
    return (tracked[0] ? 1 : 0) + (tracked[1] ? 1 : 0);
  }

  void forget() {
    tracked[0] = false;
    tracked[1] = false;
    takeEdges();
  }

  /** Mean NIS of the filters of tracked wings; NaN if there is none. */
  double meanNis() {
    return filters().stream().mapToDouble(WingFilterState::nis).average().orElse(Double.NaN);
  }

  /** Mean frequency of tracked wings, hertz; NaN if there is none. */
  double frequencyHz() {
    return IntStream.range(0, 2)
        .filter(side -> tracked[side])
        .mapToDouble(this::frequencyHz)
        .average()
        .orElse(Double.NaN);
  }

  /** Frequency of a wing, hertz; NaN while it is not tracked. */
  double frequencyHz(int side) {
    return tracked[side] ? main[side].estimate(SideEstimator.WING).frequencyHz() : Double.NaN;
  }

  /** Updates the used edges and couples two tracked wings. */
  void trackedChanged() {
    takeEdges();
    if (main[0] instanceof WingEstimator left && main[1] instanceof WingEstimator right) {
      boolean both = tracked[0] && tracked[1];
      left.besides(both ? right : null);
      right.besides(both ? left : null);
    }
  }

  void launch(int side, long timeUs, StrokeSeed seed) {
    beside[side].launch(timeUs, seed);
    if (main[side] != beside[side]) {
      main[side].launch(timeUs, seed);
    }
  }

  void advance(long timeUs) {
    for (int side = 0; side < 2; side++) {
      if (tracked[side]) {
        main[side].advance(timeUs);
        beside[side].advance(timeUs);
      }
    }
    for (int side = 0; side < 2; side++) {
      if (tracked[side] && main[side] instanceof WingEstimator wing) {
        wing.step();
      }
    }
  }

  /** The Kalman filters of tracked wings. */
  List<WingFilterState> filters() {
    List<WingFilterState> filters = new ArrayList<>();
    for (int side = 0; side < 2; side++) {
      if (tracked[side]) {
        filters.addAll(main[side].filters());
      }
    }
    return filters;
  }

  /** Changes a number of a filter. */
  void edit(WingFilterEdit edit) {
    main[sideOf(edit.part())].edit(edit);
  }

  /** Restarts a wing at its present state with the initial covariance and the set noise. */
  void restart(WingPart part) {
    int side = sideOf(part);
    StrokeSeed seed = main[side].seed();
    build(side);
    launch(side, seed.timeUs(), seed);
    trackedChanged();
  }

  private int sideOf(WingPart part) {
    int side = part.sideNumber();
    if (!tracked[side] || main[side].filters().stream().noneMatch(f -> f.part() == part)) {
      throw new IllegalArgumentException("there is no filter for " + part + " now");
    }
    return side;
  }

  /** Applies new settings to the estimators; returns whether they need other ones instead. */
  boolean apply(WingTrackerSettings changed) {
    boolean others = !isSameEstimator(settings.filter(), changed.filter());
    settings = changed;
    if (!others) {
      for (int side = 0; side < 2; side++) {
        main[side].apply(changed);
        beside[side].apply(changed);
      }
      takeEdges();
    }
    return others;
  }

  private static boolean isSameEstimator(WingFilterSettings one, WingFilterSettings other) {
    return one.method() == other.method()
        && one.model() == other.model()
        && one.harmonics() == other.harmonics();
  }

  /** Initial strokes for new estimators of tracked wings. */
  StrokeSeed[] seeds() {
    StrokeSeed[] seeds = new StrokeSeed[2];
    for (int side = 0; side < 2; side++) {
      seeds[side] = tracked[side] ? main[side].seed() : null;
    }
    return seeds;
  }

  /** Exchanges left and right. */
  void exchange() {
    boolean keep = tracked[0];
    tracked[0] = tracked[1];
    tracked[1] = keep;
  }
}
