package haltere.ui.viewer.feature;

import haltere.ui.viewer.controls.Controls;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.Property;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.geometry.Orientation;
import javafx.scene.Node;
import javafx.scene.control.SplitPane;
import javafx.scene.control.Tab;
import javafx.scene.control.TabPane;

/**
 * Panels around the events: tabs at the side, others below or beside. A panel is created when it is
 * first shown.
 */
public final class PanelLayout extends KeptPanes {
  /** Position of a panel. */
  public enum Position {
    /** In the column at the right, as a tab beside the chain. */
    SIDE,
    /** Below the events, of equal width. */
    BELOW,
    /** At the right of the events, of equal height. */
    BESIDE
  }

  /** Step of a panel's size, as a share of its container. */
  private static final double PANEL_STEP = 0.05;

  /** Initial width of the side panel. */
  private static final double SIDE_PX = 336;

  private static final double BELOW_SHARE = 0.6;
  private static final double BESIDE_SHARE = 0.55;

  /** Minimum share of the events beside other panels. */
  private static final double MIN_SHARE = 0.34;

  private final Node events;
  private final Node chain;
  private final Tab chainTab;

  /** The events, and panels at their right. */
  private final KeptPanes row = new KeptPanes();

  /** The row, and panels below it. */
  private final KeptPanes left = new KeptPanes();

  /** The panels that were added, with how they come and go. */
  private final Map<BooleanProperty, Consumer<Boolean>> offered = new LinkedHashMap<>();

  private final TabPane tabs = Controls.named(new TabPane(), "side-tabs");

  PanelLayout(Node events, Node chain) {
    this.events = events;
    this.chain = chain;
    chainTab = new Tab("Chain", chain);
    chainTab.setClosable(false);
    left.setOrientation(Orientation.VERTICAL);
    left.getItems().add(events);
    getItems().addAll(left, chain);
    // the bars below are visible in the smallest window
    setMinSize(0, 0);
    SplitPane.setResizableWithParent(chain, false);
    SplitPane.setResizableWithParent(tabs, false);
    tabs.setAccessibleText("Panels at the side");
  }

  /** Restores the saved sizes of panels, and saves new ones. */
  public void keep(UserSettings settings) {
    keep(settings, "share.side", SIDE_PX);
    left.keep(settings, "share.below", BELOW_SHARE);
    row.keep(settings, "share.beside", -1);
  }

  /** The shown panels, from the events on. */
  List<Node> shown() {
    List<Node> shown = new ArrayList<>();
    shown.add(events);
    row.getItems().stream().filter(node -> node != events).forEach(shown::add);
    left.getItems().stream().filter(node -> node != events && node != row).forEach(shown::add);
    shown.add(getItems().get(1));
    return shown;
  }

  /** Enlarges or shrinks the panel at a position by steps. */
  public void enlarge(Position position, int steps) {
    SplitPane pane =
        switch (position) {
          case SIDE -> this;
          case BELOW -> left;
          case BESIDE -> row;
        };
    if (!pane.getDividers().isEmpty()) {
      double before = pane.getDividerPositions()[0];
      pane.setDividerPosition(0, Math.max(0, Math.min(1, before - steps * PANEL_STEP)));
    }
  }

  /** Adds a panel; the returned property shows and hides it. */
  public BooleanProperty offer(
      String id, String title, Position position, Supplier<? extends Node> content) {
    BooleanProperty shown = new SimpleBooleanProperty();
    if (position == Position.SIDE) {
      Tab tab = new Tab(title);
      tab.setOnClosed(event -> shown.set(false));
      offered.put(shown, is -> showTab(tab, is, content));
    } else {
      Node[] made = new Node[1];
      offered.put(
          shown,
          is -> {
            if (made[0] == null) {
              made[0] = content.get();
            }
            if (position == Position.BELOW) {
              showLast(left, made[0], is);
            } else {
              showBeside(made[0], is);
            }
          });
    }
    shown.subscribe((was, is) -> offered.get(shown).accept(is));
    return shown;
  }

  /** Whether the chain is the only panel. */
  public boolean isAlone() {
    return shown().equals(List.of(events, chain));
  }

  /** Hides the shown panels, which go on with their work; running the result undoes that. */
  public Runnable hideAll() {
    List<BooleanProperty> hidden = offered.keySet().stream().filter(Property::getValue).toList();
    hidden.forEach(shown -> offered.get(shown).accept(false));
    return () ->
        hidden.stream()
            .filter(Property::getValue)
            .forEach(shown -> offered.get(shown).accept(true));
  }

  /** The present order and selection of the tabs; running it restores both after a change. */
  public Runnable tabOrder() {
    List<Tab> order = List.copyOf(tabs.getTabs());
    Tab selected = tabs.getSelectionModel().getSelectedItem();
    return () -> {
      tabs.getTabs().sort(Comparator.comparingInt(order::indexOf));
      tabs.getSelectionModel().select(selected);
    };
  }

  private void showTab(Tab tab, boolean show, Supplier<? extends Node> content) {
    if (tab.getContent() == null) {
      tab.setContent(content.get());
    }
    List<Tab> shown = tabs.getTabs();
    if (show) {
      if (shown.isEmpty()) {
        getItems().remove(chain);
        shown.add(chainTab);
        getItems().add(tabs);
      }
      shown.add(tab);
      tabs.getSelectionModel().select(tab);
    } else {
      shown.remove(tab);
      if (shown.size() == 1) {
        // the chain alone needs no tabs
        shown.clear();
        getItems().set(1, chain);
      }
    }
  }

  private static void showLast(SplitPane pane, Node panel, boolean show) {
    pane.getItems().remove(panel);
    if (show) {
      pane.getItems().add(panel);
    }
  }

  /** Divider positions of several panels beside the events, of equal widths. */
  private static double[] shares(int panels) {
    double first = Math.max(MIN_SHARE, BESIDE_SHARE - 0.1 * (panels - 1));
    double[] places = new double[panels];
    for (int i = 0; i < panels; i++) {
      places[i] = first + (1 - first) * i / panels;
    }
    return places;
  }

  private void showBeside(Node panel, boolean show) {
    if (show && row.getItems().isEmpty()) {
      left.getItems().remove(events);
      row.getItems().add(events);
      left.getItems().add(0, row);
    }
    showLast(row, panel, show);
    if (show) {
      row.setDividerPositions(shares(row.getItems().size() - 1));
    }
    if (row.getItems().size() == 1) {
      row.getItems().clear();
      left.getItems().set(0, events);
    }
  }
}
