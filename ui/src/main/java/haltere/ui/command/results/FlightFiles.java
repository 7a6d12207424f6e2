package haltere.ui.command.results;

import haltere.core.format.AtomicFile;
import haltere.core.json.internal.Json;
import haltere.core.simulation.internal.flight.FlightCamera;
import haltere.core.simulation.internal.flight.FlightDetection;
import haltere.core.simulation.internal.flight.FlightScene;
import haltere.core.sink.TableMetadata;
import haltere.core.sink.TableSink;
import haltere.core.sink.Tables;
import haltere.ui.command.terminal.Quantities;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * What all cameras of a simulated flight saw, and the cameras, as {@code haltere orient} reads
 * them.
 *
 * @param scene the flight
 * @param observations where what was seen goes, or null
 * @param cameras where the cameras go, or null
 */
public record FlightFiles(FlightScene scene, Path observations, Path cameras) {
  /** Writes what was seen before a time; returns what to tell the user. */
  public List<String> write(long endUs, boolean overwrite, TableMetadata metadata)
      throws IOException {
    List<String> told = new ArrayList<>();
    if (observations != null) {
      try (TableSink<FlightDetection> table =
          Tables.create(observations, FlightDetection.class, overwrite, metadata)) {
        for (long k = 0; scene.pictureTimeUs(k) < endUs; k++) {
          scene.detections(k).forEach(table);
        }
        table.finish();
        told.add("wrote " + observations + " (" + Quantities.count(table.rows()) + " rows)");
      }
    }
    if (cameras != null) {
      List<Object> list = new ArrayList<>();
      for (FlightCamera camera : scene.cameras()) {
        Map<String, Object> object = new LinkedHashMap<>();
        object.put("id", camera.id());
        object.put("matrix", camera.matrix());
        object.put("width", camera.widthPx());
        object.put("height", camera.heightPx());
        list.add(object);
      }
      AtomicFile.write(cameras, Json.write(Map.of("cameras", list)) + "\n", overwrite);
      told.add("wrote " + cameras + " (" + scene.cameras().size() + " cameras)");
    }
    return told;
  }
}
