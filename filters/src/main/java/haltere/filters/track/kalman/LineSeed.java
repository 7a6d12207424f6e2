package haltere.filters.track.kalman;

/** A piece of a line across the road: a run of events of one row in one step. */
final class LineSeed {
  int row;
  double column;
  boolean on;
  int columns;
  double ageS;
  double xM;
  double halfWidthM;
}
