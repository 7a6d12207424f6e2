package haltere.core.format.internal.decoding;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/** Lines for users on recordings with several streams of events, of which one is read. */
public final class Topics {
  private Topics() {}

  /**
   * The order of {@link #remark}.
   *
   * @param read the topic that is read
   * @param topics with events, in the order of the file
   * @return the same ones, the one that is read first
   */
  public static List<String> readFirst(String read, List<String> topics) {
    return topics.stream().sorted(Comparator.comparing(name -> !name.equals(read))).toList();
  }

  /**
   * Names those that are not read.
   *
   * @param topics with events, the one that is read first
   * @return a line, or empty without others
   */
  public static Optional<String> remark(List<String> topics) {
    return topics.size() < 2
        ? Optional.empty()
        : Optional.of(
            "the events of topic "
                + topics.get(0)
                + " are read; --topic chooses another: "
                + String.join(", ", topics.subList(1, topics.size())));
  }

  /**
   * Says that there is none of a name.
   *
   * @param wanted the name
   * @param there the topics with events
   * @return a line
   */
  public static String missing(String wanted, List<String> there) {
    return "it has no topic of events named "
        + wanted
        + (there.isEmpty() ? "" : "; there are " + String.join(", ", there));
  }
}
