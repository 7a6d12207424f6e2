package haltere.core.pipeline;

import haltere.core.stream.StreamHandler;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/** Several results as one. */
final class JoinedResults implements JobResults {
  private final List<JobResults> all = new ArrayList<>();

  private JoinedResults() {}

  static JoinedResults open(Opener... openers) throws IOException {
    JoinedResults joined = new JoinedResults();
    try {
      for (Opener opener : openers) {
        joined.all.add(opener.open());
      }
      return joined;
    } catch (IOException | RuntimeException | Error problem) {
      joined.close();
      throw problem;
    }
  }

  @Override
  public List<StreamHandler> rawSinks() {
    return all.stream().flatMap(results -> results.rawSinks().stream()).toList();
  }

  @Override
  public List<StreamHandler> sinks() {
    return all.stream().flatMap(results -> results.sinks().stream()).toList();
  }

  @Override
  public void finish() throws IOException {
    for (JobResults results : all) {
      results.finish();
    }
  }

  @Override
  public List<ResultFile> files() {
    return all.stream().flatMap(results -> results.files().stream()).toList();
  }

  @Override
  public void close() throws IOException {
    IOException problem = null;
    for (JobResults results : all) {
      try {
        results.close();
      } catch (IOException thrown) {
        problem = thrown;
      }
    }
    if (problem != null) {
      throw problem;
    }
  }
}
