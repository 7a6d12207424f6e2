package haltere.ui.viewer.compare;

import haltere.core.chain.FilterChain;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorSample;
import haltere.core.playback.SliceSink;
import haltere.core.stream.StreamNotification;
import haltere.ui.viewer.picture.DisplaySink;

/**
 * A second chain on the same stream. It gets a copy of each packet before the first chain, so both
 * process the same events.
 *
 * @param chain its filters
 * @param first the chain beside it, which is in a run-up when this one is
 * @param display makes its pictures, with those of the first chain
 * @param copy the packet that it works on
 */
record SecondChain(FilterChain chain, FilterChain first, DisplaySink display, EventPacket copy)
    implements SliceSink {
  SecondChain(FilterChain chain, FilterChain first, DisplaySink display) {
    this(chain, first, display.beside(chain), new EventPacket(4096));
  }

  @Override
  public void packet(EventPacket packet) {
    copy.clear();
    copy.append(packet, 0, packet.size());
    chain.setRunUp(first.isRunUp());
    chain.process(copy);
    display.packet(copy);
  }

  @Override
  public void sample(SensorSample sample) {
    chain.sample(sample);
  }

  @Override
  public void notified(StreamNotification notification) {
    chain.setRunUp(first.isRunUp());
    chain.notified(notification);
    display.notified(notification);
  }

  @Override
  public long memoryUs(long sliceUs) {
    return Math.max(chain.memoryUs(), display.memoryUs(sliceUs));
  }

  @Override
  public void runUpBegins(long sliceUs) {
    display.runUpBegins(sliceUs);
  }

  @Override
  public void runUpEnds() {
    display.runUpEnds();
  }

  @Override
  public void sliceHeld() {
    display.sliceHeld();
  }

  @Override
  public void sliceEnd(long fromUs, long toUs) {
    display.sliceEnd(fromUs, toUs);
  }

  /** Ends; nothing more is handed to it. */
  void close() {
    display.close();
    chain.close();
  }
}
