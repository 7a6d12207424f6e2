package haltere.ui.viewer.controls;

import atlantafx.base.theme.Styles;
import java.util.Collection;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import javafx.beans.value.ObservableBooleanValue;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.ButtonBase;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Label;
import javafx.scene.control.MenuItem;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.Slider;
import javafx.scene.control.TextField;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.Tooltip;
import javafx.scene.input.Dragboard;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseEvent;
import javafx.scene.input.TransferMode;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import javafx.scene.shape.Rectangle;
import javafx.util.Duration;
import javafx.util.StringConverter;

/** Creates the window's controls in one style, with tooltips and names for screen readers. */
public final class Controls {
  private static final String HELP = "haltere.help";
  private static final String TOOLTIP = "haltere.tooltip";

  private Controls() {}

  /**
   * A button with an icon.
   *
   * @param id by which style sheet and tests find it
   * @param help its tooltip, and its name for screen readers
   * @param action runs when it is pressed
   */
  public static Button button(
      String id, Icons icon, String help, Runnable action, String... styles) {
    Button button = new Button();
    dress(button, id, icon, help, styles);
    button.setOnAction(event -> action.run());
    return button;
  }

  /** A switch with an icon, as {@link #button}. */
  public static ToggleButton toggle(String id, Icons icon, String help, String... styles) {
    ToggleButton button = new ToggleButton();
    dress(button, id, icon, help, styles);
    return button;
  }

  /** A button with text, as {@link #button(String, Icons, String, Runnable, String...)}. */
  public static Button button(
      String id, String words, String help, Runnable action, String... styles) {
    Button button = named(new Button(words), id, styles);
    help(button, help);
    button.setOnAction(event -> action.run());
    return button;
  }

  /** A menu item with a literal text. */
  public static MenuItem item(String id, String words, Runnable action) {
    MenuItem item = new MenuItem(words);
    item.setId(id);
    item.setMnemonicParsing(false);
    item.setOnAction(event -> action.run());
    return item;
  }

  /** A slider between two values, with a text for tooltip and screen readers. */
  public static Slider slider(String id, String help, double min, double max) {
    Slider slider = named(new Slider(min, max, min), id);
    slider.setAccessibleText(help);
    help(slider, help);
    return slider;
  }

  /** A small entry of text, with its name for screen readers and its width in characters. */
  public static TextField entry(String id, String name, int columns) {
    TextField entry = named(new TextField(), id, Styles.SMALL);
    entry.setAccessibleText(name);
    entry.setPrefColumnCount(columns);
    return entry;
  }

  /** Words in one line, in some classes of the style sheet. */
  public static Label label(String words, String... styles) {
    Label label = new Label(words);
    label.getStyleClass().addAll(styles);
    return label;
  }

  /** Words that are never cut off, in some classes of the style sheet. */
  public static Label whole(String words, String... styles) {
    Label label = label(words, styles);
    label.setMinWidth(Region.USE_PREF_SIZE);
    return label;
  }

  /** Words in as many lines as they take, in some classes of the style sheet. */
  public static Label paragraph(String words, String... styles) {
    Label label = label(words, styles);
    label.setWrapText(true);
    label.setMinHeight(Region.USE_PREF_SIZE);
    return label;
  }

  /** Nodes in a line, with gaps between them. */
  public static HBox row(double gap, Node... nodes) {
    HBox row = new HBox(gap, nodes);
    row.setAlignment(Pos.CENTER_LEFT);
    return row;
  }

  /** Lets a node take the room that a row leaves. */
  public static <T extends Region> T growing(T node) {
    node.setMaxWidth(Double.MAX_VALUE);
    HBox.setHgrow(node, Priority.ALWAYS);
    return node;
  }

  /** A view of a column that scrolls up and down only. */
  public static ScrollPane scrolling(Node content) {
    return scrolling(new ScrollPane(), content);
  }

  /** Lets a view show a column, which scrolls up and down only. */
  public static ScrollPane scrolling(ScrollPane view, Node content) {
    view.setContent(content);
    view.setFitToWidth(true);
    view.setHbarPolicy(ScrollPane.ScrollBarPolicy.NEVER);
    return view;
  }

  /** Gives a node the id by which style sheet and tests find it, and classes of the style sheet. */
  public static <T extends Node> T named(T node, String id, String... styles) {
    node.setId(id);
    node.getStyleClass().addAll(styles);
    return node;
  }

  /**
   * Sets or removes the tooltip of a node. The tooltip itself, which is a window, is created when
   * the mouse comes.
   */
  public static void help(Node node, String text) {
    if (node.getProperties().put(HELP, text) == null) {
      node.addEventHandler(MouseEvent.MOUSE_ENTERED, event -> showHelp(node));
    }
    if (node.getProperties().get(TOOLTIP) instanceof Tooltip tooltip) {
      tooltip.setText(text);
    }
  }

  /** The tooltip text of a node; empty without one. */
  public static String help(Node node) {
    return (String) node.getProperties().getOrDefault(HELP, "");
  }

  private static void showHelp(Node node) {
    String text = help(node);
    if (node.getProperties().get(TOOLTIP) instanceof Tooltip tooltip) {
      if (text.isEmpty()) {
        Tooltip.uninstall(node, tooltip);
        node.getProperties().remove(TOOLTIP);
      }
    } else if (!text.isEmpty()) {
      Tooltip tooltip = new Tooltip(text);
      tooltip.setShowDelay(Duration.millis(400));
      tooltip.setShowDuration(Duration.seconds(30));
      tooltip.setWrapText(true);
      tooltip.setMaxWidth(340);
      node.getProperties().put(TOOLTIP, tooltip);
      Tooltip.install(node, tooltip);
    }
  }

  private static void dress(
      ButtonBase button, String id, Icons icon, String help, String... styles) {
    named(button, id, styles);
    button.setGraphic(icon.node());
    button.getStyleClass().addAll(Styles.BUTTON_ICON, Styles.FLAT);
    help(button, help);
    button.setAccessibleText(help);
  }

  /**
   * A wrapper for a control that may be disabled, with the reason as a tooltip: a disabled control
   * gets no mouse events.
   */
  public static Node place(Node control) {
    StackPane place = new StackPane(control);
    place.setPickOnBounds(true);
    return place;
  }

  /**
   * Disables a control in a {@link #place}.
   *
   * @param obstacle why it cannot work; on if that is empty
   */
  public static void unless(String obstacle, Node... controls) {
    for (Node control : controls) {
      control.setDisable(!obstacle.isEmpty());
      help(control.getParent(), obstacle);
    }
  }

  /** Shows nodes while a condition holds; else they take no room. */
  public static void bindVisible(ObservableBooleanValue condition, Node... nodes) {
    for (Node node : nodes) {
      node.visibleProperty().bind(condition);
      node.managedProperty().bind(node.visibleProperty());
    }
  }

  /** Shows nodes, or hides them without leaving room for them. */
  public static void show(boolean shown, Node... nodes) {
    for (Node node : nodes) {
      node.setVisible(shown);
      node.setManaged(shown);
    }
  }

  /** Adds a listener to finished entries: by Enter, or by leaving the field. */
  public static void onEntered(TextField entry, Runnable taken) {
    entry.setOnAction(event -> taken.run());
    entry
        .focusedProperty()
        .subscribe(
            (was, is) -> {
              if (!is) {
                taken.run();
              }
            });
  }

  /** Adds a listener to Escape in a field, which discards its entry. */
  public static void onEscape(TextField entry, Runnable discarded) {
    entry.addEventHandler(
        KeyEvent.KEY_PRESSED,
        event -> {
          if (event.getCode() == KeyCode.ESCAPE) {
            discarded.run();
          }
        });
  }

  /**
   * Makes a node accept a drop.
   *
   * @param wanted the content, if the node accepts it
   * @param dropped receives it
   */
  public static <T> void onDrop(
      Node target,
      TransferMode mode,
      Function<Dragboard, Optional<T>> wanted,
      Consumer<T> dropped) {
    target.setOnDragOver(
        event -> {
          if (wanted.apply(event.getDragboard()).isPresent()) {
            event.acceptTransferModes(mode);
            event.consume();
          }
        });
    target.setOnDragDropped(
        event ->
            wanted
                .apply(event.getDragboard())
                .ifPresent(
                    there -> {
                      dropped.accept(there);
                      event.setDropCompleted(true);
                      event.consume();
                    }));
  }

  /**
   * A list of values to choose from.
   *
   * @param help its tooltip, and its name for screen readers
   * @param values in order
   * @param words the label of each
   */
  public static <T> ChoiceBox<T> choice(
      String id, String help, Collection<T> values, Function<T, String> words) {
    ChoiceBox<T> box = new ChoiceBox<>();
    box.setId(id);
    box.setAccessibleText(help);
    help(box, help);
    box.getItems().setAll(values);
    box.setConverter(
        new StringConverter<>() {
          @Override
          public String toString(T value) {
            return value == null ? "" : words.apply(value);
          }

          @Override
          public T fromString(String wanted) {
            throw new UnsupportedOperationException("a choice box shows words only");
          }
        });
    return box;
  }

  /** Clips a region to its bounds. */
  public static void clip(Region region) {
    Rectangle clip = new Rectangle();
    clip.widthProperty().bind(region.widthProperty());
    clip.heightProperty().bind(region.heightProperty());
    region.setClip(clip);
  }
}
