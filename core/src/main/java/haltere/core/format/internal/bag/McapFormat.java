package haltere.core.format.internal.bag;

import haltere.core.format.FileHead;
import haltere.core.format.ProbeResult;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingFormat;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Support;
import haltere.core.format.ViolationCounts;
import haltere.core.format.WriteOptions;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;

/** MCAP files with ROS 1 or ROS 2 messages: read; written as ROS 2 bags. */
public final class McapFormat implements RecordingFormat {
  /** Called by the service loader. */
  public McapFormat() {}

  @Override
  public String name() {
    return "mcap";
  }

  @Override
  public String description() {
    return "MCAP with event messages of ROS";
  }

  @Override
  public Set<String> extensions() {
    return Set.of("mcap");
  }

  @Override
  public ProbeResult probe(FileHead head) {
    return McapIndex.isMcap(head.head())
        ? new ProbeResult(Support.CERTAIN, "it starts with the signature of MCAP")
        : new ProbeResult(Support.NONE, "it does not start with the signature of MCAP");
  }

  @Override
  public RecordingReader open(Path path, ReadOptions options) throws IOException {
    return RecordingFile.reading(path, file -> open(file, options));
  }

  private RecordingReader open(RecordingFile file, ReadOptions options) throws IOException {
    BagTopics topics = new BagTopics();
    ViolationCounts found = new ViolationCounts();
    McapIndex index = McapIndex.read(file, topics, found);
    return new BagOpening(
            name(),
            file,
            options,
            topics,
            (wanted, violations) -> new McapWalk(file, index, topics, wanted, violations))
        .open(found);
  }

  @Override
  public Optional<RecordingWriter> create(Path file, WriteOptions options) throws IOException {
    return Optional.of(new McapWriter(file, options));
  }
}
