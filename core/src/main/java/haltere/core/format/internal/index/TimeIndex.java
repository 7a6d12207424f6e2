package haltere.core.format.internal.index;

import haltere.core.event.EventPacket;
import haltere.core.format.RecordingProblem;
import haltere.core.format.TimeSegment;
import haltere.core.format.internal.clock.EventOrder;
import haltere.core.format.internal.decoding.EventCursor;
import haltere.core.stream.StreamNotification;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Optional;

/**
 * Index of a recording by time: the stated pieces of the file, else waypoints of a few dozen bytes
 * from one pass over its events, at least every {@value #SCAN_EVENTS} events and at the start of
 * each segment.
 *
 * <p>Thread rule: immutable once built.
 */
public final class TimeIndex {
  /** Maximum number of segments of a valid recording. */
  static final int MAX_SEGMENTS = 1 << 20;

  private static final int SCAN_EVENTS = 32 * 1024;

  private final int stateLongs;
  private final List<TimeSegment> segments = new ArrayList<>();
  private int[] firstWaypoint = new int[4];
  private long[] startOffsets = new long[4];
  private int waypoints;
  private long[] lastsUs = new long[64];
  private long[] states;

  private TimeIndex(int stateLongs) {
    this.stateLongs = stateLongs;
    states = new long[64 * stateLongs];
  }

  /** Scans with a separate cursor, at its start. */
  static TimeIndex scan(Path path, EventCursor cursor) throws IOException {
    TimeIndex index = new TimeIndex(cursor.stateLongs());
    if (index.fromPieces(path, cursor)) {
      return index;
    }
    EventPacket packet = new EventPacket((int) Math.min(SCAN_EVENTS, Files.size(path)));
    long[] state = new long[cursor.stateLongs()];
    long segmentFirstUs = 0;
    boolean inSegment = false;
    boolean isLate = false;
    int eventsInARow = 0;
    int eventsSinceWaypoint = 0;
    EventOrder order = new EventOrder();
    EventCursor.Stop stop;
    do {
      if (Thread.currentThread().isInterrupted()) {
        throw new InterruptedIOException("interrupted while indexing " + path);
      }
      if (eventsInARow >= SCAN_EVENTS) {
        // keeps the user interface responsive
        Thread.yield();
        eventsInARow = 0;
      }
      cursor.save(state, 0);
      long lastUs = order.newestUs();
      long offset = cursor.positionBytes();
      packet.clear();
      stop = cursor.read(packet, SCAN_EVENTS);
      order.raise(packet, 0);
      eventsInARow += packet.size();
      if (!packet.isEmpty()) {
        if (!inSegment) {
          segmentFirstUs = packet.firstTimeUs();
          index.startSegment(path, offset);
        }
        // late events would have as many waypoints
        if (!inSegment || !isLate || eventsSinceWaypoint >= SCAN_EVENTS) {
          index.addWaypoint(state, lastUs);
          eventsSinceWaypoint = 0;
        }
        inSegment = true;
        eventsSinceWaypoint += packet.size();
      }
      isLate = stop == EventCursor.Stop.CLOCK_WENT_BACK && order.isLate(cursor.times().restartUs());
      if (stop == EventCursor.Stop.CLOCK_WENT_BACK) {
        if (inSegment && !isLate) {
          index.segments.add(new TimeSegment(segmentFirstUs, order.newestUs()));
          inSegment = false;
          order.continueAfter(StreamNotification.NO_TIME_US);
        }
        cursor.times().acceptRestart();
      }
    } while (stop != EventCursor.Stop.END);
    if (inSegment) {
      index.segments.add(new TimeSegment(segmentFirstUs, order.newestUs()));
    }
    return index;
  }

  /** Writes all of it. */
  void write(DataOutputStream out) throws IOException {
    out.writeInt(stateLongs);
    out.writeInt(segments.size());
    for (int i = 0; i < segments.size(); i++) {
      out.writeLong(segments.get(i).firstUs());
      out.writeLong(segments.get(i).lastUs());
      out.writeInt(firstWaypoint[i]);
      out.writeLong(startOffsets[i]);
    }
    out.writeInt(waypoints);
    for (int i = 0; i < waypoints; i++) {
      out.writeLong(lastsUs[i]);
    }
    for (int i = 0; i < waypoints * stateLongs; i++) {
      out.writeLong(states[i]);
    }
  }

  /** Reads an index; empty if it is invalid. */
  static Optional<TimeIndex> read(DataInputStream in, int stateLongs) throws IOException {
    try {
      if (in.readInt() != stateLongs) {
        return Optional.empty();
      }
      TimeIndex index = new TimeIndex(stateLongs);
      int segments = in.readInt();
      index.firstWaypoint = new int[Math.min(segments, MAX_SEGMENTS) + 1];
      index.startOffsets = new long[index.firstWaypoint.length];
      for (int i = 0; i < segments; i++) {
        index.segments.add(new TimeSegment(in.readLong(), in.readLong()));
        index.firstWaypoint[i] = in.readInt();
        index.startOffsets[i] = in.readLong();
      }
      int waypoints = in.readInt();
      if (waypoints < segments || (waypoints > 0) != (segments > 0)) {
        return Optional.empty();
      }
      // an invalid count allocates no memory, since the bytes exist
      if (in.available() != 8L * waypoints * (1 + stateLongs)) {
        return Optional.empty();
      }
      index.waypoints = waypoints;
      index.lastsUs = longs(in, waypoints);
      index.states = longs(in, waypoints * stateLongs);
      int before = -1;
      for (int i = 0; i < segments; i++) {
        if (index.firstWaypoint[i] <= before || index.firstWaypoint[i] >= waypoints) {
          return Optional.empty();
        }
        before = index.firstWaypoint[i];
      }
      return Optional.of(index);
    } catch (EOFException | IllegalArgumentException | IndexOutOfBoundsException ignored) {
      return Optional.empty();
    }
  }

  private static long[] longs(DataInputStream in, int count) throws IOException {
    long[] numbers = new long[count];
    for (int i = 0; i < count; i++) {
      numbers[i] = in.readLong();
    }
    return numbers;
  }

  private boolean fromPieces(Path path, EventCursor cursor) throws IOException {
    // first and last time of the current segment
    long[] open = {0, Long.MIN_VALUE};
    boolean supported =
        cursor.visitPieces(
            (state, offset, firstUs, lastUs) -> {
              boolean starts =
                  waypoints == 0 || firstUs < open[1] && !EventOrder.isLate(open[1], firstUs);
              if (starts) {
                if (waypoints > 0) {
                  segments.add(new TimeSegment(open[0], open[1]));
                }
                startSegment(path, offset);
                open[0] = firstUs;
              }
              addWaypoint(state, starts ? StreamNotification.NO_TIME_US : open[1]);
              open[1] = starts ? lastUs : Math.max(open[1], lastUs);
            });
    if (supported && waypoints > 0) {
      segments.add(new TimeSegment(open[0], open[1]));
    }
    return supported;
  }

  private void startSegment(Path path, long offset) throws RecordingProblem {
    int segment = segments.size();
    if (segment == MAX_SEGMENTS) {
      throw new RecordingProblem(
          path,
          offset,
          "the clock went back "
              + MAX_SEGMENTS
              + " times; seeking in this recording is impossible");
    }
    if (segment == firstWaypoint.length) {
      firstWaypoint = Arrays.copyOf(firstWaypoint, segment * 2);
      startOffsets = Arrays.copyOf(startOffsets, segment * 2);
    }
    firstWaypoint[segment] = waypoints;
    startOffsets[segment] = offset;
  }

  private void addWaypoint(long[] state, long lastUs) {
    if (waypoints == lastsUs.length) {
      lastsUs = Arrays.copyOf(lastsUs, waypoints * 2);
      states = Arrays.copyOf(states, waypoints * 2 * stateLongs);
    }
    System.arraycopy(state, 0, states, waypoints * stateLongs, stateLongs);
    lastsUs[waypoints++] = lastUs;
  }

  /**
   * The sections of continuous time.
   *
   * @return in file order
   */
  public List<TimeSegment> segments() {
    return Collections.unmodifiableList(segments);
  }

  /**
   * Puts a cursor at the last waypoint of a segment before which all events are before a time.
   *
   * @param cursor of the same recording
   * @param segment index of one of {@link #segments()}
   * @param timeUs microseconds
   * @return time of the newest event of the segment before the waypoint, microseconds, or {@link
   *     StreamNotification#NO_TIME_US} if there is none
   * @throws IOException if the file cannot be read
   */
  public long seek(EventCursor cursor, int segment, long timeUs) throws IOException {
    int waypoint = waypoint(segment, timeUs);
    cursor.restore(states, waypoint * stateLongs);
    return lastsUs[waypoint];
  }

  /**
   * The state one waypoint earlier, for samples stored before the events of their time.
   *
   * @param segment index of one of {@link #segments()}
   * @param timeUs microseconds
   * @return as a cursor saves it; empty for the start of the file, before all events
   */
  public Optional<long[]> stateBefore(int segment, long timeUs) {
    int waypoint = Math.max(firstWaypoint[segment], waypoint(segment, timeUs) - 1);
    return waypoint == 0
        ? Optional.empty()
        : Optional.of(
            Arrays.copyOfRange(states, waypoint * stateLongs, (waypoint + 1) * stateLongs));
  }

  /**
   * File offset of a segment.
   *
   * @param segment index of one of {@link #segments()}
   * @return bytes from the start
   */
  public long startOffset(int segment) {
    return segment == 0 ? 0 : startOffsets[segment];
  }

  private int waypoint(int segment, long timeUs) {
    int low = firstWaypoint[segment];
    int high = (segment + 1 < segments.size() ? firstWaypoint[segment + 1] : waypoints) - 1;
    while (low < high) {
      int middle = (low + high + 1) >>> 1;
      if (lastsUs[middle] < timeUs) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return low;
  }
}
