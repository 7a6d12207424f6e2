package haltere.core.format.aedat2;

import haltere.core.event.EventPacket;
import haltere.core.format.RecordingProblem;
import haltere.core.format.TimeSegment;
import haltere.core.stream.StreamNotification;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Where in a file which time is: one pass over the records that keeps a waypoint per buffer and per
 * segment. About 24 bytes for each 256 KiB of file.
 *
 * <p>Thread rule: immutable once built.
 */
final class RecordIndex {
  /** More restarts of the clock than this are no recording any more. */
  static final int MAX_SEGMENTS = 1 << 20;

  private static final int SCAN_EVENTS = 32 * 1024;

  private final List<TimeSegment> segments = new ArrayList<>();
  private int[] firstWaypoint = new int[4];
  private int waypoints;
  private long[] offsets = new long[64];
  private long[] turnsUs = new long[64];
  private long[] lastsUs = new long[64];

  private RecordIndex() {}

  /** One pass over the file with a decoder of its own. */
  static RecordIndex scan(
      RecordFile file, long dataOffset, RecordDecoder decoder, ByteBuffer buffer)
      throws IOException {
    RecordIndex index = new RecordIndex();
    EventPacket packet = new EventPacket(SCAN_EVENTS);
    long offset = dataOffset;
    long segmentFirstUs = 0;
    boolean inSegment = false;
    file.read(buffer, offset);
    while (buffer.remaining() >= decoder.recordBytes()) {
      long turnUs = decoder.turnUs();
      long lastUs = decoder.lastUs();
      int from = buffer.position();
      packet.clear();
      boolean restart = decoder.decode(buffer, offset, packet, SCAN_EVENTS);
      if (!packet.isEmpty()) {
        if (!inSegment) {
          inSegment = true;
          segmentFirstUs = packet.firstTimeUs();
          index.startSegment(file, offset);
        }
        index.addWaypoint(offset, turnUs, lastUs);
      }
      offset += buffer.position() - from;
      if (restart) {
        index.segments.add(new TimeSegment(segmentFirstUs, decoder.lastUs()));
        inSegment = false;
        decoder.acceptRestart();
        decoder.reset(decoder.turnUs());
      } else if (buffer.remaining() < decoder.recordBytes()) {
        if (Thread.currentThread().isInterrupted()) {
          throw new InterruptedIOException("interrupted while indexing " + file.path());
        }
        file.read(buffer, offset);
      }
    }
    if (inSegment) {
      index.segments.add(new TimeSegment(segmentFirstUs, decoder.lastUs()));
    }
    return index;
  }

  private void startSegment(RecordFile file, long offset) throws RecordingProblem {
    int segment = segments.size();
    if (segment == MAX_SEGMENTS) {
      throw new RecordingProblem(
          file.path(),
          offset,
          "the clock went back "
              + MAX_SEGMENTS
              + " times; this is no recording that one can seek in");
    }
    if (segment == firstWaypoint.length) {
      firstWaypoint = Arrays.copyOf(firstWaypoint, segment * 2);
    }
    firstWaypoint[segment] = waypoints;
  }

  private void addWaypoint(long offset, long turnUs, long lastUs) {
    if (waypoints == offsets.length) {
      offsets = Arrays.copyOf(offsets, waypoints * 2);
      turnsUs = Arrays.copyOf(turnsUs, waypoints * 2);
      lastsUs = Arrays.copyOf(lastsUs, waypoints * 2);
    }
    offsets[waypoints] = offset;
    turnsUs[waypoints] = turnUs;
    lastsUs[waypoints++] = lastUs;
  }

  /** The stretches of continuous time, in file order. */
  List<TimeSegment> segments() {
    return java.util.Collections.unmodifiableList(segments);
  }

  /** The last waypoint of a segment that has only events before a time behind it. */
  int waypointBefore(int segment, long timeUs) {
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

  /** Where a waypoint's records start. */
  long offset(int waypoint) {
    return offsets[waypoint];
  }

  /** Puts a decoder into the state that it has at a waypoint. */
  void restore(int waypoint, RecordDecoder decoder) {
    if (lastsUs[waypoint] == StreamNotification.NO_TIME_US) {
      decoder.reset(turnsUs[waypoint]);
    } else {
      decoder.resume(turnsUs[waypoint], lastsUs[waypoint]);
    }
  }
}
