package haltere.ui.viewer.plots;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.ui.command.report.ReportPage;
import haltere.ui.plot.Curve;
import haltere.ui.plot.Lane;
import haltere.ui.plot.PlotField;
import haltere.ui.rendering.MarkColours;
import haltere.ui.viewer.controls.Theme;
import java.util.List;
import javafx.scene.paint.Color;
import org.junit.jupiter.api.Test;

class PlotColoursTest {
  private static final PlotField X = new PlotField("tracks", "estimates", "x");
  private static final PlotField MEASURED = new PlotField("tracks", "estimates", "measured_x");

  @Test
  void curveOfAnObjectHasTheColourOfItsEllipse() {
    Lane lane = new Lane(X);
    lane.take(X, 0, "7", 1);
    lane.take(X, 0, "1", 1);
    List<Curve> curves = lane.curves();
    assertEquals(colour(MarkStyle.of(Role.OBJECT, 7)), PlotColours.DARK.curve(curves.get(0)));
    assertEquals(colour(MarkStyle.of(Role.OBJECT, 1)), PlotColours.DARK.curve(curves.get(1)));
    assertEquals(ReportPage.colour("", 1), ReportPage.colour("1", 0), "in a report too");
  }

  @Test
  void curveOfAWingHasTheColourOfItsSide() {
    assertEquals(colour(MarkStyle.of(Role.LEFT)), PlotColours.DARK.curve(new Curve("left", 0)));
    assertEquals(colour(MarkStyle.of(Role.RIGHT)), PlotColours.DARK.curve(new Curve("right", 1)));
    assertNotEquals(ReportPage.colour("left", 0), ReportPage.colour("right", 0));
  }

  @Test
  void twoFieldsOfOneObjectAreDistinguishable() {
    Lane lane = new Lane(MEASURED);
    lane.add(X);
    lane.take(X, 0, "1", 1);
    lane.take(MEASURED, 0, "1", 1);
    List<Curve> curves = lane.curves();
    assertNotEquals(PlotColours.DARK.curve(curves.get(0)), PlotColours.DARK.curve(curves.get(1)));
  }

  private static Color colour(MarkStyle style) {
    return Theme.colour(MarkColours.argb(style, true));
  }
}
