package haltere.ui.viewer;

import haltere.ui.viewer.action.ViewerAction;
import haltere.ui.viewer.controls.FocusOrder;
import haltere.ui.viewer.feature.PanelPlace;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.feature.ViewerFeature;
import haltere.ui.viewer.feature.ViewerPanels;
import java.util.List;
import javafx.scene.Node;

/**
 * Goes from panel to panel, and makes them larger and smaller, without a mouse.
 *
 * <p>Thread rule: JavaFX thread only.
 */
final class PanelFeature implements ViewerFeature {
  private static final String MENU = "View/Panels";

  private ViewerContext window;

  @Override
  public void install(ViewerContext installed) {
    window = installed;
    ViewerPanels panels = window.panels();
    add("panel-next", "To the next panel", "F6", () -> go(1));
    add("panel-before", "To the panel before", "Shift+F6", () -> go(-1));
    add("side-wider", "Side wider", "", () -> panels.enlarge(PanelPlace.SIDE, 1));
    add("side-narrower", "Side narrower", "", () -> panels.enlarge(PanelPlace.SIDE, -1));
    add("below-higher", "Panel below higher", "", () -> panels.enlarge(PanelPlace.BELOW, 1));
    add("below-lower", "Panel below lower", "", () -> panels.enlarge(PanelPlace.BELOW, -1));
    add("beside-wider", "Panel beside wider", "", () -> panels.enlarge(PanelPlace.BESIDE, 1));
    add(
        "beside-narrower",
        "Panel beside narrower",
        "",
        () -> panels.enlarge(PanelPlace.BESIDE, -1));
  }

  private void add(String id, String words, String key, Runnable work) {
    window.add(ViewerAction.of(id, words, MENU, work).withKey(key));
  }

  /** Puts the focus on the first control of another panel. */
  private void go(int panels) {
    List<Node> areas = window.panels().areas();
    Node focus = window.stage().getScene().getFocusOwner();
    int here = -1;
    for (int i = 0; i < areas.size(); i++) {
      if (FocusOrder.isWithin(focus, areas.get(i))) {
        here = i;
      }
    }
    int next = here < 0 ? 0 : Math.floorMod(here + panels, areas.size());
    FocusOrder.of(areas.get(next)).stream().findFirst().ifPresent(Node::requestFocus);
  }
}
