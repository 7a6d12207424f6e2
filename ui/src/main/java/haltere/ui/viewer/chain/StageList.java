package haltere.ui.viewer.chain;

import haltere.core.chain.ChainStage;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.FocusOrder;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import javafx.scene.Node;
import javafx.scene.input.DataFormat;
import javafx.scene.input.Dragboard;
import javafx.scene.input.TransferMode;
import javafx.scene.layout.VBox;

/** A card for each stage of a chain, in order. */
final class StageList extends VBox {
  /** Data of a drag: the path of the stage. */
  static final DataFormat STAGE = new DataFormat("application/x-haltere-stage");

  private final ChainEditor editor;
  private final Node empty;
  private final Map<ChainStage, StageCard> cards = new LinkedHashMap<>();

  /** The shown stages, including those about to be shown. */
  private List<StageState> wanted = List.of();

  private SettingsSearch search = SettingsSearch.ALL;
  private Executor steps = Runnable::run;

  /** A list without stages, which shows another node if empty. */
  StageList(ChainEditor editor, Node empty) {
    this.editor = editor;
    this.empty = empty;
    getStyleClass().add("cards");
    getChildren().add(empty);
    Controls.onDrop(
        this, TransferMode.MOVE, board -> dragged(board).filter(editor::takes), this::drop);
  }

  /** The path of the stage whose card is dragged. */
  static Optional<String> dragged(Dragboard board) {
    return board.getContent(STAGE) instanceof String path ? Optional.of(path) : Optional.empty();
  }

  /** The card of a path was dropped below all others. */
  void drop(String path) {
    editor.moveHere(path, Optional.empty());
  }

  /**
   * Shows another chain. Here and in later changes each new card takes a step, because creating and
   * styling one takes milliseconds.
   */
  void reset(List<StageState> stages, Executor newSteps) {
    steps = newSteps;
    wanted = stages;
    cards.clear();
    getChildren().clear();
    // all steps are queued now, so that later tasks find all cards
    for (int i = 0; i < Math.max(1, stages.size()); i++) {
      steps.execute(() -> grow(stages));
    }
  }

  /** Shows a chain, keeping the cards of stages that were there. */
  void show(List<StageState> stages) {
    wanted = stages;
    int more = (int) stages.stream().filter(state -> !cards.containsKey(state.stage())).count() - 1;
    grow(stages);
    for (int i = 0; i < more; i++) {
      steps.execute(() -> grow(stages));
    }
  }

  /** Shows the stages that have a card, and the first of those that have none. */
  private void grow(List<StageState> stages) {
    if (wanted != stages) {
      return;
    }
    List<StageState> now = new ArrayList<>();
    int made = 0;
    for (StageState state : stages) {
      if (cards.containsKey(state.stage()) || made++ == 0) {
        now.add(state);
      }
    }
    place(now);
  }

  private void place(List<StageState> stages) {
    Map<ChainStage, StageCard> before = Map.copyOf(cards);
    cards.clear();
    Optional<StageCard> above = Optional.empty();
    for (StageState state : stages) {
      StageCard card = before.get(state.stage());
      if (card == null) {
        card = new StageCard(state, editor);
        card.narrow(search);
      } else {
        card.followInside(state);
      }
      cards.put(state.stage(), card);
      card.setPosition(above, cards.size() == stages.size());
      above = Optional.of(card);
    }
    List<? extends Node> shown = cards.isEmpty() ? List.of(empty) : List.copyOf(cards.values());
    if (!getChildren().equals(shown)) {
      Node focus = getScene() == null ? null : getScene().getFocusOwner();
      boolean marked = focus != null && FocusOrder.isMarked(focus);
      getChildren().setAll(shown);
      // a moved card keeps the focus
      if (focus != null && focus.getScene() != null) {
        focus.requestFocus();
      }
      if (marked) {
        FocusOrder.mark(focus);
      }
    }
  }

  /** Shows settings that a filter was given. */
  void adopt(ChainStage of, Record settings) {
    cards.values().forEach(card -> card.adopt(of, settings));
  }

  /** Shows only matching settings; returns whether there are any. */
  boolean narrow(SettingsSearch newSearch) {
    search = newSearch;
    boolean any = false;
    for (StageCard card : cards.values()) {
      any |= card.narrow(search);
    }
    return any;
  }

  /** Shows the stages' present numbers; called a few times a second. */
  void update() {
    cards.values().forEach(StageCard::update);
  }
}
