package haltere.spark;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.apache.hadoop.fs.Path;
import org.apache.spark.sql.SparkSession;

/**
 * Main class for {@code spark-submit}: {@code --input URI --chain URI --output URI}. The exit
 * status is 1 if the arguments are wrong or the input has no recording; a recording that fails is a
 * row of the table of failures.
 */
public final class SparkMain {
  private static final Set<String> OPTIONS = Set.of("--input", "--chain", "--output");

  private SparkMain() {}

  /**
   * Runs a chain over all recordings of a folder.
   *
   * @param args the three options with their values
   * @throws IOException if input, chain or output fails
   */
  public static void main(String[] args) throws IOException {
    Map<String, String> options = new HashMap<>();
    for (int i = 0; i + 1 < args.length; i += 2) {
      options.put(args[i], args[i + 1]);
    }
    if (args.length != 6 || !options.keySet().equals(OPTIONS)) {
      System.err.println("usage: --input URI --chain URI --output URI");
      System.exit(1);
    }
    SparkSession spark = SparkSession.builder().appName("haltere").getOrCreate();
    try {
      List<SparkRecording> recordings = HaltereSpark.find(spark, options.get("--input"));
      if (recordings.isEmpty()) {
        throw new IOException(options.get("--input") + ": there is no recording");
      }
      String chain = read(spark, options.get("--chain"));
      try (SparkResults results = HaltereSpark.open(spark, recordings, chain)) {
        results.write(options.get("--output"));
        System.out.println(
            recordings.size() + " recordings, " + results.failures().count() + " failed");
      }
    } finally {
      spark.stop();
    }
  }

  private static String read(SparkSession spark, String uri) throws IOException {
    Path path = new Path(uri);
    try (InputStream in =
        path.getFileSystem(spark.sparkContext().hadoopConfiguration()).open(path)) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    }
  }
}
