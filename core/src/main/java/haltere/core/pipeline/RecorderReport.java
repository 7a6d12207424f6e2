package haltere.core.pipeline;

import haltere.core.format.SampleCounts;
import haltere.core.stream.DataLost;
import haltere.core.stream.StreamNotification;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * The report of a {@link Recorder}. Once it has ended, received = written + lost.
 *
 * @param received events before the end of the recording
 * @param written events that are in the file; after a failure, at least these
 * @param lost events that were dropped because the disk did not keep up, or failed
 * @param afterStop events after the end of the recording
 * @param waitingPackets packets that wait for the disk
 * @param samplesLeftOut frames, inertial samples and triggers that the format cannot hold
 * @param samplesLost those that were dropped because the disk did not keep up
 * @param gaps where events are missing, the recorder's own losses and those of its source; the
 *     first hundred
 * @param stoppedBy the jump or the end of stream that ended the recording, if one did
 * @param failure the reason of a failure in one line, if it failed
 * @since 0.1
 */
public record RecorderReport(
    long received,
    long written,
    long lost,
    long afterStop,
    int waitingPackets,
    SampleCounts samplesLeftOut,
    long samplesLost,
    List<DataLost> gaps,
    Optional<StreamNotification> stoppedBy,
    Optional<String> failure) {
  /** Checks that nothing is missing, and copies. */
  public RecorderReport {
    gaps = List.copyOf(gaps);
    Objects.requireNonNull(stoppedBy, "stoppedBy");
    Objects.requireNonNull(failure, "failure");
  }
}
