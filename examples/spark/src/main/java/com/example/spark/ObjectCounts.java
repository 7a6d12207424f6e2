package com.example.spark;

import static org.apache.spark.sql.functions.avg;
import static org.apache.spark.sql.functions.count_distinct;

import haltere.spark.HaltereSpark;
import java.io.IOException;
import java.util.List;
import org.apache.spark.sql.Dataset;
import org.apache.spark.sql.Row;
import org.apache.spark.sql.SparkSession;

/** Prints the number of objects of each recording and their mean horizontal speed. */
public final class ObjectCounts {
  private static final String CHAIN =
      """
      {"filters": [{"filter": "background-activity"}, {"filter": "object-tracker"}]}
      """;

  private ObjectCounts() {}

  /** Runs the chain over recordings given by URIs. */
  public static void main(String[] recordings) throws IOException {
    try (SparkSession spark = SparkSession.builder().appName("objects").getOrCreate()) {
      count(spark, List.of(recordings)).show(Integer.MAX_VALUE, false);
    }
  }

  /** A row for each recording with objects: recording, objects, mean horizontal speed in px/s. */
  static Dataset<Row> count(SparkSession spark, List<String> recordings) throws IOException {
    Dataset<Row> tracks = HaltereSpark.run(spark, recordings, CHAIN, "object-tracker.objects");
    return tracks
        .groupBy("recording")
        .agg(
            count_distinct(tracks.col("id")).as("objects"),
            avg(tracks.col("vx_px_s")).as("mean_vx_px_s"))
        .orderBy("recording");
  }
}
