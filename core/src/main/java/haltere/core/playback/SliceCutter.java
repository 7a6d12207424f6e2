package haltere.core.playback;

import haltere.core.event.EventPacket;
import haltere.core.pipeline.ChainRunner;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamNotification;

/**
 * Cuts what a cursor gives into slices and hands them on in pieces: knows where the slices lie, and
 * nothing of when they are due.
 *
 * <p>Places are on the elapsed timeline, in microseconds.
 */
final class SliceCutter {
  /** Stands for a place that is never reached. */
  static final long NO_PLACE = Long.MAX_VALUE;

  /** What became of the wish to open a slice. */
  enum Opening {
    OPEN,
    /** A notification was handed on instead. */
    NOT_YET,
    AT_END,
    AT_OUT_POINT
  }

  private final SourceCursor cursor;
  private final ChainRunner runner;
  private final PlaybackMeter meter;

  // Where the next slice starts, unless only the next event tells.
  private long position;
  private boolean positionKnown = true;
  private long keepGridTo = NO_PLACE;
  private long slices;

  // The slice that is open, and whether it is due or some of it has been handed over.
  private boolean open;
  private boolean begun;
  private boolean byCount;
  private long from;
  private long to;
  private long offsetUs;
  private long events;
  private long eventsLeft;
  private long lastFed;

  // The run-up before a step back: to a place, and so many events of exactly that place.
  private boolean runningUp;
  private long runUpTo;
  private int runUpTies;

  // Events of the last microsecond that was handed over.
  private long tiesPlace = Long.MIN_VALUE;
  private int ties;

  // The slice that was shown last.
  private long shownFrom;
  private int shownTies;
  private long shownLengthUs;
  private long shownTimeUs = StreamNotification.NO_TIME_US;

  SliceCutter(SourceCursor cursor, ChainRunner runner, PlaybackMeter meter) {
    this.cursor = cursor;
    this.runner = runner;
    this.meter = meter;
  }

  /** Place where the next slice starts, as far as is known. */
  long position() {
    return position;
  }

  /** Slices that were shown since the last jump. */
  long slices() {
    return slices;
  }

  boolean isOpen() {
    return open;
  }

  boolean hasBegun() {
    return open && begun;
  }

  /** Start of the open slice. */
  long from() {
    return from;
  }

  long shownFrom() {
    return shownFrom;
  }

  /** Start of the shown slice among events of one time. */
  StepBackSearch.Place shownPlace() {
    return new StepBackSearch.Place(shownFrom, shownTies);
  }

  long shownLengthUs() {
    return shownLengthUs;
  }

  long shownTimeUs() {
    return shownTimeUs;
  }

  boolean runningUp() {
    return runningUp;
  }

  // ---- Jumps

  /** What comes next is from another place. */
  void moveTo(long place) {
    open = false;
    position = place;
    positionKnown = true;
    keepGridTo = NO_PLACE;
    runningUp = false;
    slices = 0;
    tiesPlace = Long.MIN_VALUE;
  }

  /** A person asked for the place, so it counts as shown. */
  void show(long place) {
    shownFrom = place;
    shownTies = 0;
    shownTimeUs = StreamNotification.NO_TIME_US;
  }

  /** What lies before a place goes through the chain only. */
  void runUpTo(StepBackSearch.Place place) {
    runningUp = position < place.elapsedUs() || place.ties() > 0;
    runUpTo = place.elapsedUs();
    runUpTies = place.ties();
  }

  /** Forgets where the grid of an open slice ends. */
  void dropGrid() {
    keepGridTo = NO_PLACE;
  }

  // ---- Slices

  /** Opens the next slice; sliceUs is its length unless slices are counted. */
  Opening open(SourceCursor.Ahead ahead, Slicing slicing, long sliceUs, long outPoint) {
    if (ahead == SourceCursor.Ahead.NOTIFICATION) {
      StreamNotification notification = cursor.takeNotification();
      positionKnown &= !(notification instanceof Reset);
      runner.notified(notification);
      return Opening.NOT_YET;
    }
    if (ahead == SourceCursor.Ahead.END) {
      return Opening.AT_END;
    }
    byCount = slicing instanceof Slicing.ByCount;
    if (!positionKnown) {
      keepGridTo = NO_PLACE;
    }
    long nextEvent = cursor.elapsedUs();
    if (!positionKnown || nextEvent < position || byCount && nextEvent < outPoint) {
      // By count a slice starts at its first event. By time an event can lie before the start if it
      // is of the very microsecond after which the last slice was cut short.
      position = nextEvent;
    }
    positionKnown = true;
    if (position >= outPoint) {
      return Opening.AT_OUT_POINT;
    }
    from = position;
    offsetUs = cursor.offsetUs();
    eventsLeft = slicing instanceof Slicing.ByCount count ? count.events() : Long.MAX_VALUE;
    if (byCount) {
      to = outPoint;
    } else {
      long gridTo = keepGridTo > position ? keepGridTo : NO_PLACE;
      long length = Math.min(sliceUs, NO_PLACE - position);
      to = Math.min(Math.min(position + length, gridTo), outPoint);
    }
    keepGridTo = NO_PLACE;
    events = 0;
    lastFed = from - 1;
    open = true;
    begun = false;
    return Opening.OPEN;
  }

  /** The open slice is due. */
  void begin() {
    begun = true;
    shownFrom = from;
    shownTies = from == tiesPlace ? ties : 0;
    shownTimeUs = from - offsetUs;
  }

  /** A slice that has not begun is cut anew. */
  void reopen() {
    open &= begun;
  }

  /** Hands a piece of the open slice over, or ends it; true if a slice has been shown. */
  boolean feed(SourceCursor.Ahead ahead) {
    if (ahead != SourceCursor.Ahead.EVENTS) {
      boolean goesOn = ahead == SourceCursor.Ahead.NOTIFICATION;
      boolean shown = end(lastFed + 1);
      keepGridTo = goesOn ? to : NO_PLACE;
      return shown;
    }
    long most = Math.min(PlaybackEngine.CHUNK_EVENTS, eventsLeft);
    int count = (int) Math.min(cursor.countBefore(to), most);
    if (count == 0) {
      return end(to);
    }
    EventPacket piece = cursor.take(count);
    noteTies(piece);
    lastFed = piece.timeUs(count - 1) + offsetUs;
    events += count;
    eventsLeft -= count;
    runner.packet(piece);
    return eventsLeft == 0 && end(lastFed + 1);
  }

  private void noteTies(EventPacket piece) {
    int count = piece.size();
    long lastUs = piece.timeUs(count - 1);
    int same = 0;
    while (same < count && piece.timeUs(count - 1 - same) == lastUs) {
      same++;
    }
    long place = lastUs + cursor.offsetUs();
    ties = same == count && place == tiesPlace ? ties + same : same;
    tiesPlace = place;
  }

  private boolean end(long place) {
    open = false;
    position = place;
    long start = from;
    if (place <= start) {
      return false;
    }
    slices++;
    shownLengthUs = place - start;
    meter.sliceEnded(place - start, events);
    long offset = offsetUs;
    runner.forEachSink(
        sink -> {
          if (sink instanceof SliceSink sliced) {
            sliced.sliceEnd(start - offset, place - offset);
          }
        });
    return true;
  }

  /** Ends a slice that is half done where it is. */
  void endEarly() {
    if (open && begun && events > 0) {
      end(lastFed + 1);
    }
    open = false;
  }

  /** As {@link #endEarly}, and what is left of the slice is the next one. */
  void split() {
    long gridTo = hasBegun() ? to : NO_PLACE;
    endEarly();
    keepGridTo = gridTo;
  }

  /** Sends a piece of the run-up through the chain, or ends it. */
  void runUp(SourceCursor.Ahead ahead) {
    if (ahead == SourceCursor.Ahead.NOTIFICATION) {
      runner.runUpNotified(cursor.takeNotification());
      return;
    }
    if (ahead == SourceCursor.Ahead.EVENTS) {
      int count = Math.min(cursor.countBefore(runUpTo), PlaybackEngine.CHUNK_EVENTS);
      if (count == 0 && runUpTies > 0) {
        count = 1;
        runUpTies--;
      }
      if (count > 0) {
        EventPacket piece = cursor.take(count);
        noteTies(piece);
        runner.runUp(piece);
        return;
      }
    }
    runningUp = false;
    position = runUpTo;
  }
}
