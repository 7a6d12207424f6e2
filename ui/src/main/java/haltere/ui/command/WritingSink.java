package haltere.ui.command;

import haltere.core.event.EventPacket;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.pipeline.PipelineCounters;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.io.IOException;
import java.io.UncheckedIOException;

/** Writes what comes out of a chain to a recording and moves the progress bar. */
final class WritingSink implements StreamHandler {
  private final RecordingReader reader;
  private final RecordingWriter writer;
  private final ProgressBar bar;
  private final PipelineCounters counters;

  /**
   * A sink.
   *
   * @param reader where the events come from, for the bar
   * @param writer takes the events; null to write nothing
   * @param bar shows how far the reader is
   * @param counters know how many events went into the chain
   */
  WritingSink(
      RecordingReader reader, RecordingWriter writer, ProgressBar bar, PipelineCounters counters) {
    this.reader = reader;
    this.writer = writer;
    this.bar = bar;
    this.counters = counters;
  }

  @Override
  public void packet(EventPacket packet) {
    if (writer != null && !packet.isEmpty()) {
      try {
        writer.write(packet);
      } catch (IOException problem) {
        throw new UncheckedIOException(problem);
      }
    }
    bar.events(counters.get(PipelineCounters.Counter.EVENTS_IN));
    bar.progress(reader.positionBytes(), reader.sizeBytes());
  }

  @Override
  public void notified(StreamNotification notification) {
    // a recording has no place for notices; its reader finds them anew
  }
}
