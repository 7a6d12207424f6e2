package haltere.ui.viewer.compare;

import haltere.core.chain.FilterChain;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorSample;
import haltere.core.playback.SliceSink;
import haltere.core.stream.StreamNotification;
import haltere.ui.plot.PublishedMeans;
import haltere.ui.viewer.picture.DisplaySink;
import java.util.ArrayList;
import java.util.List;

/**
 * A second chain on the same stream. It gets a copy of each packet before the first chain, so both
 * process the same events.
 *
 * @param chain its filters
 * @param first the chain beside it, which is in a run-up when this one is
 * @param display makes its pictures, with those of the first chain
 * @param copy the packet that it works on
 * @param numbers means of the first and of this chain; none before the first run-up
 */
record SecondChain(
    FilterChain chain,
    FilterChain first,
    DisplaySink display,
    EventPacket copy,
    List<PublishedMeans> numbers)
    implements SliceSink {
  SecondChain(FilterChain chain, FilterChain first, DisplaySink display) {
    this(chain, first, display.beside(chain), new EventPacket(4096), new ArrayList<>());
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
    restartNumbers();
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

  /** Begins new means of the present filters. */
  void restartNumbers() {
    numbers.forEach(PublishedMeans::close);
    numbers.clear();
    numbers.addAll(List.of(new PublishedMeans(first), new PublishedMeans(chain)));
  }

  /** Ends; nothing more is handed to it. */
  void close() {
    display.close();
    chain.close();
  }
}
