package haltere.filters.wing;

/** What a {@link haltere.filters.wing.tracker.WingTracker WingTracker} tells, as it comes. */
public sealed interface WingResult
    permits FlyGeometry,
        WingAverage,
        WingBeat,
        WingByHand,
        WingDifference,
        WingEstimate,
        WingMeasurement,
        WingPair,
        WingSnapshot,
        WingTrackerState,
        WingVariances {}
