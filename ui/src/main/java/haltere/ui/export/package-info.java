/** Films: GIF by the Java runtime, MP4 by ffmpeg. */
package haltere.ui.export;
