package haltere.core.simulation.internal.sensor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.settings.SettingsProblem;
import haltere.core.simulation.Scenes;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.util.List;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class TunableSceneTest {
  /** When a scene is changed. */
  private static final long CHANGED_US = 20_000;

  /** From when a change is in effect. */
  private static final long SETTLED_US = 40_000;

  /** The end of a run; a rendered scene is dear and rich in events. */
  private static long endUs(String name) {
    return name.startsWith("rendered") ? 60_000 : 170_000;
  }

  static Stream<String> tunable() {
    return Scenes.all().keySet().stream()
        .filter(name -> Scenes.named(name).create(List.of()) instanceof TunableScene<?>);
  }

  /** Events of a scene with a change. */
  private static StreamRecorder run(String name, UnaryOperator<SensorTuning> change)
      throws IOException {
    TunableScene<?> scene = (TunableScene<?>) Scenes.named(name).create(List.of());
    StreamRecorder recorder = new StreamRecorder();
    drain(scene, recorder, CHANGED_US);
    scene.tune(change.apply(scene.tuning()));
    drain(scene, recorder, endUs(name));
    return recorder;
  }

  private static void drain(TunableScene<?> scene, StreamRecorder recorder, long untilUs)
      throws IOException {
    while (recorder.events().isEmpty() || recorder.events().lastTimeUs() < untilUs) {
      scene.next(recorder);
    }
  }

  /** Events from when the change is in effect. */
  private static long after(String name, StreamRecorder recorder) {
    EventPacket events = recorder.events();
    return events.indexAtOrAfter(endUs(name), 0) - events.indexAtOrAfter(SETTLED_US, 0);
  }

  private static double shareOn(String name, StreamRecorder recorder) {
    EventPacket events = recorder.events();
    int on = 0;
    int from = events.indexAtOrAfter(SETTLED_US, 0);
    int to = events.indexAtOrAfter(endUs(name), 0);
    for (int i = from; i < to; i++) {
      on += events.isOn(i) ? 1 : 0;
    }
    return (double) on / (to - from);
  }

  @Test
  void tunableScenesExist() {
    assertEquals(List.of("fly", "rendered-fly", "road"), tunable().toList());
  }

  @ParameterizedTest
  @MethodSource("tunable")
  void tuningToThePresentValueChangesNothing(String name) throws IOException {
    StreamRecorder untouched = new StreamRecorder();
    drain((TunableScene<?>) Scenes.named(name).create(List.of()), untouched, endUs(name));
    StreamRecorder tuned = run(name, tuning -> tuning);
    assertEquals(after(name, untouched), after(name, tuned), 0.005 * after(name, untouched));
  }

  @ParameterizedTest
  @MethodSource("tunable")
  void eventRateFallsWithTheThreshold(String name) throws IOException {
    UnaryOperator<SensorTuning> quiet = tuning -> tuning.with("shotHz", 0).with("leakHz", 0);
    long usual = after(name, run(name, quiet));
    long high = after(name, run(name, tuning -> quiet.apply(tuning).with("threshold", 0.6)));
    long low = after(name, run(name, tuning -> quiet.apply(tuning).with("threshold", 0.1)));
    assertTrue(high < 0.8 * usual && usual < 0.8 * low, high + " " + usual + " " + low);
  }

  @ParameterizedTest
  @MethodSource("tunable")
  void balanceShiftsEventsBetweenPolarities(String name) throws IOException {
    double off = shareOn(name, run(name, t -> new SensorTuning(t.pixel(), t.noise(), -1)));
    double usual = shareOn(name, run(name, tuning -> tuning));
    double on = shareOn(name, run(name, t -> new SensorTuning(t.pixel(), t.noise(), 1)));
    assertTrue(off < usual - 0.05 && on > usual + 0.05, off + " " + usual + " " + on);
  }

  @Test
  void slowPhotoreceptorMakesFewerWingEvents() throws IOException {
    long usual = after("fly", run("fly", tuning -> tuning));
    long slow = after("fly", run("fly", tuning -> tuning.with("bandwidthHz", 100)));
    assertTrue(slow < 0.7 * usual, slow + " " + usual);
  }

  @Test
  void noiseIsTuned() throws IOException {
    UnaryOperator<SensorTuning> quiet = tuning -> tuning.with("shotHz", 0).with("leakHz", 0);
    long without = after("road", run("road", quiet));
    long with = after("road", run("road", tuning -> quiet.apply(tuning).with("shotHz", 10)));
    double seconds = (endUs("road") - SETTLED_US) * 1e-6;
    assertEquals(128 * 128 * 10 * seconds, with - without, 0.1 * 128 * 128 * 10 * seconds);
  }

  @Test
  void tuningIsReproducible() throws IOException {
    UnaryOperator<SensorTuning> change =
        tuning -> tuning.with("threshold", 0.3).with("shotHz", 3).with("latencyUs", 0);
    assertEquals(run("fly", change).crc32(), run("fly", change).crc32());
  }

  @Test
  void valuesOutOfRangeAreRejected() {
    SensorTuning usual = new SensorTuning(PixelSettings.defaults(), NoiseSettings.defaults(), 0);
    assertThrows(SettingsProblem.class, () -> usual.with("threshold", 5));
    assertThrows(SettingsProblem.class, () -> usual.with("no-such", 1));
    assertThrows(
        IllegalArgumentException.class,
        () -> new SensorTuning(usual.pixel(), usual.noise(), Double.NaN));
  }
}
