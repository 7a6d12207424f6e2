package haltere.filters.orientation.camera;

import haltere.core.format.hdf5.Hdf5Tables.Row;
import haltere.core.format.hdf5.Hdf5Tables.RowListener;
import java.io.BufferedReader;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.zip.GZIPInputStream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipException;
import java.util.zip.ZipFile;

/**
 * The tables of a {@code .braidz} file of Braid: a ZIP of gzipped CSV files without a folder of
 * their own, and the calibration as XML.
 */
final class BraidzTables implements FlydraDetections.Tables {
  private final Path file;
  private final ZipFile zip;

  private BraidzTables(Path file) throws IOException {
    this.file = file;
    try {
      zip = new ZipFile(file.toFile());
    } catch (ZipException damaged) {
      throw new TableProblem(file + ": this ZIP is damaged: " + damaged.getMessage());
    }
  }

  /** Whether a file is a ZIP, by its first bytes. */
  static boolean isZip(Path file) throws IOException {
    try (InputStream in = Files.newInputStream(file)) {
      byte[] head = in.readNBytes(4);
      return head.length == 4 && head[0] == 'P' && head[1] == 'K' && head[2] == 3 && head[3] == 4;
    }
  }

  /** Opens a file; one that lacks a table is refused. */
  static BraidzTables open(Path file) throws IOException {
    BraidzTables tables = new BraidzTables(file);
    for (String table : List.of("cam_info", "data2d_distorted", "data_association")) {
      if (!tables.has(table)) {
        tables.close();
        throw new TableProblem(
            file + ": there is no " + table + ".csv.gz in it; a .braidz file has no folder inside");
      }
    }
    return tables;
  }

  /** The cameras of its own calibration. */
  CameraFile cameras() throws IOException {
    ZipEntry xml = zip.getEntry("calibration.xml");
    if (xml == null) {
      throw new TableProblem(file + ": there is no calibration.xml in it, so no cameras");
    }
    try (InputStream in = zip.getInputStream(xml)) {
      return CameraXml.read(in, file + ": calibration.xml");
    }
  }

  private BufferedReader reader(String table) throws IOException {
    InputStream packed = zip.getInputStream(zip.getEntry(table + ".csv.gz"));
    return new BufferedReader(
        new InputStreamReader(new GZIPInputStream(packed), StandardCharsets.UTF_8));
  }

  @Override
  public boolean has(String table) {
    return zip.getEntry(table + ".csv.gz") != null;
  }

  @Override
  public Set<String> columns(String table) throws IOException {
    try (BufferedReader in = reader(table)) {
      String header = in.readLine();
      return new LinkedHashSet<>(header == null ? List.of() : ObservationTable.fields(header));
    } catch (EOFException | ZipException damaged) {
      throw new TableProblem(file + ": " + table + ": damaged after line 0");
    }
  }

  @Override
  public void read(String table, List<String> names, int required, RowListener listener)
      throws IOException {
    Line row = new Line(names.size());
    try (BufferedReader in = reader(table)) {
      String header = in.readLine();
      if (header == null) {
        return; // a table without rows has no header either
      }
      List<String> there = ObservationTable.fields(header);
      int[] places = names.stream().mapToInt(there::indexOf).toArray();
      for (int i = 0; i < required; i++) {
        if (places[i] < 0) {
          throw new TableProblem(
              file + ": " + table + ": there is no column " + names.get(i) + " in line 1");
        }
      }
      row.number = 1;
      for (String line = in.readLine(); line != null; line = in.readLine()) {
        row.number++;
        List<String> all = ObservationTable.fields(line);
        for (int i = 0; i < places.length; i++) {
          boolean isThere = places[i] >= 0 && places[i] < all.size();
          row.fields[i] = isThere ? all.get(places[i]).strip() : "";
        }
        listener.row(row);
      }
    } catch (NumberFormatException noNumber) {
      throw new TableProblem(
          file + ": " + table + ": line " + row.number + ": " + noNumber.getMessage());
    } catch (EOFException | ZipException damaged) {
      throw new TableProblem(file + ": " + table + ": damaged after line " + row.number);
    }
  }

  @Override
  public void close() throws IOException {
    zip.close();
  }

  /** A line of a table. */
  private static final class Line implements Row {
    private final String[] fields;
    private long number;

    Line(int columns) {
      fields = new String[columns];
    }

    @Override
    public long index() {
      return number - 2;
    }

    @Override
    public double number(int column) {
      String text = fields[column];
      return text.isEmpty() || text.equalsIgnoreCase("nan") ? Double.NaN : Double.parseDouble(text);
    }

    @Override
    public String text(int column) {
      return fields[column];
    }

    @Override
    public long[] list(int column) {
      return new long[0];
    }
  }
}
