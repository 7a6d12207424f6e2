package haltere.ui.viewer.file;

import atlantafx.base.theme.Styles;
import haltere.core.event.SensorGeometry;
import haltere.core.format.summary.RecordingSummary;
import haltere.core.settings.Parameter;
import haltere.ui.command.terminal.Quantities;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.session.RecordingFacts;
import javafx.geometry.VPos;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.layout.GridPane;
import javafx.scene.layout.Priority;

/** The facts of the open recording: format, sensor, times, counts, rates, header, warnings. */
final class FileInfoPanel extends ScrollPane {
  private final GridPane grid = new GridPane();

  FileInfoPanel() {
    Controls.named(this, "file-info", "file-info");
    Controls.scrolling(this, grid);
    grid.getStyleClass().add("file-info-grid");
    say("Open a recording with File > Open recording; its properties are shown here.");
  }

  /** Shows a sentence in place of facts. */
  void say(String sentence) {
    grid.getChildren().clear();
    grid.add(Controls.paragraph(sentence, Styles.TEXT_MUTED), 0, 0, 2, 1);
  }

  void show(RecordingFacts facts) {
    grid.getChildren().clear();
    RecordingSummary summary = facts.summary();
    SensorGeometry sensor = summary.geometry();
    line("File", String.valueOf(facts.file().getFileName()));
    line("Folder", String.valueOf(facts.file().toAbsolutePath().getParent()));
    line("Size", Quantities.count(facts.sizeBytes()) + " bytes");
    line("Format", summary.format());
    facts.compression().ifPresent(method -> line("Compression", method));
    String size = sensor.width() + " \u00d7 " + sensor.height();
    String guessed = facts.assumedSensor().isPresent() ? " (guessed)" : "";
    String origin = Parameter.text(sensor.origin());
    line("Sensor", size + guessed + ", rows from the " + origin);
    line(
        "Events",
        Quantities.text("%,d (%,d ON, %,d OFF)", summary.events(), summary.on(), summary.off()));
    line("Frames", Quantities.count(summary.samples().frames()));
    line("Inertial samples", Quantities.count(summary.samples().inertialSamples()));
    line("Triggers", Quantities.count(summary.samples().triggers()));
    if (summary.events() > 0) {
      line("First event", Quantities.seconds(summary.firstUs()));
      line("Last event", Quantities.seconds(summary.lastUs()));
      line("Duration", Quantities.text("%.6f s", summary.durationS()));
      line("Time origin", facts.clock().describe());
      line("Mean rate", Quantities.rate(summary.meanRateEps()));
      line("Peak rate", Quantities.rate(summary.peakRateEps()) + " over 10 ms");
      line(
          "File bytes per event",
          Quantities.text("%.2f", facts.sizeBytes() / (double) summary.events()));
      line("Clock", summary.clockInWords());
      line("Gaps", summary.gaps().isEmpty() ? "none" : String.valueOf(summary.gaps().size()));
    }
    facts.header().forEach(this::line);
    String warnings = String.join(".\n", WarningBanner.sentences(summary.warnings()));
    line("Warnings", warnings.isEmpty() ? "none" : warnings);
  }

  private void line(String name, String value) {
    int row = grid.getRowCount();
    Label left = Controls.whole(name, Styles.TEXT_MUTED, Styles.TEXT_SMALL);
    Label right = Controls.paragraph(value, Styles.TEXT_SMALL);
    left.setLabelFor(right);
    GridPane.setValignment(left, VPos.TOP);
    GridPane.setHgrow(right, Priority.ALWAYS);
    grid.addRow(row, left, right);
  }
}
