package haltere.ui.viewer.saving;

import haltere.core.chain.FilterChain;
import haltere.core.event.EventPacket;
import haltere.core.playback.Playable;
import haltere.core.sink.internal.Unchecked;
import haltere.core.stream.StreamHandler;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.function.LongConsumer;

/** Plays a part through a chain without a clock, and writes its output. */
abstract class PartExport implements StreamHandler, AutoCloseable {
  /**
   * The exported part.
   *
   * @param playable at its start, closed by the caller
   * @param chain for its sensor, closed by the caller
   * @param startUs start of the run-up on the elapsed timeline, microseconds
   * @param fromUs start of the part
   * @param toUs end, not included
   * @param sliceUs length of the slices on the screen
   */
  record ExportedPart(
      Playable playable, FilterChain chain, long startUs, long fromUs, long toUs, long sliceUs) {}

  final ExportedPart part;
  private final EventPacket cut = new EventPacket(4096);
  private LongConsumer progress;
  private boolean past;

  PartExport(ExportedPart part) {
    this.part = part;
  }

  /** Runs, and reports its position on the elapsed timeline; returns a message on the output. */
  final String run(LongConsumer listener) throws IOException {
    progress = listener;
    try {
      if (part.startUs() > 0) {
        part.playable().seek(part.startUs());
      }
      while (!past && part.playable().next(this)) {
        checkCancelled();
      }
      return finish();
    } catch (UncheckedIOException problem) {
      throw problem.getCause();
    }
  }

  private static void checkCancelled() throws IOException {
    if (Thread.currentThread().isInterrupted()) {
      throw new IOException("the export was ended");
    }
  }

  /** Reports the position on the elapsed timeline, and throws if the export is to stop. */
  final void report(long elapsedUs) throws IOException {
    checkCancelled();
    progress.accept(elapsedUs);
  }

  @Override
  public final void packet(EventPacket packet) {
    if (packet.isEmpty()) {
      return;
    }
    long offsetUs = part.playable().elapsedUs(packet.firstTimeUs()) - packet.firstTimeUs();
    int from = packet.indexAtOrAfter(part.startUs() - offsetUs);
    int to = packet.indexAtOrAfter(part.toUs() - offsetUs, from);
    past = to < packet.size();
    if (from < to) {
      cut.clear();
      cut.append(packet, from, to);
      Unchecked.write(() -> take(cut, offsetUs));
    }
  }

  /** Takes events of the run-up and the part, whose offset leads to the elapsed timeline. */
  abstract void take(EventPacket events, long offsetUs) throws IOException;

  /** Ends the output, and returns a message on it. */
  abstract String finish() throws IOException;

  @Override
  public abstract void close() throws IOException;
}
