package haltere.spark;

import java.io.Serializable;
import java.util.Objects;

/**
 * Recording on a file system that Hadoop supports.
 *
 * @param name name of the recording in results, unique in a batch
 * @param uri location, such as {@code s3a://bucket/day-1/fly.aedat4}
 */
public record SparkRecording(String name, String uri) implements Serializable {
  /** Checks the values. */
  public SparkRecording {
    Objects.requireNonNull(name, "name");
    Objects.requireNonNull(uri, "uri");
  }
}
