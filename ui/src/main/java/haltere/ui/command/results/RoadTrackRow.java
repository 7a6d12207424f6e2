package haltere.ui.command.results;

import haltere.core.sink.Column;
import haltere.filters.plane.PlanePoint;
import haltere.filters.road.LaneSettings;
import haltere.filters.track.TrackPoint;

/** A row of the table of tracks where there is a road; units are in the names of the columns. */
public record RoadTrackRow(
    @Column("t_us") long timeUs,
    int id,
    @Column(decimals = 3) double xPx,
    @Column(decimals = 3) double yPx,
    @Column(value = "vx_px_s", decimals = 3) double vxPxS,
    @Column(value = "vy_px_s", decimals = 3) double vyPxS,
    @Column(decimals = 3) double sdXPx,
    @Column(decimals = 3) double sdYPx,
    @Column(value = "sd_vx_px_s", decimals = 3) double sdVxPxS,
    @Column(value = "sd_vy_px_s", decimals = 3) double sdVyPxS,
    long events,
    @Column(decimals = 4) double xM,
    @Column(decimals = 4) double yM,
    @Column(value = "vx_m_s", decimals = 4) double vxMS,
    @Column(value = "vy_m_s", decimals = 4) double vyMS,
    @Column(value = "sd_x_m", decimals = 4) double sdXM,
    @Column(value = "sd_y_m", decimals = 4) double sdYM,
    @Column(value = "sd_vx_m_s", decimals = 4) double sdVxMS,
    @Column(value = "sd_vy_m_s", decimals = 4) double sdVyMS,
    @Column(decimals = 3) double speedKmH,
    @Column(decimals = 3) double sdSpeedKmH,
    int lane) {
  /** A track in the picture and on the road at one time. */
  public static RoadTrackRow of(TrackPoint inPicture, PlanePoint onRoad, LaneSettings lanes) {
    return new RoadTrackRow(
        inPicture.timeUs(),
        inPicture.id(),
        inPicture.xPx(),
        inPicture.yPx(),
        inPicture.vxPxS(),
        inPicture.vyPxS(),
        inPicture.sdXPx(),
        inPicture.sdYPx(),
        inPicture.sdVxPxS(),
        inPicture.sdVyPxS(),
        inPicture.events(),
        onRoad.xM(),
        onRoad.yM(),
        onRoad.vxMS(),
        onRoad.vyMS(),
        onRoad.sdXM(),
        onRoad.sdYM(),
        onRoad.sdVxMS(),
        onRoad.sdVyMS(),
        onRoad.speedKmH(),
        onRoad.sdSpeedKmH(),
        lanes.laneAt(onRoad.xM()));
  }
}
