package haltere.spark;

import haltere.core.format.RecordingFormat;
import haltere.core.format.Recordings;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.apache.hadoop.fs.FileSystem;
import org.apache.hadoop.fs.LocatedFileStatus;
import org.apache.hadoop.fs.Path;
import org.apache.hadoop.fs.RemoteIterator;
import org.apache.spark.sql.Dataset;
import org.apache.spark.sql.Row;
import org.apache.spark.sql.SparkSession;

/**
 * Runs one chain over many recordings on Spark. Each recording is one task: the executor copies it
 * from a Hadoop file system to its disk ({@code spark.haltere.scratch}, by default its folder for
 * temporary files), runs it by {@link haltere.core.pipeline.RecordingJob} and deletes the copy. The
 * rows equal those of {@code haltere batch}. Executors need the jars of this module, core and
 * filters.
 *
 * <p>Thread rule: as {@link SparkSession}.
 */
public final class HaltereSpark {
  private HaltereSpark() {}

  /**
   * Runs a chain with a single table over recordings. A recording that fails has no rows, see
   * {@link SparkResults#failures()}.
   *
   * @param spark the session
   * @param paths URIs of recordings, which also appear in the column {@code recording}
   * @param chain the chain as JSON, as the viewer saves it
   * @return the column {@code recording} and the columns of the table in CSV
   * @throws IOException if the chain cannot be read
   * @throws IllegalArgumentException if the chain has no table or several tables
   */
  public static Dataset<Row> run(SparkSession spark, List<String> paths, String chain)
      throws IOException {
    SparkResults results = open(spark, named(paths), chain);
    if (results.tables().size() != 1) {
      throw new IllegalArgumentException(
          "the chain has " + results.tables().size() + " tables, name one: " + results.tables());
    }
    return results.table(results.tables().get(0));
  }

  /**
   * Runs a chain over recordings and returns one of its tables.
   *
   * @param spark the session
   * @param paths URIs of recordings
   * @param chain the chain as JSON
   * @param table STAGE.OUTLET, such as {@code wing-tracker.wings}
   * @return as {@link #run(SparkSession, List, String)}
   * @throws IOException if the chain cannot be read
   * @throws IllegalArgumentException if the chain has no such table
   */
  public static Dataset<Row> run(SparkSession spark, List<String> paths, String chain, String table)
      throws IOException {
    return open(spark, named(paths), chain).table(table);
  }

  /**
   * Prepares a run of a chain over recordings.
   *
   * @param spark the session
   * @param recordings recordings with different names, the largest first
   * @param chain the chain as JSON
   * @return all tables and the failures, computed on first use
   * @throws IOException if the chain cannot be read
   */
  public static SparkResults open(SparkSession spark, List<SparkRecording> recordings, String chain)
      throws IOException {
    return new SparkResults(spark, recordings, chain);
  }

  private static List<SparkRecording> named(List<String> paths) {
    return paths.stream().map(path -> new SparkRecording(path, path)).toList();
  }

  /**
   * Finds recordings by file extension: one file, or all files of a folder and its subfolders.
   * Hidden files and ambiguous extensions ({@code .csv}, {@code .txt}) are excluded.
   *
   * @param spark the session
   * @param input URI of a file or folder
   * @return recordings with names relative to the folder, the largest first
   * @throws IOException if the input cannot be read
   */
  public static List<SparkRecording> find(SparkSession spark, String input) throws IOException {
    Path root = new Path(input);
    FileSystem files = root.getFileSystem(spark.sparkContext().hadoopConfiguration());
    Path base = files.getFileStatus(root).isFile() ? root.getParent() : root;
    String prefix = files.makeQualified(base).toUri().getPath();
    Set<String> endings =
        Recordings.formats().values().stream()
            .filter(format -> !format.sharesExtensions())
            .map(RecordingFormat::extensions)
            .flatMap(Set::stream)
            .collect(Collectors.toSet());
    List<LocatedFileStatus> found = new ArrayList<>();
    RemoteIterator<LocatedFileStatus> all = files.listFiles(root, true);
    while (all.hasNext()) {
      LocatedFileStatus file = all.next();
      String name = file.getPath().getName();
      if (!name.startsWith(".") && endings.stream().anyMatch(end -> name.endsWith("." + end))) {
        found.add(file);
      }
    }
    found.sort(
        Comparator.comparingLong(LocatedFileStatus::getLen)
            .reversed()
            .thenComparing(file -> file.getPath().toString()));
    return found.stream()
        .map(
            file ->
                new SparkRecording(
                    file.getPath()
                        .toUri()
                        .getPath()
                        .substring(prefix.length())
                        .replaceAll("^/", ""),
                    file.getPath().toString()))
        .toList();
  }
}
