package haltere.ui.command.results;

import haltere.core.event.Frame;
import haltere.core.event.InertialSample;
import haltere.core.event.Trigger;
import haltere.core.settings.Parameter;
import haltere.core.sink.Column;

/** Rows of the tables of samples. */
final class SampleTables {
  private SampleTables() {}

  /** A row of inertial samples; units are in the names of the columns. */
  record SampleRow(@Column("t_us") long timeUs, @Column(joined = true) InertialSample sample) {
    static SampleRow of(InertialSample sample) {
      return new SampleRow(sample.timeUs(), sample);
    }
  }

  /** A row of triggers: a rising or falling edge or a pulse of an input. */
  record TriggerRow(@Column("t_us") long timeUs, String source, String edge, int channel) {
    static TriggerRow of(Trigger trigger) {
      return new TriggerRow(
          trigger.timeUs(),
          Parameter.text(trigger.source()),
          Parameter.text(trigger.edge()),
          trigger.channel());
    }
  }

  /**
   * A row of frames: start and end of the exposure and of the readout, and the column and row of
   * the sensor at the left and lower edge of the picture of a file.
   */
  record FrameRow(
      @Column("t_us") long timeUs,
      @Column("exposure_end_us") long exposureEndUs,
      @Column("readout_start_us") long readoutStartUs,
      @Column("readout_end_us") long readoutEndUs,
      int leftPx,
      int bottomPx,
      String file) {
    static FrameRow of(Frame frame, String file) {
      Frame.Times times = frame.times();
      return new FrameRow(
          frame.timeUs(),
          times.exposureEndUs(),
          times.readoutStartUs(),
          times.readoutEndUs(),
          frame.left(),
          frame.bottom(),
          file);
    }
  }
}
