package haltere.filters.track.road;

/**
 * A piece of a line across the road: a run of events of one row in one step. Thread rule: that of
 * its {@link LineSeeds}.
 */
public final class LineSeed {
  int row;
  double column;
  boolean on;
  int columns;
  double ageS;
  double xM;
  double halfWidthM;

  LineSeed() {}
}
