package haltere.core.overlay;

import java.util.Objects;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * A layer over the picture: the source of its snapshots, and the overlay that draws one.
 *
 * @param name of the layer for users
 * @param subscribe registers a consumer of snapshots and returns the subscription
 * @param overlay draws a snapshot
 * @param <T> type of the snapshots
 * @since 0.1
 */
public record OverlayLayer<T>(
    String name, Function<Consumer<? super T>, AutoCloseable> subscribe, Overlay<T> overlay) {
  /** Checks that nothing is missing. */
  public OverlayLayer {
    Objects.requireNonNull(name, "name");
    Objects.requireNonNull(subscribe, "subscribe");
    Objects.requireNonNull(overlay, "overlay");
  }
}
