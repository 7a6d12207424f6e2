/**
 * Pacing a recording or a scene: slices by time or count, speed, pause, steps, seeking, loops and
 * marks.
 */
package haltere.core.playback;
