package haltere.ui.viewer;

import atlantafx.base.theme.Styles;
import javafx.scene.control.Button;
import javafx.scene.control.ButtonBase;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.Tooltip;
import javafx.util.Duration;

/** Makes the buttons of the window, all alike: an icon, a tooltip and a name for screen readers. */
final class Controls {
  private Controls() {}

  static Button button(String id, Icons icon, String help, Runnable action) {
    Button button = new Button();
    dress(button, id, icon, help);
    button.setOnAction(event -> action.run());
    return button;
  }

  static ToggleButton toggle(String id, Icons icon, String help) {
    ToggleButton button = new ToggleButton();
    dress(button, id, icon, help);
    return button;
  }

  static Tooltip tooltip(String text) {
    Tooltip tooltip = new Tooltip(text);
    tooltip.setShowDelay(Duration.millis(400));
    tooltip.setShowDuration(Duration.seconds(30));
    tooltip.setWrapText(true);
    tooltip.setMaxWidth(340);
    return tooltip;
  }

  private static void dress(ButtonBase button, String id, Icons icon, String help) {
    button.setId(id);
    button.setGraphic(icon.node());
    button.getStyleClass().addAll(Styles.BUTTON_ICON, Styles.FLAT);
    button.setTooltip(tooltip(help));
    button.setAccessibleText(help);
  }
}
