package haltere.ui.viewer;

import javafx.scene.AccessibleRole;
import javafx.scene.Node;
import javafx.scene.layout.Pane;

/**
 * A picture that Tab reaches and that keys work on as the mouse does.
 *
 * <p>Thread rule: JavaFX thread only.
 */
class KeyPane extends Pane implements ArrowKeys {
  KeyPane(Node... children) {
    super(children);
    getStyleClass().add("key-pane");
    setAccessibleRole(AccessibleRole.IMAGE_VIEW);
    setFocusTraversable(true);
  }

  @Override
  public final boolean keepsArrows() {
    return true;
  }
}
