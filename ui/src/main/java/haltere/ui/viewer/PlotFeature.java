package haltere.ui.viewer;

import haltere.ui.plot.PlotField;
import haltere.ui.rendering.Pictures;
import haltere.ui.viewer.action.ViewerActions;
import haltere.ui.viewer.action.ViewerKeys;
import haltere.ui.viewer.controls.FileDialogs;
import haltere.ui.viewer.controls.Windows;
import haltere.ui.viewer.feature.PanelLayout;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.feature.ViewerFeature;
import haltere.ui.viewer.plots.PlotPanel;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Supplier;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;
import javafx.scene.layout.StackPane;
import javafx.stage.Stage;

/** Plots of published results, below the events or in a window of their own. */
final class PlotFeature implements ViewerFeature {
  /** Setting of the plotted fields. */
  static final String LANES = "plots.lanes";

  @Override
  public void install(ViewerContext window) {
    PlotPanel plots = window.panels().plots();
    BooleanProperty shown = window.addPanel("plots", PanelLayout.Position.BELOW, () -> plots);
    BooleanProperty detached = new SimpleBooleanProperty();
    window.settings().keep("panel.plots-apart", detached);
    window.settings().keep(LANES, plots.fieldsProperty(), PlotFeature::write, PlotFeature::read);
    // layouts restore plots, a start does not: another source publishes other fields
    shown.set(false);
    detached.set(false);
    plots.fieldsProperty().set(List.of());
    window.onSession(
        made -> {
          if (plots.dropFirst(made.chain())) {
            shown.set(false);
          }
          if (plots.beginWith(made.request().start().plots())) {
            shown.set(true);
          }
        });
    bindLocation(window, plots, shown, detached);
    ViewerActions actions = window.actions();
    FileDialogs dialogs = window.dialogs();
    actions.add(
        "plots-apart", detached, () -> (detached.get() ? shown : detached).set(true), () -> "");
    actions.add(
        "add-plot",
        () -> {
          shown.set(!detached.get());
          window.steps().afterLayout(plots::showMenu);
        },
        window::nothingOpen);
    Supplier<String> noPlots = () -> plots.lanes().isEmpty() ? "nothing is plotted" : "";
    actions.add(
        "save-plot-table",
        () ->
            dialogs
                .save("Save plots as table", "plots.csv", "Tables", "*.csv")
                .ifPresent(file -> window.save(file, plots.table())),
        noPlots);
    actions.add(
        "save-plot-picture",
        () -> dialogs.picture().ifPresent(file -> save(window, file, plots.snapshot(null, null))),
        noPlots);
  }

  /** The fields of lanes as lists of their names, for JSON. */
  private static Object write(List<List<PlotField>> lanes) {
    return lanes.stream()
        .map(lane -> lane.stream().map(f -> List.of(f.stage(), f.outlet(), f.column())).toList())
        .toList();
  }

  private static List<List<PlotField>> read(Object lanes) {
    return ((List<?>) lanes)
        .stream()
            .map(lane -> ((List<?>) lane).stream().map(PlotFeature::field).toList())
            .filter(lane -> !lane.isEmpty())
            .toList();
  }

  private static PlotField field(Object names) {
    List<?> parts = (List<?>) names;
    return new PlotField((String) parts.get(0), (String) parts.get(1), (String) parts.get(2));
  }

  private static void save(ViewerContext window, Path file, WritableImage image) {
    int width = (int) image.getWidth();
    int height = (int) image.getHeight();
    BufferedImage copy = new BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB);
    int[] argb = Pictures.pixels(copy);
    image
        .getPixelReader()
        .getPixels(0, 0, width, height, PixelFormat.getIntArgbInstance(), argb, 0, width);
    window.save(file, () -> Pictures.write(file, copy));
  }

  /** Plots are in one place at a time: closing their window moves them below the events again. */
  private static void bindLocation(
      ViewerContext window, PlotPanel plots, BooleanProperty shown, BooleanProperty detached) {
    Stage[] own = new Stage[1];
    detached.subscribe(
        (was, is) -> {
          if (is) {
            shown.set(false);
            own[0] =
                Windows.beside(
                    window.stage(), "Plots \u2013 Haltere", new StackPane(plots), 900, 480);
            ViewerKeys.install(own[0].getScene(), window.actions());
            // it has no menus, which know the keys with Ctrl
            own[0].getScene().getAccelerators().putAll(window.stage().getScene().getAccelerators());
            own[0].setOnHidden(event -> shown.set(shown.get() || detached.get()));
            own[0].show();
          } else {
            own[0].hide();
          }
        });
    shown.subscribe((was, is) -> detached.set(detached.get() && !is));
  }
}
