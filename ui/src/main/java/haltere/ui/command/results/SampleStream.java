package haltere.ui.command.results;

/** Streams beside the events that can be written alone. */
public enum SampleStream {
  /** Inertial samples, as a table. */
  IMU,
  /** Edges and other marks, as a table. */
  TRIGGERS,
  /** Frames, as pictures in a folder. */
  FRAMES
}
