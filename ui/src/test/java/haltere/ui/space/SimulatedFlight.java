package haltere.ui.space;

import haltere.core.json.Json;
import haltere.core.simulation.internal.flight.FlightDetection;
import haltere.core.simulation.internal.flight.FlightScene;
import haltere.core.simulation.internal.flight.FlightSettings;
import haltere.core.sink.CsvSink;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What three cameras saw in a second of a simulated flight, in files.
 *
 * @param observations a table
 * @param cameras JSON
 */
public record SimulatedFlight(Path observations, Path cameras) {
  /** Writes the files into a folder. */
  public static SimulatedFlight in(Path folder) throws IOException {
    FlightScene scene = new FlightScene(FlightSettings.defaults());
    Path observations = folder.resolve("seen.csv");
    Path cameras = folder.resolve("cameras.json");
    try (CsvSink<FlightDetection> table =
        CsvSink.create(observations, FlightDetection.class, true)) {
      for (long k = 0; k < 100; k++) {
        scene.detections(k).forEach(table);
      }
      table.finish();
    }
    List<Map<String, Object>> list =
        scene.cameras().stream()
            .map(
                camera ->
                    Map.<String, Object>of(
                        "id", camera.id(),
                        "matrix", camera.matrix(),
                        "width", camera.widthPx(),
                        "height", camera.heightPx()))
            .toList();
    Files.writeString(cameras, Json.write(Map.of("cameras", list)));
    return new SimulatedFlight(observations, cameras);
  }

  /** The flight as it is shown. */
  public BodyFlight load() throws IOException {
    return BodyFlight.load(observations, Optional.of(cameras));
  }
}
