package haltere.ui.viewer.road;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.ui.command.CommandRun;
import haltere.ui.viewer.ViewerHarness;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A plane by four clicked corners, in the real window. */
class PlaneTest {
  private static final String MESSAGE = "status-message";

  @TempDir Path folder;
  private ViewerHarness viewer;
  private Path plane;

  @BeforeEach
  void open() throws IOException {
    viewer = ViewerHarness.withRecording(folder, 2_000_000);
    viewer.pause();
    plane = folder.resolve("plane.json");
    viewer.window.feature(PlaneFeature.class).setFiles(() -> Optional.of(plane));
    viewer.run(() -> viewer.window.context().actions().run("map-plane"));
    waitForHint("Click corner 1");
  }

  @AfterEach
  void close() {
    viewer.close();
  }

  private void waitForHint(String start) {
    viewer.waitFor(start, () -> viewer.text(MESSAGE).startsWith(start));
  }

  private Optional<PointsTool> tool() {
    return viewer.onFx(
        () -> viewer.window.context().panels().view().tool().map(PointsTool.class::cast));
  }

  private void clickThreeCorners() {
    viewer.clickAt(20, 20);
    waitForHint("Click corner 2");
    viewer.clickAt(100, 20);
    waitForHint("Click corner 3");
    viewer.clickAt(100, 60);
    waitForHint("Click corner 4");
  }

  private void answer(String size) {
    viewer.waitFor("the question", () -> viewer.isThere("answer"));
    TextField answer = viewer.node("answer", TextField.class);
    viewer.run(() -> answer.setText(size));
    viewer.press(KeyCode.ENTER);
  }

  private double[] column(List<String> lines, String name) {
    int index = List.of(lines.get(0).split(",")).indexOf(name);
    return lines.stream()
        .skip(1)
        .mapToDouble(line -> Double.parseDouble(line.split(",")[index]))
        .toArray();
  }

  @Test
  void clickedCornersGiveTracksInMetres() throws IOException {
    clickThreeCorners();
    viewer.clickAt(20, 60);
    answer("80 x 40 mm");
    viewer.waitFor("the command", () -> viewer.text(MESSAGE).endsWith("--road plane.json"));
    assertTrue(tool().isEmpty());
    Path tracks = folder.resolve("tracks.csv");
    CommandRun run =
        CommandRun.of("track", folder.resolve("blob.aedat"), "--out", tracks, "--road", plane);
    assertEquals(0, run.status(), run.err());
    List<String> lines = Files.readAllLines(tracks);
    assertTrue(lines.size() > 10, lines.size() + " lines");
    double[] x = column(lines, "x_px");
    double[] y = column(lines, "y_px");
    double[] planeX = column(lines, "x_m");
    double[] planeY = column(lines, "y_m");
    for (int i = 0; i < x.length; i++) {
      assertEquals((x[i] - 20) / 1000, planeX[i], 1.5e-3, "a pixel is a millimetre");
      assertEquals((y[i] - 20) / 1000, planeY[i], 1.5e-3);
    }
  }

  @Test
  void crossingSidesAreRefusedWithTheReason() {
    viewer.clickAt(20, 20);
    viewer.clickAt(100, 60);
    viewer.clickAt(100, 20);
    viewer.clickAt(20, 60);
    viewer.waitFor("why", () -> viewer.text(MESSAGE).contains("no homography of a camera"));
    assertEquals(3, tool().orElseThrow().points().size());
  }

  @Test
  void cornersOnALineAreRefusedWithTheReason() {
    clickThreeCorners();
    viewer.clickAt(100, 100);
    viewer.waitFor("why", () -> viewer.text(MESSAGE).contains("three of the four pixels are on a"));
    assertEquals(3, tool().orElseThrow().points().size());
  }

  @Test
  void escapeTakesTheLastCornerBackAndThenEndsTheTool() {
    clickThreeCorners();
    viewer.press(KeyCode.ESCAPE);
    waitForHint("Click corner 3");
    assertEquals(2, tool().orElseThrow().points().size());
    viewer.press(KeyCode.ESCAPE);
    viewer.press(KeyCode.ESCAPE);
    waitForHint("Click corner 1");
    viewer.press(KeyCode.ESCAPE);
    viewer.waitFor("the end of the tool", () -> tool().isEmpty());
  }

  @Test
  void sizeWithoutUnitIsRefused() {
    clickThreeCorners();
    viewer.clickAt(20, 60);
    answer("80 x 40");
    viewer.waitFor("why", () -> viewer.text(MESSAGE).startsWith("80 x 40 is not a size such as"));
    viewer.clickAt(20, 61);
    answer("0.08 x 0.04 m");
    viewer.waitFor("the plane", () -> Files.exists(plane));
  }
}
