package haltere.filters.wing;

/** A result of a {@link haltere.filters.wing.tracker.WingTracker WingTracker}. */
public sealed interface WingResult
    permits FlyGeometry,
        WingAverage,
        WingBeat,
        ManualWingChange,
        WingDifference,
        WingEstimate,
        WingMeasurement,
        WingPair,
        WingSnapshot,
        WingTrackerState,
        WingVariances {}
