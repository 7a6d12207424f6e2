package haltere.ui.command.results;

import haltere.filters.orientation.OrientationEstimate;

/**
 * A row of {@code haltere orient}; column names have the units. The axis (ux, uy, uz) points from
 * tail to head; p, q and r are the rates of roll, pitch and yaw.
 *
 * @param sdAxisRad root of the mean squared angle to the true axis
 * @param used observations used
 * @param rejected observations not used
 */
public record OrientationRow(
    long tUs,
    String object,
    double xM,
    double yM,
    double zM,
    double ux,
    double uy,
    double uz,
    double sdAxisRad,
    double pRadS,
    double qRadS,
    double rRadS,
    int used,
    int rejected) {
  /** The row of a body's estimate. */
  public static OrientationRow of(String object, OrientationEstimate now) {
    return new OrientationRow(
        now.timeUs(),
        object,
        now.xM(),
        now.yM(),
        now.zM(),
        now.ux(),
        now.uy(),
        now.uz(),
        now.sdAxisRad(),
        now.pRadS(),
        now.qRadS(),
        now.rRadS(),
        now.used(),
        now.rejected());
  }
}
