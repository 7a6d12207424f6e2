package haltere.ui.viewer;

import atlantafx.base.theme.Styles;
import haltere.core.chain.ChainStage;
import haltere.core.chain.FilterProvider;
import haltere.core.chain.Filters;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import javafx.geometry.Pos;
import javafx.scene.control.CustomMenuItem;
import javafx.scene.control.Label;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.TextField;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;

/**
 * The chain: a card for each stage, in order, and a menu to add one.
 *
 * <p>Thread rule: JavaFX thread only.
 */
final class ChainPanel extends VBox {
  private final ChainEditor editor;
  private final VBox cards = new VBox();
  private final Label empty =
      new Label("No filters: events are shown as they come. Add one with the button above.");
  private final Map<ChainStage, StageCard> cardOf = new HashMap<>();
  private List<StageState> stages = List.of();
  private SettingsSearch search = SettingsSearch.ALL;

  ChainPanel(ChainEditor editor) {
    this.editor = editor;
    getStyleClass().add("chain-panel");
    setId("chain-panel");
    Label title = new Label("Filter chain");
    title.getStyleClass().add(Styles.TITLE_4);
    Region space = new Region();
    HBox.setHgrow(space, Priority.ALWAYS);
    HBox head = new HBox(title, space, addMenu());
    head.setAlignment(Pos.CENTER_LEFT);
    head.getStyleClass().add("chain-head");
    cards.getStyleClass().add("cards");
    empty.setWrapText(true);
    empty.getStyleClass().addAll(Styles.TEXT_MUTED, "chain-empty");
    SettingsSearchField searchField = new SettingsSearchField(this::narrow);
    editor.onSettings(
        (stage, settings) ->
            Optional.ofNullable(cardOf.get(stage)).ifPresent(card -> card.adopt(settings)));
    ScrollPane scroll = new ScrollPane(cards);
    scroll.setFitToWidth(true);
    scroll.setHbarPolicy(ScrollPane.ScrollBarPolicy.NEVER);
    VBox.setVgrow(scroll, Priority.ALWAYS);
    getChildren().addAll(head, searchField, scroll);
  }

  /** Shows a chain, keeping the cards of stages that were there. */
  void show(List<StageState> newStages) {
    stages = newStages;
    List<StageCard> order = new ArrayList<>();
    Map<ChainStage, StageCard> kept = new HashMap<>();
    for (StageState state : newStages) {
      StageCard card = cardOf.get(state.stage());
      if (card == null) {
        card = new StageCard(state, editor);
        card.narrow(search);
      }
      kept.put(state.stage(), card);
      order.add(card);
    }
    cardOf.clear();
    cardOf.putAll(kept);
    for (int i = 0; i < order.size(); i++) {
      order.get(i).setPlace(i == 0, i == order.size() - 1);
    }
    if (order.isEmpty()) {
      cards.getChildren().setAll(empty);
    } else {
      cards.getChildren().setAll(order);
    }
  }

  private void narrow(SettingsSearch newSearch) {
    search = newSearch;
    stages.forEach(state -> cardOf.get(state.stage()).narrow(search));
  }

  /** Shows what the stages do now; called a few times a second. */
  void update(long elapsedNanos) {
    for (StageState state : stages) {
      cardOf.get(state.stage()).update(elapsedNanos);
    }
  }

  private MenuButton addMenu() {
    MenuButton add = new MenuButton("Add", Icons.ADD.node());
    add.setId("add-filter");
    add.setAccessibleText("Add a filter");
    add.getStyleClass().addAll(Styles.SMALL, Styles.FLAT);
    TextField wanted = new TextField();
    wanted.setId("add-search");
    wanted.setPromptText("Search filters");
    wanted.setAccessibleText("Search filters");
    CustomMenuItem first = new CustomMenuItem(wanted, false);
    List<FilterItem> items =
        Filters.all().values().stream().map(found -> new FilterItem(found, editor)).toList();
    wanted
        .textProperty()
        .addListener((property, was, is) -> items.forEach(item -> item.narrow(is)));
    wanted.setOnAction(
        event -> {
          // Enter adds the first that is left
          items.stream().filter(MenuItem::isVisible).findFirst().ifPresent(MenuItem::fire);
          add.hide();
        });
    add.setOnShown(
        event -> {
          wanted.clear();
          wanted.requestFocus();
        });
    add.getItems().add(first);
    add.getItems().addAll(items);
    return add;
  }

  /** A filter to add, with what it does in a sentence. */
  private static final class FilterItem extends CustomMenuItem {
    private final String words;

    FilterItem(FilterProvider<?> provider, ChainEditor editor) {
      words =
          (Texts.title(provider.name()) + " " + provider.description()).toLowerCase(Locale.ROOT);
      Label name = new Label(Texts.title(provider.name()));
      name.getStyleClass().add(Styles.TEXT_BOLD);
      Label help = new Label(provider.description());
      help.setWrapText(true);
      help.setMaxWidth(300);
      help.getStyleClass().addAll(Styles.TEXT_SMALL, Styles.TEXT_MUTED);
      setContent(new VBox(2, name, help));
      setId("add-" + provider.name());
      setOnAction(event -> editor.add(provider));
    }

    void narrow(String wanted) {
      setVisible(words.contains(wanted.strip().toLowerCase(Locale.ROOT)));
    }
  }
}
