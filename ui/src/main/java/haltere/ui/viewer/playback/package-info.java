/** The transport: {@code PlaybackController} asks the player, buttons and the seek bar ask it. */
package haltere.ui.viewer.playback;
