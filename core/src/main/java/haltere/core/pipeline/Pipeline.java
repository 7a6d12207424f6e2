package haltere.core.pipeline;

import haltere.core.chain.FilterChain;
import haltere.core.stream.EventSource;
import haltere.core.stream.StreamHandler;
import java.io.IOException;
import java.util.List;

/**
 * Runs source, chain and sinks at full speed on the calling thread. No packet is copied: the chain
 * works on the source's packets.
 *
 * <p>Thread rule: everything runs on the caller's thread.
 *
 * @since 0.1
 */
public final class Pipeline {
  private Pipeline() {}

  /**
   * Runs to the end of the stream; stops at the first failure.
   *
   * @param source of the stream; not closed
   * @param chain of filters; not closed
   * @param sinks receive the filtered stream
   * @param counters of the run
   * @throws IOException if the source can no longer be read, or {@link
   *     java.io.InterruptedIOException} if the thread was interrupted; the sinks have then not
   *     received an end
   * @throws haltere.core.chain.FilterFailure if a filter throws
   */
  public static void run(
      EventSource source,
      FilterChain chain,
      List<? extends StreamHandler> sinks,
      PipelineCounters counters)
      throws IOException {
    run(source, chain, sinks, counters, OnFailure.STOP);
  }

  /**
   * Runs to the end of the stream.
   *
   * @param source of the stream; not closed
   * @param chain of filters; not closed
   * @param sinks receive the filtered stream
   * @param counters of the run
   * @param onFailure reaction to an exception of a filter or a sink
   * @return failures, one line each
   * @throws IOException if the source can no longer be read, or {@link
   *     java.io.InterruptedIOException} if the thread was interrupted; the sinks have then not
   *     received an end
   * @throws haltere.core.chain.FilterFailure if a filter throws and that is to stop the run
   */
  public static List<String> run(
      EventSource source,
      FilterChain chain,
      List<? extends StreamHandler> sinks,
      PipelineCounters counters,
      OnFailure onFailure)
      throws IOException {
    List<String> failures = new java.util.ArrayList<>();
    ChainRunner runner = new ChainRunner(chain, counters, onFailure, failures::add);
    for (StreamHandler sink : sinks) {
      runner.addSink(sink, false);
    }
    source.drainTo(runner);
    return failures;
  }
}
