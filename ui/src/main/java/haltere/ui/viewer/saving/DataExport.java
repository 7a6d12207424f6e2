package haltere.ui.viewer.saving;

import haltere.core.chain.FilterChain;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorSample;
import haltere.core.format.RecordingWriter;
import haltere.core.playback.Playable;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.function.LongConsumer;

/**
 * Plays a stretch of what is open through a chain, without a clock, and writes what the chain
 * leaves of it.
 *
 * <p>Thread rule: everything happens on the calling thread.
 */
final class DataExport implements StreamHandler {
  private final Playable playable;
  private final FilterChain chain;
  private final RecordingWriter writer;
  private final long fromUs;
  private final long toUs;
  private final EventPacket part = new EventPacket(4096);
  private long written;
  private long lastUs = StreamNotification.NO_TIME_US;
  private long reachedUs;
  private boolean past;
  private boolean ended;

  /**
   * An export.
   *
   * @param playable at its start, closed by the caller
   * @param chain for its sensor
   * @param writer empty, closed by the caller
   * @param fromUs start on the elapsed timeline
   * @param toUs end, not included
   */
  DataExport(Playable playable, FilterChain chain, RecordingWriter writer, long fromUs, long toUs) {
    this.playable = playable;
    this.chain = chain;
    this.writer = writer;
    this.fromUs = fromUs;
    this.toUs = toUs;
  }

  /**
   * Runs, telling where on the elapsed timeline it is, and returns how many events were written.
   */
  long run(LongConsumer progress) throws IOException {
    try {
      if (fromUs > 0) {
        playable.seek(fromUs);
      }
      while (!past && playable.next(this)) {
        if (Thread.currentThread().isInterrupted()) {
          throw new IOException("the export was ended");
        }
        progress.accept(reachedUs);
      }
    } catch (UncheckedIOException problem) {
      throw problem.getCause();
    }
    if (!ended) {
      chain.notified(new EndOfStream(lastUs));
    }
    writer.finish();
    return written;
  }

  @Override
  public void packet(EventPacket packet) {
    if (packet.isEmpty()) {
      return;
    }
    long offsetUs = playable.elapsedUs(packet.firstTimeUs()) - packet.firstTimeUs();
    int from = packet.indexAtOrAfter(fromUs - offsetUs);
    int to = packet.indexAtOrAfter(toUs - offsetUs, from);
    past = to < packet.size();
    if (to == from) {
      return;
    }
    lastUs = packet.timeUs(to - 1);
    reachedUs = lastUs + offsetUs;
    part.clear();
    part.append(packet, from, to);
    chain.packet(part);
    written += part.size();
    try {
      writer.write(part);
    } catch (IOException problem) {
      throw new UncheckedIOException(problem);
    }
  }

  @Override
  public void sample(SensorSample sample) {
    long elapsedUs = playable.elapsedUs(sample.timeUs());
    if (elapsedUs < fromUs || elapsedUs >= toUs) {
      return;
    }
    chain.sample(sample);
    try {
      writer.write(sample);
    } catch (IOException problem) {
      throw new UncheckedIOException(problem);
    }
  }

  @Override
  public void notified(StreamNotification notification) {
    ended |= notification instanceof EndOfStream;
    chain.notified(notification);
  }
}
