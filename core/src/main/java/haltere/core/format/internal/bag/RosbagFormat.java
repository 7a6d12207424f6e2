package haltere.core.format.internal.bag;

import haltere.core.format.FileHead;
import haltere.core.format.ProbeResult;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingReader;
import haltere.core.format.Support;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.decoding.ReadOnlyFormat;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Set;

/** Bags of ROS 1, version 2.0: read. */
public final class RosbagFormat implements ReadOnlyFormat {
  /** Called by the service loader. */
  public RosbagFormat() {}

  @Override
  public String name() {
    return "rosbag";
  }

  @Override
  public String description() {
    return "ROS 1 bag, version 2.0";
  }

  @Override
  public Set<String> extensions() {
    return Set.of("bag");
  }

  @Override
  public ProbeResult probe(FileHead head) {
    return head.startsWith(RosbagIndex.MAGIC)
        ? new ProbeResult(Support.CERTAIN, "its first line says ROS bag 2.0")
        : new ProbeResult(Support.NONE, "it has no line #ROSBAG V2.0");
  }

  @Override
  public RecordingReader open(Path path, ReadOptions options) throws IOException {
    return RecordingFile.reading(path, file -> open(file, options));
  }

  private RecordingReader open(RecordingFile file, ReadOptions options) throws IOException {
    BagTopics topics = new BagTopics();
    ViolationCounts found = new ViolationCounts();
    RosbagIndex index = RosbagIndex.read(file, topics, found);
    return new BagOpening(
            name(),
            file,
            options,
            topics,
            (wanted, violations) -> new RosbagWalk(file, index, topics, wanted, violations))
        .open(found);
  }
}
