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
  private static final long HALF_US = 150_000;

  static Stream<String> tunable() {
    return Scenes.all().keySet().stream()
        .filter(name -> Scenes.named(name).create(List.of()) instanceof TunableScene<?>);
  }

  /** What a scene makes with a change in the middle. */
  private static StreamRecorder run(String name, UnaryOperator<SensorTuning> change)
      throws IOException {
    TunableScene<?> scene = (TunableScene<?>) Scenes.named(name).create(List.of());
    StreamRecorder recorder = new StreamRecorder();
    drain(scene, recorder, HALF_US);
    scene.tune(change.apply(scene.tuning()));
    drain(scene, recorder, 2 * HALF_US);
    return recorder;
  }

  private static void drain(TunableScene<?> scene, StreamRecorder recorder, long untilUs)
      throws IOException {
    while (recorder.events().isEmpty() || recorder.events().lastTimeUs() < untilUs) {
      scene.next(recorder);
    }
  }

  /** Events of the second half, from when the change is in effect. */
  private static long after(StreamRecorder recorder) {
    EventPacket events = recorder.events();
    return events.indexAtOrAfter(2 * HALF_US, 0) - events.indexAtOrAfter(HALF_US + 20_000, 0);
  }

  private static double shareOn(StreamRecorder recorder) {
    EventPacket events = recorder.events();
    int on = 0;
    int from = events.indexAtOrAfter(HALF_US + 20_000, 0);
    int to = events.indexAtOrAfter(2 * HALF_US, 0);
    for (int i = from; i < to; i++) {
      on += events.isOn(i) ? 1 : 0;
    }
    return (double) on / (to - from);
  }

  @Test
  void thereAreTunableScenes() {
    assertEquals(List.of("fly", "rendered-fly", "road"), tunable().toList());
  }

  @ParameterizedTest
  @MethodSource("tunable")
  void whatIsTunedToWhatItIsGoesOnAsItWas(String name) throws IOException {
    StreamRecorder untouched = new StreamRecorder();
    drain((TunableScene<?>) Scenes.named(name).create(List.of()), untouched, 2 * HALF_US);
    StreamRecorder tuned = run(name, tuning -> tuning);
    assertEquals(after(untouched), after(tuned), 0.005 * after(untouched));
  }

  @ParameterizedTest
  @MethodSource("tunable")
  void aHigherThresholdMakesFewerEventsAndALowerOneMore(String name) throws IOException {
    UnaryOperator<SensorTuning> quiet = tuning -> tuning.with("shotHz", 0).with("leakHz", 0);
    long usual = after(run(name, quiet));
    long high = after(run(name, tuning -> quiet.apply(tuning).with("threshold", 0.6)));
    long low = after(run(name, tuning -> quiet.apply(tuning).with("threshold", 0.1)));
    assertTrue(high < 0.8 * usual && usual < 0.8 * low, high + " " + usual + " " + low);
  }

  @ParameterizedTest
  @MethodSource("tunable")
  void balanceMovesEventsFromOnePolarityToTheOther(String name) throws IOException {
    double off = shareOn(run(name, t -> new SensorTuning(t.pixel(), t.noise(), -1)));
    double usual = shareOn(run(name, tuning -> tuning));
    double on = shareOn(run(name, t -> new SensorTuning(t.pixel(), t.noise(), 1)));
    assertTrue(off < usual - 0.05 && on > usual + 0.05, off + " " + usual + " " + on);
  }

  @Test
  void aSlowPhotoreceptorSeesLessOfABeatingWing() throws IOException {
    long usual = after(run("fly", tuning -> tuning));
    long slow = after(run("fly", tuning -> tuning.with("bandwidthHz", 100)));
    assertTrue(slow < 0.7 * usual, slow + " " + usual);
  }

  @Test
  void noiseIsTunedToo() throws IOException {
    UnaryOperator<SensorTuning> quiet = tuning -> tuning.with("shotHz", 0).with("leakHz", 0);
    long without = after(run("road", quiet));
    long with = after(run("road", tuning -> quiet.apply(tuning).with("shotHz", 10)));
    double seconds = (HALF_US - 20_000) * 1e-6;
    assertEquals(128 * 128 * 10 * seconds, with - without, 0.1 * 128 * 128 * 10 * seconds);
  }

  @Test
  void theSameChangesMakeTheSameEvents() throws IOException {
    UnaryOperator<SensorTuning> change =
        tuning -> tuning.with("threshold", 0.3).with("shotHz", 3).with("latencyUs", 0);
    assertEquals(run("fly", change).crc32(), run("fly", change).crc32());
  }

  @Test
  void valuesOutOfRangeAreRefused() {
    SensorTuning usual = new SensorTuning(PixelSettings.defaults(), NoiseSettings.defaults(), 0);
    assertThrows(SettingsProblem.class, () -> usual.with("threshold", 5));
    assertThrows(SettingsProblem.class, () -> usual.with("no-such", 1));
    assertThrows(
        IllegalArgumentException.class,
        () -> new SensorTuning(usual.pixel(), usual.noise(), Double.NaN));
  }
}
