package haltere.core.playback;

/**
 * Divides the elapsed timeline into slices: start of the next one, end and progress of the open
 * one. Independent of source and sinks.
 *
 * <p>Places are on the elapsed timeline, in microseconds. Thread rule: the processing thread only.
 */
final class SliceCutter {
  /** A place that is never reached. */
  static final long NO_PLACE = Long.MAX_VALUE;

  private final PlaybackClock clock;
  private Slicing slicing;
  private Loop loop;

  // Where the next slice starts, unless only the next event tells.
  private long position;
  private boolean positionKnown = true;
  private long outPoint = NO_PLACE;
  private long keepGridTo = NO_PLACE;
  private boolean repeats;
  private long repeatToUs;
  private long repeatEvents;
  private long slicesSinceMove;

  // The slice that is open, and whether the first piece of it is due or was handed over.
  private boolean open;
  private boolean begun;
  private long fromUs;
  private long toUs;
  private long offsetUs;
  private long events;
  private long countLeft;
  private long lastFed;

  /** Starts at position 0; of the clock only the speed is used. */
  SliceCutter(PlaybackClock clock, Slicing slicing, Loop loop) {
    this.clock = clock;
    this.slicing = slicing;
    setLoop(loop);
  }

  // ---- How to cut

  /** Other slices from here on; one that has not begun is cut anew. */
  void setSlicing(Slicing newSlicing) {
    slicing = newSlicing;
    keepGridTo = NO_PLACE;
    reopen();
  }

  /** Another loop from here on. An out point that lies before the place that is played is none. */
  void setLoop(Loop newLoop) {
    loop = newLoop;
    long out = loop.on() ? loop.outUs().orElse(NO_PLACE) : NO_PLACE;
    outPoint = position < out ? out : NO_PLACE;
  }

  /** A slice that has not begun is cut anew. */
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

  /** Where the loop starts again, 0 without a loop. */
  long inPoint() {
    return loop.on() ? loop.inUs().orElse(0) : 0;
  }

  /** Whether playback is to start again at the end: not if nothing lies between in and out. */
  boolean loops() {
    return loop.on() && slicesSinceMove > 0;
  }

  // ---- Where

  /** The next slice starts here. */
  void moveTo(long place) {
    position = place;
    positionKnown = true;
    keepGridTo = NO_PLACE;
    repeats = false;
    slicesSinceMove = 0;
    setLoop(loop);
  }

  /** The next slice is one that has been shown, however slices are cut now. */
  void repeat(long from, long to, long count) {
    moveTo(from);
    repeats = true;
    repeatToUs = to;
    repeatEvents = count;
  }

  /** Only the next event tells where the next slice starts. */
  void losePlace() {
    positionKnown = false;
  }

  /** Where the next slice starts as far as is known. */
  long position() {
    return position;
  }

  /** Where the slice starts that is open or else comes next. */
  long nextUs() {
    return open ? fromUs : position;
  }

  /**
   * Whether what is ahead waits for its slice: what lies between the first and the last event does,
   * unless nobody knows where the next slice starts.
   */
  boolean waitsForSlice(long place, long durationUs) {
    return !byCount() && positionKnown && place >= position && place < durationUs;
  }

  // ---- The open slice

  boolean isOpen() {
    return open;
  }

  /** Whether the open slice is due or was handed over in part. */
  boolean hasBegun() {
    return open && begun;
  }

  /**
   * Opens the next slice; false at the out point of the loop.
   *
   * @param next where the next event or sample lies
   * @param offset elapsed time less time of that
   */
  boolean openBefore(long next, long offset) {
    if (repeats) {
      repeats = false;
      begin(offset, repeatToUs, byCount() ? repeatEvents : Long.MAX_VALUE);
      return true;
    }
    if (!positionKnown) {
      keepGridTo = NO_PLACE;
    }
    if (!positionKnown || next < position || byCount() && next < outPoint) {
      // By count a slice starts at its first event. By time an event can lie before the start if it
      // is of the very microsecond after which the last slice was cut short.
      position = next;
    }
    positionKnown = true;
    if (position >= outPoint) {
      return false;
    }
    if (byCount()) {
      begin(offset, outPoint, countPerSlice());
    } else {
      long gridTo = keepGridTo > position ? keepGridTo : NO_PLACE;
      long length = Math.min(lengthUs(), NO_PLACE - position);
      begin(offset, Math.min(Math.min(position + length, gridTo), outPoint), Long.MAX_VALUE);
    }
    return true;
  }

  private void begin(long offset, long to, long count) {
    fromUs = position;
    offsetUs = offset;
    toUs = to;
    countLeft = count;
    keepGridTo = NO_PLACE;
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

  /** Where the open slice ends at the latest. */
  long toUs() {
    return toUs;
  }

  /** Elapsed time less time in the open slice. */
  long offsetUs() {
    return offsetUs;
  }

  /** Events of the open slice that were handed over. */
  long events() {
    return events;
  }

  /** Most events that the open slice still takes. */
  long countLeft() {
    return countLeft;
  }

  /** Some events are handed over, the last of them at a time of the source's clock. */
  void handOver(int count, long lastTimeUs) {
    lastFed = lastTimeUs + offsetUs;
    events += count;
    countLeft -= count;
  }

  /** Just after the last event that was handed over. */
  long afterLast() {
    return lastFed + 1;
  }

  /** Ends the open slice; false if it was empty of time and so is none. */
  boolean end(long to) {
    open = false;
    position = to;
    if (to <= fromUs) {
      return false;
    }
    slicesSinceMove++;
    return true;
  }

  /** Gives the open slice up. */
  void drop() {
    open = false;
  }

  /** Where the open slice was to end, for {@link #keepGridTo}, if it was cut short. */
  long gridTo() {
    return hasBegun() ? toUs : NO_PLACE;
  }

  /** The next slice ends where the one would have ended that was cut short, so the grid stays. */
  void keepGridTo(long place) {
    keepGridTo = place;
  }
}
