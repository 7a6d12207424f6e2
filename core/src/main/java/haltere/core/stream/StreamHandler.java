package haltere.core.stream;

import haltere.core.event.EventPacket;

/** Takes a stream: packets and notifications, one at a time, in order, on the processing thread. */
public interface StreamHandler {
  /**
   * Takes the next packet. It is borrowed: it must not be kept after the call.
   *
   * @param packet events in ascending time
   */
  void packet(EventPacket packet);

  /**
   * Takes the next notification. One that means nothing to the handler is ignored.
   *
   * @param notification what happened between the last packet and the next one
   */
  void notified(StreamNotification notification);
}
