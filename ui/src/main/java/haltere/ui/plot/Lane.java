package haltere.ui.plot;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/**
 * One of several stacked plots: the curves of fields with the same vertical axis, one for each key
 * of a field. The curve that has been silent for longest makes room for a new one.
 */
public final class Lane {
  /** Maximum number of distinguishable curves. */
  static final int MAX_CURVES = 32;

  /** More columns than samples. */
  private static final int ALL = 1 << 20;

  private final Map<PlotField, Map<String, Curve>> curves = new LinkedHashMap<>();
  private final List<Curve> all = new ArrayList<>();

  /** A lane with one field. */
  public Lane(PlotField field) {
    add(field);
  }

  /** Plots another field in the same lane, if it is not there already. */
  public void add(PlotField field) {
    curves.computeIfAbsent(field, absent -> new LinkedHashMap<>());
  }

  /** The plotted fields, in the order of their addition. */
  public List<PlotField> fields() {
    return List.copyOf(curves.keySet());
  }

  /** Whether a field is plotted here. */
  public boolean has(PlotField field) {
    return curves.containsKey(field);
  }

  /**
   * Takes a sample of one of the fields: time on the recording's clock in microseconds, which
   * curve, and the number.
   */
  public void take(PlotField field, long timeUs, String key, double value) {
    Map<String, Curve> ofField = curves.get(field);
    Curve curve = ofField.get(key);
    if (curve == null) {
      if (all.size() >= MAX_CURVES) {
        removeSilentCurves();
      }
      String name = key.isEmpty() ? field.column() : key;
      curve = new Curve(name, freeNumber(), fields().indexOf(field));
      ofField.put(key, curve);
      all.add(curve);
    }
    curve.add(timeUs, value);
  }

  /** The smallest unused number, so that a restarted curve has the same colour. */
  private int freeNumber() {
    return IntStream.rangeClosed(0, all.size())
        .filter(number -> all.stream().noneMatch(curve -> curve.number() == number))
        .findFirst()
        .orElseThrow();
  }

  private void removeSilentCurves() {
    Curve silent = Collections.min(all, Comparator.comparingLong(Curve::lastUs));
    all.remove(silent);
    curves.values().forEach(ofField -> ofField.values().remove(silent));
  }

  /** The curves, oldest first. */
  public List<Curve> curves() {
    return List.copyOf(all);
  }

  /** The curves of one of the fields, oldest first. */
  public Collection<Curve> curves(PlotField field) {
    return List.copyOf(curves.get(field).values());
  }

  /** The unit of the values of a curve, such as "rad"; empty without one. */
  public String unit(Curve curve) {
    return curves.entrySet().stream()
        .filter(ofField -> ofField.getValue().containsValue(curve))
        .findFirst()
        .map(ofField -> ofField.getKey().unit())
        .orElse("");
  }

  /**
   * Minimum and maximum in a window with a number of pixel columns, without initial transients; the
   * minimum is above the maximum without samples.
   */
  public double[] range(TimeWindow window, int columns) {
    double[] range = {Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY};
    for (Curve curve : all) {
      long from = Math.max(window.fromUs(), Math.min(curve.settledUs(), window.toUs()));
      curve.paint(
          from,
          window.toUs(),
          columns,
          (fromUs, toUs, low, high, joined) -> {
            if (toUs >= from && fromUs <= window.toUs()) {
              range[0] = Math.min(range[0], low);
              range[1] = Math.max(range[1], high);
            }
          });
    }
    return range;
  }

  /**
   * Removes samples from a time in microseconds on, after playback went back, and curves without
   * samples before it; a track found later has another identity.
   */
  public void removeFrom(long timeUs) {
    all.forEach(curve -> curve.removeFrom(timeUs));
    all.removeIf(curve -> curve.lastUs() == Long.MIN_VALUE);
    curves
        .values()
        .forEach(ofField -> ofField.values().removeIf(curve -> curve.lastUs() == Long.MIN_VALUE));
  }

  /**
   * Time of the newest sample of a plotted field, microseconds; {@link Long#MIN_VALUE} without
   * samples.
   */
  public long lastUs(PlotField field) {
    Collection<Curve> ofField = curves.get(field).values();
    return ofField.stream().mapToLong(Curve::lastUs).max().orElse(Long.MIN_VALUE);
  }

  /** Removes all curves. */
  public void clear() {
    curves.values().forEach(Map::clear);
    all.clear();
  }

  /**
   * The samples of lanes in a window as a table: {@code t_us,field,key,value,lowest,highest}. Where
   * only summaries remain, a row has the middle of a summary and its two extremes.
   */
  public static String table(List<Lane> lanes, TimeWindow window) {
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
    return text.toString();
  }
}
