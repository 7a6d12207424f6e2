package haltere.ui.command.results;

import haltere.core.sink.Column;
import haltere.filters.object.ObjectTrack;
import haltere.filters.plane.PlanePoint;
import haltere.filters.road.LaneSettings;

/** A row of the table of objects where there is a road; units are in the names of the columns. */
public record RoadObjectRow(
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
    @Column(decimals = 3) double majorPx,
    @Column(decimals = 3) double minorPx,
    @Column(decimals = 4) double angleRad,
    @Column(decimals = 4) double existence,
    @Column(joined = true) OnRoad onRoad) {
  /** An object in the picture and on the road at one time. */
  public static RoadObjectRow of(ObjectTrack track, PlanePoint onRoad, LaneSettings lanes) {
    return new RoadObjectRow(
        track.timeUs(),
        track.id(),
        track.xPx(),
        track.yPx(),
        track.vxPxS(),
        track.vyPxS(),
        track.sdXPx(),
        track.sdYPx(),
        track.sdVxPxS(),
        track.sdVyPxS(),
        track.events(),
        track.majorPx(),
        track.minorPx(),
        track.angleRad(),
        track.existence(),
        OnRoad.of(onRoad, lanes));
  }
}
