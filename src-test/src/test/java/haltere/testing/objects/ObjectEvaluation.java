package haltere.testing.objects;

import haltere.core.event.Origin;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import haltere.core.stream.EventSource;
import haltere.testing.SceneEvents;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * Judges a tracker of objects: {@code ./gradlew :src-test:evaluateObjects}. Settings are words of
 * the form {@code name=value}:
 *
 * <ul>
 *   <li>{@code set}: recordings, composites, looks, roads, discs or all, or several with commas;
 *   <li>{@code firstSeed} and {@code seeds}: scenes of each kind;
 *   <li>{@code chain}: names of filters with commas, the last of which publishes tracks, and {@code
 *       outlet}, the name of its outlet;
 *   <li>{@code tracks}: a folder with a table SCENE.csv for each scene, instead of a chain;
 *   <li>{@code sheets}: a folder for contact sheets of the scenes;
 *   <li>{@code export}: a folder for the events of each scene as SCENE.events.csv, y upwards, and
 *       its boxes as SCENE.boxes.csv, in which case nothing is judged.
 * </ul>
 */
public final class ObjectEvaluation {
  private final Map<String, String> settings = new HashMap<>();

  private ObjectEvaluation(String[] arguments) {
    for (String argument : arguments) {
      int equals = argument.indexOf('=');
      settings.put(argument.substring(0, equals), argument.substring(equals + 1));
    }
  }

  /**
   * Judges, and prints a line for each scene and a table.
   *
   * @param arguments settings
   * @throws IOException if a file cannot be read or written
   */
  public static void main(String[] arguments) throws IOException {
    new ObjectEvaluation(arguments).run();
  }

  private String setting(String name, String otherwise) {
    return settings.getOrDefault(name, otherwise);
  }

  private void run() throws IOException {
    long firstSeed = Long.parseLong(setting("firstSeed", "1"));
    int seeds = Integer.parseInt(setting("seeds", "10"));
    String sets = setting("set", "recordings");
    StringBuilder tables = new StringBuilder();
    for (String set : sets.equals("all") ? SceneSets.NAMES : List.of(sets.split(","))) {
      ScoreTable table = new ScoreTable();
      for (SceneSets.Later later : SceneSets.of(set, firstSeed, seeds)) {
        judge(later.make(), table);
      }
      tables.append(System.lineSeparator()).append(table);
    }
    boolean isHeldOut = firstSeed >= SceneSets.FIRST_HELD_OUT_SEED;
    System.out.println((isHeldOut ? "Held-out seeds" : "Tuning seeds") + tables);
  }

  private void judge(ObjectScene scene, ScoreTable table) throws IOException {
    Optional<Path> export = folder("export");
    if (export.isPresent()) {
      export(scene, export.get());
      return;
    }
    List<TrackRow> rows;
    try (EventSource events = scene.events().open()) {
      rows = tracker().track(scene.name(), events);
    }
    ObjectScore score = ObjectScore.of(scene, rows);
    table.add(scene.kind(), score);
    System.out.printf(
        Locale.ROOT,
        "%s: IDF1 %.3f MOTA %.3f covered %.3f tracks on it %.2f identities %.1f elsewhere %.3f%n",
        scene.name(),
        score.idf1(),
        score.mota(),
        score.covered(),
        score.tracksOnIt(),
        score.identities(),
        score.elsewhere());
    Optional<Path> sheets = folder("sheets");
    if (sheets.isPresent()) {
      TruthSheet.draw(scene, rows, sheets.get());
    }
  }

  private Optional<Path> folder(String name) throws IOException {
    Optional<Path> folder = Optional.ofNullable(settings.get(name)).map(Path::of);
    if (folder.isPresent()) {
      Files.createDirectories(folder.get());
    }
    return folder;
  }

  private TrackerUnderTest tracker() {
    String tracks = settings.get("tracks");
    if (tracks != null) {
      return (scene, events) -> TrackTable.read(Path.of(tracks, scene + ".csv"));
    }
    String chain = setting("chain", "object-tracker");
    return new ChainTracker(List.of(chain.split(",")), setting("outlet", "objects"));
  }

  private static void export(ObjectScene scene, Path folder) throws IOException {
    StringBuilder boxes = new StringBuilder("t_us,x0_px,y0_px,x1_px,y1_px,id\n");
    for (TruthMoment moment : scene.truth()) {
      moment.ignored().forEach(box -> boxes.append(line(moment, box, "ignore")));
      moment.objects().forEach(o -> boxes.append(line(moment, o.box(), "" + o.id())));
    }
    Files.writeString(folder.resolve(scene.name() + ".boxes.csv"), boxes);
    Path file = folder.resolve(scene.name() + ".events.csv");
    try (EventSource events = scene.events().open();
        RecordingWriter writer =
            Recordings.forWriting(file)
                .create(
                    file,
                    new WriteOptions(events.geometry(), true, Optional.of(Origin.BOTTOM), Map.of()))
                .orElseThrow()) {
      writer.write(SceneEvents.of(events));
      writer.finish();
    }
  }

  private static String line(TruthMoment moment, Box box, String id) {
    return String.format(
        Locale.ROOT,
        "%d,%.1f,%.1f,%.1f,%.1f,%s%n",
        moment.timeUs(),
        box.x0(),
        box.y0(),
        box.x1(),
        box.y1(),
        id);
  }
}
