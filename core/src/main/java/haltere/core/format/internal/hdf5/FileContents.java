package haltere.core.format.internal.hdf5;

import haltere.core.format.RecordingProblem;
import haltere.core.format.internal.decoding.EventColumn;
import java.io.IOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.Set;
import java.util.function.Predicate;

/** The datasets of a file, in all groups down to a depth, and the attributes of known groups. */
final class FileContents {
  private static final int MAX_DATASETS = 512;
  private static final int MAX_DEPTH = 4;

  /** Members of a group, so that frames in datasets of their own leave room for other groups. */
  private static final int MAX_OF_GROUP = 128;

  private final ContainerFile file;
  private final List<Dataset> datasets = new ArrayList<>();
  private final List<Attributes> attributes = new ArrayList<>();
  private final Set<Long> seen = new HashSet<>();
  private final Map<String, RecordingProblem> problems = new LinkedHashMap<>();
  private final Map<String, String> timeUnits = new HashMap<>();
  private final Set<String> unreadableUnits = new HashSet<>();
  private final Queue<Place> waiting = new ArrayDeque<>();
  private boolean hidden;

  /** An object that is not yet read. */
  private record Place(String path, long position, int depth) {}

  private FileContents(ContainerFile file) {
    this.file = file;
  }

  static FileContents of(ContainerFile file) throws IOException {
    FileContents contents = new FileContents(file);
    contents.collect(new Place("", file.root(), MAX_DEPTH));
    contents.collectWaiting();
    return contents;
  }

  /** Reads group by group, the upper ones first. */
  private void collectWaiting() throws IOException {
    while (!waiting.isEmpty()) {
      Place place = waiting.remove();
      try {
        collect(place);
      } catch (RecordingProblem problem) {
        // an unknown object may be irrelevant
        problems.put(place.path(), problem);
      }
    }
  }

  private void collect(Place place) throws IOException {
    long position = place.position();
    if (seen.size() >= MAX_DATASETS || !seen.add(position)) {
      return;
    }
    String path = place.path();
    ObjectHeader header = ObjectHeader.read(file, position);
    if (!Group.isGroup(header)) {
      if (header.has(ObjectHeader.LAYOUT)) {
        datasets.add(Dataset.read(file, path, header));
        if (EventColumn.named(path.substring(path.lastIndexOf('/') + 1)) == EventColumn.TIME) {
          addTimeUnit(path, header);
        }
      }
      return;
    }
    if (path.isEmpty() || path.equals("events")) {
      attributes.add(Attributes.of(file, header));
    }
    Group group = Group.of(file, header);
    hidden |= group.hasHidden();
    if (place.depth() > 0) {
      group.members().entrySet().stream()
          .sorted(Comparator.comparing(member -> EventColumn.named(member.getKey())))
          .limit(MAX_OF_GROUP)
          .forEach(
              member -> {
                String name = path.isEmpty() ? member.getKey() : path + "/" + member.getKey();
                waiting.add(new Place(name, member.getValue(), place.depth() - 1));
              });
    }
  }

  private void addTimeUnit(String path, ObjectHeader header) throws IOException {
    try {
      Attributes some = Attributes.of(file, header);
      String unit = some.text("unit").isEmpty() ? some.text("units") : some.text("unit");
      timeUnits.put(path, unit);
    } catch (RecordingProblem ignored) {
      unreadableUnits.add(path);
    }
  }

  /** Whether a dataset of times has attributes that cannot be read. */
  boolean hasUnreadableUnit(String path) {
    return unreadableUnits.contains(path);
  }

  /** The unit that an attribute of a dataset of times states, or an empty text. */
  String timeUnit(String path) {
    return timeUnits.getOrDefault(path, "");
  }

  List<Dataset> datasets() {
    return datasets;
  }

  /** Attributes of the root group and of the group of events. */
  List<Attributes> attributes() {
    return attributes;
  }

  /**
   * Rejects a file with a needed dataset whose structure cannot be read, so that a damaged column
   * is not treated as a missing one.
   *
   * @param isNeeded whether the dataset of a path is needed
   */
  void check(Predicate<String> isNeeded) throws RecordingProblem {
    for (Map.Entry<String, RecordingProblem> problem : problems.entrySet()) {
      if (isNeeded.test(problem.getKey())) {
        throw problem.getValue();
      }
    }
  }

  /** Reason why something was not found: unreadable objects, or else unsuitable datasets. */
  RecordingProblem lacks(String words) {
    return problems.isEmpty()
        ? new RecordingProblem(
            file.bytes().path(),
            "its datasets "
                + datasets.stream().map(Dataset::name).limit(20).toList()
                + (hidden
                    ? " (and some in a list that is not read here; h5repack rewrites it)"
                    : "")
                + " "
                + words)
        : problems.values().iterator().next();
  }
}
