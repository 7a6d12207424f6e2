package haltere.core.format.internal.bag;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The topics of a bag that are known so far, by the numbers that its messages name them with.
 *
 * <p>Thread rule: one thread.
 */
final class BagTopics {
  /** More than a bag can have. */
  private static final int MAX_TOPICS = 1 << 16;

  private final Map<Long, BagTopic> byNumber = new LinkedHashMap<>();

  /** Takes note of a topic; the first word on a number counts. */
  void add(long number, BagTopic topic) {
    if (byNumber.size() < MAX_TOPICS) {
      byNumber.putIfAbsent(number, topic);
    }
  }

  /** The topic of a number, or null if there is none. */
  BagTopic get(long number) {
    return byNumber.get(number);
  }

  /** All of them, each once, in the order in which they became known. */
  List<BagTopic> all() {
    return byNumber.values().stream().distinct().toList();
  }

  /** Those that have events. */
  List<BagTopic> ofEvents() {
    return all().stream().filter(topic -> topic.kind() != BagTopic.Kind.OTHER).toList();
  }
}
