package haltere.ui.viewer.chain;

import atlantafx.base.controls.ToggleSwitch;
import atlantafx.base.theme.Styles;
import atlantafx.base.theme.Tweaks;
import haltere.core.chain.ChainStage;
import haltere.core.chain.FilterChain;
import haltere.core.chain.FilterTiming;
import haltere.core.chain.Filters;
import haltere.ui.command.terminal.Quantities;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.Icons;
import haltere.ui.viewer.controls.Texts;
import java.util.Optional;
import javafx.css.PseudoClass;
import javafx.scene.AccessibleRole;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.input.ClipboardContent;
import javafx.scene.input.Dragboard;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.TransferMode;
import javafx.scene.layout.HBox;
import javafx.scene.layout.VBox;

/** One stage of the chain: its switch, its effect on the stream, its position, its settings. */
final class StageCard extends VBox {
  private static final PseudoClass TARGET = PseudoClass.getPseudoClass("target");
  private static final PseudoClass OFF = PseudoClass.getPseudoClass("off");

  private final ChainStage stage;
  private final String id;
  private final ToggleSwitch power = new ToggleSwitch();
  private final Label counts = new Label("\u2013");
  private final MenuItem up;
  private final MenuItem down;
  private final MenuItem into;
  private final Button expand;
  private final Optional<StageList> inside;
  private final ChainEditor editor;
  private Optional<SettingsPanel<?>> settings = Optional.empty();

  /** The present settings; empty for a filter without settings. */
  private Optional<Record> inForce;

  private SettingsSearch search = SettingsSearch.ALL;
  private FilterTiming last;
  private boolean followingStage;
  private Optional<StageList> chainAbove = Optional.empty();

  StageCard(StageState state, ChainEditor editor) {
    this.editor = editor;
    stage = state.stage();
    last = stage.timing();
    id = editor.path(stage).replace('/', '-');
    String title = Texts.title(stage.name());
    Controls.named(this, "stage-" + id, "stage");
    inForce = state.settings().filter(found -> found.getClass().getRecordComponents().length > 0);
    up = item("up-", "Move up   (Ctrl+Shift+\u2191)", () -> editor.move(stage, -1));
    down = item("down-", "Move down   (Ctrl+Shift+\u2193)", () -> editor.move(stage, 1));
    into =
        item(
            "into-",
            "Move into the chain above",
            () -> chainAbove.ifPresent(list -> list.drop(editor.path(stage))));
    expand =
        Controls.button(
            "expand-" + id,
            Icons.RIGHT,
            "Settings of " + title,
            this::toggleSettings,
            Styles.SMALL);
    inside =
        stage.filter() instanceof FilterChain ? Optional.of(insideOf(state)) : Optional.empty();
    expand.setVisible(inForce.isPresent() || inside.isPresent());
    setUpPower(title);
    Controls.named(counts, "counts-" + id, Styles.TEXT_SMALL, "stage-counts");
    Controls.help(counts, "Share of events that the filter passes, and its mean time per event");
    HBox head = Controls.row(2, expand, name(title), more(title), power);
    takePart(head);
    head.getStyleClass().add("stage-head");
    setOnKeyPressed(this::moveByKey);
    getChildren().addAll(head, counts);
    inside.ifPresent(
        list -> {
          getChildren().add(list.getParent());
          showInside(true);
        });
  }

  private Label name(String title) {
    Label name = Controls.paragraph(title, Styles.TEXT_BOLD);
    Controls.help(name, description());
    return Controls.growing(name);
  }

  private void setUpPower(String title) {
    power.setId("power-" + id);
    power.setAccessibleText(title + " on or off");
    power.setAccessibleRole(AccessibleRole.TOGGLE_BUTTON);
    power.setSelected(stage.isEnabled());
    power
        .selectedProperty()
        .subscribe(
            (was, is) -> {
              pseudoClassStateChanged(OFF, !is);
              if (!followingStage) {
                editor.setEnabled(stage, is);
              }
            });
    pseudoClassStateChanged(OFF, !stage.isEnabled());
  }

  /** The menu that moves and removes the stage. */
  private MenuButton more(String title) {
    MenuButton more = new MenuButton("", Icons.MORE.node(), up, down, into);
    if (editor.isInside()) {
      more.getItems().add(item("out-", "Move out of its chain", () -> editor.moveOut(stage)));
    }
    more.getItems().add(item("remove-", "Remove", () -> editor.remove(stage)));
    if (stage.filter() instanceof FilterChain) {
      more.getItems().add(presets(editor.inside(stage)));
    }
    more.setId("more-" + id);
    more.setAccessibleText("Move or remove " + title);
    Controls.help(more, "Move or remove");
    more.getStyleClass().addAll(Styles.BUTTON_ICON, Styles.FLAT, Styles.SMALL, Tweaks.NO_ARROW);
    return more;
  }

  /** Saves the nested chain as a preset, or replaces it by a preset. */
  private Menu presets(ChainEditor inner) {
    Menu menu = new Menu("Presets");
    menu.setId("presets-" + id);
    Runnable follow = () -> menu.getItems().setAll(inner.presets().apply(menu.getId(), inner));
    // a menu without items never opens
    follow.run();
    menu.setOnShowing(event -> follow.run());
    return menu;
  }

  /** The stages of a chain inside the chain, and a menu to add one. */
  private StageList insideOf(StageState state) {
    ChainEditor inner = editor.inside(stage);
    Label empty = Controls.label("No filters yet.", Styles.TEXT_MUTED);
    StageList list = new StageList(inner, empty);
    list.show(state.inside());
    new VBox(
            list,
            new AddFilterMenu(
                "add-filter-" + id, "Add a filter to " + Texts.title(stage.name()), inner))
        .getStyleClass()
        .add("stages-inside");
    return list;
  }

  /** Shows the present stages of a nested chain. */
  void followInside(StageState state) {
    inside.ifPresent(list -> list.show(state.inside()));
  }

  /** Says which cards are before and behind this one, if any. */
  void setPosition(Optional<StageCard> before, boolean lastOne) {
    up.setDisable(before.isEmpty());
    down.setDisable(lastOne);
    chainAbove = before.flatMap(card -> card.inside);
    into.setDisable(chainAbove.isEmpty());
  }

  private void moveByKey(KeyEvent event) {
    boolean isUp = event.getCode() == KeyCode.UP;
    if (event.isShortcutDown()
        && event.isShiftDown()
        && (isUp || event.getCode() == KeyCode.DOWN)) {
      editor.move(stage, isUp ? -1 : 1);
      event.consume();
    }
  }

  /** Shows the stage's numbers since the last call. */
  void update() {
    inside.ifPresent(StageList::update);
    if (power.isSelected() != stage.isEnabled()) {
      // the player has disabled a failed filter, or a change is pending
      followingStage = true;
      power.setSelected(stage.isEnabled());
      followingStage = false;
    }
    FilterTiming now = stage.timing();
    FilterTiming since = now.since(last);
    last = now;
    if (!stage.isEnabled()) {
      counts.setText("off");
    } else if (since.eventsIn() == 0) {
      counts.setText("idle");
    } else {
      counts.setText(
          Quantities.text(
              "%d %% of events pass \u00b7 %s ns/ev",
              Math.round(100.0 * since.eventsOut() / since.eventsIn()),
              Texts.digits(since.microsPerThousandEvents())));
    }
  }

  private void toggleSettings() {
    if (inside.isPresent()) {
      showInside(!inside.get().getParent().isVisible());
    } else {
      showSettings(!settings.map(Node::isVisible).orElse(false));
    }
  }

  private void showInside(boolean show) {
    Controls.show(show, inside.orElseThrow().getParent());
    expand.setRotate(show ? 90 : 0);
  }

  private void showSettings(boolean show) {
    if (settings.isEmpty() && show && inForce.isPresent()) {
      // only on request: styling dozens of controls takes time
      SettingsPanel<?> made = SettingsPanel.of(stage, inForce.get(), editor);
      made.narrow(search);
      getChildren().add(made);
      settings = Optional.of(made);
    }
    settings.ifPresent(panel -> Controls.show(show, panel));
    expand.setRotate(show ? 90 : 0);
  }

  /** Shows settings that a filter was given, if it is this one's. */
  void adopt(ChainStage of, Record newSettings) {
    inside.ifPresent(list -> list.adopt(of, newSettings));
    if (of == stage) {
      inForce = Optional.of(newSettings);
      settings.ifPresent(panel -> panel.adopt(newSettings));
    }
  }

  /**
   * Shows those settings only that are searched for; without a search as it was. False if nothing
   * of the card is shown.
   */
  boolean narrow(SettingsSearch newSearch) {
    boolean wasActive = search.isActive();
    search = newSearch;
    boolean any = true;
    if (inside.isPresent()) {
      any = inside.get().narrow(search) || !search.isActive();
    } else if (search.isActive()) {
      showSettings(true);
      any = settings.map(panel -> panel.narrow(search) > 0).orElse(false);
    } else if (wasActive) {
      settings.ifPresent(panel -> panel.narrow(search));
      showSettings(false);
    }
    Controls.show(any, this);
    return any;
  }

  /** Makes the card draggable to the position of another one. */
  private void takePart(Node handle) {
    handle.setOnDragDetected(
        event -> {
          ClipboardContent content = new ClipboardContent();
          content.put(StageList.STAGE, editor.path(stage));
          handle.startDragAndDrop(TransferMode.MOVE).setContent(content);
          event.consume();
        });
    Controls.onDrop(this, TransferMode.MOVE, this::dragged, this::drop);
    setOnDragEntered(
        event -> pseudoClassStateChanged(TARGET, dragged(event.getDragboard()).isPresent()));
    setOnDragExited(event -> pseudoClassStateChanged(TARGET, false));
  }

  /** The path of the dragged card, if it may be dropped here. */
  private Optional<String> dragged(Dragboard board) {
    return StageList.dragged(board).filter(this::accepts);
  }

  /** Whether the card of a path may be dropped on this one. */
  boolean accepts(String path) {
    return editor.takes(path);
  }

  /** The card of a path was dropped on this one. */
  void drop(String path) {
    editor.moveHere(path, Optional.of(stage));
  }

  private String description() {
    if (stage.filter() instanceof FilterChain) {
      return "A chain inside the chain.";
    }
    var provider = Filters.all().get(stage.kind());
    return provider == null ? stage.kind() : provider.description();
  }

  private MenuItem item(String action, String text, Runnable work) {
    return Controls.item(action + id, text, work);
  }
}
