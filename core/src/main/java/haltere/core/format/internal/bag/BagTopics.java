package haltere.core.format.internal.bag;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The topics of a bag that are known so far, by their numbers in the messages.
 *
 * <p>Thread rule: one thread.
 */
final class BagTopics {
  /** Limit for damaged files, above that of any bag. */
  private static final int MAX_TOPICS = 1 << 16;

  private final Map<Long, BagTopic> byNumber = new LinkedHashMap<>();

  /** Adds a topic; the first one of a number is kept. */
  void add(long number, BagTopic topic) {
    if (byNumber.size() < MAX_TOPICS) {
      byNumber.putIfAbsent(number, topic);
    }
  }

  /** The topic of a number, or null if there is none. */
  BagTopic get(long number) {
    return byNumber.get(number);
  }

  /** All topics, each once, in the order of their discovery. */
  List<BagTopic> all() {
    return byNumber.values().stream().distinct().toList();
  }

  /** The topics with events. */
  List<BagTopic> ofEvents() {
    return all().stream().filter(topic -> topic.kind() != BagTopic.TopicKind.OTHER).toList();
  }
}
