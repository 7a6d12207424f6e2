package haltere.core.format.summary;

/**
 * A stretch of a recording in which events are missing, or in which a whole sensor was silent for
 * so long that they probably are.
 *
 * @param fromUs time of the last event before it, or {@link
 *     haltere.core.stream.StreamNotification#NO_TIME_US}
 * @param toUs time of the first event after it, or {@link
 *     haltere.core.stream.StreamNotification#NO_TIME_US}
 * @param told whether the source itself says that data were lost there
 */
public record Gap(long fromUs, long toUs, boolean told) {}
