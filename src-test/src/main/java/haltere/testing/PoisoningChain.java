package haltere.testing;

import haltere.core.chain.EventFilter;
import haltere.core.chain.Outlet;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorSample;
import haltere.core.overlay.OverlayLayer;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;

/**
 * Passes a filter a packet whose arrays are overwritten after each call, so that a filter that
 * stores the packet or an array gives wrong results, and checks before the next call that they were
 * not written in between. The filtered packet is copied back.
 */
public final class PoisoningChain implements EventFilter, StreamHandler {
  private static final long POISON_TIME_US = 0x0bad_c0de_0bad_c0deL;
  private static final int POISON_ADDRESS = 0x7bad_c0de;

  private final EventFilter filter;
  private final EventPacket lent = new EventPacket(0);

  /**
   * Stands before a filter.
   *
   * @param filter a filter or a chain
   */
  public PoisoningChain(EventFilter filter) {
    this.filter = Objects.requireNonNull(filter, "filter");
  }

  @Override
  public void process(EventPacket packet) {
    checkPoison();
    lent.append(packet, 0, packet.size());
    filter.process(lent);
    packet.clear();
    packet.append(lent, 0, lent.size());
    Arrays.fill(lent.timesUs(), POISON_TIME_US);
    Arrays.fill(lent.addresses(), POISON_ADDRESS);
    lent.clear();
  }

  @Override
  public void packet(EventPacket packet) {
    process(packet);
  }

  /** Checks that the packet has not changed since the last call. */
  public void checkPoison() {
    if (!lent.isEmpty()) {
      throw new AssertionError("a packet was filled after the call that lent it");
    }
    if (lent.capacity() == 0) {
      return;
    }
    for (long timeUs : lent.timesUs()) {
      if (timeUs != POISON_TIME_US) {
        throw new AssertionError("a packet's times were written after the call that lent it");
      }
    }
    for (int address : lent.addresses()) {
      if (address != POISON_ADDRESS) {
        throw new AssertionError("a packet's addresses were written after the call that lent it");
      }
    }
  }

  @Override
  public void reset() {
    filter.reset();
  }

  @Override
  public void sample(SensorSample sample) {
    checkPoison();
    filter.sample(sample);
  }

  @Override
  public void notified(StreamNotification notification) {
    checkPoison();
    filter.notified(notification);
  }

  @Override
  public List<Outlet<?>> outlets() {
    return filter.outlets();
  }

  @Override
  public List<OverlayLayer<?>> overlays() {
    return filter.overlays();
  }

  @Override
  public void close() {
    checkPoison();
    filter.close();
  }
}
