package haltere.ui.viewer.controls;

import javafx.scene.AccessibleRole;
import javafx.scene.Node;
import javafx.scene.layout.Pane;

/** A picture that can have the focus and be operated by keys. */
public class KeyPane extends Pane implements ArrowKeys {
  /** A picture with some nodes in it at first. */
  public KeyPane(Node... children) {
    super(children);
    getStyleClass().add("key-pane");
    setAccessibleRole(AccessibleRole.IMAGE_VIEW);
    setFocusTraversable(true);
  }

  @Override
  public final boolean consumesArrows() {
    return true;
  }
}
