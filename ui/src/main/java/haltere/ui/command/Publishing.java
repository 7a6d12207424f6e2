package haltere.ui.command;

import haltere.core.pipeline.JobResults;
import haltere.core.pipeline.LiveResults;
import haltere.core.stream.StreamHandler;
import haltere.ui.command.terminal.Quantities;
import java.io.InterruptedIOException;
import java.util.ArrayList;
import java.util.List;

/**
 * The outputs to other programs while a command runs.
 *
 * <p>Thread rule: the command's thread.
 *
 * @param command prints messages
 * @param open the outputs, one for each address
 */
record Publishing(Subcommand command, List<LiveResults> open) implements JobResults {
  private static final long POLL_MS = 5;

  /** Nothing is sent yet. */
  Publishing(Subcommand command) {
    this(command, new ArrayList<>());
  }

  void add(LiveResults results) {
    open.add(results);
    results.onFailure(
        text -> command.reportFailure(results.address() + ": sending has stopped: " + text));
    command.message("publishing at " + results.address());
  }

  /** Waits until each address with known receivers has this number of them. */
  void await(int receivers) throws InterruptedIOException {
    for (LiveResults results : open) {
      while (results.receivers() >= 0 && results.receivers() < receivers) {
        try {
          Thread.sleep(POLL_MS);
        } catch (InterruptedException stopped) {
          Thread.currentThread().interrupt();
          throw new InterruptedIOException("interrupted while waiting for receivers");
        }
      }
    }
  }

  @Override
  public List<StreamHandler> sinks() {
    return List.copyOf(open);
  }

  @Override
  public void finish() {
    // each line was sent at once
  }

  @Override
  public void close() {
    for (LiveResults results : open) {
      results.close();
      if (results.refused() > 0) {
        command.warning(
            "%s: refused %s, because there were too many",
            results.address(), Quantities.counted(results.refused(), "connection"));
      }
      if (results.lost() > 0) {
        boolean slow = results.failure().isEmpty();
        command.warning(
            "%s: lost %s%s",
            results.address(),
            Quantities.counted(results.lost(), "message"),
            slow ? ", because a receiver or this computer was too slow" : "");
      }
    }
    open.clear();
  }
}
