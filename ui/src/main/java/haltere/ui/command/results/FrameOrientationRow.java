package haltere.ui.command.results;

import haltere.core.sink.Column;
import haltere.filters.orientation.OrientationEstimate;

/**
 * A row of what {@code haltere orient} writes of observations that have frames: the columns of
 * {@link OrientationRow}, then the frame and the line in space as Flydra stores it.
 *
 * @param tUs time, microseconds
 * @param object name of the body
 * @param xM position, metres
 * @param yM position, metres
 * @param zM position, metres
 * @param ux axis, tail to head
 * @param uy axis
 * @param uz axis
 * @param sdAxisRad root of the mean squared angle to the true axis, radians
 * @param pRadS rate of roll, radians a second
 * @param qRadS rate of pitch
 * @param rRadS rate of yaw
 * @param used observations used
 * @param rejected observations not used
 * @param frame number of the pictures
 * @param hzLine0 Plücker coordinates, {@link OrientationEstimate#hzLine}
 * @param hzLine1 Plücker coordinates
 * @param hzLine2 Plücker coordinates
 * @param hzLine3 Plücker coordinates
 * @param hzLine4 Plücker coordinates
 * @param hzLine5 Plücker coordinates
 */
record FrameOrientationRow(
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
    int rejected,
    long frame,
    @Column("hz_line0") double hzLine0,
    @Column("hz_line1") double hzLine1,
    @Column("hz_line2") double hzLine2,
    @Column("hz_line3") double hzLine3,
    @Column("hz_line4") double hzLine4,
    @Column("hz_line5") double hzLine5) {
  static FrameOrientationRow of(String object, OrientationEstimate now, long frame) {
    double[] line = now.hzLine();
    return new FrameOrientationRow(
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
        now.rejected(),
        frame,
        line[0],
        line[1],
        line[2],
        line[3],
        line[4],
        line[5]);
  }
}
