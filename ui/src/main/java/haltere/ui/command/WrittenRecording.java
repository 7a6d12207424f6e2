package haltere.ui.command;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorSample;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.SampleCounts;
import haltere.core.format.Violation;
import haltere.core.pipeline.JobResults;
import haltere.core.pipeline.OverflowPolicy;
import haltere.core.pipeline.Recorder;
import haltere.core.pipeline.RecorderReport;
import haltere.core.stream.StreamHandler;
import haltere.ui.command.terminal.Quantities;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/** The events that a chain passes, written to another recording. */
final class WrittenRecording implements JobResults, StreamHandler {
  private final Subcommand command;
  private final RecordingReader reader;
  private final Path file;
  private final RecordingWriter writer;
  private final Recorder recorder;
  private SampleCounts samples = SampleCounts.NONE;

  WrittenRecording(Subcommand command, RecordingReader reader, Path file, RecordingWriter writer) {
    this.command = command;
    this.reader = reader;
    this.file = file;
    this.writer = writer;
    recorder = new Recorder(writer, reader.geometry(), OverflowPolicy.BLOCK);
  }

  @Override
  public List<StreamHandler> sinks() {
    return List.of(this);
  }

  @Override
  public void packet(EventPacket packet) {
    if (!packet.isEmpty()) {
      recorder.packet(packet);
    }
  }

  @Override
  public void sample(SensorSample sample) {
    samples = samples.plus(sample.kind());
    recorder.sample(sample);
  }

  @Override
  public void finish() throws IOException {
    RecorderReport report = recorder.finish();
    writer.losses().forEach(loss -> command.warning(file + ": " + loss));
    SampleCounts leftOut = report.samplesLeftOut();
    long words = reader.violations().count(Violation.OTHER_DATA);
    if (!leftOut.isEmpty() || samples.isEmpty() && words > 0) {
      String what = leftOut.isEmpty() ? words + " words of other data" : leftOut.toString();
      String why = ": left out, as the format of " + file + " cannot hold this: ";
      command.warning(reader.path() + why + what);
    }
    SampleCounts kept = samples.minus(leftOut);
    String beside = kept.isEmpty() ? "" : ", " + kept;
    command.message("wrote %s (%s%s)", file, Quantities.events(report.written()), beside);
  }

  @Override
  public void close() throws IOException {
    recorder.close();
  }
}
