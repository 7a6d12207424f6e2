package haltere.core.camera;

/**
 * Counts of received and lost data of a camera since it was opened.
 *
 * @param transfers received buffers
 * @param bytes bytes in them
 * @param events events passed to the consumer
 * @param lostTransfers buffers that were dropped because too many waited
 * @param lostEvents events in them
 * @param brokenTransfers losses of unknown size: transfers that ended with an error, or pauses of a
 *     simulated scene that is slower than its clock
 * @param unknownWords invalid words, incomplete words and impossible times
 * @param waiting filled buffers waiting for the consumer
 * @param maxWaiting largest number of waiting buffers
 * @param streams started streams: more than one after reconnection
 * @param medianLatencyUs median time from arrival to the end of processing of the latest buffers,
 *     microseconds; 0 before the first
 * @param latency999Us 99.9 % quantile of the same
 * @param maxLatencyUs the longest since opening
 * @since 0.1
 */
public record CameraStatistics(
    long transfers,
    long bytes,
    long events,
    long lostTransfers,
    long lostEvents,
    long brokenTransfers,
    long unknownWords,
    int waiting,
    int maxWaiting,
    long streams,
    long medianLatencyUs,
    long latency999Us,
    long maxLatencyUs) {
  /** Counts before the first data. */
  public static final CameraStatistics NONE =
      new CameraStatistics(0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
}
