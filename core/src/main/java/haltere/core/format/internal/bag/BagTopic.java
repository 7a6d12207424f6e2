package haltere.core.format.internal.bag;

/**
 * A topic of a bag: its messages are all of one type.
 *
 * @param name such as {@code /dvs/events}
 * @param type such as {@code dvs_msgs/EventArray}; ROS 2 has {@code /msg} in between
 * @param cdr whether messages are serialised as in ROS 2, else as in ROS 1
 */
record BagTopic(String name, String type, boolean cdr) {
  /** The contents of its messages. */
  enum TopicKind {
    /** Single events: {@code dvs_msgs/EventArray} and similar types. */
    ARRAY,
    /** Bytes that encode events: {@code event_camera_msgs/EventPacket} and its predecessor. */
    PACKET,
    /** No events. */
    OTHER
  }

  /** The contents of the messages, by their type. */
  TopicKind kind() {
    return switch (type.replace("/msg/", "/")) {
      case "dvs_msgs/EventArray", "prophesee_event_msgs/EventArray" -> TopicKind.ARRAY;
      case "event_camera_msgs/EventPacket", "event_array_msgs/EventArray" -> TopicKind.PACKET;
      default -> TopicKind.OTHER;
    };
  }
}
