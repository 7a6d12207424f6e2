package haltere.core.stream;

import haltere.core.event.EventPacket;
import java.util.Objects;
import java.util.function.IntConsumer;

/**
 * Queues of events for the parts of a filter, such as two wings. The parts process their events one
 * after the other, or in parallel by {@link SharedWork}. Each part sees its events in order, so
 * that results are identical.
 *
 * <p>Thread rule: as the filter, except for the handler, which may be called for two parts at once.
 *
 * @since 0.1
 */
public final class EventQueues {
  /** Processes the events of a part. */
  public interface PartHandler {
    /**
     * Processes events; must not access state of another part, nor publish.
     *
     * @param part its index
     * @param events in order of time, borrowed for the length of the call
     */
    void handle(int part, EventPacket events);
  }

  private final EventPacket[] waiting;
  private final IntConsumer processPart;
  private SharedWork work = SharedWork.ALONE;

  /**
   * Empty queues.
   *
   * @param parts number of parts
   * @param handler processes the events of a part
   */
  public EventQueues(int parts, PartHandler handler) {
    Objects.requireNonNull(handler, "handler");
    waiting = new EventPacket[parts];
    for (int part = 0; part < parts; part++) {
      waiting[part] = new EventPacket(0);
    }
    processPart =
        part -> {
          try {
            handler.handle(part, waiting[part]);
          } finally {
            waiting[part].clear();
          }
        };
  }

  /**
   * Sets the threads of the work.
   *
   * @param with one or two threads
   */
  public void share(SharedWork with) {
    work = Objects.requireNonNull(with, "with");
  }

  /**
   * Adds an event.
   *
   * @param part its part
   * @param timeUs microseconds, not before the previous event
   * @param address packed, as in a packet
   */
  public void add(int part, long timeUs, int address) {
    waiting[part].append(timeUs, address);
  }

  /** Lets all parts process their events; the queues are empty afterwards. */
  public void process() {
    work.each(waiting.length, processPart);
  }
}
