package haltere.ui.viewer.road;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.filters.plane.VanishingPoint;
import haltere.filters.track.KalmanTracksFilter;
import haltere.filters.track.RoadTracksSettings;
import haltere.ui.viewer.ViewerHarness;
import haltere.ui.viewer.action.ViewerAction;
import haltere.ui.viewer.picture.ViewTool;
import javafx.scene.control.TextField;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Where the road vanishes, said by the mouse in the real window. */
class VanishingPointTest {
  private static final String ACTION = "vanishing-point";
  private static final String TRACKS = "kalman-tracks";
  private ViewerHarness viewer;

  @BeforeEach
  void open() {
    viewer = ViewerHarness.withBlob();
  }

  @AfterEach
  void close() {
    viewer.close();
  }

  private boolean isOffered() {
    return viewer.onFx(
        () -> {
          ViewerAction action = viewer.window.context().actions().find(ACTION).orElseThrow();
          return action.obstacle().get().isEmpty();
        });
  }

  private void addTracks() {
    viewer.click("add-filter");
    viewer.waitFor("the filter in the menu", () -> viewer.isThere("add-" + TRACKS));
    viewer.click("add-" + TRACKS);
    viewer.waitFor("the action", this::isOffered);
  }

  private RoadTracksSettings road() {
    KalmanTracksFilter tracks =
        (KalmanTracksFilter) viewer.session().chain().stage(TRACKS).filter();
    return tracks.settings().road();
  }

  private VanishingPoint point() {
    return road().view().vanishingPoint();
  }

  @Test
  void toolIsOfferedWhileTheChainHasTracks() {
    assertFalse(isOffered());
    addTracks();
    viewer.run(() -> viewer.window.context().actions().run(ACTION));
    viewer.waitFor("the tool", () -> viewer.window.context().panels().view().tool().isPresent());
    viewer.click("more-" + TRACKS);
    viewer.click("remove-" + TRACKS);
    viewer.waitFor("the action is gone", () -> !isOffered());
    assertTrue(viewer.onFx(() -> viewer.window.context().panels().view().tool().isEmpty()));
  }

  @Test
  void refusalOfACommandEndsWithTheNextCommand() {
    viewer.run(() -> viewer.window.context().actions().run(ACTION));
    viewer.waitFor("why", () -> viewer.text("status-message").contains("no filter of Kalman"));
    addTracks();
    viewer.run(() -> viewer.window.context().actions().run(ACTION));
    viewer.waitFor("the hint", () -> viewer.text("status-message").startsWith("Click the vanish"));
  }

  @Test
  void clickSetsTheVanishingPointAndIsUndone() {
    addTracks();
    viewer.click("expand-" + TRACKS);
    viewer.run(() -> viewer.window.context().actions().run(ACTION));
    viewer.clickAt(40, 100);
    viewer.waitFor("tracks on a road", () -> road().mapToRoad() && point().marked());
    assertEquals(40, point().xPx(), 1);
    assertEquals(100, point().yPx(), 1);
    PointsTool tool =
        (PointsTool)
            viewer.onFx(() -> viewer.window.context().panels().view().tool().orElseThrow());
    viewer.waitFor("the mark", () -> tool.points().get(0).getX() == point().xPx());
    TextField entry =
        viewer.node("entry-" + TRACKS + "-road-view-vanishingPoint-xPx", TextField.class);
    viewer.waitFor(
        "the setting in its card", () -> Double.parseDouble(entry.getText()) == point().xPx());
    viewer.run(() -> viewer.window.context().actions().run("undo"));
    viewer.waitFor("no road", () -> !road().mapToRoad() && !point().marked());
    viewer.waitFor("no mark", () -> tool.points().isEmpty());
    viewer.run(() -> viewer.window.context().actions().run("redo"));
    viewer.waitFor("the road again", () -> road().mapToRoad() && point().marked());
  }

  @Test
  void invalidVanishingPointIsReportedInOneLine() {
    addTracks();
    viewer.run(() -> viewer.window.context().actions().run(ACTION));
    ViewTool tool = viewer.onFx(() -> viewer.window.context().panels().view().tool().orElseThrow());
    viewer.run(
        () -> {
          tool.pressed(40, -3);
          tool.released(40, -3);
        });
    viewer.waitFor(
        "why", () -> viewer.text("status-message").contains("road.view.vanishingPoint.yPx is -3"));
    assertFalse(point().marked());
    viewer.run(() -> tool.released(40, 100));
    viewer.waitFor("the mark", () -> point().marked());
    viewer.waitFor(
        "no problem any more", () -> !viewer.text("status-message").contains("vanishingPoint"));
  }
}
