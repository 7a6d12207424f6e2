package haltere.core.format.internal.bag;

import haltere.core.event.SensorGeometry;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.decoding.StreamDecoder;
import haltere.core.format.internal.evt.Evt3Decoder;
import java.util.Optional;

/** Encoding of the events of a topic. */
enum Encoding {
  /** Single events in a message type of their own. */
  ARRAY(EventMessage.ARRAY),
  /** The words of a Prophesee camera, unchanged. */
  EVT3("evt3"),
  /** libcaer's words. */
  LIBCAER("libcaer"),
  /** libcaer's events, compressed. */
  LIBCAER_CMP("libcaer_cmp"),
  /** 64 bits an event. */
  MONO("mono"),
  /** External triggers, no pixel events. */
  TRIGGER("trigger");

  private static final int TRIGGER_BYTES = 8;

  private final String word;

  Encoding(String word) {
    this.word = word;
  }

  /** The encoding of a message; empty if it is unknown. */
  static Optional<Encoding> of(EventMessage message) {
    for (Encoding encoding : values()) {
      if (encoding.word.equals(message.encoding())) {
        return Optional.of(encoding);
      }
    }
    return Optional.empty();
  }

  /** Its name in messages. */
  String word() {
    return word;
  }

  /** Whether it contains pixel events. */
  boolean hasEvents() {
    return this != TRIGGER;
  }

  /** Number of triggers in a message. */
  static long triggers(EventMessage message) {
    return Math.max(1, message.events() / TRIGGER_BYTES);
  }

  /** A decoder before the first message. */
  StreamDecoder decoder(SensorGeometry geometry, boolean cdr, ViolationCounts violations) {
    return switch (this) {
      case ARRAY -> new EventArrayDecoder(geometry, cdr, violations);
      case EVT3 -> new Evt3Decoder(geometry, 0, violations);
      case LIBCAER -> new WordDecoder(geometry, true, violations);
      case LIBCAER_CMP -> new LibcaerPackedDecoder(geometry, violations);
      case MONO -> new WordDecoder(geometry, false, violations);
      case TRIGGER -> throw new IllegalArgumentException("triggers are no pixel events");
    };
  }
}
