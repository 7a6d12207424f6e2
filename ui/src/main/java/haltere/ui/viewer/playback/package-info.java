/** Playback: {@code PlaybackController} controls the player; buttons and the seek bar use it. */
package haltere.ui.viewer.playback;
