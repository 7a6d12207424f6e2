package haltere.core.format.internal.bag;

import haltere.core.format.FileHead;
import haltere.core.format.ProbeResult;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.Support;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.decoding.ReadOnlyFormat;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/** Bags of ROS 2 in SQLite files: read. */
public final class SqliteBagFormat implements ReadOnlyFormat {
  private static final int SCHEMA_ROOT = 1;
  private static final int MAX_ROWS = 1 << 16;

  /** Called by the service loader. */
  public SqliteBagFormat() {}

  @Override
  public String name() {
    return "rosbag2";
  }

  @Override
  public String description() {
    return "ROS 2 bag in an SQLite file";
  }

  @Override
  public Set<String> extensions() {
    return Set.of("db3");
  }

  @Override
  public ProbeResult probe(FileHead head) {
    if (!head.startsWith(SqliteFile.MAGIC)) {
      return new ProbeResult(Support.NONE, "it does not start with the signature of SQLite");
    }
    return head.extension().equals("db3")
        ? new ProbeResult(Support.CERTAIN, "it is an SQLite file named as bags are")
        : new ProbeResult(Support.PLAUSIBLE, "it is an SQLite file");
  }

  @Override
  public RecordingReader open(Path path, ReadOptions options) throws IOException {
    return RecordingFile.reading(path, bytes -> new SqliteBagOpening(bytes, options).open());
  }

  private final class SqliteBagOpening {
    private final RecordingFile bytes;
    private final ReadOptions options;
    private final SqliteFile file;
    private final BagTopics topics = new BagTopics();
    private final ViolationCounts found = new ViolationCounts();
    private final List<String> remarks = new ArrayList<>();
    private long messagesRoot;
    private long topicsRoot;

    SqliteBagOpening(RecordingFile bytes, ReadOptions options) throws IOException {
      this.bytes = bytes;
      this.options = options;
      file = new SqliteFile(bytes);
    }

    RecordingReader open() throws IOException {
      if (file.cutOff()) {
        found.addOnce(Violation.CUT_OFF, bytes.size());
      }
      rows(SCHEMA_ROOT, this::readSchema);
      if (messagesRoot == 0 || topicsRoot == 0) {
        throw new RecordingProblem(
            bytes.path(), "it is an SQLite file, but has no tables of topics and messages");
      }
      rows(topicsRoot, this::readTopic);
      Path log = Path.of(bytes.path() + "-wal");
      if (Files.isRegularFile(log) && Files.size(log) > 0) {
        remarks.add("the content of " + log.getFileName() + " is not read; have ROS close the bag");
      }
      long first = firstFrom(Long.MIN_VALUE);
      long last = last(first);
      return new BagOpening(
              name(),
              bytes,
              options,
              topics,
              (wanted, violations) ->
                  new SqliteWalk(file, messagesRoot, first, last, topics, wanted, violations))
          .remark(remarks)
          .open(found);
    }

    /** Receives each row of a table. */
    @FunctionalInterface
    private interface RowReader {
      void read(SqliteTable table) throws IOException, DamagedPacketException;
    }

    private void rows(long root, RowReader reader) throws IOException {
      SqliteTable table = new SqliteTable(file, root);
      for (int i = 0; i < MAX_ROWS; i++) {
        try {
          if (!table.next()) {
            return;
          }
          reader.read(table);
        } catch (DamagedPacketException e) {
          found.add(Violation.DAMAGED_PACKET, (table.page() - 1) * file.pageBytes());
        }
      }
    }

    private void readSchema(SqliteTable table) throws IOException, DamagedPacketException {
      SqliteRow row = table.row();
      boolean isTable = row.takeText().equals("table");
      String name = row.takeText();
      row.takeText();
      long root = row.takeNumber();
      if (isTable && name.equals("messages")) {
        messagesRoot = root;
      } else if (isTable && name.equals("topics")) {
        topicsRoot = root;
      }
    }

    private void readTopic(SqliteTable table) throws IOException, DamagedPacketException {
      SqliteRow row = table.row();
      row.takeNumber();
      String name = row.takeText();
      String type = row.takeText();
      String serialisation = row.takeText();
      topics.add(
          table.number(),
          new BagTopic(name, serialisation.equals("cdr") ? type : serialisation, true));
    }

    /** The first message number at or after a number; that number if there is none. */
    private long firstFrom(long from) throws IOException {
      SqliteTable table = new SqliteTable(file, messagesRoot);
      table.seek(from);
      try {
        return table.next() ? table.number() : Math.max(0, from);
      } catch (DamagedPacketException e) {
        return Math.max(0, from);
      }
    }

    /** The highest number, by bisection. */
    private long last(long first) throws IOException {
      long low = first;
      long high = Long.MAX_VALUE;
      SqliteTable table = new SqliteTable(file, messagesRoot);
      while (low < high) {
        long middle = low + (high - low >>> 1) + 1;
        table.seek(middle);
        boolean there;
        try {
          there = table.next();
        } catch (DamagedPacketException e) {
          there = false;
        }
        if (there) {
          low = Math.max(middle, table.number());
        } else {
          high = middle - 1;
        }
      }
      return low;
    }
  }
}
