package haltere.ui.viewer.feature;

import javafx.application.Platform;
import javafx.beans.InvalidationListener;
import javafx.beans.property.DoubleProperty;
import javafx.beans.property.SimpleDoubleProperty;
import javafx.collections.ListChangeListener;
import javafx.scene.Node;
import javafx.scene.control.SplitPane;

/**
 * Panels whose first divider stays where a user or a setting has put it: a small window moves it,
 * which a larger one reverts.
 */
class KeptPanes extends SplitPane {
  private boolean isLayingOut;

  @Override
  protected void layoutChildren() {
    isLayingOut = true;
    super.layoutChildren();
    // what a small window cuts off is the right and the lower part
    for (Node child : getChildren()) {
      child.relocate(Math.max(0, child.getLayoutX()), Math.max(0, child.getLayoutY()));
    }
    isLayingOut = false;
  }

  /**
   * Restores the saved position of the divider, and saves new ones.
   *
   * @param initial initial width after the divider in pixels, or share before it, up to 1; such a
   *     value is saved. -1 for a share without an initial one
   */
  void keep(UserSettings settings, String name, double initial) {
    boolean inPixels = initial > 1;
    DoubleProperty share = new SimpleDoubleProperty(initial);
    settings.keep(name, share, value -> value, value -> ((Number) value).doubleValue());
    InvalidationListener dividerListener =
        observed -> {
          if (!isLayingOut && !getDividers().isEmpty() && getWidth() > 0) {
            double at = getDividerPositions()[0];
            share.set(inPixels ? Math.rint((1 - at) * getWidth()) : Math.rint(at * 1e3) / 1e3);
          }
        };
    Runnable place =
        () -> {
          double position = share.get() > 1 ? 1 - share.get() / getWidth() : share.get();
          if (!getDividers().isEmpty()
              && position >= 0
              && Math.abs(getDividerPositions()[0] - position) >= 0.001) {
            setDividerPosition(0, position);
          }
        };
    share.subscribe(place);
    layoutBoundsProperty().subscribe((was, is) -> Platform.runLater(place));
    Runnable follow =
        () -> {
          place.run();
          getDividers().forEach(each -> each.positionProperty().addListener(dividerListener));
        };
    getDividers().addListener((ListChangeListener<SplitPane.Divider>) change -> follow.run());
    follow.run();
  }
}
