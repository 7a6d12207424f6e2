package haltere.ui.viewer;

import atlantafx.base.controls.ToggleSwitch;
import atlantafx.base.theme.Styles;
import atlantafx.base.theme.Tweaks;
import haltere.core.chain.ChainStage;
import haltere.core.chain.FilterChain;
import haltere.core.chain.FilterTiming;
import haltere.core.chain.Filters;
import java.util.Optional;
import java.util.function.Supplier;
import javafx.css.PseudoClass;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;

/**
 * One stage of the chain: its switch, what it does to the stream, its place, its settings.
 *
 * <p>Thread rule: JavaFX thread only.
 */
final class StageCard extends VBox {
  private static final PseudoClass OFF = PseudoClass.getPseudoClass("off");

  private final ChainStage stage;
  private final ToggleSwitch power = new ToggleSwitch();
  private final Label counts = new Label();
  private final MenuItem up;
  private final MenuItem down;
  private final Button expand;
  private final Supplier<Node> settingsMaker;
  private Node settings;
  private FilterTiming last;
  private boolean followingStage;

  StageCard(StageState state, ChainEditor editor) {
    stage = state.stage();
    last = stage.timing();
    String title = Texts.title(stage.name());
    getStyleClass().add("stage");
    setId("stage-" + stage.name());
    Optional<Record> record =
        state.settings().filter(found -> found.getClass().getRecordComponents().length > 0);
    settingsMaker = () -> SettingsPanel.of(stage, record.orElseThrow(), editor);
    Label name = new Label(title);
    name.getStyleClass().add(Styles.TEXT_BOLD);
    name.setMaxWidth(Double.MAX_VALUE);
    name.setMinWidth(0);
    String help = description();
    Controls.help(name, help);
    HBox.setHgrow(name, Priority.ALWAYS);
    power.setId("power-" + stage.name());
    power.setAccessibleText(title + " on or off");
    power.setSelected(stage.isEnabled());
    power
        .selectedProperty()
        .addListener(
            (property, was, is) -> {
              pseudoClassStateChanged(OFF, !is);
              if (!followingStage) {
                editor.setEnabled(stage, is);
              }
            });
    pseudoClassStateChanged(OFF, !stage.isEnabled());
    up = item("up-", "Move up", () -> editor.move(stage, -1));
    down = item("down-", "Move down", () -> editor.move(stage, 1));
    MenuButton more = new MenuButton("", Icons.MORE.node(), up, down);
    more.getItems().add(item("remove-", "Remove", () -> editor.remove(stage)));
    more.setId("more-" + stage.name());
    more.setAccessibleText("Move or remove " + title);
    Controls.help(more, "Move or remove");
    more.getStyleClass().addAll(Styles.BUTTON_ICON, Styles.FLAT, Styles.SMALL, Tweaks.NO_ARROW);
    expand =
        Controls.button(
            "expand-" + stage.name(), Icons.RIGHT, "Settings of " + title, this::toggleSettings);
    expand.getStyleClass().add(Styles.SMALL);
    expand.setVisible(record.isPresent());
    HBox head = new HBox(2, expand, name, more, power);
    head.setAlignment(Pos.CENTER_LEFT);
    head.getStyleClass().add("stage-head");
    counts.setId("counts-" + stage.name());
    counts.getStyleClass().addAll(Styles.TEXT_SMALL, "stage-counts");
    Controls.help(
        counts,
        "Events into and out of the filter per second of real time, the share that it lets"
            + " through, and what a thousand events cost");
    counts.setText("\u2013");
    getChildren().addAll(head, counts);
  }

  /** Says whether the stage is the first, the last or both. */
  void setPlace(boolean first, boolean lastOne) {
    up.setDisable(first);
    down.setDisable(lastOne);
  }

  /** Shows what the stage did since the last call. */
  void update(long elapsedNanos) {
    if (power.isSelected() != stage.isEnabled() && elapsedNanos > 0) {
      followStage();
    }
    FilterTiming now = stage.timing();
    FilterTiming since = now.since(last);
    last = now;
    if (!stage.isEnabled()) {
      counts.setText("off");
    } else if (since.eventsIn() == 0) {
      counts.setText("no events");
    } else {
      double seconds = elapsedNanos / 1e9;
      counts.setText(
          Texts.quantity(since.eventsIn() / seconds)
              + " \u2192 "
              + Texts.quantity(since.eventsOut() / seconds)
              + " ev/s  \u00b7  "
              + Math.round(100.0 * since.eventsOut() / since.eventsIn())
              + " %  \u00b7  "
              + Texts.digits(since.microsPerThousandEvents())
              + " \u00b5s/kev");
    }
  }

  /** The player has switched a filter off that failed, or a switch is still under way. */
  private void followStage() {
    followingStage = true;
    power.setSelected(stage.isEnabled());
    followingStage = false;
  }

  private void toggleSettings() {
    if (settings == null) {
      // not before they are asked for: styling some dozen controls takes time
      settings = settingsMaker.get();
      settings.setVisible(false);
      getChildren().add(settings);
    }
    boolean show = !settings.isVisible();
    settings.setVisible(show);
    settings.setManaged(show);
    expand.setRotate(show ? 90 : 0);
  }

  private String description() {
    if (stage.filter() instanceof FilterChain) {
      return "A chain inside the chain.";
    }
    var provider = Filters.all().get(stage.kind());
    return provider == null ? stage.kind() : provider.description();
  }

  private MenuItem item(String id, String words, Runnable action) {
    MenuItem item = new MenuItem(words);
    item.setId(id + stage.name());
    item.setOnAction(event -> action.run());
    return item;
  }
}
