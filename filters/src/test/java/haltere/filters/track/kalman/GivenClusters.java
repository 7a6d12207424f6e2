package haltere.filters.track.kalman;

import haltere.filters.cluster.ClusterReadings;
import java.util.ArrayList;
import java.util.List;

/** Clusters that a test puts where it wants them, for a {@link TrackEstimator} to read. */
final class GivenClusters implements ClusterReadings {
  /** One cluster and what it has measured. */
  static final class Given {
    final int id;
    double x;
    double y;
    double vx;
    double vy;
    double newEvents = 20;
    double ageUs = 5000;
    double variance = 4;

    /** How many times the variance across it is that up and down. */
    double upright = 1;

    double radius = 12;
    boolean overlapped;

    /** Information on the middle of an outline, which is that far to the right of the mean. */
    double outline;

    double outlineAheadX;

    /** How many times the information on its column that on its row is. */
    double outlineUpright = 1;

    /** Variance of the middle of the thing about that of the outline. */
    double misfit;

    /** Direction of a line that goes on beyond the cluster, or 0. */
    double lineX;

    double lineY;
    double fedX = Double.NaN;
    double fedY = Double.NaN;
    double fedVx = Double.NaN;
    double fedVy = Double.NaN;
    long keptApartUntilUs = Long.MIN_VALUE;

    Given(int id) {
      this.id = id;
    }

    Given at(double newX, double newY) {
      x = newX;
      y = newY;
      return this;
    }
  }

  final List<Given> list = new ArrayList<>();

  Given add(int id) {
    Given given = new Given(id);
    list.add(given);
    return given;
  }

  @Override
  public int count() {
    return list.size();
  }

  @Override
  public int id(int index) {
    return list.get(index).id;
  }

  @Override
  public double x(int index) {
    return list.get(index).x;
  }

  @Override
  public double y(int index) {
    return list.get(index).y;
  }

  @Override
  public double vx(int index) {
    return list.get(index).vx;
  }

  @Override
  public double vy(int index) {
    return list.get(index).vy;
  }

  @Override
  public double newEvents(int index) {
    return list.get(index).newEvents;
  }

  @Override
  public double contestedEvents(int index) {
    return list.get(index).overlapped ? list.get(index).newEvents : 0;
  }

  @Override
  public double measuredX(int index) {
    return list.get(index).x;
  }

  @Override
  public double measuredY(int index) {
    return list.get(index).y;
  }

  @Override
  public double measuredAgeUs(int index) {
    return list.get(index).ageUs;
  }

  @Override
  public double eventVarianceX(int index) {
    return list.get(index).variance;
  }

  @Override
  public double eventVarianceY(int index) {
    return list.get(index).upright * list.get(index).variance;
  }

  @Override
  public double eventCovarianceXy(int index) {
    return 0;
  }

  @Override
  public double unseenVariance(int index) {
    return 0;
  }

  @Override
  public double outlineMisfitVariance(int index) {
    return list.get(index).misfit;
  }

  @Override
  public double lineX(int index) {
    return list.get(index).lineX;
  }

  @Override
  public double lineY(int index) {
    return list.get(index).lineY;
  }

  @Override
  public double outlineXx(int index) {
    return list.get(index).outline;
  }

  @Override
  public double outlineXy(int index) {
    return 0;
  }

  @Override
  public double outlineYy(int index) {
    return list.get(index).outlineUpright * list.get(index).outline;
  }

  @Override
  public double outlineX(int index) {
    return list.get(index).outline * (list.get(index).x + list.get(index).outlineAheadX);
  }

  @Override
  public double outlineY(int index) {
    return outlineYy(index) * list.get(index).y;
  }

  @Override
  public double radiusPx(int index) {
    return list.get(index).radius;
  }

  @Override
  public long events(int index) {
    return 1;
  }

  @Override
  public double mass(int index) {
    return 1;
  }

  @Override
  public long ageUs(int index) {
    return 0;
  }

  @Override
  public boolean overlapped(int index) {
    return list.get(index).overlapped;
  }

  @Override
  public void feedBack(int index, double xPx, double yPx, double vxPxPerS, double vyPxPerS) {
    Given given = list.get(index);
    given.fedX = xPx;
    given.fedY = yPx;
    given.fedVx = vxPxPerS;
    given.fedVy = vyPxPerS;
  }

  @Override
  public void keepAlive(int index, long untilUs) {
    // the test keeps them alive
  }

  @Override
  public void keepApart(int index, int other, long untilUs) {
    list.get(index).keptApartUntilUs = untilUs;
    list.get(other).keptApartUntilUs = untilUs;
  }
}
