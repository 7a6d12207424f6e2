package haltere.ui.viewer.wings;

import haltere.core.chain.FilterChain;
import haltere.core.format.AtomicFile;
import haltere.core.playback.Player;
import haltere.core.sink.internal.Unchecked;
import haltere.core.stream.StreamHandler;
import haltere.filters.wing.tracker.WingTrackerFilter;
import haltere.ui.viewer.controls.Texts;
import haltere.ui.viewer.feature.PlaybackOutput;
import haltere.ui.wing.WingLog;
import haltere.ui.wing.WingLogFormat;
import java.io.IOException;
import java.util.concurrent.atomic.AtomicReference;

/**
 * A log of the wings, written during playback; an existing file is replaced when the log ends.
 *
 * <p>Thread rule: as {@link PlaybackOutput.Output}; the log itself belongs to the processing
 * thread.
 */
record WingLogOutput(WingLog log, AtomicFile file, Player player) implements PlaybackOutput.Output {
  /** Begins a log of the wing tracker in the chain, in a new file; in the background. */
  static WingLogOutput begin(AtomicFile file, WingLogFormat format, Player player) {
    AtomicReference<WingLog> made = new AtomicReference<>();
    player.read(chain -> made.set(open(chain, file, player.playable().name(), format))).join();
    return new WingLogOutput(made.get(), file, player);
  }

  private static WingLog open(
      FilterChain chain, AtomicFile file, String source, WingLogFormat format) {
    WingTrackerFilter filter = WingsView.orRefuse(chain).filter();
    return Unchecked.read(() -> WingLog.open(file, source, filter, format));
  }

  @Override
  public StreamHandler sink() {
    // the log listens to the tracker
    return packet -> {};
  }

  @Override
  public String startMessage() {
    return "Logging wings to " + file.path().getFileName();
  }

  @Override
  public boolean isOver() {
    return log.hasFailed();
  }

  @Override
  public String finish() {
    player.read(chain -> Unchecked.write(this::close)).join();
    return "Logged " + Texts.count(log.rows()) + " rows of wings";
  }

  private void close() throws IOException {
    try (log) {
      try {
        log.finish();
      } catch (IOException | RuntimeException problem) {
        log.keep();
        throw new IOException(Texts.oneLine(problem) + "; what was logged before is kept", problem);
      }
    }
  }
}
