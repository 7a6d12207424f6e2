package haltere.filters.track;

/** How the process noise of a track grows. */
public enum ProcessNoise {
  /** White acceleration of a density per second, integrated over each step. */
  DENSITY,
  /** The same variance at each step for each entry of the state, however long the step is. */
  PER_UPDATE
}
