package haltere.ui.command.results;

import haltere.core.sink.Column;
import haltere.filters.orientation.OrientationEstimate;

/**
 * A row of {@code haltere orient} for observations with frames: the columns of {@link
 * OrientationRow}, the frame, and the line in space as stored by Flydra.
 *
 * @param row position and axis
 * @param frame number of the pictures
 * @param hzLine0 Plücker coordinates, {@link OrientationEstimate#hzLine}, as the next ones
 */
record FrameOrientationRow(
    @Column(joined = true) OrientationRow row,
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
        OrientationRow.of(object, now),
        frame,
        line[0],
        line[1],
        line[2],
        line[3],
        line[4],
        line[5]);
  }
}
