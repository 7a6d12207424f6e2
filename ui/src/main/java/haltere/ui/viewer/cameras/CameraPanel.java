package haltere.ui.viewer.cameras;

import atlantafx.base.theme.Styles;
import haltere.core.camera.BiasSliders;
import haltere.core.camera.Biases;
import haltere.core.camera.Camera;
import haltere.core.camera.CameraInfo;
import haltere.core.camera.CameraStatistics;
import haltere.core.camera.RegionOfInterest;
import haltere.core.camera.RegionOfInterest.Region;
import haltere.core.settings.Parameter;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.SettingField;
import haltere.ui.viewer.controls.Texts;
import haltere.ui.viewer.feature.BackgroundWork;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.Slider;
import javafx.scene.layout.VBox;

/** Settings and counts of a camera: four sliders, sets of biases, and each bias. */
final class CameraPanel extends ScrollPane {
  /** Latency from which on a camera's events count as shown late. */
  private static final long BEHIND_US = 100_000;

  private final BackgroundWork background;
  private final VBox content = new VBox(10);
  private final Label statistics =
      Controls.named(Controls.paragraph("", Styles.TEXT_SMALL), "camera-statistics");
  private final Label region = Controls.named(new Label(), "camera-region-words");
  private final Label problem =
      Controls.named(Controls.paragraph("", Styles.TEXT_SMALL, Styles.DANGER), "camera-problem");

  /** Show the values in effect, one for each control. */
  private final List<Runnable> updates = new ArrayList<>();

  private boolean showing;

  CameraPanel(BackgroundWork background) {
    this.background = background;
    setId("camera-panel");
    getStyleClass().add("settings");
    content.setStyle("-fx-padding: 10;");
    Controls.scrolling(this, content);
    setCamera(Optional.empty());
  }

  /** Shows another camera, or that none is open. */
  void setCamera(Optional<Camera> shown) {
    content.getChildren().clear();
    updates.clear();
    problem.setText("");
    if (shown.isEmpty()) {
      Label none =
          Controls.paragraph(
              "No camera is open. Camera > Open lists those that are plugged in; their biases"
                  + " and losses are then shown here.");
      content.getChildren().add(Controls.named(none, "camera-none"));
      return;
    }
    CameraInfo info = shown.get().info();
    String words = Texts.source(info.id()) + "   " + info.model();
    Label name = Controls.named(Controls.paragraph(words), "camera-name", Styles.TEXT_BOLD);
    content.getChildren().addAll(name, statistics, problem);
    shown.get().facet(RegionOfInterest.class).ifPresent(this::addRegion);
    shown.get().facet(BiasSliders.class).ifPresent(this::addSliders);
    shown.get().facet(Biases.class).ifPresent(this::addBiases);
    refresh();
  }

  private void addRegion(RegionOfInterest facet) {
    content.getChildren().add(region);
    Function<Region, String> words =
        part ->
            "Region %d \u00d7 %d at %d, %d"
                .formatted(part.width(), part.height(), part.left(), part.bottom());
    updates.add(() -> region.setText(facet.region().map(words).orElse("The whole sensor")));
  }

  private void addSliders(BiasSliders facet) {
    for (BiasSliders.Slider which : BiasSliders.Slider.values()) {
      String name = Parameter.text(which);
      String text =
          which == BiasSliders.Slider.BALANCE ? "Balance of ON and OFF" : Texts.title(name);
      Slider slider = Controls.slider("camera-slider-" + name, help(which), -1, 1);
      slider.setAccessibleText(text);
      slider.setBlockIncrement(0.05);
      slider
          .valueProperty()
          .subscribe(
              (was, is) -> {
                if (!showing) {
                  double value = is.doubleValue();
                  send(() -> facet.set(which, value), problem::setText);
                }
              });
      updates.add(
          () -> {
            if (!slider.isValueChanging()) {
              slider.setValue(facet.get(which));
            }
          });
      content.getChildren().add(new VBox(2, new Label(text), slider));
    }
  }

  private static String help(BiasSliders.Slider slider) {
    return switch (slider) {
      case BANDWIDTH -> "Right: pixels follow faster light, with more noise";
      case THRESHOLD -> "Right: the light must change more for an event";
      case REFRACTORY_PERIOD -> "Right: longer refractory period after an event";
      case BALANCE -> "Right: ON events come more easily, left: OFF events";
    };
  }

  private void addBiases(Biases facet) {
    ChoiceBox<String> sets =
        Controls.choice("camera-bias-sets", "Sets of biases", facet.sets(), set -> set);
    sets.setOnAction(
        event -> {
          String chosen = sets.getValue();
          if (chosen != null) {
            send(() -> facet.apply(chosen), problem::setText);
          }
        });
    if (!sets.getItems().isEmpty()) {
      content.getChildren().add(Controls.row(6, new Label("Set"), Controls.growing(sets)));
    }
    for (Parameter parameter : facet.parameters()) {
      SettingField field =
          SettingField.of(
              "camera",
              parameter,
              (value, refused) ->
                  send(
                      () ->
                          facet.set(
                              parameter.name(), ((Number) parameter.convert(value)).doubleValue()),
                      refused));
      updates.add(
          () -> {
            double value = facet.get(parameter.name());
            boolean isDefault =
                parameter.defaultValue() instanceof Number number && number.doubleValue() == value;
            field.show(parameter.convert(value), !isDefault);
          });
      content.getChildren().add(field);
    }
  }

  /**
   * Sends a command to the camera in the background; reports the reason of a refusal in one line.
   */
  private void send(BackgroundWork.Action command, Consumer<String> refused) {
    background.file(
        command,
        () -> {
          problem.setText("");
          refresh();
        },
        why -> refused.accept(Texts.oneLine(why)));
  }

  /** Shows the values in effect. */
  void refresh() {
    showing = true;
    updates.forEach(Runnable::run);
    showing = false;
  }

  /** Shows received and lost events. */
  void update(CameraStatistics now) {
    statistics.setText(
        """
        %s events in %s transfers
        lost %s events in %s transfers, %s broken
        waiting %d transfers, at most %d
        latency %s (median), %s (99.9 %%), %s (longest)"""
            .formatted(
                Texts.count(now.events()),
                Texts.count(now.transfers()),
                Texts.count(now.lostEvents()),
                Texts.count(now.lostTransfers()),
                Texts.count(now.brokenTransfers()),
                now.waiting(),
                now.maxWaiting(),
                Texts.duration(now.medianLatencyUs()),
                Texts.duration(now.latency999Us()),
                Texts.duration(now.maxLatencyUs())));
  }

  /** The same as a short text, for the bottom line. */
  static String line(CameraStatistics now) {
    String behind = now.medianLatencyUs() > BEHIND_US ? " behind" : "";
    return now.waiting() + " waiting, " + Texts.duration(now.medianLatencyUs()) + behind;
  }
}
