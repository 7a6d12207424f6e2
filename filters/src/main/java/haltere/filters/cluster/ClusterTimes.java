package haltere.filters.cluster;

/**
 * When what a {@link ClusterTracker} does at regular times is due next, microseconds on the clock
 * of the events. Thread rule: that of its owner.
 */
final class ClusterTimes {
  private static final long NEVER = Long.MAX_VALUE;

  /** Time between two of a kind; 0 for no observations. */
  private long upkeepIntervalUs;

  private long reportIntervalUs;
  private long observationIntervalUs;

  private boolean started;
  private long upkeepUs;
  private long reportUs;
  private long observationUs = NEVER;

  /** Goes over to other intervals, from the last upkeep that has not been on. */
  void apply(long newUpkeepIntervalUs, long newReportIntervalUs) {
    upkeepIntervalUs = newUpkeepIntervalUs;
    reportIntervalUs = newReportIntervalUs;
    if (started) {
      long nowUs = upkeepUs - 1;
      upkeepUs = nextMultiple(nowUs, upkeepIntervalUs);
      reportUs = nextMultiple(nowUs, reportIntervalUs);
    }
  }

  /** Goes over to another interval of observations; 0 for none. */
  void observe(long newObservationIntervalUs) {
    observationIntervalUs = newObservationIntervalUs;
    observationUs = started ? observationAfter(upkeepUs - upkeepIntervalUs) : NEVER;
  }

  /** The next event will be the first. */
  void reset() {
    started = false;
  }

  /** At the first event, nothing before it is due. */
  void startAt(long timeUs) {
    if (!started) {
      started = true;
      skipTo(timeUs);
    }
  }

  /** Leaves out what is due until a time. */
  void skipTo(long timeUs) {
    upkeepUs = nextMultiple(timeUs, upkeepIntervalUs);
    reportUs = nextMultiple(timeUs, reportIntervalUs);
    observationUs = observationAfter(timeUs);
  }

  private long observationAfter(long timeUs) {
    return observationIntervalUs == 0 ? NEVER : nextMultiple(timeUs, observationIntervalUs);
  }

  private static long nextMultiple(long timeUs, long intervalUs) {
    return (Math.floorDiv(timeUs, intervalUs) + 1) * intervalUs;
  }

  /** When something is due next. */
  long nextUs() {
    return Math.min(Math.min(upkeepUs, reportUs), observationUs);
  }

  /** Of what is due at one time, upkeep is first. */
  boolean isUpkeepNext() {
    return upkeepUs == nextUs();
  }

  /** Of what is due at one time, a report is last. */
  boolean isObservationNext() {
    return !isUpkeepNext() && observationUs == nextUs();
  }

  /** The upkeep that is next is being done; its time. */
  long takeUpkeep() {
    long timeUs = upkeepUs;
    upkeepUs += upkeepIntervalUs;
    return timeUs;
  }

  long takeObservation() {
    long timeUs = observationUs;
    observationUs += observationIntervalUs;
    return timeUs;
  }

  long takeReport() {
    long timeUs = reportUs;
    reportUs += reportIntervalUs;
    return timeUs;
  }
}
