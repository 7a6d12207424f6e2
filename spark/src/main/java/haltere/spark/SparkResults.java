package haltere.spark;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import org.apache.hadoop.fs.FileSystem;
import org.apache.hadoop.fs.Path;
import org.apache.spark.api.java.JavaRDD;
import org.apache.spark.api.java.JavaSparkContext;
import org.apache.spark.sql.Dataset;
import org.apache.spark.sql.Row;
import org.apache.spark.sql.RowFactory;
import org.apache.spark.sql.SparkSession;
import org.apache.spark.sql.types.DataTypes;
import org.apache.spark.sql.types.StructType;
import org.apache.spark.storage.StorageLevel;
import org.apache.spark.util.SerializableConfiguration;

/**
 * Results of a chain over many recordings: a table for each outlet and a table of failures. The
 * chain runs when a table is used first; each recording is one task, whose rows stay on the disks
 * of the executors for the other tables until this is closed. Rows lost with an executor are
 * computed again and do not differ.
 *
 * <p>Thread rule: as {@link SparkSession}.
 */
public final class SparkResults implements AutoCloseable {
  /** Name of the table of failures: recording, kind (as in {@code failed.json}) and cause. */
  public static final String FAILURES = "failures";

  private static final StructType FAILURE =
      new StructType()
          .add(ResultTable.RECORDING, DataTypes.StringType, false)
          .add("kind", DataTypes.StringType, false)
          .add("cause", DataTypes.StringType, false);

  private final SparkSession spark;
  private final List<ResultTable> tables;
  private final JavaRDD<Row> rows;

  SparkResults(SparkSession spark, List<SparkRecording> recordings, String chain)
      throws IOException {
    this.spark = spark;
    tables = ResultTable.of(chain);
    long names = recordings.stream().map(SparkRecording::name).distinct().count();
    if (names < recordings.size()) {
      throw new IllegalArgumentException("two recordings have one name");
    }
    JavaSparkContext context = JavaSparkContext.fromSparkContext(spark.sparkContext());
    RecordingTask task =
        new RecordingTask(
            chain,
            tables,
            context.broadcast(new SerializableConfiguration(context.hadoopConfiguration())));
    rows =
        context
            .parallelize(recordings, Math.max(1, recordings.size()))
            .flatMap(task)
            .persist(StorageLevel.DISK_ONLY());
  }

  /**
   * Names of the tables.
   *
   * @return names of the form STAGE.OUTLET, in the order of the chain
   */
  public List<String> tables() {
    return tables.stream().map(ResultTable::name).toList();
  }

  /**
   * Table of results of all recordings.
   *
   * @param name one of {@link #tables()}
   * @return the column {@code recording} and the columns of the table in CSV
   * @throws IllegalArgumentException if the chain has no such table
   */
  public Dataset<Row> table(String name) {
    int index = tables().indexOf(name);
    if (index < 0) {
      throw new IllegalArgumentException(
          "the chain has no table " + name + "; it has " + String.join(", ", tables()));
    }
    return dataset(index, tables.get(index).schema());
  }

  /**
   * Table of the recordings that failed.
   *
   * @return one row for each of them: recording, kind and cause
   */
  public Dataset<Row> failures() {
    return dataset(RecordingTask.FAILED, FAILURE);
  }

  private Dataset<Row> dataset(int table, StructType schema) {
    int length = schema.size() + 1;
    return spark.createDataFrame(
        rows.filter(row -> row.getInt(0) == table).map(row -> withoutTable(row, length)), schema);
  }

  private static Row withoutTable(Row row, int length) {
    Object[] values = new Object[length];
    for (int i = 0; i < length; i++) {
      values[i] = row.get(i);
    }
    return RowFactory.create(Arrays.copyOfRange(values, 1, length));
  }

  /**
   * Writes all tables as Parquet, each into a folder of its name with a subfolder for each
   * recording, and the failures into {@value #FAILURES}. Spark commits each table once.
   *
   * @param folder URI of a folder on a file system that Hadoop supports
   * @throws IOException if one of the tables exists already
   */
  public void write(String folder) throws IOException {
    Path out = new Path(folder);
    FileSystem files = out.getFileSystem(spark.sparkContext().hadoopConfiguration());
    for (String name : tables()) {
      if (files.exists(new Path(out, name))) {
        throw new IOException(
            new Path(out, name) + ": there is a result already; name another folder");
      }
    }
    for (String name : tables()) {
      table(name)
          .write()
          .partitionBy(ResultTable.RECORDING)
          .parquet(new Path(out, name).toString());
    }
    failures().coalesce(1).write().parquet(new Path(out, FAILURES).toString());
  }

  /** Releases the rows that the executors hold. */
  @Override
  public void close() {
    rows.unpersist(false);
  }
}
