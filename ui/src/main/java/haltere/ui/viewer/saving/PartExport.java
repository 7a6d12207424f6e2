package haltere.ui.viewer.saving;

import haltere.core.chain.FilterChain;
import haltere.core.event.EventPacket;
import haltere.core.playback.Playable;
import haltere.core.sink.internal.Unchecked;
import haltere.core.stream.StreamHandler;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.function.LongConsumer;

/** Plays a part of what is open through a chain, without a clock, and writes what comes of it. */
abstract class PartExport implements StreamHandler, AutoCloseable {
  /**
   * What is exported.
   *
   * @param playable at its start, closed by the caller
   * @param chain for its sensor, closed by the caller
   * @param fromUs start on the elapsed timeline, microseconds
   * @param toUs end, not included
   */
  record Part(Playable playable, FilterChain chain, long fromUs, long toUs) {}

  final Part part;
  private final long startUs;
  private final EventPacket cut = new EventPacket(4096);
  private LongConsumer progress;
  private boolean past;

  /** An export that sends so much of what comes before the part through the chain, microseconds. */
  PartExport(Part part, long runUpUs) {
    this.part = part;
    startUs = Math.max(0, part.fromUs() - runUpUs);
  }

  /** Runs, telling where on the elapsed timeline it is; what was written, in words. */
  final String run(LongConsumer toTell) throws IOException {
    progress = toTell;
    try {
      if (startUs > 0) {
        part.playable().seek(startUs);
      }
      while (!past && part.playable().next(this)) {
        stopIfAsked();
      }
      return finish();
    } catch (UncheckedIOException problem) {
      throw problem.getCause();
    }
  }

  private static void stopIfAsked() throws IOException {
    if (Thread.currentThread().isInterrupted()) {
      throw new IOException("the export was ended");
    }
  }

  /** Says how far it is on the elapsed timeline, and goes on unless the export is to end. */
  final void tell(long elapsedUs) throws IOException {
    stopIfAsked();
    progress.accept(elapsedUs);
  }

  @Override
  public final void packet(EventPacket packet) {
    if (packet.isEmpty()) {
      return;
    }
    long offsetUs = part.playable().elapsedUs(packet.firstTimeUs()) - packet.firstTimeUs();
    int from = packet.indexAtOrAfter(startUs - offsetUs);
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

  /** Ends what is written, and says in words what it is. */
  abstract String finish() throws IOException;

  @Override
  public abstract void close() throws IOException;
}
