package haltere.testing.objects;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.LongStream;

/** The sets of scenes that object trackers are judged on, by name. */
public final class SceneSets {
  /** First seed of held-out scenes. Seeds below it are for tuning. */
  public static final long FIRST_HELD_OUT_SEED = 1_000_000;

  /** Names of all sets. */
  public static final List<String> NAMES =
      List.of("recordings", "parts", "variants", "composites", "looks", "roads", "discs");

  /** Makes a scene when it is needed, so that few are in memory. */
  public interface Later {
    /**
     * Makes the scene.
     *
     * @return always the same one
     * @throws IOException if a recording cannot be read
     */
    ObjectScene make() throws IOException;
  }

  private SceneSets() {}

  /**
   * The scenes of a set.
   *
   * @param set one of {@link #NAMES}
   * @param firstSeed of each kind of scene; recordings have none
   * @param seeds how many scenes of each kind
   * @return those of one kind one after the other
   */
  public static List<Later> of(String set, long firstSeed, int seeds) {
    long[] range = LongStream.range(firstSeed, firstSeed + seeds).toArray();
    List<Later> scenes = new ArrayList<>();
    switch (set) {
      case "recordings" ->
          LabelledRecording.all().forEach(recording -> scenes.add(recording::scene));
      case "parts" -> {
        for (LabelledRecording recording : LabelledRecording.all()) {
          for (long seed : range) {
            scenes.add(() -> recording.part(seed));
          }
        }
      }
      case "variants" -> {
        for (LabelledRecording recording : LabelledRecording.all()) {
          for (long seed : range) {
            scenes.add(() -> recording.variant(seed));
          }
        }
      }
      case "composites" -> {
        for (Composites.Arrangement kind : Composites.Arrangement.values()) {
          for (long seed : range) {
            scenes.add(() -> Composites.scene(kind, seed));
          }
        }
      }
      case "looks" -> {
        for (Looks.Look look : Looks.Look.values()) {
          for (long seed : range) {
            scenes.add(() -> Looks.scene(look, seed));
          }
        }
      }
      case "roads" -> {
        for (Roads.Traffic traffic : Roads.Traffic.values()) {
          for (Roads.EdgeEvents events : Roads.EdgeEvents.values()) {
            for (long seed : range) {
              scenes.add(() -> Roads.scene(traffic, events, seed));
            }
          }
        }
      }
      case "discs" -> {
        for (long seed : range) {
          scenes.add(() -> Discs.scene(seed));
        }
      }
      default -> throw new IllegalArgumentException("there is no set " + set);
    }
    return scenes;
  }
}
