package haltere.core.pipeline;

import haltere.core.event.EventPacket;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.util.function.Consumer;

/**
 * Ends a job whose results cannot be written: stores the exception of a subscriber, and throws it
 * after the chain has processed the packet.
 *
 * <p>Thread rule: the processing thread.
 *
 * @since 0.1
 */
final class ResultFailure implements Consumer<RuntimeException>, StreamHandler {
  private RuntimeException first;

  @Override
  public void accept(RuntimeException thrown) {
    first = first == null ? thrown : first;
  }

  /** Throws the first failure, if there was one. */
  void rethrow() {
    if (first != null) {
      throw first;
    }
  }

  @Override
  public void packet(EventPacket packet) {
    rethrow();
  }

  @Override
  public void notified(StreamNotification notification) {
    rethrow();
  }
}
