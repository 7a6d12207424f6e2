package haltere.ui.wing;

import haltere.core.chain.Outlet;
import haltere.core.format.AtomicFile;
import haltere.core.settings.Parameter;
import haltere.core.settings.SettingsSchema;
import haltere.core.sink.CsvSink;
import haltere.filters.wing.ManualWingChange;
import haltere.filters.wing.WingBeat;
import haltere.filters.wing.WingEstimate;
import haltere.filters.wing.WingFilterEdit;
import haltere.filters.wing.WingFilterState;
import haltere.filters.wing.WingMeasurement;
import haltere.filters.wing.WingResult;
import haltere.filters.wing.WingTrackerSettings;
import haltere.filters.wing.tracker.WingTrackerFilter;
import java.io.BufferedOutputStream;
import java.io.BufferedWriter;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.LongSupplier;

/**
 * A readable log of tracked wings. Its header, lines with #, has recording, version, columns with
 * units, and settings. Changes of settings and manual changes of filters are such lines between the
 * rows. The file is atomic.
 *
 * <p>Thread rule: opened, finished and closed on the processing thread, or while it does not run.
 */
public final class WingLog implements Closeable {
  private static final Map<String, String> MEANINGS =
      Map.ofEntries(
          Map.entry("t_us", "time on the recording's clock, microseconds"),
          Map.entry("edge", "edge of a wing, or the wing as a whole"),
          Map.entry("angle_rad", "stroke angle, radians: 0 at the head, pi at the tail"),
          Map.entry("centre_rad", "mean stroke angle of the beat, radians"),
          Map.entry("amplitude_rad", "half of peak to peak, radians"),
          Map.entry("phase_rad", "radians, 0 where the wing passes its centre towards the tail"),
          Map.entry("frequency_hz", "beat frequency, hertz"),
          Map.entry("sd_angle_rad", "standard deviation of the angle, radians"),
          Map.entry("sd_frequency_hz", "standard deviation of the frequency, hertz"),
          Map.entry("events", "events used since the wing was found"),
          Map.entry("measured_rad", "stroke angle of the event's pixel, radians"),
          Map.entry("expected_rad", "expected stroke angle of the event, radians"),
          Map.entry("side", "wing"),
          Map.entry("beat", "number of the beat since the wing was found"),
          Map.entry("period_us", "length of the beat, microseconds"),
          Map.entry("min_rad", "smallest stroke angle of the beat, radians"),
          Map.entry("max_rad", "largest stroke angle of the beat, radians"),
          Map.entry("phase_lag_rad", "phase lag of this wing behind the other, radians"));

  private static final SettingsSchema<WingTrackerSettings> SCHEMA =
      SettingsSchema.of(WingTrackerSettings.class);

  private final AtomicFile file;
  private final WingTrackerFilter filter;
  private final OutputStream out;
  private final Writer text;
  private final List<Outlet.Subscription> subscriptions = new ArrayList<>();
  private CsvSink<?> table;
  private WingTrackerSettings settings;
  private LongSupplier rows = () -> 0;
  private Consumer<String> comments = label -> {};
  private volatile RuntimeException failure;

  private WingLog(AtomicFile file, WingTrackerFilter filter) {
    this.file = file;
    this.filter = filter;
    settings = filter.settings();
    out = new BufferedOutputStream(file.stream(), 1 << 16);
    text = new BufferedWriter(new OutputStreamWriter(out, StandardCharsets.UTF_8));
  }

  /** Starts a log of a filter's results in a new file, with the display name of the recording. */
  public static WingLog open(
      AtomicFile file, String source, WingTrackerFilter filter, WingLogFormat format)
      throws IOException {
    WingLog log = new WingLog(file, filter);
    try {
      log.begin(source, format);
      return log;
    } catch (IOException | RuntimeException problem) {
      log.close();
      throw problem;
    }
  }

  private void begin(String source, WingLogFormat format) throws IOException {
    String version = WingLog.class.getPackage().getImplementationVersion();
    comment("haltere " + (version == null ? "(not from a jar)" : version) + ", wings of " + source);
    List<String> changed = SCHEMA.changed(settings);
    for (Parameter parameter : SCHEMA.parameters()) {
      String name = parameter.name();
      String value = SCHEMA.get(settings, name) + unit(parameter);
      comment("setting: " + name + "=" + value + (changed.contains(name) ? "" : " (default)"));
    }
    if (format.layout() == WingLogFormat.Layout.ORIGINAL) {
      original(format.rows());
      return;
    }
    switch (format.rows()) {
      case EVENT -> table(WingMeasurement.class);
      case TICK -> table(WingEstimate.class);
      case BEAT -> table(WingBeat.class);
    }
  }

  private void original(WingLogFormat.Rows when) throws IOException {
    for (String line : OriginalRows.columns(settings.filter().method())) {
      comment(line);
    }
    text.flush();
    OriginalRows lines = new OriginalRows(text, settings.filter().method());
    rows = lines::rows;
    comments = lines::comment;
    if (when == WingLogFormat.Rows.EVENT) {
      log(WingMeasurement.class, lines::event);
    } else {
      subscribe(WingMeasurement.class, lines::keep);
      log(WingEstimate.class, lines::tick);
    }
  }

  private <R extends Record & WingResult> void table(Class<R> kind) throws IOException {
    for (String column : CsvSink.columns(kind)) {
      comment("column " + column + ": " + MEANINGS.get(column));
    }
    text.flush();
    CsvSink<R> sink = CsvSink.on(out, kind);
    table = sink;
    rows = sink::rows;
    comments = sink::comment;
    log(kind, sink);
  }

  /** Writes a row for each result of a kind, after lines on changes since the last row. */
  private <R extends WingResult> void log(Class<R> kind, Consumer<? super R> rowsOf) {
    subscribe(ManualWingChange.class, change -> comments.accept("manual change: " + label(change)));
    subscribe(kind, row -> logChanges());
    subscribe(kind, rowsOf);
  }

  private <R extends WingResult> void subscribe(Class<R> kind, Consumer<? super R> consumer) {
    subscriptions.add(filter.results(kind).subscribe(consumer, this::fail));
  }

  /** Says which settings are others from the next row on. */
  private void logChanges() {
    WingTrackerSettings now = filter.settings();
    if (now == settings) {
      return;
    }
    for (Parameter parameter : SCHEMA.parameters()) {
      String name = parameter.name();
      Object value = SCHEMA.get(now, name);
      if (!value.equals(SCHEMA.get(settings, name))) {
        comments.accept("setting changed: " + name + "=" + value + unit(parameter));
      }
    }
    settings = now;
  }

  private String label(ManualWingChange change) {
    String part = change.part() + " ";
    if (change.edit().isEmpty()) {
      return part + "restarted";
    }
    WingFilterEdit edit = change.edit().get();
    List<String> names =
        filter.tracker().filters().stream()
            .filter(state -> state.part() == change.part())
            .findFirst()
            .map(WingFilterState::names)
            .orElseThrow();
    String number =
        switch (edit.table()) {
          case STATE -> "x of " + names.get(edit.row());
          case COVARIANCE -> "P of " + names.get(edit.row()) + ", " + names.get(edit.column());
          case PROCESS_NOISE -> "Q of " + names.get(edit.row());
          case MEASUREMENT_NOISE -> "R";
        };
    return part + number + (edit.restoresAutomatic() ? " automatic again" : "=" + edit.value());
  }

  private static String unit(Parameter parameter) {
    return parameter.unit().isEmpty() ? "" : " " + parameter.unit();
  }

  private void fail(RuntimeException problem) {
    failure = problem;
  }

  private void comment(String line) throws IOException {
    text.write("# " + line + "\n");
  }

  /** Number of rows written, without header lines. */
  public long rows() {
    return rows.getAsLong();
  }

  /** Whether it has ended, because a row could not be written; any thread. */
  public boolean hasFailed() {
    return failure != null;
  }

  /** Ends the log and moves the file to its path. */
  public void finish() throws IOException {
    leave();
    if (hasFailed()) {
      throw failure;
    }
    if (table != null) {
      table.finish();
    }
    text.flush();
    file.commit();
  }

  /** Moves a log that failed to its path, with what was written. */
  public void keep() throws IOException {
    file.commit();
  }

  private void leave() {
    subscriptions.forEach(Outlet.Subscription::close);
    subscriptions.clear();
  }

  /** Ends the log; one that was not finished leaves nothing. */
  @Override
  public void close() throws IOException {
    leave();
    file.close();
  }
}
