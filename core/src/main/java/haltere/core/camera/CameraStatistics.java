package haltere.core.camera;

/**
 * Counts of received and lost data of a camera since it was opened.
 *
 * @param transfers buffers that came
 * @param bytes bytes in them
 * @param events events handed to the consumer
 * @param lostTransfers buffers that were dropped because too many waited
 * @param lostEvents events in them
 * @param brokenTransfers transfers that ended with an error; what they would have held is not known
 * @param oddWords words without a meaning, pieces of words, and times that cannot be true
 * @param waiting filled buffers that wait for the consumer now
 * @param mostWaiting the most that ever waited
 * @param streams streams that were begun: more than one after the camera was plugged in again
 * @param medianLatencyUs half of the latest buffers were with the consumer within so many
 *     microseconds of their arrival, until it was done with them; 0 before the first
 * @param latency999Us the same for 999 of 1,000
 * @param longestLatencyUs the longest ever
 * @since 0.1
 */
public record CameraStatistics(
    long transfers,
    long bytes,
    long events,
    long lostTransfers,
    long lostEvents,
    long brokenTransfers,
    long oddWords,
    int waiting,
    int mostWaiting,
    long streams,
    long medianLatencyUs,
    long latency999Us,
    long longestLatencyUs) {
  /** Before anything came. */
  public static final CameraStatistics NONE =
      new CameraStatistics(0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
}
