/**
 * How object trackers are judged: recordings with labelled boxes, composites of them, simulated
 * scenes of other looks, and the scores.
 */
package haltere.testing.objects;
