package haltere.ui.wing;

import haltere.core.sink.internal.Unchecked;
import haltere.filters.wing.WingEstimate;
import haltere.filters.wing.WingMeasurement;
import haltere.filters.wing.WingMethod;
import haltere.filters.wing.WingPart;
import java.io.Writer;
import java.util.Arrays;
import java.util.Locale;

/**
 * Rows in the layout of the wing tracker of 2006, separated by tabs. Kalman filter: edge code,
 * time, edge, centre, amplitude, phase, angular frequency, measurement. Running average: edge code,
 * time, edge, frequency, amplitude, measurement; of the fourth edge only time, edge and
 * measurement.
 *
 * <p>Thread rule: the processing thread.
 */
final class OriginalRows {
  private static final int LAST_EDGE = 4;

  private final Writer text;
  private final boolean average;
  private final double[] measured = new double[LAST_EDGE];
  private long rows;

  OriginalRows(Writer text, WingMethod method) {
    this.text = text;
    average = method == WingMethod.WRA;
    Arrays.fill(measured, Double.NaN);
  }

  /** Descriptions of the columns, a line each. */
  static String[] columns(WingMethod method) {
    String common =
        "edge codes: 1 left leading, 2 left trailing, 3 right leading, 4 right trailing";
    return method == WingMethod.WRA
        ? new String[] {
          common,
          "columns: edge code, time (us), edge (rad), frequency (Hz), amplitude (rad, half of peak"
              + " to peak), measurement (rad)",
          "columns of edge 4: edge code, time (us), edge (rad), measurement (rad)"
        }
        : new String[] {
          common,
          "columns: edge code, time (us), edge (rad), centre (rad), amplitude (rad, half of peak to"
              + " peak), phase (rad), angular frequency (rad/s), measurement (rad)"
        };
  }

  long rows() {
    return rows;
  }

  /** Writes a comment line. */
  void comment(String text) {
    write("# " + text + "\n");
  }

  /** Stores the last measurement of an edge. */
  void keep(WingMeasurement m) {
    measured[m.edge().ordinal()] = m.measuredRad();
  }

  void event(WingMeasurement m) {
    keep(m);
    row(
        m.edge(),
        m.timeUs(),
        m.expectedRad(),
        m.centreRad(),
        m.amplitudeRad(),
        m.phaseRad(),
        m.frequencyHz());
  }

  /** A row for an edge at a tick; wings as a whole have no code. */
  void tick(WingEstimate e) {
    if (e.edge().ordinal() < LAST_EDGE) {
      row(
          e.edge(),
          e.timeUs(),
          e.angleRad(),
          e.centreRad(),
          e.amplitudeRad(),
          e.phaseRad(),
          e.frequencyHz());
    }
  }

  private void row(
      WingPart part,
      long timeUs,
      double edge,
      double centre,
      double amplitude,
      double phase,
      double hz) {
    int code = part.ordinal() + 1;
    double z = measured[part.ordinal()];
    String numbers =
        !average
            ? text("\t%.6f\t%.6f\t%.6f\t%.4f", centre, amplitude, phase, 2 * Math.PI * hz)
            : code < LAST_EDGE ? text("\t%.4f\t%.6f", hz, amplitude) : "";
    write(text("%d\t%d\t%.6f%s\t%.6f\n", code, timeUs, edge, numbers, z));
    rows++;
  }

  private static String text(String form, Object... values) {
    return String.format(Locale.ROOT, form, values);
  }

  private void write(String line) {
    Unchecked.write(() -> text.write(line));
  }
}
