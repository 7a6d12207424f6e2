package haltere.ui.plot;

import java.util.List;

/**
 * The plotted samples as a table: {@code t_us,field,key,value,lowest,highest}. Where only summaries
 * remain, a row has the middle of a summary and its two extremes.
 *
 * @param text the whole table
 */
public record PlotTable(String text) {
  private static final int ALL = 1 << 20;

  /** The table of a window of time, with a header line. */
  public static PlotTable of(List<Lane> lanes, TimeWindow window) {
    StringBuilder text = new StringBuilder("t_us,field,key,value,lowest,highest\n");
    for (Lane lane : lanes) {
      for (PlotField field : lane.fields()) {
        String name = field.toString().replace(" / ", "/");
        for (Curve curve : lane.curves(field)) {
          curve.paint(
              window.fromUs(),
              window.toUs(),
              ALL,
              (fromUs, toUs, lowest, highest, joined) -> {
                long timeUs = fromUs + (toUs - fromUs) / 2;
                if (timeUs >= window.fromUs() && timeUs <= window.toUs()) {
                  text.append(timeUs).append(',').append(name).append(',');
                  text.append(curve.key()).append(',').append((lowest + highest) / 2);
                  text.append(',').append(lowest).append(',').append(highest).append('\n');
                }
              });
        }
      }
    }
    return new PlotTable(text.toString());
  }
}
