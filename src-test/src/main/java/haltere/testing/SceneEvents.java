package haltere.testing;

import haltere.core.event.EventPacket;
import haltere.core.stream.EventSource;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.io.IOException;
import java.io.UncheckedIOException;

/** The events of simulated scenes and short recordings, all at once. */
public final class SceneEvents {
  private SceneEvents() {}

  /**
   * All events of a source.
   *
   * @param source one that ends and has one segment; it is at its end afterwards
   * @return one packet
   */
  public static EventPacket of(EventSource source) {
    EventPacket all = new EventPacket(0);
    StreamHandler collect =
        new StreamHandler() {
          @Override
          public void packet(EventPacket packet) {
            all.append(packet, 0, packet.size());
          }

          @Override
          public void notified(StreamNotification notification) {
            // the events are all that counts
          }
        };
    try {
      source.drainTo(collect);
    } catch (IOException problem) {
      throw new UncheckedIOException(problem);
    }
    return all;
  }
}
