package haltere.ui.command.results;

import haltere.core.sink.internal.SvgPlot;
import haltere.filters.estimation.internal.example.ExampleTable;
import haltere.filters.estimation.internal.example.Oscillations;
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
  private static final String[] COLOURS = {BLUE, RED, GREEN, GREY};
  private static final String TIME = "time (s)";
  private static final String FILTERED = "filtered, ± 1 SD";

  /** Maximum number of points, by the width of a plot. */
  private static final int MAX_POINTS = 300;

  /** Measurements that show single pixels: 0.1 s of video. */
  private static final int CLOSE_UP = 24;

  private final Map<String, String> plots = new LinkedHashMap<>();
  private final ExampleTable table;
  private final String what;
  private final double[] t;

  private ExamplePlots(ExampleTable table, String what) {
    this.table = table;
    this.what = what;
    t = column("t_s");
  }

  /** Plots of a falling weight: SVG documents by name. */
  public static Map<String, String> fallingWeight(ExampleTable table) {
    ExamplePlots all = new ExamplePlots(table, " of a falling weight");
    all.motion("parabola");
    SvgPlot acceleration = all.within("a_m_s2");
    all.band(acceleration, "smoothed, ± 1 SD", GREEN, "smoothed_a_m_s2");
    all.band(acceleration, FILTERED, BLUE, "a_m_s2");
    acceleration.line("parabola", RED, all.t, all.column("fit_a_m_s2"));
    all.put("acceleration", acceleration, "Acceleration", "a (m/s²)");
    all.gains("gain_s", "gain_v_per_s", "gain_a_per_s2");
    return all.plots;
  }

  /** Plots of a weight on a spring: SVG documents by name. */
  public static Map<String, String> oscillator(ExampleTable table) {
    ExamplePlots all = new ExamplePlots(table, " of a weight on a spring");
    all.motion("fit to all");
    all.put("acceleration", all.filtered("a_m_s2"), "Acceleration", "a (m/s²)");
    all.put("damping", all.filtered("damping"), "Damping ratio", "ζ");
    all.put("frequency", all.filtered("frequency_rad_s"), "Frequency", "ω (rad/s)");
    double[] plain = all.column("plain_frequency_rad_s");
    SvgPlot both = SvgPlot.around(all.t, all.column("frequency_rad_s"), plain);
    both.line("linearised once", RED, all.t, plain);
    all.band(both, "iterated, ± 1 SD", BLUE, "frequency_rad_s");
    all.put("linearisation", both, "Frequency by two filters", "ω (rad/s)");
    all.gains("gain_s", "gain_v_per_s", "gain_damping_per_m", "gain_frequency_rad_s_m");
    all.plots.put("integrators", integrators());
    return all.plots;
  }

  /** Displacement, velocity, phase plane and single pixels, with the fit to all measurements. */
  private void motion(String fit) {
    double[] measured = column("x_m");
    double[] fitS = column("fit_s_m");
    double[] fitV = column("fit_v_m_s");
    double[] differences = column("difference_v_m_s");
    SvgPlot displacement = SvgPlot.around(t, measured, fitS).dots("measured", GREY, t, measured);
    band(displacement, FILTERED, BLUE, "s_m").line(fit, RED, t, fitS);
    put("displacement", displacement, "Displacement", "s (m)");
    SvgPlot velocity = SvgPlot.around(t, differences, fitV);
    velocity.dots("finite differences", GREY, t, differences);
    band(velocity, FILTERED, BLUE, "v_m_s").line(fit, RED, t, fitV);
    put("velocity", velocity, "Velocity", "v (m/s)");
    SvgPlot phase = SvgPlot.around(measured, differences, fitV);
    phase.dots("finite differences", GREY, measured, differences);
    phase.line("filtered", BLUE, column("s_m"), column("v_m_s")).line(fit, RED, fitS, fitV);
    plots.put("phase-plane", phase.draw("Phase plane" + what, "s (m)", "v (m/s)"));
    double[] closeT = closeUp("t_s");
    double[] closeX = closeUp("x_m");
    double[] closeFit = closeUp("fit_s_m");
    SvgPlot close = SvgPlot.around(closeT, closeX, closeFit);
    close.dots("measured", GREY, closeT, closeX).line(fit, RED, closeT, closeFit);
    put("quantisation", close, "Quantisation", "s (m)");
  }

  private void gains(String... columns) {
    double[][] gains =
        Arrays.stream(columns).map(name -> logarithms(column(name))).toArray(double[][]::new);
    SvgPlot plot = SvgPlot.around(t, gains);
    for (int i = 0; i < columns.length; i++) {
      plot.line(columns[i], COLOURS[i], t, gains[i]);
    }
    put("gains", plot, "Gains", "log₁₀ |K|");
  }

  private static String integrators() {
    int[] steps = IntStream.rangeClosed(0, 48).map(i -> (int) Math.pow(2, i / 4.0)).toArray();
    double[] x = logarithms(Arrays.stream(steps).asDoubleStream().toArray());
    SvgPlot plot = new SvgPlot(0, x[x.length - 1], -16, 6);
    for (int i = 0; i < COLOURS.length; i++) {
      boolean euler = i < 2;
      int s0 = i % 2;
      double[] errors =
          Arrays.stream(steps).mapToDouble(n -> Oscillations.error(euler, s0, 1 - s0, n)).toArray();
      String name = (euler ? "Euler" : "Runge-Kutta 4") + (s0 > 0 ? ", (1, 0)" : ", (0, 1)");
      plot.line(name, COLOURS[i], x, logarithms(errors));
    }
    String title = "Error after 100 ms at 3 Hz, ζ = 0.1, from two (s, v)";
    return plot.draw(title, "log₁₀ of the number of steps", "log₁₀ of the error");
  }

  private static double[] logarithms(double... values) {
    return Arrays.stream(values).map(x -> x == 0 ? Double.NaN : Math.log10(Math.abs(x))).toArray();
  }

  private void put(String name, SvgPlot plot, String title, String label) {
    plots.put(name, plot.draw(title + what, TIME, label));
  }

  private SvgPlot filtered(String name) {
    return band(within(name), FILTERED, BLUE, name);
  }

  /** A range for estimates with their deviations, from a tenth of the measurements on. */
  private SvgPlot within(String name) {
    int from = t.length / 10;
    double[] low = Arrays.copyOfRange(edge(name, -1), from, t.length);
    return SvgPlot.around(t, low, Arrays.copyOfRange(edge(name, 1), from, t.length));
  }

  private SvgPlot band(SvgPlot plot, String label, String colour, String name) {
    plot.band("", colour, t, edge(name, -1), edge(name, 1));
    return plot.line(label, colour, t, column(name));
  }

  private double[] edge(String name, int sign) {
    double[] value = column(name);
    double[] deviation = column("sd_" + name);
    return IntStream.range(0, t.length).mapToDouble(k -> value[k] + sign * deviation[k]).toArray();
  }

  private double[] closeUp(String name) {
    return Arrays.stream(table.column(name)).limit(CLOSE_UP).toArray();
  }

  private double[] column(String name) {
    double[] all = table.column(name);
    int stride = (all.length + MAX_POINTS - 1) / MAX_POINTS;
    return IntStream.range(0, (all.length + stride - 1) / stride)
        .mapToDouble(i -> all[i * stride])
        .toArray();
  }
}
