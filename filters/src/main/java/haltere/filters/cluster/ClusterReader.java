package haltere.filters.cluster;

/** The visible ones of a tracker's clusters, as its observer sees them. */
final class ClusterReader implements ClusterReadings {
  /** Balance from which on mostly one edge of a thing is seen. */
  private static final double ONE_SIDED = 0.5;

  /**
   * Of such a thing the middle is between 0.64 (half a ring) and 1 ring radius away, which is 1
   * over 1.2 of the cluster's: that squared, for one of two axes. Of what the border cuts off a
   * part of, the same of that part.
   */
  private static final double UNSEEN = 0.23;

  private final ClusterMerging merging;
  private Cluster[] visible = new Cluster[0];
  private int count;
  private long timeUs;
  private double width;
  private double height;
  private boolean fedBack;

  ClusterReader(ClusterMerging merging) {
    this.merging = merging;
  }

  /** Opens the view, with the clusters moved on to its time. */
  void open(Cluster[] clusters, int clusterCount, long readingUs, int widthPx, int heightPx) {
    if (visible.length < clusters.length) {
      visible = new Cluster[clusters.length];
    }
    timeUs = readingUs;
    width = widthPx;
    height = heightPx;
    fedBack = false;
    count = 0;
    for (int i = 0; i < clusterCount; i++) {
      if (clusters[i].isVisible()) {
        clusters[i].moveTo(readingUs);
        clusters[i].endBatch();
        clusters[i].contour.read(clusters[i]);
        ClusterLines.hold(clusters[i], ageUs(clusters[i]) * 1e-6);
        visible[count++] = clusters[i];
      }
    }
  }

  /** Ends the measurements that were read. */
  void close() {
    for (int i = 0; i < count; i++) {
      visible[i].clearBatch(timeUs);
      visible[i].contour.next(visible[i], timeUs);
      visible[i] = null;
    }
    count = 0;
  }

  /** Whether a cluster was moved. */
  boolean wasFedBack() {
    return fedBack;
  }

  private Cluster at(int index) {
    if (index >= count) {
      throw new IndexOutOfBoundsException(
          "there are " + count + " visible clusters, none at " + index);
    }
    return visible[index];
  }

  @Override
  public int count() {
    return count;
  }

  @Override
  public int id(int index) {
    return at(index).id;
  }

  @Override
  public double x(int index) {
    return at(index).x;
  }

  @Override
  public double y(int index) {
    return at(index).y;
  }

  @Override
  public double vx(int index) {
    return at(index).vx;
  }

  @Override
  public double vy(int index) {
    return at(index).vy;
  }

  @Override
  public double newEvents(int index) {
    return at(index).batchEvents;
  }

  @Override
  public double contestedEvents(int index) {
    return at(index).batchContested;
  }

  @Override
  public double measuredX(int index) {
    return at(index).batchX / at(index).batchEvents;
  }

  @Override
  public double measuredY(int index) {
    return at(index).batchY / at(index).batchEvents;
  }

  @Override
  public double measuredAgeUs(int index) {
    return ageUs(at(index));
  }

  private double ageUs(Cluster cluster) {
    return timeUs - cluster.batchFromUs - cluster.batchMeanUs;
  }

  @Override
  public double lineX(int index) {
    return at(index).lineX;
  }

  @Override
  public double lineY(int index) {
    return at(index).lineY;
  }

  @Override
  public double eventVarianceX(int index) {
    return at(index).cxx;
  }

  @Override
  public double eventVarianceY(int index) {
    return at(index).cyy;
  }

  @Override
  public double eventCovarianceXy(int index) {
    return at(index).cxy;
  }

  @Override
  public double unseenVariance(int index) {
    Cluster cluster = at(index);
    double reach = cluster.radius;
    double toSides = Math.min(cluster.x, width - 1 - cluster.x);
    double toBorder = Math.min(toSides, Math.min(cluster.y, height - 1 - cluster.y));
    boolean oneSided = toBorder < reach && Math.abs(cluster.balance) > ONE_SIDED;
    double unseen = oneSided ? reach : Math.max(0, reach / ClusterContour.RING_RADII - toBorder);
    return UNSEEN * unseen * unseen;
  }

  @Override
  public double outlineXx(int index) {
    return at(index).contour.informationXx;
  }

  @Override
  public double outlineXy(int index) {
    return at(index).contour.informationXy;
  }

  @Override
  public double outlineYy(int index) {
    return at(index).contour.informationYy;
  }

  @Override
  public double outlineX(int index) {
    return shifted(at(index), at(index).contour.vectorX, true);
  }

  @Override
  public double outlineY(int index) {
    return shifted(at(index), at(index).contour.vectorY, false);
  }

  /** The vector of information at the mean time of the new events. */
  private static double shifted(Cluster cluster, double vector, boolean first) {
    double seconds = cluster.batchMeanUs * 1e-6;
    ClusterContour contour = cluster.contour;
    double moved =
        first
            ? contour.informationXx * cluster.vx + contour.informationXy * cluster.vy
            : contour.informationXy * cluster.vx + contour.informationYy * cluster.vy;
    return vector + seconds * moved;
  }

  @Override
  public double outlineMisfitVariance(int index) {
    return at(index).contour.misfitVariance();
  }

  @Override
  public double radiusPx(int index) {
    return at(index).radius;
  }

  @Override
  public long events(int index) {
    return at(index).events;
  }

  @Override
  public double mass(int index) {
    return at(index).mass;
  }

  @Override
  public long ageUs(int index) {
    return timeUs - at(index).bornUs;
  }

  @Override
  public boolean overlapped(int index) {
    return at(index).overlapped;
  }

  @Override
  public void feedBack(int index, double xPx, double yPx, double vxPxPerS, double vyPxPerS) {
    Cluster cluster = at(index);
    double radius = cluster.radius;
    boolean inside =
        xPx > -radius && yPx > -radius && xPx < width + radius && yPx < height + radius;
    if (inside && Double.isFinite(vxPxPerS) && Double.isFinite(vyPxPerS)) {
      cluster.x = xPx;
      cluster.y = yPx;
      cluster.vx = vxPxPerS;
      cluster.vy = vyPxPerS;
      ClusterLines.settle(cluster);
      fedBack = true;
    }
  }

  @Override
  public void keepAlive(int index, long untilUs) {
    at(index).keptUntilUs = untilUs;
  }

  @Override
  public void keepApart(int index, int other, long untilUs) {
    merging.keepApart(at(index), at(other), untilUs);
  }
}
