package haltere.ui.command.results;

import haltere.core.sink.Column;
import haltere.filters.object.ObjectTrack;
import haltere.filters.plane.PlanePoint;
import haltere.filters.road.LaneSettings;
import haltere.filters.track.TrackPoint;

/**
 * Columns of an object on a road, added to those of the picture.
 *
 * @param point position and velocity on the road
 * @param speedKmH its speed, km/h
 * @param sdSpeedKmH standard deviation of the speed, km/h
 * @param lane number of its lane, as {@link LaneSettings#laneAt}
 */
public record RoadColumns(
    @Column(joined = true) PlanePoint point,
    @Column(decimals = 3) double speedKmH,
    @Column(decimals = 3) double sdSpeedKmH,
    int lane) {
  /** A row of the table of objects on a road; newer columns are at the end. */
  public record OfObject(
      @Column(joined = true) ObjectTrack inPicture,
      @Column(joined = true) RoadColumns onRoad,
      @Column(decimals = 1) double eventRateHz,
      @Column(decimals = 3) double ageS,
      @Column(decimals = 3) double lowYPx) {
    /** An object in the picture and on the road at one time. */
    public OfObject(ObjectTrack object, RoadColumns onRoad) {
      this(object, onRoad, object.eventRateHz(), object.ageS(), object.lowYPx());
    }
  }

  /** A row of the table of tracks on a road. */
  public record OfTrack(
      @Column(joined = true) TrackPoint inPicture, @Column(joined = true) RoadColumns onRoad) {}

  /** The position of a point on a road with lanes. */
  public static RoadColumns of(PlanePoint point, LaneSettings lanes) {
    return new RoadColumns(point, point.speedKmH(), point.sdSpeedKmH(), lanes.laneAt(point.xM()));
  }
}
