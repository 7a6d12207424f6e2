package haltere.core.stream;

/**
 * The last notification of every stream: publish what is still buffered.
 *
 * @param lastUs time of the last event, or {@link StreamNotification#NO_TIME_US} if there was none
 * @since 0.1
 */
public record EndOfStream(long lastUs) implements StreamNotification {
  @Override
  public boolean endsContinuity() {
    return false;
  }
}
