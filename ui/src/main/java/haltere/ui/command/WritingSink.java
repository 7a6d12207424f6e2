package haltere.ui.command;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorReading;
import haltere.core.format.ReadingCounts;
import haltere.core.format.RecordingReader;
import haltere.core.pipeline.PipelineCounters;
import haltere.core.pipeline.Recorder;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.ui.command.terminal.ProgressBar;

/** Writes what comes out of a chain to a recording and moves the progress bar. */
final class WritingSink implements StreamHandler {
  private final RecordingReader reader;
  private final Recorder recorder;
  private final ProgressBar bar;
  private final PipelineCounters counters;
  private ReadingCounts readings = ReadingCounts.NONE;

  /**
   * A sink.
   *
   * @param reader where the events come from, for the bar
   * @param recorder takes the events and readings; null to write nothing
   * @param bar shows how far the reader is
   * @param counters know how many events went into the chain
   */
  WritingSink(
      RecordingReader reader, Recorder recorder, ProgressBar bar, PipelineCounters counters) {
    this.reader = reader;
    this.recorder = recorder;
    this.bar = bar;
    this.counters = counters;
  }

  @Override
  public void packet(EventPacket packet) {
    if (recorder != null && !packet.isEmpty()) {
      recorder.packet(packet);
    }
    bar.events(counters.get(PipelineCounters.Counter.EVENTS_IN));
    bar.progress(reader.positionBytes(), reader.sizeBytes());
  }

  @Override
  public void reading(SensorReading reading) {
    readings = readings.plus(reading.kind());
    if (recorder != null) {
      recorder.reading(reading);
    }
  }

  /** How many readings came by. */
  ReadingCounts readings() {
    return readings;
  }

  @Override
  public void notified(StreamNotification notification) {
    // a recording has no place for notices; its reader finds them anew
  }
}
