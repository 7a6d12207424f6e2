package haltere.ui.viewer.action;

import atlantafx.base.controls.ToggleSwitch;
import haltere.ui.viewer.controls.ArrowKeys;
import java.util.Map;
import java.util.Optional;
import javafx.event.EventHandler;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.Scene;
import javafx.scene.control.ButtonBase;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.ComboBoxBase;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.Control;
import javafx.scene.control.ListView;
import javafx.scene.control.MenuButton;
import javafx.scene.control.Slider;
import javafx.scene.control.TabPane;
import javafx.scene.control.TextInputControl;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyCombination;
import javafx.scene.input.KeyEvent;
import javafx.stage.Window;

/**
 * Keys of commands without Ctrl or Alt. They work with any focus except in text fields and open
 * menus; arrow keys also belong to sliders, lists and the like. As Space is pause, Enter presses
 * the focused button, toggles the switch or opens the list.
 */
public final class ViewerKeys {
  /** Key codes that some national keyboards send in place of another one. */
  private static final Map<KeyCode, KeyCode> EQUIVALENTS =
      Map.of(KeyCode.GREATER, KeyCode.PERIOD, KeyCode.LESS, KeyCode.COMMA);

  private ViewerKeys() {}

  /** Listens to the keys of a window. */
  public static void install(Scene scene, ViewerActions actions) {
    EventHandler<KeyEvent> pressed =
        event -> {
          if (handle(event, scene.getFocusOwner(), actions)) {
            event.consume();
          }
        };
    // the bar of menus consumes its keys in the scene, before they reach the root
    scene.getRoot().addEventFilter(KeyEvent.KEY_PRESSED, pressed);
    // without a focus, keys reach the scene alone
    scene.addEventHandler(
        KeyEvent.KEY_PRESSED,
        event -> {
          if (event.getTarget() == scene) {
            pressed.handle(event);
          }
        });
    // a button fires when Space is released
    scene.addEventFilter(
        KeyEvent.KEY_RELEASED,
        event -> {
          if (event.getCode() == KeyCode.SPACE
              && !(scene.getFocusOwner() instanceof TextInputControl)) {
            event.consume();
          }
        });
  }

  static String label(String key) {
    return key.isEmpty() ? "" : KeyCombination.keyCombination(key).getDisplayText();
  }

  private static boolean handle(KeyEvent event, Node focus, ViewerActions actions) {
    if (event.isControlDown()
        || event.isAltDown()
        || event.isMetaDown()
        || focus instanceof TextInputControl
        || Window.getWindows().stream().anyMatch(ContextMenu.class::isInstance)) {
      return false;
    }
    if (event.getCode() == KeyCode.ENTER && press(focus)) {
      return true;
    }
    if (event.getCode().isNavigationKey() && ownsMoves(focus)) {
      return false;
    }
    Optional<ViewerAction> wanted = action(event, actions);
    wanted.ifPresent(actions::run);
    return wanted.isPresent();
  }

  /** Presses the focused node, if it is a button or the like. */
  private static boolean press(Node focus) {
    if (focus instanceof Control control && control.getSkin() == null) {
      // new: without a skin it would consider itself open and never show
      Parent all = control.getScene().getRoot();
      all.applyCss();
      all.layout();
    }
    if (focus instanceof MenuButton menu) {
      menu.show();
    } else if (focus instanceof ButtonBase button) {
      button.fire();
    } else if (focus instanceof ToggleSwitch power) {
      power.fire();
    } else if (focus instanceof ChoiceBox<?> choice) {
      choice.show();
    } else {
      return false;
    }
    return true;
  }

  private static Optional<ViewerAction> action(KeyEvent event, ViewerActions actions) {
    KeyCode code = EQUIVALENTS.getOrDefault(event.getCode(), event.getCode());
    String key = (event.isShiftDown() ? "Shift+" : "") + code.getName();
    return actions.all().stream()
        .filter(action -> action.hasPlainKey() && action.key().equals(key))
        .findFirst();
  }

  private static boolean ownsMoves(Node focus) {
    return focus instanceof Slider
        || focus instanceof ChoiceBox<?>
        || focus instanceof ComboBoxBase<?>
        || focus instanceof ListView<?>
        || focus instanceof TabPane
        || focus instanceof ArrowKeys own && own.consumesArrows();
  }
}
