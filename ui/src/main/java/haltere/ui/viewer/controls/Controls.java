package haltere.ui.viewer.controls;

import atlantafx.base.theme.Styles;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.ButtonBase;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.Tooltip;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.Region;
import javafx.scene.shape.Rectangle;
import javafx.util.Duration;

/** Makes the buttons of the window, all alike: an icon, a tooltip and a name for screen readers. */
public final class Controls {
  private static final String HELP = "haltere.help";
  private static final String TOOLTIP = "haltere.tooltip";

  private Controls() {}

  /**
   * A button with an icon.
   *
   * @param id by which style sheet and tests find it
   * @param help its tooltip, and its name for screen readers
   * @param action what pressing it does
   */
  public static Button button(String id, Icons icon, String help, Runnable action) {
    Button button = new Button();
    dress(button, id, icon, help);
    button.setOnAction(event -> action.run());
    return button;
  }

  /** A switch with an icon, as {@link #button}. */
  public static ToggleButton toggle(String id, Icons icon, String help) {
    ToggleButton button = new ToggleButton();
    dress(button, id, icon, help);
    return button;
  }

  /**
   * Gives a node words that appear when the mouse rests on it, or other ones, or none. The tooltip
   * itself, which is a window, is not made before the mouse comes.
   */
  public static void help(Node node, String text) {
    if (node.getProperties().put(HELP, text) == null) {
      node.addEventHandler(MouseEvent.MOUSE_ENTERED, event -> showHelp(node));
    }
    if (node.getProperties().get(TOOLTIP) instanceof Tooltip tooltip) {
      tooltip.setText(text);
    }
  }

  private static void showHelp(Node node) {
    String text = (String) node.getProperties().get(HELP);
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

  private static void dress(ButtonBase button, String id, Icons icon, String help) {
    button.setId(id);
    button.setGraphic(icon.node());
    button.getStyleClass().addAll(Styles.BUTTON_ICON, Styles.FLAT);
    help(button, help);
    button.setAccessibleText(help);
  }

  /** Shows of a region what lies within its bounds and nothing else. */
  public static void clip(Region region) {
    Rectangle clip = new Rectangle();
    clip.widthProperty().bind(region.widthProperty());
    clip.heightProperty().bind(region.heightProperty());
    region.setClip(clip);
  }
}
