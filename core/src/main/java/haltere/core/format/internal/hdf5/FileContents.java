package haltere.core.format.internal.hdf5;

import haltere.core.format.RecordingProblem;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;

/** The datasets of a file, in all groups down to a depth, and the attributes of known groups. */
final class FileContents {
  private static final int MAX_DATASETS = 512;
  private static final int MAX_DEPTH = 4;

  private final ContainerFile file;
  private final List<Dataset> datasets = new ArrayList<>();
  private final List<Attributes> attributes = new ArrayList<>();
  private final Set<Long> seen = new HashSet<>();
  private final Map<String, RecordingProblem> problems = new LinkedHashMap<>();
  private boolean hidden;

  private FileContents(ContainerFile file) {
    this.file = file;
  }

  static FileContents of(ContainerFile file) throws IOException {
    FileContents contents = new FileContents(file);
    contents.collect("", file.root(), MAX_DEPTH);
    return contents;
  }

  private void collect(String path, long position, int depth) throws IOException {
    if (!seen.add(position) || seen.size() > MAX_DATASETS) {
      return;
    }
    ObjectHeader header = ObjectHeader.read(file, position);
    if (!Group.isGroup(header)) {
      if (header.has(ObjectHeader.LAYOUT)) {
        datasets.add(Dataset.read(file, path, header));
      }
      return;
    }
    if (path.isEmpty() || path.equals("events")) {
      attributes.add(Attributes.of(file, header));
    }
    Group group = Group.of(file, header);
    hidden |= group.hasHidden();
    if (depth > 0) {
      for (Map.Entry<String, Long> member : group.members().entrySet()) {
        String name = path.isEmpty() ? member.getKey() : path + "/" + member.getKey();
        try {
          collect(name, member.getValue(), depth - 1);
        } catch (RecordingProblem problem) {
          // an unknown object may be irrelevant
          problems.put(name, problem);
        }
      }
    }
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
