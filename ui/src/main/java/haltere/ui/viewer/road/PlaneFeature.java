package haltere.ui.viewer.road;

import haltere.core.format.AtomicFile;
import haltere.core.json.internal.Json;
import haltere.filters.plane.Homography;
import haltere.filters.plane.PointPair;
import haltere.ui.viewer.controls.Windows;
import haltere.ui.viewer.feature.WindowFeature;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import javafx.beans.property.BooleanProperty;
import javafx.geometry.Point2D;

/**
 * Maps a plane by the four clicked corners of a rectangle of known size, and saves it as {@code
 * haltere track --road} reads it. The first corner is the origin.
 */
public final class PlaneFeature extends WindowFeature {
  private static final Pattern SIZE =
      Pattern.compile("(\\d+(?:\\.\\d+)?)\\s*[x\u00d7]\\s*(\\d+(?:\\.\\d+)?)\\s*(m|cm|mm)");
  private static final Map<String, Integer> PER_METRE = Map.of("m", 1, "cm", 100, "mm", 1000);
  private static final String SAVED =
      "Saved %s. To use it: haltere track FILE --out TRACKS.csv --road %1$s";

  private BooleanProperty marking;
  private final PointsTool tool =
      new PointsTool(
          this::follow,
          "Click corner 1 of a rectangle of known size: the origin of the plane.",
          "Click corner 2, at the other end of the width; Esc takes the last corner back.",
          "Click corner 3, at the other end of the length; Esc takes the last corner back.",
          "Click corner 4; Esc takes the last corner back.");
  private String size = "300 x 200 mm";
  private Supplier<Optional<Path>> files =
      () -> window.dialogs().save("Save plane", "plane.json", "Planes", "*.json");

  /** Sets who is asked for the file, in place of a dialog. */
  void setFiles(Supplier<Optional<Path>> newFiles) {
    files = newFiles;
  }

  @Override
  protected void install() {
    marking = window.addTool("map-plane", tool, window::nothingOpen);
    marking.subscribe((was, is) -> tool.show(List.of()));
    window.sessions().onChange((was, is) -> marking.set(false));
  }

  private void follow(List<Point2D> corners) {
    window.showHint(tool);
    window.status().showRefusal("");
    if (corners.size() == 4) {
      try {
        new Homography(points(corners, 1, 1));
        String question = "Width (corners 1-2) x length (2-3), m, cm or mm";
        Windows.ask(window.stage(), "Map a plane", question, size, text -> set(corners, text));
      } catch (IllegalArgumentException problem) {
        tool.takeBack();
        window.status().showRefusal("Corner 4 is refused: " + problem.getMessage());
      }
    }
  }

  private static List<PointPair> points(List<Point2D> corners, double width, double length) {
    double[] x = {0, width, width, 0};
    double[] y = {0, 0, length, length};
    return IntStream.range(0, 4)
        .mapToObj(i -> new PointPair(corners.get(i).getX(), corners.get(i).getY(), x[i], y[i]))
        .toList();
  }

  private void set(List<Point2D> corners, String text) {
    Matcher found = SIZE.matcher(text);
    double width = found.matches() ? Double.parseDouble(found.group(1)) : 0;
    double length = found.matches() ? Double.parseDouble(found.group(2)) : 0;
    if (width == 0 || length == 0) {
      window
          .status()
          .showRefusal(text + " is not a size such as 300 x 200 mm; click corner 4 again");
      return;
    }
    size = text;
    double scale = 1.0 / PER_METRE.get(found.group(3));
    marking.set(false);
    files.get().ifPresent(file -> save(file, points(corners, width * scale, length * scale)));
  }

  private void save(Path file, List<PointPair> points) {
    List<?> list =
        points.stream()
            .map(
                p ->
                    new TreeMap<>(Map.of("xPx", p.xPx(), "yPx", p.yPx(), "xM", p.x(), "yM", p.y())))
            .toList();
    String text = Json.write(Map.of("points", list)) + "\n";
    String saved = SAVED.formatted(file.getFileName());
    window.save(() -> AtomicFile.write(file, text, true), saved);
  }
}
