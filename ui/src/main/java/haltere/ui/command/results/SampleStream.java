package haltere.ui.command.results;

/** Kinds of samples that can be exported alone. */
public enum SampleStream {
  /** Inertial samples, as a table. */
  IMU,
  /** Edges and other marks, as a table. */
  TRIGGERS,
  /** Frames, as pictures in a folder. */
  FRAMES
}
