package haltere.ui.viewer.chain;

import atlantafx.base.theme.Styles;
import haltere.ui.viewer.controls.Controls;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Executor;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.TextField;
import javafx.scene.control.ToggleButton;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;

/**
 * The chain: a card for each stage in order, a search in the settings, and a menu to add a stage.
 */
public final class ChainPanel extends VBox {
  private final StageList cards;
  private final TextField text = Controls.named(new TextField(), "settings-search", Styles.SMALL);
  private final ToggleButton changedOnly =
      Controls.named(new ToggleButton("Changed"), "changed-only", Styles.SMALL);
  private final Label nothing =
      Controls.named(
          new Label("No setting matches."), "settings-none", Styles.TEXT_MUTED, "settings-none");

  /** A panel without stages; changes go to an editor. */
  public ChainPanel(ChainEditor editor) {
    Controls.named(this, "chain-panel", "chain-panel");
    Label title = Controls.label("Chain", Styles.TITLE_4);
    Region space = Controls.growing(new Region());
    HBox head =
        Controls.row(0, title, space, new AddFilterMenu("add-filter", "Add a filter", editor));
    head.getStyleClass().addAll("chain-head");
    Label empty =
        Controls.paragraph(
            "No filters: events are shown as they come. Add one with the button above, or press"
                + " Denoise, Track objects or Track wings beside the picture.",
            Styles.TEXT_MUTED,
            "chain-empty");
    cards = new StageList(editor, empty);
    HBox search = Controls.named(Controls.row(6, text, changedOnly), null, "settings-search");
    text.setPromptText("Search settings");
    text.setAccessibleText("Search settings");
    Controls.growing(text);
    text.textProperty().subscribe(this::narrow);
    changedOnly.setMinWidth(Region.USE_PREF_SIZE);
    changedOnly.setAccessibleText("Only the settings that I changed");
    Controls.help(changedOnly, "Only the settings that are not at their defaults");
    changedOnly.selectedProperty().subscribe(this::narrow);
    narrow();
    editor.onSettings(cards::adopt);
    editor.onStages(cards::show);
    ScrollPane scroll = Controls.scrolling(cards);
    VBox.setVgrow(scroll, Priority.ALWAYS);
    getChildren().addAll(head, search, nothing, scroll);
  }

  private void narrow() {
    SettingsSearch search =
        new SettingsSearch(
            text.getText().strip().toLowerCase(Locale.ROOT), changedOnly.isSelected());
    Controls.show(!cards.narrow(search) && search.isActive(), nothing);
  }

  /** Shows another chain; many new stages take a step each. */
  public void reset(List<StageState> stages, Executor steps) {
    cards.reset(stages, steps);
  }

  /** Shows the stages' present numbers; called a few times a second. */
  public void update() {
    cards.update();
  }
}
