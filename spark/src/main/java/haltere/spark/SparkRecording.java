package haltere.spark;

import java.io.Serializable;
import java.util.Objects;

/**
 * A recording on any file system that Hadoop knows.
 *
 * @param name what results call it; of one batch no two are the same
 * @param uri where it is, such as {@code s3a://bucket/day-1/fly.aedat4}
 */
public record SparkRecording(String name, String uri) implements Serializable {
  /** Checks the values. */
  public SparkRecording {
    Objects.requireNonNull(name, "name");
    Objects.requireNonNull(uri, "uri");
  }
}
