package haltere.filters.frequency;

import haltere.core.chain.NamedProvider;
import haltere.core.chain.Outlet;
import haltere.core.chain.PublishingFilter;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.ReportClock;
import haltere.core.stream.StreamNotification;

/**
 * {@link FrequencyMap} as a stage of a chain; passes all events. Publishes {@code frequencies}: at
 * each report, and at the end of the stream, a {@link PixelFrequency} for each pixel whose
 * frequency is known, from events before that time only.
 *
 * <p>Thread rule: as {@link haltere.core.chain.EventFilter}.
 */
final class FrequencyMapFilter extends PublishingFilter<FrequencyMapSettings> {
  private final Outlet<PixelFrequency> frequencies = outlet("frequencies", PixelFrequency.class);
  private final SensorGeometry geometry;
  private final FrequencyMap map;
  private final ReportClock reports = new ReportClock();
  private final EventPacket part = new EventPacket(0);
  private boolean begun;
  private long lastReportUs;
  private long lastEventUs;

  /**
   * A filter in its initial state.
   *
   * @param geometry of the sensor
   * @param settings limits, tolerance and rate of reports
   */
  public FrequencyMapFilter(SensorGeometry geometry, FrequencyMapSettings settings) {
    this.geometry = geometry;
    map = new FrequencyMap(geometry, settings);
    reports.setRate(settings.reportRateHz());
  }

  /**
   * Frequencies of pixels.
   *
   * @return published at each report, row by row from the bottom
   */
  public Outlet<PixelFrequency> frequencies() {
    return frequencies;
  }

  @Override
  public void process(EventPacket packet) {
    int from = 0;
    while (from < packet.size()) {
      if (!begun) {
        begun = true;
        lastReportUs = Long.MIN_VALUE;
        reports.skipTo(packet.timeUs(from));
      }
      int to = packet.indexAtOrAfter(reports.nextUs(), from);
      part.clear();
      part.append(packet, from, to);
      map.add(part);
      if (to < packet.size()) {
        report(packet.timeUs(to));
      }
      from = to;
    }
    lastEventUs = from > 0 ? packet.lastTimeUs() : lastEventUs;
  }

  /**
   * Reports at all times up to that of the next event; none for pixels that were silent too long.
   */
  private void report(long nextEventUs) {
    publish(reports.nextUs());
    reports.advance();
    if (nextEventUs - reports.nextUs() > map.memoryUs()) {
      reports.skipTo(nextEventUs);
    }
    while (reports.nextUs() <= nextEventUs) {
      publish(reports.nextUs());
      reports.advance();
    }
  }

  /** {@inheritDoc} The end of the stream gives a last report; a short recording has no other. */
  @Override
  public void notified(StreamNotification notification) {
    if (notification instanceof EndOfStream && begun && lastEventUs > lastReportUs) {
      publish(lastEventUs);
    }
    super.notified(notification);
  }

  private void publish(long timeUs) {
    lastReportUs = timeUs;
    for (int y = 0; y < geometry.height(); y++) {
      for (int x = 0; x < geometry.width(); x++) {
        double frequencyHz = map.frequencyHz(x, y, timeUs);
        if (!Double.isNaN(frequencyHz)) {
          frequencies.publish(new PixelFrequency(timeUs, frequencyHz, x, y));
        }
      }
    }
  }

  @Override
  public void reset() {
    map.reset();
    begun = false;
  }

  @Override
  public long memoryUs() {
    return map.memoryUs();
  }

  @Override
  public FrequencyMapSettings settings() {
    return map.settings();
  }

  @Override
  public void apply(FrequencyMapSettings settings) {
    if (settings.reportRateHz() != settings().reportRateHz()) {
      reports.setRate(settings.reportRateHz());
    }
    map.apply(settings);
  }

  /** Creates the filter by its name in a chain. */
  public static final class Provider extends NamedProvider<FrequencyMapSettings> {
    /** Called by the service loader. */
    public Provider() {
      super(
          "frequency-map",
          "Publishes the frequency at which each pixel flickers; events pass as they are.",
          FrequencyMapSettings.class,
          FrequencyMapFilter::new);
    }
  }
}
