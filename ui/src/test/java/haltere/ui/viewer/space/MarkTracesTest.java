package haltere.ui.viewer.space;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.Overlay;
import haltere.ui.rendering.OverlaySnapshots;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Where marks were, time by time. */
class MarkTracesTest {
  private static final Overlay<Double> OBJECT =
      (x, canvas) -> {
        canvas.ellipse(x, 5, 3, 2, 0, MarkStyle.of(Role.ESTIMATE, 7));
        canvas.text(x, 9, "7", MarkStyle.of(Role.LABEL, 7));
        canvas.polyline(new double[] {0, x}, new double[] {0, 5}, 2, MarkStyle.of(Role.PATH, 7));
      };
  private static final Overlay<Double> WING =
      (x, canvas) -> {
        canvas.line(0, 0, x, 1, MarkStyle.of(Role.LEFT, 0));
        canvas.line(0, 0, x, 2, MarkStyle.of(Role.LEFT, 1));
      };

  private final MarkTraces traces = new MarkTraces();

  private void add(long timeUs, Overlay<Double> overlay, double x) {
    traces.add(timeUs, List.of(new OverlaySnapshots.Marks<>(x, overlay)));
  }

  @Test
  void objectTraceFollowsItsCentreWithoutLabelAndPath() {
    add(10, OBJECT, 1);
    add(20, OBJECT, 4);
    MarkTraces.Trace trace = traces.copy().get(0);
    assertEquals(1, traces.copy().size());
    assertEquals(MarkStyle.of(Role.ESTIMATE, 7), trace.style());
    assertEquals(
        List.of(new MarkTraces.TracePoint(10, 1, 5), new MarkTraces.TracePoint(20, 4, 5)),
        List.copyOf(trace.positions()));
  }

  @Test
  void wingTraceFollowsItsTip() {
    add(10, WING, 30);
    add(20, WING, 31);
    assertEquals(1, traces.copy().size(), "for both edges");
    assertEquals(new MarkTraces.TracePoint(20, 31, 1), traces.copy().get(0).positions().getLast());
  }

  @Test
  void returningMarkStartsANewTraceAndOldPositionsExpire() {
    add(10, OBJECT, 1);
    traces.add(20, List.of());
    add(30, OBJECT, 2);
    assertEquals(2, traces.copy().size());
    traces.removeBefore(15);
    assertEquals(
        List.of(new MarkTraces.TracePoint(30, 2, 5)),
        List.copyOf(traces.copy().get(0).positions()));
    traces.clear();
    assertEquals(List.of(), traces.copy());
    add(40, OBJECT, 3);
    assertEquals(1, traces.copy().get(0).positions().size());
  }
}
