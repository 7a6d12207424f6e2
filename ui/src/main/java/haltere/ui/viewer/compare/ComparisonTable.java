package haltere.ui.viewer.compare;

import atlantafx.base.theme.Styles;
import haltere.ui.plot.PlotField;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.Texts;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import javafx.geometry.HPos;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.layout.ColumnConstraints;
import javafx.scene.layout.GridPane;
import javafx.scene.layout.Priority;

/** The published numbers of two chains side by side: means, and the difference. */
final class ComparisonTable extends ScrollPane {
  /** A line of the table, below the heading of its outlet. */
  record ComparisonLine(
      String group, String field, String first, String second, String difference) {}

  private final GridPane grid = new GridPane(6, 0);

  ComparisonTable() {
    setAccessibleText("Published numbers of both chains");
    setFitToWidth(true);
    Controls.named(this, "comparison", "comparison");
    ColumnConstraints names = new ColumnConstraints();
    names.setHgrow(Priority.ALWAYS);
    names.setMinWidth(72);
    ColumnConstraints numbers =
        new ColumnConstraints(USE_PREF_SIZE, USE_COMPUTED_SIZE, USE_PREF_SIZE);
    numbers.setHalignment(HPos.RIGHT);
    grid.getColumnConstraints().addAll(names, numbers, numbers, numbers);
    setContent(grid);
    show(List.of());
  }

  /** The lines of two sets of means; a number of only one chain has no difference. */
  static List<ComparisonLine> lines(Map<PlotField, Double> first, Map<PlotField, Double> second) {
    Set<PlotField> fields = new LinkedHashSet<>(first.keySet());
    fields.addAll(second.keySet());
    List<ComparisonLine> lines = new ArrayList<>();
    for (PlotField field : fields) {
      Double a = first.get(field);
      Double b = second.get(field);
      String group = Texts.title(field.stage()) + ": " + field.outlet().replace('-', ' ');
      String unit = field.unit().isEmpty() ? "" : ", " + field.unit();
      lines.add(
          new ComparisonLine(group, field.label() + unit, number(a), number(b), difference(a, b)));
    }
    return lines;
  }

  private static String number(Double value) {
    return value == null ? "\u2013" : Texts.number(value);
  }

  private static String difference(Double first, Double second) {
    if (first == null || second == null) {
      return "";
    }
    if (first.equals(second)) {
      return "same";
    }
    return first == 0
        ? Texts.number(second)
        : String.format(Locale.ROOT, "%+.2f %%", 100 * (second - first) / Math.abs(first));
  }

  /** Replaces the shown lines. */
  void show(List<ComparisonLine> lines) {
    grid.getChildren().clear();
    grid.addRow(0, heading("Mean"), heading("First"), heading("Second"), heading("Differs"));
    if (lines.isEmpty()) {
      grid.add(small("No filter has published numbers yet."), 0, 1, 4, 1);
    }
    String group = "";
    int row = 1;
    for (ComparisonLine line : lines) {
      if (!line.group().equals(group)) {
        group = line.group();
        grid.add(heading(group), 0, row++, 4, 1);
      }
      grid.addRow(
          row++,
          small(line.field()),
          small(line.first()),
          small(line.second()),
          small(line.difference()));
    }
  }

  private static Label heading(String text) {
    return Controls.label(text, Styles.TEXT_SMALL, Styles.TEXT_BOLD);
  }

  private static Label small(String text) {
    return Controls.label(text, Styles.TEXT_SMALL);
  }
}
