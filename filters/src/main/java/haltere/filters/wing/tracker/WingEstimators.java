package haltere.filters.wing.tracker;

import haltere.filters.wing.WingFilterEdit;
import haltere.filters.wing.WingFilterSettings;
import haltere.filters.wing.WingFilterState;
import haltere.filters.wing.WingListener;
import haltere.filters.wing.WingMethod;
import haltere.filters.wing.WingModel;
import haltere.filters.wing.WingOutputSettings;
import haltere.filters.wing.WingPart;
import haltere.filters.wing.WingSide;
import haltere.filters.wing.WingTrackerSettings;
import haltere.filters.wing.stroke.BeatListener;
import haltere.filters.wing.stroke.EdgesEstimator;
import haltere.filters.wing.stroke.RunningAverage;
import haltere.filters.wing.stroke.SideEstimator;
import haltere.filters.wing.stroke.StrokeFrame;
import haltere.filters.wing.stroke.StrokeSeed;
import haltere.filters.wing.stroke.WingEstimator;
import java.util.ArrayList;
import java.util.List;

/**
 * What estimates the strokes of both wings, as the settings want it: an estimator and a running
 * average for each wing, whether the wing is tracked, and which of its edges are taken.
 *
 * <p>Thread rule: one thread at a time.
 */
final class WingEstimators {
  private static final WingSide[] SIDES = WingSide.values();
  private static final int BOTH = 3;

  final SideEstimator[] main = new SideEstimator[2];
  final RunningAverage[] beside = new RunningAverage[2];
  final boolean[] tracked = new boolean[2];

  /** Edges of wings that are tracked, of which events are taken. */
  final boolean[] takesNow = new boolean[4];

  final FlyReport report;
  private final boolean[] takes = new boolean[4];
  private final StrokeFrame[] frames;
  private WingTrackerSettings settings;

  /** Wings of which the running average has ended a beat since {@link #beatOfBoth()}, as bits. */
  private int beatsEnded;

  WingEstimators(StrokeFrame[] frames, WingTrackerSettings settings, WingListener listener) {
    this.frames = frames;
    this.settings = settings;
    report = new FlyReport(listener, main, beside, tracked, takes);
  }

  /** Makes the estimators anew. */
  void build() {
    for (int side = 0; side < 2; side++) {
      build(side);
    }
    takeEdges();
  }

  private void build(int side) {
    WingFilterSettings filter = settings.filter();
    boolean tells = filter.method() == WingMethod.WRA;
    BeatListener beats =
        (s, endUs, periodUs, least, most) -> {
          beatsEnded |= 1 << side;
          if (tells) {
            report.beat(s, endUs, periodUs, least, most);
          }
        };
    beside[side] = new RunningAverage(SIDES[side], frames[side], settings.average(), beats);
    main[side] =
        filter.method() == WingMethod.WRA
            ? beside[side]
            : filter.model() != WingModel.WINGS
                ? new EdgesEstimator(SIDES[side], frames[side], settings, report::beat)
                : new WingEstimator(SIDES[side], frames[side], settings, report::beat);
  }

  private void takeEdges() {
    WingOutputSettings output = settings.output();
    takes[0] = output.leftLeading();
    takes[1] = output.leftTrailing();
    takes[2] = output.rightLeading();
    takes[3] = output.rightTrailing();
    for (int edge = 0; edge < 4; edge++) {
      takesNow[edge] = takes[edge] && tracked[edge / 2];
    }
  }

  boolean isTracked() {
    return tracked[0] || tracked[1];
  }

  /** Wings that are tracked. */
  int count() {
    return (tracked[0] ? 1 : 0) + (tracked[1] ? 1 : 0);
  }

  void forget() {
    tracked[0] = false;
    tracked[1] = false;
    takeEdges();
  }

  double meanNis() {
    return !isTracked()
        ? Double.NaN
        : tracked[0] && tracked[1]
            ? (main[0].nis() + main[1].nis()) / 2
            : main[tracked[0] ? 0 : 1].nis();
  }

  double frequencyHz() {
    return !isTracked()
        ? Double.NaN
        : tracked[0] && tracked[1]
            ? (main[0].frequencyHz() + main[1].frequencyHz()) / 2
            : main[tracked[0] ? 0 : 1].frequencyHz();
  }

  /** Frequency of a wing's estimator, hertz; NaN while the wing is not tracked. */
  double frequencyHz(int side) {
    return tracked[side] ? main[side].frequencyHz() : Double.NaN;
  }

  /** Whether both wings have ended a beat since this was last true. */
  boolean beatOfBoth() {
    if (beatsEnded != BOTH) {
      return false;
    }
    beatsEnded = 0;
    return true;
  }

  /** Edges of wings that are tracked are taken, and two of them are driven together. */
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
    if (main[side] instanceof WingEstimator wing) {
      wing.launch(timeUs, seed);
    } else if (main[side] instanceof EdgesEstimator edges) {
      double startHz = settings.search().startFrequencyHz();
      if (startHz > 0) {
        edges.launch(timeUs, StrokeSeed.blind(timeUs, seed.centre(), startHz), false);
      } else {
        edges.launch(timeUs, seed, true);
      }
    }
  }

  void advance(long timeUs) {
    for (int side = 0; side < 2; side++) {
      if (tracked[side]) {
        main[side].advance(timeUs);
        beside[side].advance(timeUs);
      }
    }
  }

  /** The Kalman filters of the wings that are tracked. */
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

  /** Begins a wing anew where it is now, as sure as when it was found, with the settings' noise. */
  void restart(WingPart part) {
    int side = sideOf(part);
    StrokeSeed seed = main[side].seed();
    build(side);
    launch(side, seed.timeUs(), seed);
    trackedChanged();
  }

  private int sideOf(WingPart part) {
    int side = part.side().ordinal();
    if (!tracked[side] || main[side].filters().stream().noneMatch(f -> f.part() == part)) {
      throw new IllegalArgumentException("there is no filter for " + part + " now");
    }
    return side;
  }

  /**
   * Takes new settings over.
   *
   * @return whether they need other estimators; those that are there take them over else
   */
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

  /** The same for estimators that are made anew after it. */
  void applyToNew(WingTrackerSettings changed) {
    settings = changed;
  }

  private static boolean isSameEstimator(WingFilterSettings one, WingFilterSettings other) {
    return one.method() == other.method()
        && one.model() == other.model()
        && one.harmonics() == other.harmonics();
  }

  /** What a new estimator of each wing that is tracked begins with. */
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
