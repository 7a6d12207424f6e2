package haltere.ui.viewer.wings;

import atlantafx.base.theme.Styles;
import haltere.core.settings.Parameter;
import haltere.filters.wing.WingFilterEdit;
import haltere.filters.wing.WingFilterEdit.Table;
import haltere.filters.wing.WingFilterState;
import haltere.filters.wing.WingFilterState.Source;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.Texts;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.ToDoubleFunction;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Hyperlink;
import javafx.scene.control.Label;
import javafx.scene.control.TextField;
import javafx.scene.layout.ColumnConstraints;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.GridPane;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;

/**
 * State x with standard deviations, process noise Q, measurement noise R and covariance P of one
 * Kalman filter, live. Of P, the column of one state is shown. An edited entry is fixed until Enter
 * applies it or Escape discards it. A button beside a noise switches between adaptive and manual.
 */
final class FilterTables extends VBox {
  private static final MathContext FOUR_DIGITS = new MathContext(4);
  private static final MathContext TWO_DIGITS = new MathContext(2);
  private static final double MIN_PLAIN = 1e-3;

  /** Room for "-0.001234" and "-1.23e-05". */
  private static final double NUMBER_WIDTH = 62;

  private static final double NAME_WIDTH = 64;
  private static final double MAX_PLAIN = 1e6;

  private static final Map<Source, String> SOURCES =
      Map.of(Source.SETTINGS, "", Source.ESTIMATOR, "adaptive", Source.MANUAL, "manual");

  private final Consumer<WingFilterEdit> edited;

  /** Updaters of the numbers; those of the selected column of P come last. */
  private final List<Consumer<WingFilterState>> numbers = new ArrayList<>();

  private final int fixedNumbers;
  private final ChoiceBox<String> column;
  private final Label summary =
      Controls.named(new Label(), "filter-summary", Styles.TEXT_SMALL, Styles.TEXT_MUTED);
  private WingFilterState shown;

  /** Tables of a filter; the consumer gets manual changes. */
  FilterTables(WingFilterState first, Consumer<WingFilterEdit> edited) {
    this.edited = edited;
    setSpacing(6);
    getStyleClass().add("filter-tables");
    setAccessibleText("State and noise of the filter");
    shown = first;
    column =
        Controls.choice(
            "covariance-column",
            "State whose column of the covariance is shown",
            first.names(),
            name -> name);
    // its longest name is wider than the tables
    column.setPrefWidth(2 * NUMBER_WIDTH);
    column.getSelectionModel().select(0);
    column.setOnAction(event -> showColumn());
    FlowPane title = new FlowPane(6, 0, heading("Covariance P with"), column);
    title.setAlignment(Pos.CENTER_LEFT);
    Node states = states(first);
    fixedNumbers = numbers.size();
    getChildren().addAll(summary, states, title, covariance(0));
    show(first);
  }

  private static Label heading(String text) {
    return Controls.whole(text, Styles.TEXT_SMALL, Styles.TEXT_BOLD);
  }

  /** Columns of names, entries and derived numbers. */
  private static List<ColumnConstraints> columns() {
    ColumnConstraints names = new ColumnConstraints(NAME_WIDTH, NAME_WIDTH, Double.MAX_VALUE);
    names.setHgrow(Priority.ALWAYS);
    return List.of(names, new ColumnConstraints(NUMBER_WIDTH), new ColumnConstraints());
  }

  private static Label name(String text) {
    return Controls.paragraph(text, Styles.TEXT_SMALL);
  }

  private Label derived(ToDoubleFunction<WingFilterState> number) {
    Label label = Controls.whole("", Styles.TEXT_SMALL, Styles.TEXT_MUTED);
    numbers.add(now -> label.setText(text(number.applyAsDouble(now), TWO_DIGITS)));
    return label;
  }

  private static double sd(WingFilterState f, int i) {
    return Math.sqrt(Math.max(0, f.value(Table.COVARIANCE, i, i)));
  }

  private Node states(WingFilterState f) {
    GridPane grid = new GridPane(4, 3);
    grid.getColumnConstraints().addAll(columns());
    grid.getColumnConstraints().add(new ColumnConstraints(NUMBER_WIDTH));
    grid.addRow(0, heading("State"), heading("x"), heading("\u00b1 SD"), heading("Q"));
    for (int i = 0; i < f.names().size(); i++) {
      int row = i;
      Node noise = noise(Table.PROCESS_NOISE, i, f.qUnits().get(i));
      grid.addRow(
          i + 1,
          name(f.names().get(i) + ", " + f.units().get(i)),
          cell(Table.STATE, i, 0),
          derived(now -> sd(now, row)),
          noise);
    }
    int last = f.names().size() + 1;
    grid.add(name("measurement R"), 0, last);
    grid.add(noise(Table.MEASUREMENT_NOISE, 0, "rad\u00b2"), 3, last);
    return grid;
  }

  /** An entry of the noise, with its unit and its source below. */
  private Node noise(Table table, int row, String unit) {
    Label label = Controls.whole(unit, Styles.TEXT_SMALL, Styles.TEXT_MUTED);
    return new VBox(cell(table, row, 0), new FlowPane(4, 0, label, source(table, row)));
  }

  private Hyperlink source(Table table, int row) {
    Hyperlink button =
        Controls.named(
            new Hyperlink(), "source-" + Parameter.text(table) + "-" + row, Styles.TEXT_SMALL);
    button.setAccessibleText("Source of " + name(table, row, 0));
    Controls.help(
        button,
        "Adaptive: a click fixes the present number. Manual: a click returns the number to"
            + " the estimator or to the settings.");
    button.setOnAction(
        event -> {
          boolean manual = shown.source(table, row) == Source.MANUAL;
          double value = manual ? Double.NaN : shown.value(table, row, 0);
          edited.accept(new WingFilterEdit(shown.part(), table, row, 0, value));
        });
    numbers.add(
        now -> {
          String text = SOURCES.get(now.source(table, row));
          button.setText(text);
          Controls.show(!text.isEmpty(), button);
        });
    return button;
  }

  /** Shows the column of P of the selected state. */
  private void showColumn() {
    numbers.subList(fixedNumbers, numbers.size()).clear();
    getChildren()
        .set(getChildren().size() - 1, covariance(column.getSelectionModel().getSelectedIndex()));
    show(shown);
  }

  private Node covariance(int chosen) {
    GridPane grid = new GridPane(4, 3);
    grid.getColumnConstraints().addAll(columns());
    grid.addRow(0, heading("State"), heading("P"), heading("Correlation"));
    for (int i = 0; i < shown.names().size(); i++) {
      int row = i;
      String unit = shown.units().get(i) + " \u00b7 " + shown.units().get(chosen);
      grid.addRow(
          i + 1,
          name(shown.names().get(i) + ", " + unit),
          cell(Table.COVARIANCE, i, chosen),
          derived(
              now -> now.value(Table.COVARIANCE, row, chosen) / (sd(now, row) * sd(now, chosen))));
    }
    return grid;
  }

  private TextField cell(Table table, int row, int column) {
    String id = Parameter.text(table) + "-" + row + "-" + column;
    TextField entry = Controls.entry(id, name(table, row, column), 6);
    entry.setOnAction(event -> take(entry, table, row, column));
    Controls.onEscape(
        entry,
        () -> {
          requestFocus();
          show(shown);
        });
    numbers.add(
        now -> {
          if (!entry.isFocused()) {
            entry.setText(text(now.value(table, row, column), FOUR_DIGITS));
          }
        });
    return entry;
  }

  private String name(Table table, int row, int column) {
    String state = table == Table.MEASUREMENT_NOISE ? "" : shown.names().get(row);
    return switch (table) {
      case STATE -> "State: " + state;
      case PROCESS_NOISE -> "Process noise of " + state;
      case COVARIANCE -> "Covariance of " + state + " and " + shown.names().get(column);
      case MEASUREMENT_NOISE -> "Measurement noise";
    };
  }

  private void take(TextField entry, Table table, int row, int column) {
    try {
      double value = Double.parseDouble(entry.getText().trim());
      edited.accept(new WingFilterEdit(shown.part(), table, row, column, value));
    } catch (IllegalArgumentException notOne) {
      entry.setText(text(shown.value(table, row, column), FOUR_DIGITS));
    }
    setFocusTraversable(true);
    requestFocus();
  }

  /** Whether it has the entries for a filter. */
  boolean suits(WingFilterState f) {
    return f.part() == shown.part() && f.names().equals(shown.names());
  }

  /** Shows the present numbers. */
  void show(WingFilterState now) {
    shown = now;
    numbers.forEach(number -> number.accept(now));
    summary.setText(
        Texts.count(now.events())
            + " events   NIS "
            + String.format(Locale.ROOT, "%.2f", now.nis()));
  }

  /** Few digits, so that the columns of the panel hold them. */
  private static String text(double value, MathContext digits) {
    if (!Double.isFinite(value)) {
      return String.valueOf(value);
    }
    double size = Math.abs(value);
    return size > 0 && size < MIN_PLAIN || size >= MAX_PLAIN
        ? String.format(Locale.ROOT, "%." + digits.getPrecision() / 2 + "e", value)
        : new BigDecimal(value).round(digits).stripTrailingZeros().toPlainString();
  }
}
