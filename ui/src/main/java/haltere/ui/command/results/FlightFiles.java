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
 * Observations and cameras of a simulated flight, as inputs of {@code haltere orient}.
 *
 * @param scene the flight
 * @param observations output of the observations, or null
 * @param cameras where the cameras go, or null
 */
public record FlightFiles(FlightScene scene, Path observations, Path cameras) {
  /** Writes the observations before a time; returns messages for the user. */
  public List<String> write(long endUs, boolean overwrite, TableMetadata metadata)
      throws IOException {
    List<String> lines = new ArrayList<>();
    if (observations != null) {
      try (TableSink<FlightDetection> table =
          Tables.create(observations, FlightDetection.class, overwrite, metadata)) {
        for (long k = 0; scene.pictureTimeUs(k) < endUs; k++) {
          scene.detections(k).forEach(table);
        }
        table.finish();
        lines.add("wrote " + observations + " (" + Quantities.count(table.rows()) + " rows)");
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
      lines.add("wrote " + cameras + " (" + scene.cameras().size() + " cameras)");
    }
    return lines;
  }
}
