package haltere.ui.viewer.session;

import haltere.core.chain.ChainFile;
import haltere.core.chain.FilterChain;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.format.Recordings;
import haltere.core.playback.KeptPlayable;
import haltere.core.playback.Playable;
import haltere.core.playback.RecordingPlayable;
import haltere.core.playback.ScenePlayable;
import haltere.core.simulation.Scenes;
import haltere.core.simulation.internal.fly.FlyScene;
import haltere.core.simulation.internal.fly.FlySceneSettings;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * What can be opened, and the chain that it goes through.
 *
 * <p>Thread rule: any thread but JavaFX's, because files are read.
 */
public final class Sources {
  /** Events of a camera or a scene that are kept, in 48 MB. */
  private static final int KEPT_EVENTS = 6_000_000;

  private Sources() {}

  /** The built-in scene. */
  static Playable flyScene() {
    return new ScenePlayable(() -> new FlyScene(FlySceneSettings.defaults()), "Fly scene");
  }

  /** A simulated scene, by its name on the command line, with its default settings. */
  static Playable scene(String name, String title) {
    return new ScenePlayable(() -> Scenes.named(name).create(List.of()), title);
  }

  /** A camera or a scene, so that one can go back to its last moments. */
  static Playable kept(Playable source) {
    return new KeptPlayable(source, KEPT_EVENTS);
  }

  /** A recording; one that cannot be read is told in one line for a person. */
  public static Playable recording(Path file, ReadOptions options) throws IOException {
    var reader = Recordings.open(file, options.withSamples(true));
    try {
      return new RecordingPlayable(reader);
    } catch (IOException | RuntimeException problem) {
      reader.close();
      throw problem;
    }
  }

  /** A saved chain made anew for a sensor, which it has to fit. */
  public static FilterChain chain(SensorGeometry geometry, String json) throws IOException {
    return ChainFile.parse(json, "the chain", geometry);
  }

  /** A chain that was kept for a recording or a scene; empty where it does not fit any more. */
  static Optional<FilterChain> ownChain(SensorGeometry geometry, String json) {
    try {
      return Optional.of(chain(geometry, json));
    } catch (IOException | RuntimeException unfit) {
      return Optional.empty();
    }
  }
}
