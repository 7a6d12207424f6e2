package haltere.ui.command;

import haltere.core.pipeline.JobResults;
import haltere.core.pipeline.SessionRecorder;
import haltere.core.stream.StreamHandler;
import haltere.ui.command.terminal.Quantities;
import java.io.IOException;
import java.util.List;

/** A camera's recording in parts, as the result of a job. */
record SessionResults(Subcommand command, SessionRecorder recorder) implements JobResults {
  @Override
  public List<StreamHandler> sinks() {
    return List.of(recorder);
  }

  @Override
  public void finish() throws IOException {
    for (SessionRecorder.Part part : recorder.finish()) {
      command.message(
          "wrote " + part.file() + " (" + Quantities.events(part.report().written()) + ")");
    }
    RecordingWritingOptions.endedEarly(recorder).ifPresent(command::reportFailure);
  }

  @Override
  public void close() throws IOException {
    recorder.close();
  }
}
