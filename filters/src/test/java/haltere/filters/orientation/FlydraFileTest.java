package haltere.filters.orientation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.format.internal.hdf5.Hdf5TableWriter;
import haltere.core.format.internal.hdf5.Hdf5TableWriter.Hdf5Column;
import haltere.core.format.internal.hdf5.Hdf5TableWriter.NumberType;
import haltere.core.json.internal.Json;
import haltere.core.simulation.internal.flight.FlightScene;
import haltere.filters.orientation.camera.LineObservation;
import haltere.filters.orientation.camera.ObservationFile;
import haltere.filters.orientation.camera.Vectors;
import haltere.testing.ReplacedFile;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Detected lines are read from HDF5 files of Flydra. */
class FlydraFileTest {
  /** The flight of the files that make.py made. */
  private static final FlightScene SCENE =
      Flights.scene(3, 21, "run.startUs=1600000000000000", "detection.missingShare=0.1");

  @TempDir Path folder;
  private Path cameras;

  /** Content of a file. */
  private static final class Heard implements ObservationFile.Listener {
    final TreeMap<Long, List<LineObservation>> seen = new TreeMap<>();
    final List<String> objects = new ArrayList<>();
    final List<String> bad = new ArrayList<>();
    final List<String> remarks = new ArrayList<>();

    @Override
    public void observed(long timeUs, String object, LineObservation line) {
      assertTrue(seen.isEmpty() || timeUs >= seen.lastKey(), "times ascend");
      seen.computeIfAbsent(timeUs, time -> new ArrayList<>()).add(line);
      objects.add(object);
    }

    @Override
    public void skipped(String where, String why) {
      bad.add(where + ": " + why);
    }

    @Override
    public void remark(String words) {
      remarks.add(words);
    }

    long observations() {
      return seen.values().stream().mapToLong(List::size).sum();
    }
  }

  @BeforeEach
  void writeCameras() throws IOException {
    List<Object> list = new ArrayList<>();
    SCENE
        .cameras()
        .forEach(camera -> list.add(Map.of("id", camera.id(), "matrix", camera.matrix())));
    cameras = folder.resolve("cameras.json");
    Files.writeString(cameras, Json.write(Map.of("cameras", list)));
  }

  private Path resource(String name) throws IOException {
    Path file = folder.resolve(name);
    try (InputStream in = FlydraFileTest.class.getResourceAsStream(name)) {
      Files.copy(in, file);
    }
    return file;
  }

  private Heard read(Path file) throws IOException {
    Heard heard = new Heard();
    ObservationFile.open(file, Optional.of(cameras)).read(heard);
    return heard;
  }

  private static double medianDeg(Map<Long, List<LineObservation>> seen) {
    BodyOrientationEstimator body =
        new BodyOrientationEstimator(Flights.cameras(SCENE), OrientationSettings.defaults());
    FlightScores scores = new FlightScores();
    seen.forEach(
        (timeUs, lines) ->
            body.update(timeUs, lines)
                .ifPresent(now -> scores.note(now, SCENE.truthAt(timeUs), true)));
    assertTrue(scores.estimates > 50, scores.estimates + " estimates");
    return FlightScores.quantile(scores.axisDeg, 0.5);
  }

  @Test
  void tablesOfFlydraAreFiltered() throws IOException {
    ObservationFile file = ObservationFile.open(resource("flydra.h5"), Optional.of(cameras));
    Heard heard = new Heard();
    file.read(heard);
    assertEquals(List.of(), heard.bad);
    assertEquals(List.of(), heard.remarks);
    assertEquals(154, heard.observations(), "those of the body, not those of nothing");
    assertTrue(heard.objects.stream().allMatch("42"::equals));
    assertTrue(file.hasFrames());
    assertEquals(1003, file.frame(SCENE.pictureTimeUs(3)));
    assertTrue(medianDeg(heard.seen) < 2.5, medianDeg(heard.seen) + " deg");
  }

  @Test
  void lineBySlopeAndInterceptEqualsThatBySlopeAndPosition() throws IOException {
    Heard lists = read(resource("lists.h5"));
    assertEquals(List.of(), lists.bad);
    assertEquals(1, lists.remarks.size());
    assertEquals("0", lists.objects.get(0));
    Heard flydra = read(resource("flydra.h5"));
    for (Map.Entry<Long, List<LineObservation>> each : flydra.seen.entrySet()) {
      for (LineObservation line : each.getValue()) {
        LineObservation same =
            lists.seen.get(each.getKey()).stream()
                .filter(other -> other.camera() == line.camera())
                .findAny()
                .orElseThrow();
        assertEquals(line.xPx(), same.xPx(), 1e-4);
        assertEquals(line.yPx(), same.yPx(), 1e-4);
        assertEquals(line.angleRad(), same.angleRad(), 1e-6);
      }
    }
  }

  private Path table(List<String> columns, double[]... rows) throws IOException {
    Path file = folder.resolve("table.h5");
    List<Hdf5Column> list =
        columns.stream().map(name -> new Hdf5Column(name, NumberType.F64)).toList();
    try (Hdf5TableWriter writer = Hdf5TableWriter.create(file, "data2d_distorted", list, true)) {
      for (double[] row : rows) {
        writer.append(row);
      }
      writer.finish();
    }
    return file;
  }

  @Test
  void missingValuesOfAFrameAreUnknownAndInvalidOnesReported() throws IOException {
    double nan = Double.NaN;
    double inf = Double.POSITIVE_INFINITY;
    Heard heard =
        read(
            table(
                List.of("camn", "frame", "timestamp", "x", "y", "slope", "obj_id"),
                new double[] {0, 5, 2, 10, 20, inf, 3},
                new double[] {1, 5, nan, 11, 21, -inf, 3},
                new double[] {2, 5, nan, 12, 22, nan, 3},
                new double[] {0, 4, 1, nan, nan, nan, 3},
                new double[] {9, 4, 1, 13, 23, 1, 3},
                new double[] {1, nan, 1, 14, 24, 1, 3},
                new double[] {1, 7, inf, 15, 25, 1, 3},
                new double[] {1, 3, 0.5, 16, 26, 1, 4}));
    assertEquals(List.of(500_000L, 2_000_000L), List.copyOf(heard.seen.keySet()));
    List<LineObservation> lines = heard.seen.get(2_000_000L);
    assertEquals(Math.PI / 2, lines.get(0).angleRad(), 1e-15, "a vertical line");
    assertEquals(-Math.PI / 2, lines.get(1).angleRad(), 1e-15);
    assertTrue(Double.isNaN(lines.get(2).angleRad()) && lines.get(2).hasPosition());
    assertEquals(List.of("4", "3", "3", "3"), heard.objects);
    assertEquals(3, heard.bad.size(), heard.bad.toString());
    assertTrue(heard.bad.get(0).startsWith("row 4 of data2d_distorted: there is no camera"));
    assertTrue(heard.bad.get(1).startsWith("row 5 of data2d_distorted: it has no frame"));
    assertTrue(heard.bad.get(2).contains("frame 7: no camera has a time"), heard.bad.get(2));
  }

  private void assertRefused(Path file, String... words) {
    IOException problem = assertThrows(IOException.class, () -> read(file));
    assertTrue(problem.getMessage().startsWith(file.toString()), problem.getMessage());
    for (String each : words) {
      assertTrue(problem.getMessage().contains(each), problem.getMessage());
    }
  }

  @Test
  void missingColumnsAndTypesAreReportedWithTheFile() throws IOException {
    List<String> all = List.of("camn", "frame", "timestamp", "x", "y", "slope");
    for (String missing : all) {
      List<String> others = new ArrayList<>(all);
      others.remove(missing);
      assertRefused(table(others, new double[5]), "no column " + missing);
    }
    assertRefused(resource("text-slope.h5"), "slope", "no numbers");
    Path other = folder.resolve("other.h5");
    try (Hdf5TableWriter writer =
        Hdf5TableWriter.create(
            other, "lines", List.of(new Hdf5Column("x", NumberType.F64)), true)) {
      writer.finish();
    }
    assertRefused(other, "no table data2d_distorted", "lines");
    IOException problem =
        assertThrows(IOException.class, () -> ObservationFile.open(other, Optional.empty()));
    assertTrue(problem.getMessage().contains("no cameras of its own"), problem.getMessage());
  }

  @Test
  void truncatedAndDamagedFilesAreRejectedOrReadAndNeverHang() throws IOException {
    byte[] whole = Files.readAllBytes(resource("flydra.h5"));
    Path broken = folder.resolve("broken.h5");
    int refused = 0;
    for (int length = 600; length < whole.length; length += 1217) {
      ReplacedFile.write(broken, Arrays.copyOf(whole, length));
      refused += isRefused(broken) ? 1 : 0;
    }
    assertTrue(refused >= 20, refused + " of the cut files are refused");
    for (int at = 8; at < whole.length - 8; at += 61) {
      byte[] lie = whole.clone();
      ByteBuffer bytes = ByteBuffer.wrap(lie).order(ByteOrder.LITTLE_ENDIAN);
      switch (at % 3) {
        case 0 -> bytes.putInt(at, 0x7fffffff);
        case 1 -> bytes.putLong(at, Long.MAX_VALUE / 3);
        default -> bytes.putInt(at, bytes.getInt(at) + 3);
      }
      ReplacedFile.write(broken, lie);
      isRefused(broken);
    }
  }

  private boolean isRefused(Path file) {
    try {
      read(file);
      return false;
    } catch (IOException problem) {
      assertTrue(problem.getMessage().startsWith(file.toString()), problem.getMessage());
      return true;
    }
  }

  @Test
  void plueckerLineMatchesTwoPointsOnTheAxis() {
    double[] a = {0.3, -0.2, 0.5, 1};
    double[] u = {0.48, 0.6, -0.64};
    double[] b = {a[0] + u[0], a[1] + u[1], a[2] + u[2], 1};
    OrientationEstimate now =
        new OrientationEstimate(0, a[0], a[1], a[2], u[0], u[1], u[2], 0.1, 2, 0, 0, 0, 1, 2, 0);
    double[] line = now.hzLine();
    int[][] entries = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {3, 1}, {2, 3}};
    for (int k = 0; k < 6; k++) {
      int i = entries[k][0];
      int j = entries[k][1];
      assertEquals(a[i] * b[j] - b[i] * a[j], line[k], 1e-15, "entry " + k);
    }
    assertEquals(
        0, Vectors.angle(u, new double[] {-line[2], line[4], -line[5]}), 1e-7, "tail to head");
  }
}
