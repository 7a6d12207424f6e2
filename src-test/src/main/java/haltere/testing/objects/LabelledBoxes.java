package haltere.testing.objects;

import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Boxes with identities that a person has labelled in a real recording: a table with the columns
 * t_us, x0_px, y0_px, x1_px, y1_px and id, y upwards. Without the column id there is one object.
 * The id {@code ignore} marks a region where tracks are neither right nor wrong.
 */
public final class LabelledBoxes {
  private LabelledBoxes() {}

  /**
   * Reads the labels of a recording.
   *
   * @param recording name of the recording's file
   * @return in the order of time
   * @throws IOException if there are no labels of it
   */
  public static List<TruthMoment> of(String recording) throws IOException {
    String name = recording + ".boxes.csv";
    try (InputStream labels = LabelledBoxes.class.getResourceAsStream(name)) {
      if (labels == null) {
        throw new FileNotFoundException("there are no labels " + name);
      }
      return read(new InputStreamReader(labels, StandardCharsets.UTF_8));
    }
  }

  /**
   * Reads a table of labels.
   *
   * @param text the table
   * @return in the order of time
   * @throws IOException if it cannot be read or lacks a column
   */
  public static List<TruthMoment> read(Reader text) throws IOException {
    Map<Long, List<TrueObject>> objects = new TreeMap<>();
    Map<Long, List<Box>> ignored = new TreeMap<>();
    CsvTable.read(
        text,
        List.of("t_us", "x0_px", "y0_px", "x1_px", "y1_px"),
        row -> {
          long timeUs = Long.parseLong(row.text("t_us"));
          objects.computeIfAbsent(timeUs, t -> new ArrayList<>());
          ignored.computeIfAbsent(timeUs, t -> new ArrayList<>());
          Box box =
              new Box(
                  row.number("x0_px"),
                  row.number("y0_px"),
                  row.number("x1_px"),
                  row.number("y1_px"));
          String id = row.text("id");
          if (id.equals("ignore")) {
            ignored.get(timeUs).add(box);
          } else {
            objects.get(timeUs).add(new TrueObject(id.isEmpty() ? 1 : Integer.parseInt(id), box));
          }
        });
    List<TruthMoment> moments = new ArrayList<>();
    objects.forEach((t, boxes) -> moments.add(new TruthMoment(t, boxes, ignored.get(t))));
    return moments;
  }
}
