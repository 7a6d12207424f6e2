package haltere.spark;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.batch.Batch;
import haltere.core.batch.BatchFailure;
import haltere.core.batch.BatchInputs;
import haltere.core.batch.BatchItem;
import haltere.core.batch.BatchOptions;
import haltere.core.chain.ChainFile;
import haltere.core.event.EventPacket;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import haltere.core.simulation.Scene;
import haltere.core.simulation.Scenes;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.apache.spark.scheduler.SparkListener;
import org.apache.spark.scheduler.SparkListenerTaskEnd;
import org.apache.spark.sql.Dataset;
import org.apache.spark.sql.Row;
import org.apache.spark.sql.SparkSession;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Chains on a real Spark give the rows of a batch. */
class HaltereSparkTest {
  private static final String CHAIN =
      """
      {"filters": [{"filter": "background-activity"}, {"filter": "object-tracker"},
       {"filter": "cluster-tracker"}]}
      """;
  private static final String TRACKS = "object-tracker.objects";
  private static final int RECORDINGS = 6;

  @TempDir static Path folder;
  private static Path in;
  private static final List<String> EXPECTED = new ArrayList<>();

  /** Hears nothing. */
  private static final Batch.Listener QUIET =
      new Batch.Listener() {
        @Override
        public void progress(long doneBytes, long totalBytes) {}

        @Override
        public void failed(BatchFailure failure) {}

        @Override
        public void warned(BatchItem item, String warning) {}
      };

  @BeforeAll
  static void runABatch() throws IOException {
    in = Files.createDirectories(folder.resolve("in/day 1")).getParent();
    for (int i = 0; i < RECORDINGS; i++) {
      simulate(in.resolve(i % 2 == 0 ? "a" + i + ".aedat" : "day 1/b" + i + ".es"), i);
    }
    Path out = folder.resolve("batch");
    BatchInputs inputs = new BatchInputs(out, Optional.empty());
    inputs.add(in);
    BatchOptions options =
        new BatchOptions(
            out,
            1,
            BatchOptions.Existing.REFUSE,
            ReadOptions.DEFAULT,
            false,
            "test",
            RowsFormat.ENDING,
            Set.of());
    new Batch(sensor -> ChainFile.parse(CHAIN, "chain", sensor), options, Throwable::toString)
        .run(inputs.items(), "failed.json", QUIET);
    int columns =
        ResultTable.of(CHAIN).stream()
            .filter(table -> table.name().equals(TRACKS))
            .findFirst()
            .orElseThrow()
            .columns();
    for (BatchItem item : inputs.items()) {
      Path table = out.resolve(item.name()).resolve(TRACKS + "." + RowsFormat.ENDING);
      try (DataInputStream rows = RowsFormat.open(table)) {
        List<Object> row = new ArrayList<>(List.of(item.name()));
        while (RowsFormat.read(rows, columns, row::add)) {
          EXPECTED.add(row.toString());
          row = new ArrayList<>(List.of(item.name()));
        }
      }
    }
    EXPECTED.sort(null);
    assertTrue(EXPECTED.size() > 50, "rows to compare: " + EXPECTED.size());
    Files.writeString(in.resolve("broken.aedat4"), "#!AER-DAT4.0\r\nnot what it should be");
  }

  private static void simulate(Path file, int seed) throws IOException {
    try (Scene<?> scene =
            Scenes.named("dots").create(List.of("run.durationS=0.5", "run.seed=" + (seed + 1)));
        RecordingWriter writer =
            Recordings.forWriting(file)
                .create(file, WriteOptions.of(scene.geometry()))
                .orElseThrow()) {
      scene.drainTo(
          new StreamHandler() {
            @Override
            public void packet(EventPacket packet) {
              try {
                writer.write(packet);
              } catch (IOException thrown) {
                throw new UncheckedIOException(thrown);
              }
            }

            @Override
            public void notified(StreamNotification notification) {}
          });
      writer.finish();
    }
  }

  private static SparkSession spark(String master) throws IOException {
    return SparkSession.builder()
        .appName("test")
        .master(master)
        .config("spark.ui.enabled", false)
        .config("spark.driver.host", "127.0.0.1")
        .config("spark.driver.bindAddress", "127.0.0.1")
        .config("spark.sql.warehouse.dir", folder.resolve("warehouse").toString())
        .config(
            "spark.haltere.scratch", Files.createDirectories(folder.resolve("scratch")).toString())
        .config("spark.hadoop.fs.elsewhere.impl", ElsewhereFileSystem.class.getName())
        .config("spark.hadoop." + ElsewhereFileSystem.ROOT, folder.toString())
        .config("spark.jars", System.getProperty("haltere.submitted"))
        .config("spark.sql.shuffle.partitions", 2)
        .getOrCreate();
  }

  private static List<String> rows(Dataset<Row> table) {
    List<String> rows = new ArrayList<>();
    List<String> columns = new ArrayList<>(List.of(table.columns()));
    columns.remove("recording");
    columns.add(0, "recording");
    for (Row row :
        table
            .select(columns.stream().map(table::col).toArray(org.apache.spark.sql.Column[]::new))
            .collectAsList()) {
      List<Object> values = new ArrayList<>();
      for (int i = 0; i < row.size(); i++) {
        values.add(row.get(i));
      }
      rows.add(values.toString());
    }
    rows.sort(null);
    return rows;
  }

  /** Runs all recordings into a folder of Parquet and reads it back. */
  private static void assertRowsEqualABatch(
      SparkSession spark, String input, String output, Path out) throws IOException {
    try (SparkResults results = HaltereSpark.open(spark, HaltereSpark.find(spark, input), CHAIN)) {
      results.write(output);
      assertThrows(IOException.class, () -> results.write(output));
    }
    assertEquals(EXPECTED, rows(spark.read().parquet(output + "/" + TRACKS)));
    List<Row> failures =
        spark.read().parquet(out.resolve(SparkResults.FAILURES).toString()).collectAsList();
    assertEquals(1, failures.size());
    assertEquals("broken.aedat4", failures.get(0).getString(0));
    assertEquals("recording", failures.get(0).getString(1));
    assertTrue(Files.exists(out.resolve(TRACKS).resolve("recording=a0.aedat")));
    assertScratchIsEmpty();
  }

  private static void assertScratchIsEmpty() throws IOException {
    try (Stream<Path> scratch = Files.list(folder.resolve("scratch"))) {
      assertEquals(List.of(), scratch.toList());
    }
  }

  @Test
  void localRunWritesTheRowsOfABatch() throws IOException {
    try (SparkSession spark = spark("local[2]")) {
      Path out = folder.resolve("local");
      assertRowsEqualABatch(spark, in.toUri().toString(), out.toUri().toString(), out);
    }
  }

  @Test
  void runOnAnotherFileSystemWritesTheRowsOfABatch() throws IOException {
    try (SparkSession spark = spark("local[2]")) {
      assertRowsEqualABatch(
          spark, "elsewhere:///in", "elsewhere:///out/tables", folder.resolve("out/tables"));
    }
  }

  @Test
  void abandonedScratchFoldersAreRemovedAndUsedOnesRemain() throws IOException {
    Path parent = Files.createDirectories(folder.resolve("scratches"));
    Path left = Files.createDirectories(parent.resolve("haltere-left/more")).getParent();
    Files.writeString(left.resolve("more/recording.aedat"), "cut off");
    Files.createFile(parent.resolve("haltere-left.lock"));
    Path others = Files.createDirectory(parent.resolve("haltere"));
    try (Scratch first = Scratch.in(parent);
        Scratch second = Scratch.in(parent)) {
      assertTrue(Files.isDirectory(first.folder()) && Files.isDirectory(second.folder()));
      assertFalse(Files.exists(left));
    }
    try (Stream<Path> all = Files.list(parent)) {
      assertEquals(List.of(others), all.toList());
    }
  }

  @Test
  void runReturnsTheOnlyTableOfAChain() throws IOException {
    try (SparkSession spark = spark("local[2]")) {
      List<String> paths = List.of(in.resolve("a0.aedat").toString());
      String one = "{\"filters\": [{\"filter\": \"object-tracker\"}]}";
      Dataset<Row> tracks = HaltereSpark.run(spark, paths, one);
      assertTrue(tracks.count() > 0);
      assertEquals("t_us", tracks.columns()[1]);
      assertThrows(IllegalArgumentException.class, () -> HaltereSpark.run(spark, paths, CHAIN));
      assertThrows(
          IllegalArgumentException.class, () -> HaltereSpark.run(spark, paths, CHAIN, "none"));
    }
  }

  @Test
  void clusterRunWithAKilledExecutorWritesTheRowsOfABatch() throws IOException {
    try (SparkSession spark = spark("local-cluster[2,1,1024]")) {
      AtomicInteger ended = new AtomicInteger();
      AtomicInteger killed = new AtomicInteger();
      spark
          .sparkContext()
          .addSparkListener(
              new SparkListener() {
                @Override
                public void onTaskEnd(SparkListenerTaskEnd end) {
                  if (ended.incrementAndGet() == 2) {
                    ProcessHandle.current()
                        .descendants()
                        .filter(HaltereSparkTest::isExecutor)
                        .findFirst()
                        .ifPresent(
                            executor -> {
                              executor.destroyForcibly();
                              killed.incrementAndGet();
                            });
                  }
                }
              });
      assertRowsEqualABatchAfterAKill(spark, folder.resolve("cluster"));
      assertEquals(1, killed.get());
    }
  }

  private static void assertRowsEqualABatchAfterAKill(SparkSession spark, Path out)
      throws IOException {
    try (SparkResults results =
        HaltereSpark.open(spark, HaltereSpark.find(spark, in.toUri().toString()), CHAIN)) {
      results.write(out.toUri().toString());
    }
    assertEquals(EXPECTED, rows(spark.read().parquet(out.resolve(TRACKS).toString())));
    assertEquals(1, spark.read().parquet(out.resolve(SparkResults.FAILURES).toString()).count());
    assertFalse(Files.exists(out.resolve(TRACKS).resolve("_temporary")));
    assertScratchIsEmpty();
  }

  private static boolean isExecutor(ProcessHandle process) {
    return process
        .info()
        .commandLine()
        .filter(line -> line.contains("CoarseGrainedExecutorBackend"))
        .isPresent();
  }
}
