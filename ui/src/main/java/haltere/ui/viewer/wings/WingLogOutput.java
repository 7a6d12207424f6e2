package haltere.ui.viewer.wings;

import haltere.core.chain.FilterChain;
import haltere.core.playback.Player;
import haltere.core.sink.internal.Unchecked;
import haltere.core.stream.StreamHandler;
import haltere.filters.wing.tracker.WingTrackerFilter;
import haltere.ui.viewer.controls.Texts;
import haltere.ui.viewer.feature.PlaybackOutput;
import haltere.ui.wing.WingLog;
import haltere.ui.wing.WingLogFormat;
import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;

/**
 * A log of the wings, written during playback; an existing file is replaced when the log ends.
 *
 * <p>Thread rule: as {@link PlaybackOutput.Output}; the log itself belongs to the processing
 * thread.
 */
record WingLogOutput(WingLog log, Path file, Player player) implements PlaybackOutput.Output {
  /** Begins a log of the wing tracker in the chain; in the background. */
  static WingLogOutput begin(Path file, WingLogFormat format, Player player) {
    AtomicReference<WingLog> made = new AtomicReference<>();
    onChain(player, chain -> made.set(open(chain, file, player.playable().name(), format)));
    return new WingLogOutput(made.get(), file, player);
  }

  private static WingLog open(FilterChain chain, Path file, String source, WingLogFormat format) {
    WingTrackerFilter filter = WingsView.orRefuse(chain).filter();
    return Unchecked.read(() -> WingLog.open(file, source, filter, format, true));
  }

  private static void onChain(Player player, Consumer<FilterChain> work) {
    player.read(work).join();
  }

  @Override
  public StreamHandler sink() {
    // the log listens to the tracker
    return packet -> {};
  }

  @Override
  public String startMessage() {
    return "Logging wings to " + file.getFileName();
  }

  @Override
  public String finish() {
    onChain(player, chain -> Unchecked.write(this::close));
    return "Logged " + Texts.count(log.rows()) + " rows of wings";
  }

  private void close() throws IOException {
    try (log) {
      log.finish();
    }
  }
}
