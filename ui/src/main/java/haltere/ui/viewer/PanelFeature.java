package haltere.ui.viewer;

import haltere.ui.viewer.action.ViewerActions;
import haltere.ui.viewer.controls.FocusOrder;
import haltere.ui.viewer.feature.PanelLayout;
import haltere.ui.viewer.feature.PanelPlace;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.feature.ViewerFeature;
import java.util.List;
import javafx.scene.Node;

/** Goes from panel to panel, and makes them larger and smaller, without a mouse. */
final class PanelFeature implements ViewerFeature {

  private ViewerContext window;

  @Override
  public void install(ViewerContext installed) {
    window = installed;
    PanelLayout layout = window.panels().panelLayout();
    ViewerActions actions = window.actions();
    actions.add("panel-next", () -> go(1));
    actions.add("panel-before", () -> go(-1));
    actions.add("side-wider", () -> layout.enlarge(PanelPlace.SIDE, 1));
    actions.add("side-narrower", () -> layout.enlarge(PanelPlace.SIDE, -1));
    actions.add("below-higher", () -> layout.enlarge(PanelPlace.BELOW, 1));
    actions.add("below-lower", () -> layout.enlarge(PanelPlace.BELOW, -1));
    actions.add("beside-wider", () -> layout.enlarge(PanelPlace.BESIDE, 1));
    actions.add("beside-narrower", () -> layout.enlarge(PanelPlace.BESIDE, -1));
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
