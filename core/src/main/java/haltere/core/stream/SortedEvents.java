package haltere.core.stream;

import haltere.core.event.EventPacket;
import java.util.Objects;
import java.util.function.IntConsumer;

/**
 * Events that a filter has sorted by the part of it that takes them, such as each of two wings, and
 * that wait until the parts take them in: one after the other, or at the same time as {@link
 * SharedWork}. A part sees its events in order, so that the result is the same.
 *
 * <p>Thread rule: as the filter's, but for the taker, which may be called for two parts at once.
 *
 * @since 0.1
 */
public final class SortedEvents {
  /** Takes events in. */
  public interface Taker {
    /**
     * Takes the events of a part; must not touch what another part changes, nor publish.
     *
     * @param part its number
     * @param events in order of time, borrowed for the length of the call
     */
    void take(int part, EventPacket events);
  }

  private final EventPacket[] waiting;
  private final IntConsumer takeOne;
  private SharedWork work = SharedWork.ALONE;

  /**
   * Nothing waits.
   *
   * @param parts how many there are
   * @param taker takes the events of a part
   */
  public SortedEvents(int parts, Taker taker) {
    Objects.requireNonNull(taker, "taker");
    waiting = new EventPacket[parts];
    for (int part = 0; part < parts; part++) {
      waiting[part] = new EventPacket(0);
    }
    takeOne =
        part -> {
          try {
            taker.take(part, waiting[part]);
          } finally {
            waiting[part].clear();
          }
        };
  }

  /**
   * Says who does the work.
   *
   * @param with maybe two threads
   */
  public void share(SharedWork with) {
    work = Objects.requireNonNull(with, "with");
  }

  /**
   * Lets an event wait.
   *
   * @param part which part takes it
   * @param timeUs when, microseconds, not before the event before it
   * @param address packed, as in a packet
   */
  public void add(int part, long timeUs, int address) {
    waiting[part].append(timeUs, address);
  }

  /** Lets all parts take their events in; none waits afterwards. */
  public void take() {
    work.each(waiting.length, takeOne);
  }
}
