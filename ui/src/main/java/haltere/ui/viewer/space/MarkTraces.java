package haltere.ui.viewer.space;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.OverlayCanvas;
import haltere.ui.viewer.picture.DisplayFrame;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Positions over time of what overlays draw: centres of objects and tips of wing lines. A mark that
 * is missing at one moment begins a new trace.
 *
 * <p>Thread rule: one thread at a time.
 */
final class MarkTraces {
  /** A position on the sensor at a time of the events. */
  record Position(long timeUs, double x, double y) {}

  /** Positions of one mark in ascending order of their times. */
  record Trace(MarkStyle style, List<Position> positions) {}

  /** The n-th mark of a style at a moment. */
  private record Key(MarkStyle style, int number) {}

  private final List<Deque<Position>> traces = new ArrayList<>();
  private final List<MarkStyle> styles = new ArrayList<>();
  private Map<Key, Deque<Position>> open = Map.of();

  /** Adds the positions of all marks at a time. */
  void add(long timeUs, List<DisplayFrame.Marks<?>> marks) {
    Collector collector = new Collector();
    marks.forEach(each -> each.draw(timeUs, collector));
    Map<Key, Deque<Position>> now = new HashMap<>();
    collector.places.forEach(
        (key, place) -> {
          Deque<Position> trace = open.get(key);
          if (trace == null) {
            trace = new ArrayDeque<>();
            traces.add(trace);
            styles.add(key.style());
          }
          trace.add(new Position(timeUs, place[0], place[1]));
          now.put(key, trace);
        });
    open = now;
  }

  /** Forgets positions of before a time. */
  void forgetBefore(long timeUs) {
    for (int i = traces.size() - 1; i >= 0; i--) {
      Deque<Position> trace = traces.get(i);
      while (!trace.isEmpty() && trace.getFirst().timeUs() < timeUs) {
        trace.removeFirst();
      }
      if (trace.isEmpty()) {
        traces.remove(i);
        styles.remove(i);
        open.values().remove(trace);
      }
    }
  }

  /** Forgets all positions. */
  void clear() {
    forgetBefore(Long.MAX_VALUE);
  }

  /** A copy of the traces. */
  List<Trace> copy() {
    List<Trace> copy = new ArrayList<>();
    for (int i = 0; i < traces.size(); i++) {
      copy.add(new Trace(styles.get(i), List.copyOf(traces.get(i))));
    }
    return copy;
  }

  /** Takes one position of each mark that stands for an object or a wing edge. */
  private static final class Collector implements OverlayCanvas {
    private final Map<Key, double[]> places = new HashMap<>();

    private void put(MarkStyle style, double x, double y) {
      int number = 0;
      while (places.putIfAbsent(new Key(style, number), new double[] {x, y}) != null) {
        number++;
      }
    }

    private static boolean isObject(MarkStyle style) {
      return style.role() == Role.OBJECT || style.role() == Role.ESTIMATE;
    }

    @Override
    public void line(double x1, double y1, double x2, double y2, MarkStyle style) {
      if (style.role() == Role.LEFT || style.role() == Role.RIGHT) {
        // one edge stands for the wing
        places.putIfAbsent(new Key(MarkStyle.of(style.role()), 0), new double[] {x2, y2});
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
        // the first corner of an outline stands once more at its end
        put(style, mean(x, points - 1), mean(y, points - 1));
      }
    }

    private static double mean(double[] values, int count) {
      return Arrays.stream(values, 0, count).average().orElse(Double.NaN);
    }

    @Override
    public void text(double x, double y, String text, MarkStyle style) {
      // words have no trace
    }
  }
}
