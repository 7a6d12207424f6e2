package haltere.ui.viewer;

import haltere.ui.viewer.action.ViewerAction;
import haltere.ui.viewer.action.ViewerActions;
import haltere.ui.viewer.controls.FocusOrder;
import haltere.ui.viewer.controls.Windows;
import haltere.ui.viewer.feature.PanelLayout;
import haltere.ui.viewer.feature.UserSettings;
import haltere.ui.viewer.feature.WindowFeature;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import javafx.scene.Node;

/** Focuses and sizes panels by keys; saves layouts of panels by name and restores them. */
final class LayoutFeature extends WindowFeature {
  private static final String NAME = "layouts";
  private static final String MENU = "View/Layouts";
  private static final String PANELS = "panel.";
  private static final String SHARES = "share.";
  private final Map<String, Object> layouts = new TreeMap<>();
  private Runnable showHidden = () -> {};

  @Override
  protected void install() {
    layouts.putAll(window.settings().map(NAME));
    addKeys(window.actions(), window.panels().panelLayout());
    Set<String> names = layouts.keySet();
    ViewerActions actions = window.actions();
    actions.add("keep-layout", () -> Windows.askName(window.stage(), "layout", names, this::keep));
    actions.add("picture-alone", this::hideOrRestorePanels);
    offer();
  }

  private void addKeys(ViewerActions actions, PanelLayout layout) {
    actions.add("panel-next", () -> go(1));
    actions.add("panel-before", () -> go(-1));
    actions.add("side-wider", () -> layout.enlarge(PanelLayout.Position.SIDE, 1));
    actions.add("side-narrower", () -> layout.enlarge(PanelLayout.Position.SIDE, -1));
    actions.add("below-higher", () -> layout.enlarge(PanelLayout.Position.BELOW, 1));
    actions.add("below-lower", () -> layout.enlarge(PanelLayout.Position.BELOW, -1));
    actions.add("beside-wider", () -> layout.enlarge(PanelLayout.Position.BESIDE, 1));
    actions.add("beside-narrower", () -> layout.enlarge(PanelLayout.Position.BESIDE, -1));
  }

  /** Puts the focus on the first control of another panel. */
  private void go(int panels) {
    List<Node> areas = window.panels().areas();
    Node focus = window.stage().getScene().getFocusOwner();
    long here = areas.stream().takeWhile(area -> !FocusOrder.isWithin(focus, area)).count();
    int next = here == areas.size() ? 0 : Math.floorMod(here + panels, areas.size());
    FocusOrder.of(areas.get(next)).stream().findFirst().ifPresent(FocusOrder::mark);
  }

  /** Saves the present layout under a name, in place of an earlier one. */
  void keep(String name) {
    layouts.put(name, window.settings().chosen(PANELS, SHARES, PlotFeature.LANES));
    offer();
  }

  private void remove(String name) {
    layouts.remove(name);
    offer();
  }

  private void hideOrRestorePanels() {
    Map<String, Object> panels = window.settings().chosen(PANELS);
    PanelLayout layout = window.panels().panelLayout();
    if (panels.containsValue(true) || !layout.isAlone()) {
      Runnable tabOrder = layout.tabOrder();
      hidePanels();
      Runnable others = layout.hideAll();
      showHidden =
          () -> {
            window.settings().choose(panels);
            others.run();
            tabOrder.run();
          };
    } else {
      showHidden.run();
    }
  }

  private void hidePanels() {
    UserSettings settings = window.settings();
    settings.chosen(PANELS).forEach((name, shown) -> settings.choose(Map.of(name, false)));
  }

  private void choose(String name) {
    if (layouts.get(name) instanceof Map<?, ?> layout) {
      hidePanels();
      window.settings().choose(layout);
      // new panels get their sizes after their layout
      window.steps().afterLayout(() -> window.settings().choose(layout));
    }
  }

  private void offer() {
    window.settings().put(NAME, Map.copyOf(layouts));
    window.actions().offer(NAME, layouts.keySet().stream().flatMap(this::actions).toList());
  }

  private Stream<ViewerAction> actions(String name) {
    return Stream.of(
        ViewerAction.of("layout-" + name, name, MENU, () -> choose(name)),
        ViewerAction.of("remove-layout-" + name, name, MENU + "/Remove", () -> remove(name)));
  }
}
