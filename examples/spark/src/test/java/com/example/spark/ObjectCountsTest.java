package com.example.spark;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import org.apache.spark.sql.Row;
import org.apache.spark.sql.SparkSession;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ObjectCountsTest {
  private static final double SPEED_PX_S = 80;
  private static final double RADIUS_PX = 5;
  private static final int EVENT_INTERVAL_US = 25;

  @TempDir Path folder;

  @Test
  void countHasOneRowPerRecordingWithObjects() throws IOException {
    String right = writeMovingSpot("right.aedat", SPEED_PX_S).toUri().toString();
    String left = writeMovingSpot("left.es", -SPEED_PX_S).toUri().toString();
    String broken = Files.writeString(folder.resolve("broken.raw"), "none").toUri().toString();
    try (SparkSession spark =
        SparkSession.builder()
            .master("local[2]")
            .config("spark.ui.enabled", false)
            .config("spark.driver.bindAddress", "127.0.0.1")
            .config("spark.driver.host", "127.0.0.1")
            .config("spark.sql.warehouse.dir", folder.resolve("warehouse").toString())
            .getOrCreate()) {
      List<Row> rows =
          ObjectCounts.count(spark, List.of(right, left, broken)).collectAsList();
      assertEquals(List.of(left, right), rows.stream().map(row -> row.getString(0)).toList());
      assertEquals(List.of(1L, 1L), rows.stream().map(row -> row.getLong(1)).toList());
      assertEquals(-SPEED_PX_S, rows.get(0).getDouble(2), 0.1 * SPEED_PX_S);
      assertEquals(SPEED_PX_S, rows.get(1).getDouble(2), 0.1 * SPEED_PX_S);
    }
  }

  /** A spot that crosses the middle of the sensor within a second. */
  private Path writeMovingSpot(String name, double speedPxS) throws IOException {
    Path file = folder.resolve(name);
    Random random = new Random(1);
    EventPacket packet = new EventPacket(1_000_000 / EVENT_INTERVAL_US);
    for (int timeUs = 0; timeUs < 1_000_000; timeUs += EVENT_INTERVAL_US) {
      double angle = 2 * Math.PI * random.nextDouble();
      double radius = RADIUS_PX * Math.sqrt(random.nextDouble());
      packet.append(
          timeUs,
          (int) Math.round(64 + speedPxS * (timeUs * 1e-6 - 0.5) + radius * Math.cos(angle)),
          (int) Math.round(64 + radius * Math.sin(angle)),
          random.nextBoolean());
    }
    try (RecordingWriter writer =
        Recordings.forWriting(file)
            .create(file, WriteOptions.of(new SensorGeometry(128, 128)))
            .orElseThrow()) {
      writer.write(packet);
      writer.finish();
    }
    return file;
  }
}
