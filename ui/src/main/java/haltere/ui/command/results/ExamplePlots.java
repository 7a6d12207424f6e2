package haltere.ui.command.results;

import haltere.core.sink.SvgPlot;
import haltere.filters.estimation.example.ExampleTable;
import haltere.filters.estimation.example.Oscillations;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.stream.IntStream;

/** Draws the plots of the worked examples from their tables. */
public final class ExamplePlots {
  private static final String GREY = "#888888";
  private static final String BLUE = "#1f6fb4";
  private static final String RED = "#c23b22";
  private static final String GREEN = "#2f8f4e";
  private static final String TIME = "time (s)";

  /** More points than this are not told apart at the width of a plot. */
  private static final int MAX_POINTS = 300;

  /** Measurements that show single pixels: 0.1 s of video. */
  private static final int CLOSE_UP = 24;

  private final Map<String, String> plots = new LinkedHashMap<>();
  private final ExampleTable table;
  private final String what;
  private final String fit;
  private final double[] t;

  private ExamplePlots(ExampleTable table, String what, String fit) {
    this.table = table;
    this.what = what;
    this.fit = fit;
    t = column("t_s");
  }

  /**
   * Plots of a falling weight.
   *
   * @param table its results
   * @return SVG documents by name
   */
  public static Map<String, String> fallingWeight(ExampleTable table) {
    ExamplePlots all = new ExamplePlots(table, "a falling weight", "parabola");
    all.motion(true);
    SvgPlot acceleration = all.within("a_m_s2");
    all.band(acceleration, "smoothed, ± 1 SD", GREEN, "smoothed_a_m_s2");
    all.band(acceleration, "filtered, ± 1 SD", BLUE, "a_m_s2");
    acceleration.line("parabola", RED, all.t, all.column("fit_a_m_s2"));
    all.put("acceleration", acceleration, "Acceleration", "a (m/s²)");
    all.gains(
        new String[] {"gain_s", "gain_v_per_s", "gain_a_per_s2"},
        new String[] {"of s", "of v (1/s)", "of a (1/s²)"});
    return all.plots;
  }

  /**
   * Plots of a weight on a spring.
   *
   * @param table its results
   * @return SVG documents by name
   */
  public static Map<String, String> oscillator(ExampleTable table) {
    ExamplePlots all = new ExamplePlots(table, "a weight on a spring", "fit to all");
    all.motion(false);
    all.plot("acceleration", "Acceleration", "a (m/s²)", "a_m_s2");
    all.plot("damping", "Damping ratio", "ζ", "damping");
    all.plot("frequency", "Frequency", "ω (rad/s)", "frequency_rad_s");
    SvgPlot both =
        SvgPlot.around(all.t, all.column("frequency_rad_s"), all.column("plain_frequency_rad_s"));
    both.line("linearised once", RED, all.t, all.column("plain_frequency_rad_s"));
    all.band(both, "linearised anew, ± 1 SD", BLUE, "frequency_rad_s");
    all.put("linearisation", both, "Frequency by two filters", "ω (rad/s)");
    all.gains(
        new String[] {"gain_s", "gain_v_per_s", "gain_damping_per_m", "gain_frequency_rad_s_m"},
        new String[] {"of s", "of v (1/s)", "of ζ (1/m)", "of ω (rad/s/m)"});
    all.integrators();
    return all.plots;
  }

  /** What both examples have: displacement and velocity, phase plane, single pixels. */
  private void motion(boolean rises) {
    double[] measured = column("x_m");
    double[] fitS = column("fit_s_m");
    double[] fitV = column("fit_v_m_s");
    double[] differences = column("difference_v_m_s");
    SvgPlot displacement = legend(SvgPlot.around(t, measured, fitS), rises);
    displacement.dots("measured", GREY, t, measured);
    band(displacement, "filtered, ± 1 SD", BLUE, "s_m");
    displacement.line(fit, RED, t, fitS);
    put("displacement", displacement, "Displacement", "s (m)");
    SvgPlot velocity = legend(SvgPlot.around(t, differences, fitV), rises);
    velocity.dots("finite differences", GREY, t, differences);
    band(velocity, "filtered, ± 1 SD", BLUE, "v_m_s");
    velocity.line(fit, RED, t, fitV);
    put("velocity", velocity, "Velocity", "v (m/s)");
    SvgPlot phase = legend(SvgPlot.around(measured, differences, fitV), rises);
    phase.dots("finite differences", GREY, measured, differences);
    phase.line("filtered", BLUE, column("s_m"), column("v_m_s"));
    phase.line(fit, RED, fitS, fitV);
    plots.put("phase-plane", phase.draw("Phase plane of " + what, "s (m)", "v (m/s)"));
    double[] closeT = closeUp("t_s", 1);
    double[] closeX = closeUp("x_m", 1000);
    double[] closeFit = closeUp("fit_s_m", 1000);
    SvgPlot close = SvgPlot.around(closeT, closeX, closeFit).legendLeft();
    close.dots("measured", GREY, closeT, closeX).line(fit, RED, closeT, closeFit);
    put("quantisation", close, "Quantisation", "s (mm)");
  }

  private static SvgPlot legend(SvgPlot plot, boolean left) {
    return left ? plot.legendLeft() : plot;
  }

  private void put(String name, SvgPlot plot, String title, String label) {
    plots.put(name, plot.draw(title + " of " + what, TIME, label));
  }

  private double[] closeUp(String name, double factor) {
    return Arrays.stream(table.column(name)).limit(CLOSE_UP).map(x -> factor * x).toArray();
  }

  private void plot(String name, String title, String label, String column) {
    SvgPlot plot = within(column);
    band(plot, "filtered, ± 1 SD", BLUE, column);
    put(name, plot, title, label);
  }

  /** A range for estimates with their deviations, from a tenth of the measurements on. */
  private SvgPlot within(String name) {
    int from = t.length / 10;
    double[] low = band(name, -1);
    double[] high = band(name, 1);
    return SvgPlot.around(
        t, Arrays.copyOfRange(low, from, t.length), Arrays.copyOfRange(high, from, t.length));
  }

  private void band(SvgPlot plot, String label, String colour, String name) {
    plot.band("", colour, t, band(name, -1), band(name, 1)).line(label, colour, t, column(name));
  }

  private double[] band(String name, int sign) {
    double[] value = column(name);
    double[] deviation = column("sd_" + name);
    return IntStream.range(0, t.length).mapToDouble(k -> value[k] + sign * deviation[k]).toArray();
  }

  private void gains(String[] columns, String[] labels) {
    String[] colours = {BLUE, RED, GREEN, GREY};
    double[][] gains = new double[columns.length][];
    for (int i = 0; i < columns.length; i++) {
      gains[i] = logarithms(column(columns[i]));
    }
    SvgPlot plot = SvgPlot.around(t, gains);
    for (int i = 0; i < columns.length; i++) {
      plot.line(labels[i], colours[i], t, gains[i]);
    }
    put("gains", plot, "Gains", "log₁₀ |K|");
  }

  private static double[] logarithms(double... values) {
    return Arrays.stream(values).map(x -> x == 0 ? Double.NaN : Math.log10(Math.abs(x))).toArray();
  }

  private void integrators() {
    int[] steps = IntStream.rangeClosed(0, 48).map(i -> (int) Math.pow(2, i / 4.0)).toArray();
    double[] x = logarithms(Arrays.stream(steps).asDoubleStream().toArray());
    String[] starts = {"from (1, 0)", "from (0, 1)"};
    double[][] euler = new double[2][];
    double[][] rungeKutta = new double[2][];
    for (int i = 0; i < 2; i++) {
      int s0 = 1 - i;
      euler[i] = errors(steps, true, s0);
      rungeKutta[i] = errors(steps, false, s0);
    }
    SvgPlot plot = SvgPlot.around(x, euler[0], euler[1], rungeKutta[0], rungeKutta[1]);
    for (int i = 0; i < 2; i++) {
      plot.line("Euler " + starts[i], i == 0 ? RED : GREY, x, euler[i]);
      plot.line("Runge-Kutta 4 " + starts[i], i == 0 ? BLUE : GREEN, x, rungeKutta[i]);
    }
    plots.put(
        "integrators",
        plot.draw(
            "Error after 100 ms at 3 Hz, ζ = 0.1",
            "log₁₀ of the number of steps",
            "log₁₀ of the error"));
  }

  private static double[] errors(int[] steps, boolean euler, double s0) {
    return logarithms(
        Arrays.stream(steps).mapToDouble(n -> Oscillations.error(euler, s0, 1 - s0, n)).toArray());
  }

  private double[] column(String name) {
    double[] all = table.column(name);
    int stride = (all.length + MAX_POINTS - 1) / MAX_POINTS;
    return IntStream.range(0, (all.length + stride - 1) / stride)
        .mapToDouble(i -> all[i * stride])
        .toArray();
  }
}
