package haltere.ui.viewer.controls;

import java.util.ArrayList;
import java.util.List;
import javafx.scene.Node;
import javafx.scene.Parent;

/** The order of the nodes for Tab. */
public final class FocusOrder {
  private FocusOrder() {}

  /** The nodes that can have the focus now, from a node on downwards. */
  public static List<Node> of(Node top) {
    List<Node> found = new ArrayList<>();
    collect(top, found);
    return found;
  }

  private static void collect(Node node, List<Node> found) {
    if (!node.isVisible() || node.isDisabled()) {
      return;
    }
    if (node.isFocusTraversable()) {
      found.add(node);
    }
    if (node instanceof Parent parent) {
      parent.getChildrenUnmodifiable().forEach(child -> collect(child, found));
    }
  }

  /** Whether a node is another one or inside it. */
  public static boolean isWithin(Node node, Node top) {
    for (Node above = node; above != null; above = above.getParent()) {
      if (above == top) {
        return true;
      }
    }
    return false;
  }
}
