package haltere.ui.viewer.controls;

import java.util.ArrayList;
import java.util.List;
import javafx.css.PseudoClass;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.util.Subscription;

/** The focus, and the order of the nodes for Tab. */
public final class FocusOrder {
  private static final PseudoClass VISIBLE = PseudoClass.getPseudoClass("focus-visible");

  private FocusOrder() {}

  /** Gives a node the focus, which it shows until it loses it, as after Tab. */
  public static void mark(Node node) {
    node.requestFocus();
    node.pseudoClassStateChanged(VISIBLE, true);
    Subscription[] lost = new Subscription[1];
    lost[0] =
        node.focusedProperty()
            .subscribe(
                (was, is) -> {
                  node.pseudoClassStateChanged(VISIBLE, node.isFocusVisible());
                  lost[0].unsubscribe();
                });
  }

  /** Whether a node shows that it has the focus. */
  public static boolean isMarked(Node node) {
    return node.getPseudoClassStates().contains(VISIBLE);
  }

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
