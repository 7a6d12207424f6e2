package haltere.testing.objects;

import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.testing.Recorded;
import haltere.testing.SceneEvents;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;

/**
 * A real recording whose objects are labelled, and how it is played. Recordings of less than a
 * second are repeated, for a tracker needs some tenths of a second to show an object.
 *
 * @param file name in the folder of recordings
 * @param playback how it is played
 * @param fromMs start of the stretch that is played, from the first event, milliseconds
 * @param toMs end of that stretch, milliseconds
 * @param times how often it is played
 */
public record LabelledRecording(String file, Playback playback, long fromMs, long toMs, int times) {
  /** Playback of a recording. */
  public enum Playback {
    /** Unchanged. */
    ONCE,
    /** From the start again at the end: its objects end where they began. */
    LOOP,
    /** Forwards and backwards by turns: its objects rest at the start and at the end. */
    BACK_AND_FORTH
  }

  private static LabelledRecording once(String file) {
    return new LabelledRecording(file, Playback.ONCE, 0, Long.MAX_VALUE / 2000, 1);
  }

  /**
   * All labelled recordings.
   *
   * @return those labelled from all of their events first
   */
  public static List<LabelledRecording> all() {
    return List.of(
        once("dvs128-pendulum.aedat"),
        once("dvs128-walking-10s.aedat"),
        once("dvs128-moving-dark-box.aedat"),
        once("dvs128-gesture.aedat4"),
        once("dvs128-tmpdiff128-2007.dat"),
        once("davis346-events-frames-imu.aedat4"),
        once("imx636-evt3.raw"),
        once("evt3-eventpacket.bag"),
        once("davis240c-rotating-disk-imu-aps.aedat"),
        new LabelledRecording("dvxplorer-sample.aedat4", Playback.BACK_AND_FORTH, 0, 470, 8),
        new LabelledRecording("dvs.es", Playback.LOOP, 1, 1000, 4),
        new LabelledRecording("nmnist-sample.bin", Playback.LOOP, 0, 311, 12));
  }

  /**
   * The recording as a scene.
   *
   * @return its scores are reported by themselves
   * @throws IOException if there are no labels of it
   */
  public ObjectScene scene() throws IOException {
    return withVelocities(
        playback == Playback.ONCE
            ? new ObjectScene(file, file, () -> open(path()), LabelledBoxes.of(file), Matching.BOX)
            : footage().scene(file, file));
  }

  /**
   * A part of the recording: it begins somewhere in the first half of its labels, and a tenth of
   * its events is left out. A tracker that depends on how a recording begins has other scores on
   * it.
   *
   * @param seed the same seed makes the same scene
   * @return a scene of the recording's kind
   * @throws IOException if the file or its labels cannot be read
   */
  public ObjectScene part(long seed) throws IOException {
    SplittableRandom random = new SplittableRandom(seed);
    return withVelocities(part(random).thinned(0.1, random).scene(file + "-" + seed, file));
  }

  /**
   * A variant of the recording: it begins somewhere in the first half of its labels, lacks up to
   * seven tenths of its events, runs at half to twice its speed, may be mirrored, and may have up
   * to two events of noise a second in each pixel. Other cameras and other scenes differ so.
   *
   * @param seed the same seed makes the same scene
   * @return a scene of the recording's kind
   * @throws IOException if the file or its labels cannot be read
   */
  public ObjectScene variant(long seed) throws IOException {
    SplittableRandom random = new SplittableRandom(seed);
    Footage variant =
        part(random)
            .thinned(random.nextDouble(0.7), random)
            .stretched(Math.pow(2, random.nextDouble(-1, 1)));
    if (random.nextBoolean()) {
      variant = variant.mirrored();
    }
    if (random.nextBoolean()) {
      variant = variant.withNoise(random.nextDouble(2), random);
    }
    return withVelocities(variant.scene(file + "-" + seed, file));
  }

  /**
   * The recording backwards in time: objects begin where and as they end. A tracker that depends on
   * how they begin has other scores on it.
   *
   * @return a scene of the recording's kind
   * @throws IOException if the file or its labels cannot be read
   */
  public ObjectScene backwards() throws IOException {
    Footage whole = whole();
    return withVelocities(
        whole.reversed(whole.events().lastTimeUs()).scene(file + "-backwards", file));
  }

  /** With the velocities of the labels, unless objects jump back to their first positions. */
  private ObjectScene withVelocities(ObjectScene scene) {
    return playback == Playback.LOOP
        ? scene
        : new ObjectScene(
            scene.name(),
            scene.kind(),
            scene.events(),
            LabelVelocities.of(scene.truth()),
            scene.matching());
  }

  private Footage whole() throws IOException {
    return playback == Playback.ONCE ? read() : footage();
  }

  private Footage part(SplittableRandom random) throws IOException {
    Footage whole = whole();
    List<TruthMoment> labels = whole.truth();
    long firstUs = labels.get(0).timeUs();
    long lastUs = labels.get(labels.size() - 1).timeUs();
    long fromUs = firstUs + (long) (random.nextDouble(0.5) * (lastUs - firstUs));
    return whole.between(fromUs, Long.MAX_VALUE);
  }

  /** All played events, in memory. */
  Footage footage() throws IOException {
    Footage whole = read();
    long firstUs = whole.events().firstTimeUs();
    long startUs = firstUs + fromMs * 1000;
    long endUs = Math.min(firstUs + toMs * 1000, whole.events().lastTimeUs() + 1);
    Footage once = whole.between(startUs, endUs);
    Footage played = once;
    for (int i = 1; i < times; i++) {
      long shiftUs = i * (endUs - startUs);
      boolean backwards = playback == Playback.BACK_AND_FORTH && i % 2 == 1;
      played =
          played.then(
              backwards
                  ? once.reversed(endUs).shifted(shiftUs - (endUs - startUs))
                  : once.shifted(shiftUs));
    }
    return played;
  }

  private Footage read() throws IOException {
    try (RecordingReader reader = open(path())) {
      return new Footage(reader.geometry(), SceneEvents.of(reader), LabelledBoxes.of(file));
    }
  }

  private static RecordingReader open(Path path) throws IOException {
    return Recordings.open(path, ReadOptions.DEFAULT);
  }

  /**
   * Where the file should be.
   *
   * @return its path, whether it is there or not
   */
  public Path path() {
    return Recorded.path(file);
  }
}
