package haltere.core.format.internal.bag;

import haltere.core.event.EventAddress;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.decoding.SampleCursor;
import haltere.core.format.internal.decoding.SensorGuess;
import haltere.core.format.internal.decoding.Topics;
import haltere.core.format.internal.reader.DecodingReader;
import java.io.IOException;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * Opens a bag of any container: selects the topic and detects sensor and encoding of its events.
 */
final class BagOpening {
  private static final int ANY_SIDE = EventAddress.MAX_COORDINATE + 1;
  private static final long NS_PER_S = 1_000_000_000;

  /** Creates walks through the messages of a bag. */
  @FunctionalInterface
  interface Walks {
    /** A walk from the start that stops at the messages of some topics. */
    MessageWalk from(MessageWalk.Wanted wanted, ViolationCounts violations) throws IOException;
  }

  /** The first message with events. */
  private record First(
      BagTopic topic, EventMessage message, Encoding encoding, Optional<String> compression) {}

  private final String formatName;
  private final RecordingFile file;
  private final ReadOptions options;
  private final BagTopics topics;
  private final Walks walks;
  private final List<String> remarks = new ArrayList<>();

  /**
   * A bag to open.
   *
   * @param formatName the container's name
   * @param file the bag
   * @param options the user's options
   * @param topics the known topics, to which walks add others
   * @param walks creates walks through its messages
   */
  BagOpening(
      String formatName, RecordingFile file, ReadOptions options, BagTopics topics, Walks walks) {
    this.formatName = formatName;
    this.file = file;
    this.options = options;
    this.topics = topics;
    this.walks = walks;
  }

  /** Adds remarks for users. */
  BagOpening remark(List<String> lines) {
    remarks.addAll(lines);
    return this;
  }

  /**
   * Opens it.
   *
   * @param violations the violations found so far
   */
  RecordingReader open(ViolationCounts violations) throws IOException {
    Optional<First> found = first();
    checkTopics(found);
    First first =
        found.orElseGet(
            () ->
                new First(
                    topics.ofEvents().stream().filter(this::isRequested).findFirst().orElseThrow(),
                    new EventMessage(0, 0, 0, -1, 0, EventMessage.ARRAY, false, 0, false),
                    Encoding.ARRAY,
                    Optional.empty()));
    SensorGeometry geometry = geometry(first, found.isPresent());
    remarkOnTopics(first.topic());
    found.ifPresent(this::remarkOnTime);
    return new DecodingReader(
        formatName,
        file,
        geometry,
        remarks,
        options,
        violations,
        counts -> cursor(first, geometry, counts),
        Optional.of(first).filter(one -> one.encoding() == Encoding.EVT3).map(this::triggers));
  }

  private SampleCursor.SampleCursors triggers(First first) {
    return counted -> new BagTriggerCursor(messages(first.topic()::equals, new ViolationCounts()));
  }

  private BagCursor cursor(First first, SensorGeometry geometry, ViolationCounts violations)
      throws IOException {
    return new BagCursor(
        messages(first.topic()::equals, violations),
        geometry,
        first.encoding(),
        first.topic().cdr(),
        first.compression(),
        violations);
  }

  private MessageWalk messages(MessageWalk.Wanted wanted, ViolationCounts violations)
      throws IOException {
    return new DecompressingWalk(walks.from(wanted, violations));
  }

  private boolean isRequested(BagTopic topic) {
    return topic.kind() != BagTopic.TopicKind.OTHER
        && (options.topic().isEmpty() || options.topic().get().equals(topic.name()));
  }

  /** Finds the first message with events. */
  private Optional<First> first() throws IOException {
    ViolationCounts ignored = new ViolationCounts();
    MessageBody body = new MessageBody();
    try (MessageWalk walk = messages(this::isRequested, ignored)) {
      while (walk.find()) {
        try {
          body.open(walk.payload(), walk.size());
          EventMessage message = EventMessage.read(walk.topic(), body);
          Optional<Encoding> encoding = Encoding.of(message);
          if (encoding.isPresent() && encoding.get().hasEvents() && message.events() > 0) {
            return Optional.of(
                new First(walk.topic(), message, encoding.get(), Optional.of(walk.compression())));
          }
          walk.pass(walk.size() - body.used());
        } catch (DamagedPacketException e) {
          walk.damaged(e);
        }
      }
    }
    return Optional.empty();
  }

  private void checkTopics(Optional<First> found) throws RecordingProblem {
    if (found.isPresent() || topics.ofEvents().stream().anyMatch(this::isRequested)) {
      return;
    }
    if (options.topic().isPresent()) {
      throw new RecordingProblem(
          file.path(), Topics.missing(options.topic().get(), names(topics.ofEvents())));
    }
    throw new RecordingProblem(
        file.path(),
        "it has no topic of events"
            + (topics.all().isEmpty()
                ? ""
                : ", only "
                    + topics.all().stream()
                        .limit(20)
                        .map(topic -> topic.name() + " (" + topic.type() + ")")
                        .collect(Collectors.joining(", "))));
  }

  private static List<String> names(List<BagTopic> topics) {
    return topics.stream().map(BagTopic::name).distinct().toList();
  }

  private void remarkOnTopics(BagTopic chosen) {
    List<String> names = Topics.readFirst(chosen.name(), names(topics.ofEvents()));
    Topics.remark(names).ifPresent(remarks::add);
  }

  private void remarkOnTime(First first) {
    if (first.encoding() == Encoding.EVT3) {
      long stampNs = first.message().stampNs();
      Instant stamp =
          Instant.ofEpochSecond(Math.floorDiv(stampNs, NS_PER_S), Math.floorMod(stampNs, NS_PER_S));
      remarks.add("times are the camera's own, not those of ROS; the first message is of " + stamp);
    }
  }

  private SensorGeometry geometry(First first, boolean found) throws IOException {
    long width = first.message().width();
    long height = first.message().height();
    if (width > 0 && height > 0 && width <= ANY_SIDE && height <= ANY_SIDE) {
      return SensorGuess.top((int) width, (int) height);
    }
    if (options.sensor().isPresent()) {
      SensorGeometry given = options.sensor().get();
      return SensorGuess.top(given.width(), given.height());
    }
    SensorGeometry guess = SensorGuess.COMMON_SIZES.get(0);
    if (found) {
      BagCursor any = cursor(first, SensorGuess.square(ANY_SIDE), new ViolationCounts());
      guess = SensorGuess.smallest(any, ANY_SIDE, SensorGuess.COMMON_SIZES).orElse(guess);
    }
    remarks.add(SensorGuess.remark(guess));
    return guess;
  }
}
