package haltere.ui.command;

import haltere.core.format.AtomicFile;
import haltere.core.settings.SettingsSchema;
import haltere.filters.wing.WingEstimate;
import haltere.filters.wing.WingPart;
import haltere.filters.wing.WingTrackerSettings;
import java.io.BufferedWriter;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Locale;
import java.util.function.Consumer;

/**
 * A log in the layout of the original wing tracker: tab-separated lines of edge code, time, edge,
 * centre, amplitude, phase and angular frequency. The header says the columns, their units, the
 * program's version and the settings that differ from the defaults; its lines begin with #.
 *
 * <p>Thread rule: the processing thread.
 */
final class WingLog implements Consumer<WingEstimate>, Closeable {
  private final AtomicFile atomic;
  private final Writer text;

  private WingLog(AtomicFile atomic) {
    this.atomic = atomic;
    text =
        new BufferedWriter(
            new OutputStreamWriter(atomic.stream(), StandardCharsets.UTF_8), 1 << 16);
  }

  static WingLog create(Path file, Path recording, WingTrackerSettings settings, boolean overwrite)
      throws IOException {
    WingLog log = new WingLog(AtomicFile.create(file, overwrite));
    try {
      log.line("# " + new Version().getVersion()[0] + ", wings of " + recording.getFileName());
      log.line("# edge codes: 1 left leading, 2 left trailing, 3 right leading, 4 right trailing");
      log.line(
          "# columns: edge code, time (us), edge (rad), centre (rad), amplitude (rad, half of peak"
              + " to peak), phase (rad), angular frequency (rad/s)");
      SettingsSchema<WingTrackerSettings> schema = SettingsSchema.of(WingTrackerSettings.class);
      for (String name : schema.changed(settings)) {
        log.line("# setting: " + name + "=" + schema.get(settings, name));
      }
    } catch (IOException | RuntimeException problem) {
      log.close();
      throw problem;
    }
    return log;
  }

  private void line(String words) throws IOException {
    text.write(words);
    text.write('\n');
  }

  @Override
  public void accept(WingEstimate e) {
    if (e.edge() == WingPart.LEFT || e.edge() == WingPart.RIGHT) {
      return;
    }
    try {
      line(
          String.format(
              Locale.ROOT,
              "%d\t%d\t%.6f\t%.6f\t%.6f\t%.6f\t%.4f",
              e.edge().ordinal() + 1,
              e.timeUs(),
              e.angleRad(),
              e.centreRad(),
              e.amplitudeRad(),
              e.phaseRad(),
              2 * Math.PI * e.frequencyHz()));
    } catch (IOException problem) {
      throw new UncheckedIOException(problem);
    }
  }

  void finish() throws IOException {
    text.flush();
    atomic.commit();
  }

  @Override
  public void close() throws IOException {
    atomic.close();
  }
}
