package haltere.ui.command;

import haltere.core.json.internal.Json;
import haltere.core.settings.SettingsJson;
import haltere.core.settings.SettingsSchema;
import haltere.filters.orientation.OrientationSettings;
import haltere.filters.orientation.camera.CameraFile;
import haltere.filters.orientation.camera.CameraModel;
import haltere.filters.orientation.camera.LineObservation;
import haltere.filters.orientation.camera.ObservationFile;
import haltere.ui.command.report.OrientReport;
import haltere.ui.command.report.ReportPage;
import haltere.ui.command.results.OrientationTable;
import haltere.ui.command.results.OrientedBodies;
import haltere.ui.command.terminal.Quantities;
import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Finds the three-dimensional orientation of bodies from observations of calibrated cameras. */
@Command(
    name = "orient",
    footer = {"", "Example: haltere orient seen.csv --cameras cameras.json --out orientation.csv"},
    description = {
      "Estimate position and orientation of bodies from the observations of calibrated cameras.",
      "OUT has a row for each observed body with a known axis at each time. The "
          + "axis points from tail to head and uses observations up to that time only "
          + "(with --smooth, all). A line does not show roll, so p_rad_s has no meaning."
    })
final class OrientCommand extends Subcommand {
  private static final int MAX_REPORTED_ROWS = 10;

  @Parameters(
      paramLabel = "OBSERVATIONS.csv",
      description = {
        "Observations: a table t_us,camera,object,x_px,y_px,angle_rad,area_px,eccentricity; or a "
            + ".braidz file; or HDF5 with the tables of Flydra."
      })
  Path file;

  @Option(
      names = "--cameras",
      paramLabel = "CAMERAS.json",
      description = "The calibrated cameras: JSON or XML; a .braidz file has its own.")
  Path camerasFile;

  @Option(
      names = "--out",
      required = true,
      paramLabel = "ORIENTATION.csv",
      description =
          "Output table: CSV, or by its ending Parquet (OUT.parquet), or for "
              + "observations with frames HDF5 (OUT.h5).")
  Path out;

  @Option(
      names = "--gate-angle",
      paramLabel = "DEG",
      description =
          "Reject lines at this angle or more from the predicted one; default 40. 0 "
              + "rejects all and gives no orientation, 180 accepts all.")
  Double gateAngleDeg;

  @Option(
      names = "--min-area",
      paramLabel = "PX",
      description = "Smaller detections are ignored; default 0.")
  Double minAreaPx;

  @Option(
      names = "--min-eccentricity",
      paramLabel = "RATIO",
      description = "Detections of a smaller eccentricity are ignored; default: none are.")
  Double minEccentricity;

  @Option(
      names = "--preset",
      paramLabel = "NAME",
      description = "original: Flydra's filter with its defaults, for comparison.")
  String preset;

  @Option(
      names = "--smooth",
      description = "Smooth each whole track, and choose head and tail from all of it.")
  boolean smooth;

  @Option(
      names = "--set",
      paramLabel = "name=value",
      description = "A setting, such as turning.saccadeRateRadS=30; may be repeated.")
  List<String> assignments = List.of();

  @Mixin WritingOptions writing;
  @Mixin ReportOptions reporting;

  private long badRows;

  @Override
  public Integer call() throws IOException {
    OrientationSettings settings = settings();
    writing.check(Arrays.asList(file, camerasFile), Arrays.asList(out, reporting.report));
    if (camerasFile == null && !ObservationFile.hasCameras(file)) {
      throw wrongArguments("--cameras is missing: a table has no cameras of its own");
    }
    ObservationFile observations = ObservationFile.open(file, Optional.ofNullable(camerasFile));
    CameraFile cameras = observations.cameras();
    if (OrientationTable.isHdf5(out) && !observations.hasFrames()) {
      throw wrongArguments(
          "--out " + out + ": HDF5 is written of observations with frames only; choose a .csv");
    }
    if (cameras.minEccentricity() > 0 && minEccentricity == null && preset == null) {
      settings = settings.with("gate.minEccentricity=" + cameras.minEccentricity());
    }
    printProblems(cameras.cameras());
    try (OrientationTable table =
        new OrientationTable(
            out,
            observations,
            writing.overwrite,
            provenance(file).with("haltere.settings", json(settings)))) {
      OrientReport report = new OrientReport();
      OrientedBodies bodies =
          new OrientedBodies(cameras.cameras(), settings, smooth, table.andThen(report));
      read(observations, bodies);
      bodies.finish();
      if (bodies.observations() == 0 && badRows > 0) {
        throw new CommandProblem(
            file + ": none of its " + badRows + " rows are usable; see the warnings above");
      }
      table.finish();
      wrote(out, bodies.estimates());
      bodies.summary().forEach(this::result);
      report(report, settings, cameras, bodies.summary());
      if (bodies.estimates() == 0) {
        warning(
            file
                + ": no orientation found: each needs accepted lines of two cameras from different "
                + "directions at nearly the same time; the counts above tell what is missing");
      }
    }
    return OK;
  }

  private void report(
      OrientReport report, OrientationSettings settings, CameraFile cameras, List<String> summary)
      throws IOException {
    if (reporting.report == null) {
      return;
    }
    Map<String, String> read = new LinkedHashMap<>();
    read.put("Observations", file.toString());
    read.put("SHA-256", ReportOptions.checksum(file));
    if (camerasFile != null) {
      read.put("Cameras", camerasFile.toString());
      read.put("SHA-256 of the cameras", ReportOptions.checksum(camerasFile));
    }
    read.put(
        "Cameras in use",
        cameras.cameras().stream()
            .filter(camera -> camera.problem().isEmpty())
            .map(CameraModel::id)
            .collect(Collectors.joining(", ")));
    read.put("Rows left out", Quantities.count(badRows));
    ReportPage page = reporting.page(file);
    report.addTo(page, read, settings, summary);
    reporting.write(page, writing.overwrite);
  }

  private static Supplier<String> json(OrientationSettings settings) {
    SettingsSchema<OrientationSettings> schema = SettingsSchema.of(OrientationSettings.class);
    return () -> Json.write(SettingsJson.toMap(settings, schema));
  }

  private void read(ObservationFile observations, OrientedBodies bodies) throws IOException {
    try {
      observations.read(
          new ObservationFile.Listener() {
            @Override
            public void observed(long timeUs, String object, LineObservation line) {
              bodies.observed(timeUs, object, line);
            }

            @Override
            public void skipped(String where, String why) {
              badRows++;
              if (badRows <= MAX_REPORTED_ROWS) {
                warning(file + ": " + where + ": " + why + "; the row is left out");
              }
            }

            @Override
            public void remark(String text) {
              warning(file + ": " + text);
            }
          });
    } catch (CharacterCodingException notText) {
      throw Failures.notText(file, notText);
    }
    if (badRows > MAX_REPORTED_ROWS) {
      long more = badRows - MAX_REPORTED_ROWS;
      warning("%s: %d more rows like that, %d left out", file, more, badRows);
    }
  }

  private void printProblems(List<CameraModel> cameras) {
    for (CameraModel camera : cameras) {
      camera.problem().ifPresent(why -> warning("camera " + camera.id() + " is left out: " + why));
    }
    long usable = cameras.stream().filter(camera -> camera.problem().isEmpty()).count();
    if (usable < 2) {
      String there = usable == 1 ? "one camera" : "no camera";
      warning("there is " + there + " to use; an orientation needs two");
    }
  }

  private OrientationSettings settings() {
    OrientationSettings start =
        switch (preset == null ? "" : preset) {
          case "" -> OrientationSettings.defaults();
          case "original" -> OrientationSettings.original();
          default -> throw wrongArguments("there is no preset " + preset + "; there is: original");
        };
    Map<String, Object> options = new LinkedHashMap<>();
    options.put("gate.angleDeg", gateAngleDeg);
    options.put("gate.minAreaPx", minAreaPx);
    options.put("gate.minEccentricity", minEccentricity);
    return assigned(OrientationSettings.class, start, options, assignments);
  }
}
