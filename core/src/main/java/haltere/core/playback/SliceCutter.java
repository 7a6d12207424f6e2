package haltere.core.playback;

/**
 * Divides the elapsed timeline into slices: start of the next one, end and progress of the open
 * one. Independent of source and sinks.
 *
 * <p>Positions are on the elapsed timeline, in microseconds. Thread rule: the processing thread
 * only.
 */
final class SliceCutter {
  /** A position that is never reached. */
  static final long NO_POSITION = Long.MAX_VALUE;

  private final PlaybackClock clock;
  private final boolean hasEvents;
  private Slicing slicing;
  private Loop loop;

  // Start of the next slice, unless the next event decides it.
  private long position;
  private boolean positionKnown = true;
  private long outPoint = NO_POSITION;
  private long keepGridTo = NO_POSITION;
  private boolean repeats;
  private long repeatToUs;
  private long repeatEvents;
  private long slicesSinceMove;

  // The open slice, and whether its first piece is due or was passed on.
  private boolean open;
  private boolean begun;
  private long fromUs;
  private long toUs;
  private long offsetUs;
  private long events;
  private long countLeft;
  private long lastFed;

  /**
   * Starts at position 0; of the clock only the speed is used. Without events, slices by count are
   * the default ones.
   */
  SliceCutter(PlaybackClock clock, Slicing slicing, Loop loop, boolean hasEvents) {
    this.clock = clock;
    this.hasEvents = hasEvents;
    setSlicing(slicing);
    setLoop(loop);
  }

  // ---- How to cut

  /** Changes the slicing, also of an open slice that has not begun. */
  void setSlicing(Slicing newSlicing) {
    boolean isCountable = hasEvents || !(newSlicing instanceof Slicing.ByCount);
    slicing = isCountable ? newSlicing : PlayerOptions.defaults().slicing();
    keepGridTo = NO_POSITION;
    reopen();
  }

  /**
   * Changes the loop. An out point before the present position is ignored; at an out point just
   * behind the displayed slice, playback continues at the in point.
   */
  void setLoop(Loop newLoop) {
    loop = newLoop;
    outPoint = position <= outOfLoop() ? outOfLoop() : NO_POSITION;
  }

  private long outOfLoop() {
    return loop.on() ? loop.outUs().orElse(NO_POSITION) : NO_POSITION;
  }

  /** Cuts an open slice that has not begun again. */
  void reopen() {
    if (open && !begun) {
      open = false;
    }
  }

  /** Number of events in a slice, or 0 where slices are of time. */
  int countPerSlice() {
    return slicing instanceof Slicing.ByCount byCount ? byCount.events() : 0;
  }

  boolean byCount() {
    return slicing instanceof Slicing.ByCount;
  }

  /** Length of a slice of time, microseconds. */
  long lengthUs() {
    if (slicing instanceof Slicing.ByTime byTime) {
      return byTime.sliceUs();
    }
    if (slicing instanceof Slicing.PerFrame perFrame) {
      double speed = clock.unlimited() ? 1 : clock.speed();
      return Math.max(1, Math.round(speed * 1e6 / perFrame.framesPerSecond()));
    }
    return 1;
  }

  /** Start of the loop, 0 without a loop. */
  long inPoint() {
    return loop.on() ? loop.inUs().orElse(0) : 0;
  }

  /**
   * Whether playback starts again at the end: not if no slice lies between in and out, nor if there
   * is a single moment to repeat.
   */
  boolean loops() {
    return loop.on() && slicesSinceMove > 0 && position > inPoint() + 1;
  }

  // ---- Where

  /** The next slice starts here. */
  void moveTo(long positionUs) {
    position = positionUs;
    positionKnown = true;
    keepGridTo = NO_POSITION;
    repeats = false;
    slicesSinceMove = 0;
    outPoint = position < outOfLoop() ? outOfLoop() : NO_POSITION;
  }

  /** The next slice is one that was shown before, independent of the present slicing. */
  void repeat(long from, long to, long count) {
    moveTo(from);
    repeats = true;
    repeatToUs = to;
    repeatEvents = count;
  }

  /** The next event decides where the next slice starts. */
  void losePosition() {
    positionKnown = false;
  }

  /** Start of the next slice, as far as known. */
  long position() {
    return position;
  }

  /** Start of the open slice, or of the next one. */
  long nextUs() {
    return open ? fromUs : position;
  }

  /**
   * Whether a sample at a position waits for its slice, as those between the first and the last
   * event do if the start of the next slice is known.
   */
  boolean waitsForSlice(long positionUs, long durationUs) {
    return !byCount() && positionKnown && positionUs >= position && positionUs < durationUs;
  }

  // ---- The open slice

  boolean isOpen() {
    return open;
  }

  /** Whether the open slice is due or was passed on in part. */
  boolean hasBegun() {
    return open && begun;
  }

  /**
   * Opens the next slice; false at the out point of the loop.
   *
   * @param next position of the next event or sample
   * @param offset its elapsed time minus its time
   */
  boolean openBefore(long next, long offset) {
    if (repeats) {
      repeats = false;
      begin(offset, repeatToUs, byCount() ? repeatEvents : Long.MAX_VALUE);
      return true;
    }
    if (!positionKnown) {
      keepGridTo = NO_POSITION;
    }
    if (!positionKnown || next < position || byCount() && next < outPoint) {
      // A slice by count starts at its first event. By time, an event can precede the start: it has
      // the time at which the last slice was cut short.
      position = next;
    }
    positionKnown = true;
    if (position >= outPoint) {
      return false;
    }
    if (byCount()) {
      begin(offset, outPoint, countPerSlice());
    } else {
      long gridTo = keepGridTo > position ? keepGridTo : NO_POSITION;
      long length = Math.min(lengthUs(), NO_POSITION - position);
      begin(offset, Math.min(Math.min(position + length, gridTo), outPoint), Long.MAX_VALUE);
    }
    return true;
  }

  private void begin(long offset, long to, long count) {
    fromUs = position;
    offsetUs = offset;
    toUs = to;
    countLeft = count;
    keepGridTo = NO_POSITION;
    events = 0;
    lastFed = fromUs - 1;
    open = true;
    begun = false;
  }

  void begin() {
    begun = true;
  }

  long fromUs() {
    return fromUs;
  }

  /** Latest end of the open slice. */
  long toUs() {
    return toUs;
  }

  /** Elapsed time minus time in the open slice. */
  long offsetUs() {
    return offsetUs;
  }

  /** Number of events of the open slice that were passed on. */
  long events() {
    return events;
  }

  /** Maximum number of events that may still be added to the open slice. */
  long countLeft() {
    return countLeft;
  }

  /** Counts events that are passed on; the time of the last is on the source's clock. */
  void handOver(int count, long lastTimeUs) {
    lastFed = lastTimeUs + offsetUs;
    events += count;
    countLeft -= count;
  }

  /** Notes a sample that is passed on: without events, samples are what a slice ends after. */
  void handOverSample(long elapsedUs) {
    if (!hasEvents) {
      lastFed = elapsedUs;
    }
  }

  /** Position just after the last event that was passed on, or the last sample without events. */
  long afterLast() {
    return lastFed + 1;
  }

  /** Ends the open slice; false if it has no length and does not count. */
  boolean end(long to) {
    open = false;
    position = to;
    if (to <= fromUs) {
      return false;
    }
    slicesSinceMove++;
    return true;
  }

  /** Drops the open slice. */
  void drop() {
    open = false;
  }

  /** Planned end of the open slice, for {@link #keepGridTo} if it is cut short. */
  long gridTo() {
    return hasBegun() ? toUs : NO_POSITION;
  }

  /** Ends the next slice at the planned end of the one that was cut short, to keep the grid. */
  void keepGridTo(long positionUs) {
    keepGridTo = positionUs;
  }
}
