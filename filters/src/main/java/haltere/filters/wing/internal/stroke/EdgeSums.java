package haltere.filters.wing.internal.stroke;

/** Events of an edge for one update of the filter of its wing. */
final class EdgeSums {
  private final int edge;
  private double weight;
  private double residual;
  private double cos;
  private double sin;

  /** Events of an edge: 0 leading (OFF), 1 trailing (ON). */
  EdgeSums(int edge) {
    this.edge = edge;
  }

  void clear() {
    weight = 0;
    residual = 0;
    cos = 0;
    sin = 0;
  }

  /** Adds a residual with its weight and phase. */
  void add(double w, double y, double c, double s) {
    weight += w;
    residual += w * y;
    cos += w * c;
    sin += w * s;
  }

  /**
   * Updates a filter and clears the sums. Returns the variance that the filter expected, or the
   * argument if there was no event.
   */
  double update(StrokeEkf filter, double otherwise) {
    if (!(weight > 0)) {
      clear();
      return otherwise;
    }
    double c = cos / weight;
    double s = sin / weight;
    double scale = 1.5 - 0.5 * (c * c + s * s);
    filter.look(c * scale, s * scale, 1 - 2 * edge);
    double expected = filter.expectedVariance();
    filter.update(residual / weight - filter.movedBy(), 1 / weight);
    clear();
    return expected;
  }
}
