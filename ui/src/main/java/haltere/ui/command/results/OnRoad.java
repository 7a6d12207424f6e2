package haltere.ui.command.results;

import haltere.core.sink.Column;
import haltere.filters.plane.PlanePoint;
import haltere.filters.road.LaneSettings;

/** Where something is on a road: columns that are added to those of the picture. */
record OnRoad(
    @Column(joined = true) PlanePoint point,
    @Column(decimals = 3) double speedKmH,
    @Column(decimals = 3) double sdSpeedKmH,
    int lane) {
  static OnRoad of(PlanePoint point, LaneSettings lanes) {
    return new OnRoad(point, point.speedKmH(), point.sdSpeedKmH(), lanes.laneAt(point.xM()));
  }
}
