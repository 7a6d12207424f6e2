package haltere.ui.command;

import haltere.core.format.AtomicFile;
import haltere.filters.estimation.Gate;
import haltere.filters.estimation.internal.example.ExampleTable;
import haltere.filters.estimation.internal.example.FallingWeight;
import haltere.filters.estimation.internal.example.MeasurementSeries;
import haltere.filters.estimation.internal.example.Oscillator;
import haltere.filters.estimation.internal.example.SimulatedVideo;
import haltere.ui.command.results.ExamplePlots;
import haltere.ui.command.terminal.Quantities;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Runs a worked example of the estimation library. */
@Command(
    name = "example",
    description = {
      "Run a worked example of estimation on simulated or measured motion (video "
          + "of 240 frames a second).",
      "falling-weight: displacement, velocity and acceleration of a weight in free "
          + "fall. oscillator: also damping ratio and frequency of a weight on a spring, "
          + "released from below. TABLE has a row for each measurement: the filter's "
          + "estimates with standard deviations (sd_) and gains (gain_), and for "
          + "comparison a fit to all measurements (fit_) and finite differences (difference_)."
    })
final class ExampleCommand extends Subcommand {
  private static final String FALLING_WEIGHT = "falling-weight";
  private static final String OSCILLATOR = "oscillator";

  @Parameters(
      paramLabel = "EXAMPLE",
      description = "Which one: " + FALLING_WEIGHT + " or " + OSCILLATOR + ".")
  String name;

  @Option(
      names = "--out",
      required = true,
      paramLabel = "TABLE.csv",
      description = "Output table of the estimates.")
  Path out;

  @Option(
      names = "--plots",
      paramLabel = "FOLDER",
      description = "Folder for the plots, as SVG; created if missing.")
  Path plots;

  @Option(
      names = "--data",
      paramLabel = "MEASUREMENTS.csv",
      description =
          "Your measurements instead of simulated ones: columns t_s,x_m and, if "
              + "accelerations along x were measured, a_m_s2; rows ascend in time. For the "
              + "oscillator, x_m is the displacement from rest.")
  Path data;

  @Option(
      names = "--seed",
      paramLabel = "N",
      description = "Seed of the simulated measurements; default 1.")
  Long seed;

  @Mixin WritingOptions writing;

  @Override
  public Integer call() throws IOException {
    boolean falls = name.equals(FALLING_WEIGHT);
    if (!falls && !name.equals(OSCILLATOR)) {
      throw wrongArguments(
          "there is no example " + name + "; there are " + FALLING_WEIGHT + ", " + OSCILLATOR);
    }
    checkNeeded(data == null, "simulated measurements, not --data", "--seed");
    if (WritingOptions.hasEnding(out, ".parquet")) {
      throw wrongArguments("--out " + out + ": this table is written as CSV; choose a .csv");
    }
    boolean isNewFolder = plots != null && !Files.isDirectory(plots);
    if (isNewFolder && Files.exists(plots)) {
      throw new CommandProblem(plots + ": this is a file; name a folder");
    }
    writing.check(Arrays.asList(data), Arrays.asList(out, isNewFolder ? plots : null));
    MeasurementSeries series;
    ExampleTable table;
    try {
      series = series(falls);
      table = falls ? new FallingWeight(series).table() : new Oscillator(series).table();
    } catch (IllegalArgumentException | ArithmeticException useless) {
      throw new CommandProblem(data + ": " + useless.getMessage(), useless);
    }
    Map<Path, String> files = new TreeMap<>();
    if (plots != null) {
      Map<String, String> drawn =
          falls ? ExamplePlots.fallingWeight(table) : ExamplePlots.oscillator(table);
      drawn.forEach((plot, svg) -> files.put(plots.resolve(name + "-" + plot + ".svg"), svg));
      if (isNewFolder) {
        Files.createDirectory(plots);
      }
    }
    List<Path> outputs = new ArrayList<>(files.keySet());
    outputs.add(out);
    writing.check(Arrays.asList(data), outputs);
    for (Map.Entry<Path, String> file : files.entrySet()) {
      AtomicFile.write(file.getKey(), file.getValue(), writing.overwrite);
    }
    AtomicFile.write(out, table.csv(), writing.overwrite);
    files.keySet().forEach(file -> message("wrote " + file));
    wrote(out, table.column("t_s").length);
    printResults(table, series.noiseM(), falls);
    return OK;
  }

  private MeasurementSeries series(boolean falls) throws IOException {
    if (data != null) {
      return MeasurementFile.read(data);
    }
    long chosen = seed == null ? 1 : seed;
    return falls ? SimulatedVideo.fallingWeight(chosen) : SimulatedVideo.oscillator(chosen);
  }

  private void printResults(ExampleTable table, double noiseM, boolean falls) {
    result("%-26s %.2g mm", "noise of the displacement", 1000 * noiseM);
    if (falls) {
      result(estimate("acceleration", table, "a_m_s2", "m/s²"));
      result(estimate("  least squares", table, "fit_a_m_s2", "m/s²"));
    } else {
      result(estimate("damping ratio", table, "damping", ""));
      result(estimate("frequency", table, "frequency_rad_s", "rad/s"));
      double plain = last(table, "plain_frequency_rad_s");
      result(
          Double.isNaN(plain)
              ? "  linearised only once     left the numbers"
              : Quantities.text(
                  "  linearised only once     %.4g rad/s, damping ratio %.4g",
                  plain, last(table, "plain_damping")));
    }
    double[] measured = table.column("x_m");
    double worst = 0;
    for (String column : falls ? List.of("s_m", "fit_s_m") : List.of("fit_s_m")) {
      double[] fit = table.column(column);
      double squares = 0;
      for (int k = 0; k < fit.length; k++) {
        squares += Math.pow((measured[k] - fit[k]) / noiseM, 2) / fit.length;
      }
      worst = Math.max(worst, squares);
    }
    // The noise was estimated from third differences, each of four neighbours.
    int independent = measured.length / 4;
    if (!(worst * independent <= Gate.probability(0.9995).threshold(independent))) {
      warning(
          "the residuals are %.2g times the noise: the model does not fit this "
              + "motion%s; the stated deviations do not hold",
          Math.sqrt(worst),
          falls ? ", or x_m is not in metres" : ", or x_m is not measured from rest");
    }
  }

  /** The value with its deviation, to two digits of the deviation. */
  private static String estimate(String label, ExampleTable table, String column, String unit) {
    double deviation = last(table, "sd_" + column);
    int digits = (int) Math.max(0, Math.min(9, 1 - Math.floor(Math.log10(deviation))));
    String number = "%." + digits + "f";
    String form = "%-26s " + number + " ± " + number + " %s";
    return Quantities.text(form, label, last(table, column), deviation, unit).stripTrailing();
  }

  private static double last(ExampleTable table, String column) {
    double[] values = table.column(column);
    return values[values.length - 1];
  }
}
