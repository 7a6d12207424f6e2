package haltere.ui.command.results;

import haltere.core.sink.Column;
import haltere.filters.plane.PlanePoint;
import haltere.filters.road.LaneSettings;
import haltere.filters.track.TrackPoint;

/** A row of the table of tracks where there is a road; units are in the names of the columns. */
public record RoadTrackRow(
    @Column(joined = true) TrackPoint inPicture, @Column(joined = true) OnRoad onRoad) {
  /** A track in the picture and on the road at one time. */
  public static RoadTrackRow of(TrackPoint inPicture, PlanePoint onRoad, LaneSettings lanes) {
    return new RoadTrackRow(inPicture, OnRoad.of(onRoad, lanes));
  }
}
