package haltere.ui.command;

import haltere.core.pipeline.JobResults;
import haltere.core.pipeline.RecorderReport;
import haltere.core.pipeline.SessionRecorder;
import haltere.core.stream.StreamHandler;
import haltere.ui.command.terminal.Quantities;
import java.io.IOException;
import java.nio.file.Files;
import java.util.List;

/** A camera's recording in parts, as the result of a job. */
record SessionResults(Subcommand command, SessionRecorder recorder) implements JobResults {
  @Override
  public List<StreamHandler> sinks() {
    return List.of(recorder);
  }

  @Override
  public void finish() throws IOException {
    recorder.finish();
    print();
  }

  /** Prints the parts of a recording that has ended, and what they lack. */
  void print() throws IOException {
    for (SessionRecorder.Part part : recorder.parts()) {
      RecorderReport report = part.report();
      command.message(
          "wrote %s (%s, %.1f MB)",
          part.file(), Quantities.events(report.written()), Files.size(part.file()) / 1e6);
      if (report.lost() > 0) {
        String lost = Quantities.events(report.lost());
        command.warning(part.file() + ": lost " + lost + ", the disk is too slow");
      }
      if (!report.samplesLeftOut().isEmpty()) {
        command.warning(
            part.file() + ": the format cannot hold " + report.samplesLeftOut() + ", left out");
      }
    }
    RecordingWritingOptions.endedEarly(recorder).ifPresent(command::reportFailure);
  }

  @Override
  public void close() throws IOException {
    recorder.close();
  }
}
