/** Where the road vanishes, which tells the tracks of vehicles how far away they are. */
package haltere.ui.viewer.road;
