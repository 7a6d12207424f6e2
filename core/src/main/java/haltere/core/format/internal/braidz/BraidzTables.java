package haltere.core.format.internal.braidz;

import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingProblem;
import haltere.core.format.internal.csv.CsvTable;
import haltere.core.format.internal.table.RecordingTables;
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
 *
 * <p>Thread rule: one thread.
 */
public final class BraidzTables implements RecordingTables {
  private final Path file;
  private final ZipFile zip;

  private BraidzTables(Path file) throws IOException {
    this.file = file;
    try {
      zip = new ZipFile(file.toFile());
    } catch (ZipException damaged) {
      throw new RecordingProblem(file, "this ZIP is damaged: " + damaged.getMessage());
    }
  }

  /**
   * Whether a file is a ZIP, by its first bytes.
   *
   * @param file any file
   * @return true for a ZIP
   * @throws IOException if it cannot be read
   */
  public static boolean isZip(Path file) throws IOException {
    RecordingFile.checkRegular(file);
    try (InputStream in = Files.newInputStream(file)) {
      byte[] head = in.readNBytes(4);
      return head.length == 4 && head[0] == 'P' && head[1] == 'K' && head[2] == 3 && head[3] == 4;
    }
  }

  /**
   * Opens a file.
   *
   * @param file a ZIP
   * @return its tables
   * @throws RecordingProblem if it is damaged or lacks a table; the message names the file
   * @throws IOException if it cannot be read
   */
  public static BraidzTables open(Path file) throws IOException {
    BraidzTables tables = new BraidzTables(file);
    for (String table : List.of("cam_info", "data2d_distorted", "data_association")) {
      if (!tables.has(table)) {
        tables.close();
        throw new RecordingProblem(
            file, "there is no " + table + ".csv.gz in it; a .braidz file has no folder inside");
      }
    }
    return tables;
  }

  /**
   * Its own calibration.
   *
   * @return the XML of a {@code multi_camera_reconstructor}; ends with these tables
   * @throws RecordingProblem if there is none; the message names the file
   * @throws IOException if it cannot be read
   */
  public InputStream calibration() throws IOException {
    ZipEntry xml = zip.getEntry("calibration.xml");
    if (xml == null) {
      throw new RecordingProblem(file, "there is no calibration.xml in it, so no cameras");
    }
    return zip.getInputStream(xml);
  }

  private BufferedReader reader(String table) throws IOException {
    InputStream compressed = zip.getInputStream(zip.getEntry(table + ".csv.gz"));
    return new BufferedReader(
        new InputStreamReader(new GZIPInputStream(compressed), StandardCharsets.UTF_8));
  }

  @Override
  public boolean has(String table) {
    return zip.getEntry(table + ".csv.gz") != null;
  }

  @Override
  public Set<String> columns(String table) throws IOException {
    try (BufferedReader in = reader(table)) {
      return new LinkedHashSet<>(new CsvTable(in, List.of()).header());
    } catch (EOFException | ZipException damaged) {
      throw new RecordingProblem(file, table + ": damaged in line 1");
    }
  }

  @Override
  public void read(String table, List<String> names, int required, RowListener listener)
      throws IOException {
    CsvTable rows = null;
    try (BufferedReader in = reader(table)) {
      rows = new CsvTable(in, names);
      for (String name : names.subList(0, rows.header().isEmpty() ? 0 : required)) {
        if (!rows.header().contains(name)) {
          throw new RecordingProblem(file, table + ": there is no column " + name + " in line 1");
        }
      }
      while (rows.next()) {
        listener.row(rows);
      }
    } catch (NumberFormatException noNumber) {
      throw new RecordingProblem(
          file, table + ": line " + rows.line() + ": " + noNumber.getMessage());
    } catch (EOFException | ZipException damaged) {
      throw new RecordingProblem(
          file, table + ": damaged after line " + (rows == null ? 0 : rows.line()));
    }
  }

  @Override
  public void close() throws IOException {
    zip.close();
  }
}
