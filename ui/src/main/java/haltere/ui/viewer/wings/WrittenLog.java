package haltere.ui.viewer.wings;

import haltere.core.chain.FilterChain;
import haltere.core.playback.Player;
import haltere.core.sink.internal.Unchecked;
import haltere.core.stream.StreamHandler;
import haltere.filters.wing.tracker.WingTrackerFilter;
import haltere.ui.viewer.controls.Texts;
import haltere.ui.viewer.feature.PlayedOutput;
import haltere.ui.wing.WingLog;
import haltere.ui.wing.WingLogFormat;
import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;

/**
 * A log of the wings that is written while it plays; a file that is there is replaced, and appears
 * when the log is ended.
 *
 * <p>Thread rule: as {@link PlayedOutput.Output}; the log itself belongs to the processing thread.
 */
record WrittenLog(WingLog log, Path file, Player player) implements PlayedOutput.Output {
  /** Begins a log of the wing tracker in the chain; in the background. */
  static WrittenLog begin(Path file, WingLogFormat format, Player player) {
    AtomicReference<WingLog> made = new AtomicReference<>();
    onChain(player, chain -> made.set(open(chain, file, player.playable().name(), format)));
    return new WrittenLog(made.get(), file, player);
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
  public String begun() {
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
