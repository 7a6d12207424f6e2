package haltere.core.format.summary;

/**
 * An interval of a recording in which events are missing, or probably missing because the whole
 * sensor was silent.
 *
 * @param fromUs time of the last event before it, or {@link
 *     haltere.core.stream.StreamNotification#NO_TIME_US}
 * @param toUs time of the first event after it, or {@link
 *     haltere.core.stream.StreamNotification#NO_TIME_US}
 * @param reported whether the source itself reports the loss
 * @since 0.1
 */
public record Gap(long fromUs, long toUs, boolean reported) {}
