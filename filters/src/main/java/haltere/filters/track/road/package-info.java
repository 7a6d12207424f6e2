/**
 * What the events of a road show before anybody follows a vehicle: {@link
 * haltere.filters.track.road.RoadEvents} gives each its place on the road, {@link
 * haltere.filters.track.road.LineSeeds} are pieces of lines across it, and {@link
 * haltere.filters.track.road.LineSearch} finds how such a line has moved; with how lines of one
 * vehicle lie in space, and how large vehicles are. Nothing here knows of tracks.
 */
package haltere.filters.track.road;
