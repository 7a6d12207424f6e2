package haltere.ui.viewer.space;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.OverlayCanvas;
import haltere.ui.rendering.OverlaySnapshots;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Positions of overlay marks over time: centres of objects and tips of wings. A mark that is
 * missing at one moment starts a new trace.
 */
final class MarkTraces {
  /** A position on the sensor at a time of the events. */
  record TracePoint(long timeUs, double x, double y) {}

  /** Positions of one mark in ascending order of their times. */
  record Trace(MarkStyle style, Deque<TracePoint> positions) {
    void removeBefore(long timeUs) {
      while (!positions.isEmpty() && positions.getFirst().timeUs() < timeUs) {
        positions.removeFirst();
      }
    }
  }

  /** The n-th mark of a style at a moment. */
  private record Key(MarkStyle style, int number) {}

  private final List<Trace> traces = new ArrayList<>();
  private Map<Key, Trace> open = new HashMap<>();

  /** Adds the positions of all marks at a time. */
  void add(long timeUs, List<OverlaySnapshots.Marks<?>> marks) {
    MarkCollector collector = new MarkCollector();
    marks.forEach(each -> each.draw(timeUs, collector));
    Map<Key, Trace> now = new HashMap<>();
    collector.positions.forEach(
        (key, position) -> {
          Trace trace = open.get(key);
          if (trace == null) {
            trace = new Trace(key.style(), new ArrayDeque<>());
            traces.add(trace);
          }
          trace.positions().add(new TracePoint(timeUs, position[0], position[1]));
          now.put(key, trace);
        });
    open = now;
  }

  void removeBefore(long timeUs) {
    traces.forEach(trace -> trace.removeBefore(timeUs));
    traces.removeIf(trace -> trace.positions().isEmpty());
    open.values().removeIf(trace -> trace.positions().isEmpty());
  }

  /** Removes all positions. */
  void clear() {
    removeBefore(Long.MAX_VALUE);
  }

  List<Trace> copy() {
    return traces.stream()
        .map(trace -> new Trace(trace.style(), new ArrayDeque<>(trace.positions())))
        .toList();
  }

  /** Collects one position of each mark of an object or a wing edge. */
  private static final class MarkCollector implements OverlayCanvas {
    private final Map<Key, double[]> positions = new HashMap<>();

    private void put(MarkStyle style, double x, double y) {
      int number = 0;
      while (positions.putIfAbsent(new Key(style, number), new double[] {x, y}) != null) {
        number++;
      }
    }

    private static boolean isObject(MarkStyle style) {
      return style.role() == Role.OBJECT || style.role() == Role.ESTIMATE;
    }

    @Override
    public void line(double x1, double y1, double x2, double y2, MarkStyle style) {
      if (style.role() == Role.LEFT || style.role() == Role.RIGHT) {
        // one edge represents the wing
        positions.putIfAbsent(new Key(MarkStyle.of(style.role()), 0), new double[] {x2, y2});
      }
    }

    @Override
    public void ellipse(
        double x, double y, double radiusA, double radiusB, double angleRad, MarkStyle style) {
      if (isObject(style)) {
        put(style, x, y);
      }
    }

    @Override
    public void polyline(double[] x, double[] y, int points, MarkStyle style) {
      if (isObject(style)) {
        // the first corner of a closed line is repeated at its end
        put(style, mean(x, points - 1), mean(y, points - 1));
      }
    }

    private static double mean(double[] values, int count) {
      return Arrays.stream(values, 0, count).average().orElse(Double.NaN);
    }

    @Override
    public void text(double x, double y, String text, MarkStyle style) {
      // text has no trace
    }
  }
}
