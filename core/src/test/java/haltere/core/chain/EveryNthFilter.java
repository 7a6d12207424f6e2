package haltere.core.chain;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;
import haltere.core.stream.StreamNotification;
import java.util.ArrayList;
import java.util.List;

/** A filter to test chains with: passes every n-th event and remembers what it was told. */
final class EveryNthFilter implements ConfigurableFilter<EveryNthFilter.Settings> {
  enum Start {
    AT_FIRST_EVENT,
    AFTER_FULL_ROUND
  }

  record Settings(
      @Help("Which event of a round passes.") @Range(min = 1, max = 100) @Unit("events") int n,
      @Help("Where the counting begins.") Start start,
      Extras extras) {
    Settings {
      SettingsSchema.validate(Settings.class, n, start, extras);
    }

    static Settings defaults() {
      return new Settings(2, Start.AT_FIRST_EVENT, new Extras(0.5));
    }

    static Settings of(int n) {
      return new Settings(n, Start.AT_FIRST_EVENT, new Extras(0.5));
    }
  }

  record Extras(
      @Help("A ratio without any effect.") @Range(min = 0, max = 1) @Unit("1") double ratio) {
    Extras {
      SettingsSchema.validate(Extras.class, ratio);
    }
  }

  final Outlet<Long> passed = new Outlet<>("passed", Long.class);
  final List<String> log = new ArrayList<>();
  private Settings settings;
  private long count;
  boolean closed;

  EveryNthFilter(Settings settings) {
    this.settings = settings;
    reset();
  }

  @Override
  public void process(EventPacket packet) {
    log.add("packet of " + packet.size());
    int kept = 0;
    for (int i = 0; i < packet.size(); i++) {
      if (count++ % settings.n() == 0) {
        passed.publish(packet.timeUs(i));
        packet.move(i, kept++);
      }
    }
    packet.truncate(kept);
  }

  @Override
  public void reset() {
    count = settings.start() == Start.AT_FIRST_EVENT ? 0 : 1;
  }

  @Override
  public void notified(StreamNotification notification) {
    log.add(notification.toString());
    ConfigurableFilter.super.notified(notification);
  }

  @Override
  public List<Outlet<?>> outlets() {
    return List.of(passed);
  }

  @Override
  public Settings settings() {
    return settings;
  }

  @Override
  public void apply(Settings newSettings) {
    settings = newSettings;
  }

  @Override
  public void close() {
    closed = true;
  }

  /** Found as a service in these tests. */
  public static class Provider implements FilterProvider<Settings> {
    @Override
    public String name() {
      return "every-nth";
    }

    @Override
    public String description() {
      return "Passes every n-th event.";
    }

    @Override
    public Class<Settings> settingsType() {
      return Settings.class;
    }

    @Override
    public EveryNthFilter create(SensorGeometry geometry, Settings settings) {
      return new EveryNthFilter(settings);
    }
  }
}
