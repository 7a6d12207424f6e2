package haltere.ui.command;

import haltere.core.chain.FilterChain;
import haltere.core.pipeline.LiveResults;
import haltere.core.sink.LineOutputs;
import java.io.IOException;
import java.time.Clock;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;

/** Options of commands that can send results to other programs. */
final class PublishingOptions extends OptionGroup {
  @Option(
      names = "--publish",
      paramLabel = "ADDRESS",
      description =
          "Send results of the filters while they run, one line of JSON each, to tcp://HOST:PORT "
              + "(listens), udp://HOST:PORT or zmq://HOST:PORT (a PUB socket). May be repeated.")
  List<String> addresses = List.of();

  @Option(
      names = "--outlet",
      paramLabel = "STAGE/OUTLET",
      description = "Send only this outlet, such as object-tracker/objects. May be repeated.")
  List<String> outlets = List.of();

  @Option(
      names = "--receivers",
      paramLabel = "N",
      defaultValue = "0",
      description =
          "Wait until this many programs have connected to each tcp:// or zmq:// " + "address.")
  int receivers;

  /**
   * Rejects, by a {@link ParameterException}, invalid addresses and options without their main
   * option.
   */
  void check() {
    try {
      addresses.forEach(LineOutputs::check);
    } catch (IllegalArgumentException wrong) {
      throw wrong(wrong.getMessage());
    }
    subcommand().checkNeeded(!addresses.isEmpty(), "--publish", "--outlet", "--receivers");
  }

  /** Starts to publish a chain's results, before it runs; may publish none. */
  Publishing open(FilterChain chain, Subcommand subcommand) throws IOException {
    Publishing publishing = new Publishing(subcommand);
    try {
      return open(chain, publishing);
    } catch (IOException | RuntimeException problem) {
      publishing.close();
      throw problem;
    }
  }

  /** Starts to publish in addition to present outputs, and returns them all. */
  Publishing open(FilterChain chain, Publishing publishing) throws IOException {
    Predicate<String> wanted = addresses.isEmpty() ? name -> false : wanted(chain);
    for (String address : addresses) {
      publishing.add(LiveResults.open(chain, LineOutputs.open(address), wanted, Clock.systemUTC()));
    }
    publishing.await(receivers);
    return publishing;
  }

  private Predicate<String> wanted(FilterChain chain) {
    if (outlets.isEmpty()) {
      return name -> true;
    }
    List<String> there = LiveResults.outlets(chain);
    for (String outlet : outlets) {
      if (!there.contains(outlet)) {
        throw new CommandProblem(
            "nothing publishes " + outlet + "; there are " + String.join(", ", there));
      }
    }
    Set<String> chosen = new HashSet<>(outlets);
    return chosen::contains;
  }
}
