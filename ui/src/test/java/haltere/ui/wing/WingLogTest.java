package haltere.ui.wing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.format.AtomicFile;
import haltere.core.simulation.internal.fly.FlyScene;
import haltere.core.simulation.internal.fly.FlySceneSettings;
import haltere.filters.wing.WingFilterEdit;
import haltere.filters.wing.WingFilterEdit.Table;
import haltere.filters.wing.WingPart;
import haltere.filters.wing.WingTrackerSettings;
import haltere.filters.wing.tracker.WingTrackerFilter;
import haltere.testing.SceneEvents;
import haltere.ui.wing.WingLogFormat.Layout;
import haltere.ui.wing.WingLogFormat.Rows;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class WingLogTest {
  @TempDir Path folder;

  @ParameterizedTest
  @CsvSource({"TICK,TABLE", "BEAT,TABLE", "EVENT,TABLE", "TICK,ORIGINAL", "EVENT,ORIGINAL"})
  void changedSettingsAreLoggedBetweenRows(Rows rows, Layout layout) throws IOException {
    FlyScene scene =
        new FlyScene(
            FlySceneSettings.defaults().with("run.durationS=0.1", "fly.wing.visibleShare=0.15"));
    EventPacket fly = SceneEvents.of(scene);
    WingTrackerFilter filter =
        new WingTrackerFilter(scene.geometry(), WingTrackerSettings.defaults());
    Path file = folder.resolve("log.txt");
    int half = fly.indexAtOrAfter(70_000);
    AtomicFile out = AtomicFile.create(file, false);
    try (WingLog log = WingLog.open(out, "fly", filter, new WingLogFormat(rows, layout))) {
      filter.process(part(fly, 0, half));
      filter.apply(filter.settings().with("noise.amplitude=0.5"));
      filter.process(part(fly, half, fly.size()));
      log.finish();
    }
    List<String> lines = Files.readAllLines(file);
    int told = lines.indexOf("# setting changed: noise.amplitude=0.5 rad^2/s");
    assertTrue(lines.contains("# setting: noise.amplitude=0.02 rad^2/s (default)"));
    assertTrue(!lines.get(told - 1).startsWith("#"), "rows before it");
    assertTrue(!lines.get(told + 1).startsWith("#"), "one setting, and rows after it");
    assertEquals(told, lines.lastIndexOf(lines.get(told)), "told once");
  }

  @ParameterizedTest
  @CsvSource({"TICK,TABLE", "EVENT,ORIGINAL"})
  void manualFilterEditsAreLoggedBetweenRows(Rows rows, Layout layout) throws IOException {
    FlyScene scene = new FlyScene(FlySceneSettings.defaults().with("run.durationS=0.1"));
    EventPacket fly = SceneEvents.of(scene);
    WingTrackerFilter filter =
        new WingTrackerFilter(scene.geometry(), WingTrackerSettings.defaults());
    Path file = folder.resolve("log.txt");
    int half = fly.indexAtOrAfter(80_000);
    AtomicFile out = AtomicFile.create(file, false);
    try (WingLog log = WingLog.open(out, "fly", filter, new WingLogFormat(rows, layout))) {
      filter.process(part(fly, 0, half));
      filter.tracker().edit(new WingFilterEdit(WingPart.LEFT, Table.STATE, 1, 0, 1.25));
      filter.tracker().edit(new WingFilterEdit(WingPart.RIGHT, Table.COVARIANCE, 0, 0, 0.01));
      filter.tracker().edit(new WingFilterEdit(WingPart.LEFT, Table.MEASUREMENT_NOISE, 0, 0, 0.02));
      filter.tracker().edit(new WingFilterEdit(WingPart.LEFT, Table.PROCESS_NOISE, 4, 0, 0.003));
      filter
          .tracker()
          .edit(new WingFilterEdit(WingPart.LEFT, Table.PROCESS_NOISE, 4, 0, Double.NaN));
      filter.tracker().restart(WingPart.RIGHT);
      filter.process(part(fly, half, fly.size()));
      log.finish();
    }
    List<String> lines = Files.readAllLines(file);
    int told = lines.indexOf("# manual change: left x of amplitude=1.25");
    assertTrue(told > 0 && !lines.get(told - 1).startsWith("#"), "rows before it");
    assertEquals(
        List.of(
            "# manual change: right P of centre, centre=0.01",
            "# manual change: left R=0.02",
            "# manual change: left Q of half width=0.003",
            "# manual change: left Q of half width automatic again",
            "# manual change: right restarted"),
        lines.subList(told + 1, told + 6));
    assertTrue(!lines.get(told + 6).startsWith("#"), "rows after it");
  }

  private static EventPacket part(EventPacket events, int from, int to) {
    EventPacket part = new EventPacket(to - from);
    part.append(events, from, to);
    return part;
  }
}
