package haltere.filters.orientation.camera;

/** Takes what cameras saw of bodies, in order of time. */
public interface ObservationListener {
  /**
   * An observation.
   *
   * @param timeUs microseconds, not before that of the last one
   * @param object name of the body
   * @param line what was seen
   */
  void seen(long timeUs, String object, LineObservation line);

  /**
   * A row that was left out.
   *
   * @param where line or row of the file, for a person
   * @param why what is wrong with it
   */
  void bad(String where, String why);

  /**
   * A statement about the whole file.
   *
   * @param words for a person
   */
  default void remark(String words) {}
}
