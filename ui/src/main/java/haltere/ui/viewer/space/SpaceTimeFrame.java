package haltere.ui.viewer.space;

import haltere.ui.rendering.SpaceTimeCloud;
import haltere.ui.viewer.picture.DisplayFrame;
import java.util.List;

/** What the view in space and time shows of one moment. */
final class SpaceTimeFrame {
  final SpaceTimeCloud.Points points;

  /** The time that is shown, which has the age 0, microseconds. */
  long nowUs;

  /** Marks of filters at that time. */
  List<DisplayFrame.Marks<?>> marks = List.of();

  /** Where marks were before. */
  List<MarkTraces.Trace> traces = List.of();

  SpaceTimeFrame(int capacity) {
    points = new SpaceTimeCloud.Points(capacity);
  }
}
