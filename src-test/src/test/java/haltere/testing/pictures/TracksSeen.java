package haltere.testing.pictures;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.filters.track.TrackPoint;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * What can be said of the tracks of a recording of which nobody has written down what is right: how
 * many identities there are, for how long each is shown, how many at a time, what share of the
 * events was theirs, whether they slide along lines, and whether what makes most events has one.
 * Thread rule: not safe for use by two threads at a time.
 */
final class TracksSeen implements StreamHandler {
  private static final double US = 1e-6;

  /** Tracks are compared with the events of the last so many microseconds. */
  private static final long RECENT_US = 20_000;

  /** Shown at a time means: no further apart than reports are, and some more. */
  private static final long REPORT_US = 15_000;

  /** Half the length of the piece of a line that is looked at, as a share of the longer side. */
  private static final double PIECE = 0.08;

  /** A line is this many times as long as it is wide, squared. */
  private static final double SLENDER = 8;

  /**
   * On a line that goes on there are as many events beyond the piece, as a share of those in it.
   */
  private static final double GOES_ON = 0.3;

  /** Fewer events than this say nothing of a line or of where the busiest place is. */
  private static final int LEAST_EVENTS = 25;

  private static final int ROOM = 1 << 16;

  private final Map<Integer, Life> lives = new LinkedHashMap<>();
  private final SensorGeometry geometry;
  private final double piece;
  private final long[] timesUs = new long[ROOM];
  private final int[] columns = new int[ROOM];
  private final int[] rows = new int[ROOM];
  private long events;
  private long firstUs = Long.MIN_VALUE;
  private long lastUs;
  private final Times times = new Times();
  private final Deque<List<TrackPoint>> reports = new ArrayDeque<>();
  private long frameUs;

  /** The recent events are those from here, counted from the first of all, and before there. */
  private long from;

  private long to;

  TracksSeen(SensorGeometry geometry) {
    this.geometry = geometry;
    piece = Math.max(5, PIECE * geometry.longerSide());
  }

  /** Sums over tracks or over times, seconds. */
  private static final class Times {
    double all;
    double shown;
    double onLines;
    double sliding;
    double busy;
    double busyWithOne;
    double busyWithNone;
  }

  private static final class Life {
    long fromUs;
    long untilUs;
    long events;
    long firstEvents;
    double onBusiest;
  }

  @Override
  public void packet(EventPacket packet) {
    for (int i = 0; i < packet.size(); i++) {
      int at = at(events++);
      timesUs[at] = packet.timeUs(i);
      columns[at] = packet.x(i);
      rows[at] = packet.y(i);
    }
    if (packet.size() > 0) {
      if (firstUs == Long.MIN_VALUE) {
        firstUs = packet.firstTimeUs();
      }
      lastUs = packet.lastTimeUs();
    }
    while (!reports.isEmpty() && reports.peekFirst().get(0).timeUs() <= lastUs) {
      look(reports.removeFirst());
    }
  }

  @Override
  public void notified(StreamNotification notification) {
    // a recording has one stream
  }

  /** Takes a track as it is shown at a report, which may be before its events come. */
  void shown(TrackPoint point) {
    if (reports.isEmpty() || reports.peekLast().get(0).timeUs() != point.timeUs()) {
      reports.addLast(new ArrayList<>());
    }
    reports.peekLast().add(point);
  }

  /** Looks at the tracks of one report. */
  private void look(List<TrackPoint> frame) {
    frameUs = frame.get(0).timeUs();
    findRecent();
    double dt = REPORT_US * US * 2 / 3;
    times.shown += dt * frame.size();
    double[] busiest = busiestPlace();
    int there = 0;
    for (TrackPoint point : frame) {
      Life life = lives.computeIfAbsent(point.id(), id -> new Life());
      if (life.fromUs == 0) {
        life.fromUs = point.timeUs();
        life.firstEvents = point.events();
      }
      life.untilUs = point.timeUs();
      life.events = point.events();
      double[] line = lineAt(point);
      if (line != null) {
        times.onLines += dt;
        times.sliding += dt * Math.abs(line[0] * point.vxPxS() + line[1] * point.vyPxS());
      }
      if (busiest != null
          && Math.hypot(point.xPx() - busiest[0], point.yPx() - busiest[1]) < 1.5 * piece) {
        there++;
        life.onBusiest += dt;
      }
    }
    if (busiest != null) {
      times.busy += dt;
      times.busyWithOne += there == 1 ? dt : 0;
      times.busyWithNone += there == 0 ? dt : 0;
    }
  }

  private void findRecent() {
    long oldest = Math.max(0, events - ROOM);
    to = events;
    while (to > oldest && timesUs[at(to - 1)] > frameUs) {
      to--;
    }
    from = to;
    while (from > oldest && timesUs[at(from - 1)] > frameUs - RECENT_US) {
      from--;
    }
  }

  private static int at(long index) {
    return (int) (index & ROOM - 1);
  }

  /** The median of the recent events, or null if there are few. */
  private double[] busiestPlace() {
    int n = (int) (to - from);
    if (n < LEAST_EVENTS) {
      return null;
    }
    int[] x = new int[n];
    int[] y = new int[n];
    for (int i = 0; i < n; i++) {
      x[i] = columns[at(from + i)];
      y[i] = rows[at(from + i)];
    }
    Arrays.sort(x);
    Arrays.sort(y);
    return new double[] {x[n / 2], y[n / 2]};
  }

  /** The direction of the line through a track that goes on beyond the piece, or null. */
  private double[] lineAt(TrackPoint point) {
    double[] sums = new double[6];
    for (long i = from; i < to; i++) {
      int at = at(i);
      double dx = columns[at] - point.xPx();
      double dy = rows[at] - point.yPx();
      if (dx * dx + dy * dy < piece * piece) {
        sums[0]++;
        sums[1] += dx;
        sums[2] += dy;
        sums[3] += dx * dx;
        sums[4] += dx * dy;
        sums[5] += dy * dy;
      }
    }
    if (sums[0] < LEAST_EVENTS) {
      return null;
    }
    double mx = sums[1] / sums[0];
    double my = sums[2] / sums[0];
    double xx = sums[3] / sums[0] - mx * mx;
    double xy = sums[4] / sums[0] - mx * my;
    double yy = sums[5] / sums[0] - my * my;
    double mean = (xx + yy) / 2;
    double apart = Math.hypot((xx - yy) / 2, xy);
    double across = mean - apart;
    if (mean + apart < SLENDER * (across + 0.3)) {
      return null;
    }
    double angle = 0.5 * Math.atan2(2 * xy, xx - yy);
    double c = Math.cos(angle);
    double s = Math.sin(angle);
    int[] beyond = new int[2];
    for (long i = from; i < to; i++) {
      int at = at(i);
      double dx = columns[at] - point.xPx() - mx;
      double dy = rows[at] - point.yPx() - my;
      double along = c * dx + s * dy;
      double off = c * dy - s * dx;
      if (off * off < 9 * (across + 0.3)
          && Math.abs(along) > piece
          && Math.abs(along) < 1.5 * piece) {
        beyond[along > 0 ? 1 : 0]++;
      }
    }
    return goesOn(point, c, s, beyond[1], sums[0]) && goesOn(point, -c, -s, beyond[0], sums[0])
        ? new double[] {c, s}
        : null;
  }

  private boolean goesOn(TrackPoint point, double c, double s, int beyond, double within) {
    double x = point.xPx() + 2 * piece * c;
    double y = point.yPx() + 2 * piece * s;
    boolean outside = x < 0 || y < 0 || x >= geometry.width() || y >= geometry.height();
    return outside || beyond > GOES_ON * within / 2;
  }

  /** All of it in one line. */
  String figures() {
    double[] seconds =
        lives.values().stream()
            .mapToDouble(one -> (one.untilUs - one.fromUs) * US)
            .sorted()
            .toArray();
    int n = seconds.length;
    times.all = (lastUs - firstUs) * US;
    long theirs = lives.values().stream().mapToLong(one -> one.events - one.firstEvents).sum();
    double[] onBusiest =
        lives.values().stream()
            .mapToDouble(one -> one.onBusiest)
            .filter(s -> s > 0)
            .sorted()
            .toArray();
    int m = onBusiest.length;
    return String.format(
        Locale.ROOT,
        "%d identities in %.1f s, shown for %.2f s (median) and %.2f s (mean), %.1f at a time,"
            + " with %.0f %% of the events; on lines %.0f %% of the time, sliding at %.1f px/s;"
            + " at the busiest place %d, one %.0f %% and none %.0f %% of the time, the longest %.0f %%",
        n,
        times.all,
        n == 0 ? 0 : seconds[n / 2],
        n == 0 ? 0 : Arrays.stream(seconds).average().orElse(0),
        times.shown / times.all,
        100.0 * theirs / events,
        100 * times.onLines / Math.max(1e-9, times.shown),
        times.sliding / Math.max(1e-9, times.onLines),
        m,
        100 * times.busyWithOne / Math.max(1e-9, times.busy),
        100 * times.busyWithNone / Math.max(1e-9, times.busy),
        m == 0 ? 0 : 100 * onBusiest[m - 1] / Math.max(1e-9, times.busy));
  }
}
