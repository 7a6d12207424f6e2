package haltere.ui.viewer.wings;

import atlantafx.base.theme.Styles;
import haltere.filters.wing.WingFilterState;
import haltere.filters.wing.WingOutputSettings;
import haltere.filters.wing.WingPart;
import haltere.ui.viewer.controls.Controls;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.CheckBox;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.VBox;

/** The wing tracker's filters: their edges, and the numbers of each filter, live. */
final class WingsPanel extends ScrollPane {
  private static final Set<WingPart> EDGES =
      EnumSet.range(WingPart.LEFT_LEADING, WingPart.RIGHT_TRAILING);

  private static final double CHOICE_WIDTH = 130;

  /** Room beside the text: margins and scroll bar. */
  private static final double MARGIN = 40;

  private final WingsFeature wings;
  private final ChoiceBox<WingPart> choice =
      Controls.named(new ChoiceBox<WingPart>(), "wings-filter");
  private final List<CheckBox> edges = EDGES.stream().map(this::edge).toList();
  private final Label empty = Controls.paragraph("", Styles.TEXT_MUTED);
  private final Label search =
      Controls.named(Controls.paragraph(""), "wings-search", Styles.TEXT_SMALL);
  private final VBox body = new VBox(8);
  private Optional<FilterTables> tables = Optional.empty();

  /** A panel without filters, below some buttons; the feature gets the user's requests. */
  WingsPanel(List<Button> buttons, WingsFeature wings) {
    this.wings = wings;
    setId("wings-panel");
    setFitToWidth(true);
    choice.setAccessibleText("Which filter is shown");
    choice.setMinWidth(CHOICE_WIDTH);
    choice.setOnAction(event -> tables.ifPresent(shown -> rebuild()));
    Button restart =
        Controls.button(
            "wings-restart",
            "Reset filter",
            "Restarts the filter at its state, with the initial covariance and the noise of the settings",
            () -> Optional.ofNullable(choice.getValue()).ifPresent(wings::restart),
            Styles.SMALL);
    FlowPane head = new FlowPane(6, 6, buttons.toArray(Node[]::new));
    FlowPane taken = new FlowPane(10, 4, edges.toArray(Node[]::new));
    FlowPane chosen = new FlowPane(6, 6, choice, restart);
    body.getStyleClass().add("settings");
    // tables may be wider than the panel, text wraps
    search.maxWidthProperty().bind(widthProperty().subtract(MARGIN));
    body.getChildren().addAll(head, search, taken, chosen, empty);
    setContent(body);
    show(Optional.empty());
  }

  private CheckBox edge(WingPart part) {
    CheckBox box =
        Controls.named(new CheckBox(part.toString()), "wings-edge-" + part, Styles.TEXT_SMALL);
    box.setOnAction(event -> wings.takeEdge(part, box.isSelected()));
    return box;
  }

  /** Shows the present state of the tracker. */
  void show(Optional<WingsView> now) {
    List<WingFilterState> filters = now.map(WingsView::filters).orElse(List.of());
    now.ifPresent(view -> showEdges(view.settings().output()));
    search.setText(now.map(SearchText::of).orElse(""));
    body.getChildren().forEach(part -> Controls.show(now.isPresent(), part));
    List<WingPart> parts = filters.stream().map(WingFilterState::part).toList();
    if (!choice.getItems().equals(parts)) {
      WingPart before = choice.getValue();
      choice.getItems().setAll(parts);
      choice.setValue(parts.contains(before) ? before : parts.isEmpty() ? null : parts.get(0));
    }
    empty.setText(
        now.isEmpty()
            ? "There is no wing tracker in the chain. Press Track wings beside the picture."
                + " Then the state, the covariance and the noise of each wing are shown here."
            : filters.isEmpty() ? "No Kalman filter tracks a wing now." : "");
    Controls.show(!empty.getText().isEmpty(), empty);
    filters.stream()
        .filter(filter -> filter.part() == choice.getValue())
        .findFirst()
        .ifPresentOrElse(this::showTables, this::rebuild);
  }

  private void showEdges(WingOutputSettings output) {
    boolean[] on = {
      output.leftLeading(), output.leftTrailing(), output.rightLeading(), output.rightTrailing()
    };
    for (int i = 0; i < on.length; i++) {
      edges.get(i).setSelected(on[i]);
    }
  }

  private void showTables(WingFilterState filter) {
    if (tables.isEmpty() || !tables.get().suits(filter)) {
      rebuild();
      FilterTables made = new FilterTables(filter, wings::edit);
      tables = Optional.of(made);
      body.getChildren().add(made);
    } else {
      tables.get().show(filter);
    }
  }

  /** Rebuilds the tables for a new filter. */
  private void rebuild() {
    tables.ifPresent(shown -> body.getChildren().remove(shown));
    tables = Optional.empty();
  }
}
