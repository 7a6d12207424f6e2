package haltere.ui.viewer.file;

import atlantafx.base.theme.Styles;
import haltere.core.event.SensorGeometry;
import haltere.core.format.internal.decoding.SensorGuess;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.Icons;
import haltere.ui.viewer.controls.Texts;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import javafx.scene.control.Button;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Hyperlink;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;

/**
 * Warnings of the open file above the picture, the first of several until it is expanded, and the
 * question for an unknown camera.
 */
final class WarningBanner extends VBox {
  /** Cameras of common sizes, for users who do not know the size. */
  private static final Map<String, String> CAMERAS =
      Map.of(
          "128x128", "DVS128",
          "240x180", "DAVIS240",
          "304x240", "ATIS",
          "320x240", "DVXplorer at half size",
          "346x260", "DAVIS346",
          "640x480", "Gen3, DVXplorer",
          "1280x720", "Gen4, IMX636");

  private final Consumer<SensorGeometry> chosen;
  private final Label first = Controls.named(Controls.paragraph(""), "warning-first");
  private final Hyperlink more = Controls.named(new Hyperlink(), "warnings-more");
  private final VBox all = new VBox(2);

  private final ChoiceBox<SensorGeometry> sizes =
      Controls.choice(
          "camera-choice", "Camera that made the recording", List.of(), WarningBanner::label);
  private final HBox question;
  private List<String> warnings = List.of();

  /** A banner that is not seen. */
  WarningBanner(Consumer<SensorGeometry> chosen) {
    this.chosen = chosen;
    Controls.named(this, "warnings", "warning-banner");
    first.setMinWidth(0);
    more.setAccessibleText("Show all warnings");
    more.setMinWidth(Region.USE_PREF_SIZE);
    more.setOnAction(event -> open(!all.isVisible()));
    HBox head =
        Controls.row(
            8,
            Controls.growing(first),
            more,
            Controls.button("warnings-dismiss", Icons.REMOVE, "Dismiss the warnings", this::hide));
    Button use = Controls.named(new Button("Use and remember"), "camera-use", Styles.SMALL);
    use.setMinWidth(Region.USE_PREF_SIZE);
    use.setOnAction(event -> answer());
    question = Controls.row(8, Controls.whole("Camera:"), sizes, use);
    getChildren().addAll(head, all, question);
    hide();
  }

  /** Says nothing. */
  void hide() {
    Controls.show(false, this);
  }

  /**
   * Shows warnings about a file, a line each, and the guessed sensor, if the file does not state
   * it; no line hides the banner. Dismissed warnings stay hidden.
   */
  void show(List<String> newWarnings, Optional<SensorGeometry> guess) {
    boolean isNews = isVisible() || guess.isPresent() || !warnings.equals(sentences(newWarnings));
    warnings = sentences(newWarnings);
    Controls.show(!warnings.isEmpty() && isNews, this);
    all.getChildren().setAll(warnings.stream().map(Controls::paragraph).toList());
    Controls.show(guess.isPresent(), question);
    guess.ifPresent(this::offer);
    open(false);
  }

  /** Warnings of readers as sentences. */
  static List<String> sentences(List<String> lines) {
    return lines.stream().map(Texts::withoutOptions).map(Texts::capital).toList();
  }

  private void open(boolean opened) {
    Controls.show(opened, all);
    more.setText(opened ? "Less" : "More");
    int count = warnings.size();
    Controls.show(count > 1, more);
    String single = count == 0 ? "" : warnings.get(0);
    first.setText(count < 2 ? single : count + " warnings" + (opened ? "" : ": " + single));
  }

  private void offer(SensorGeometry guess) {
    Set<SensorGeometry> sensors = new LinkedHashSet<>(List.of(guess));
    for (SensorGeometry usual : SensorGuess.COMMON_SIZES) {
      sensors.add(new SensorGeometry(usual.width(), usual.height(), guess.origin()));
    }
    sizes.getItems().setAll(sensors);
    sizes.getSelectionModel().select(0);
  }

  private static String label(SensorGeometry sensor) {
    String name = CAMERAS.get(sensor.width() + "x" + sensor.height());
    return sensor.width() + " \u00d7 " + sensor.height() + (name == null ? "" : " (" + name + ")");
  }

  private void answer() {
    hide();
    chosen.accept(sizes.getValue());
  }
}
