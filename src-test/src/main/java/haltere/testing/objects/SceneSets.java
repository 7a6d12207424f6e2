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
      List.of(
          "recordings", "backwards", "parts", "variants", "composites", "looks", "roads", "discs");

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
      case "backwards" ->
          LabelledRecording.all().forEach(recording -> scenes.add(recording::backwards));
      case "parts" -> add(scenes, LabelledRecording.all(), range, LabelledRecording::part);
      case "variants" -> add(scenes, LabelledRecording.all(), range, LabelledRecording::variant);
      case "composites" ->
          add(scenes, List.of(Composites.Arrangement.values()), range, Composites::scene);
      case "looks" -> add(scenes, List.of(Looks.Look.values()), range, Looks::scene);
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

  private interface Maker<K> {
    ObjectScene make(K kind, long seed) throws IOException;
  }

  private static <K> void add(List<Later> scenes, List<K> kinds, long[] seeds, Maker<K> maker) {
    for (K kind : kinds) {
      for (long seed : seeds) {
        scenes.add(() -> maker.make(kind, seed));
      }
    }
  }
}
