package haltere.ui.rendering;

import haltere.core.chain.FilterChain;
import haltere.core.overlay.Overlay;
import haltere.core.overlay.OverlayCanvas;
import haltere.core.overlay.OverlayLayer;
import haltere.core.stream.StreamNotification;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * Subscribes to the overlays of enabled filters and keeps the newest snapshot of each.
 *
 * <p>Thread rule: the processing thread only.
 */
public final class OverlaySnapshots {
  /** A snapshot of results with its overlay. */
  public record Marks<T>(T snapshot, Overlay<T> overlay) {
    /** Draws it at the displayed time. */
    public void draw(long timeUs, OverlayCanvas canvas) {
      overlay.drawAt(snapshot, timeUs, canvas);
    }
  }

  private final FilterChain chain;
  private final List<LayerSnapshot<?>> snapshots = new ArrayList<>();

  /** Subscribes to the filters of a chain. */
  public OverlaySnapshots(FilterChain chain) {
    this.chain = chain;
    followChain();
  }

  /** The newest snapshots of enabled filters. */
  public List<Marks<?>> marks() {
    followChain();
    return snapshots.stream()
        .<Marks<?>>map(LayerSnapshot::latest)
        .filter(Objects::nonNull)
        .toList();
  }

  /** Subscribes to the filters that are enabled now. */
  public void followChain() {
    List<OverlayLayer<?>> layers = chain.overlays();
    snapshots.removeIf(
        each -> {
          boolean gone = layers.stream().noneMatch(each::isOf);
          if (gone) {
            each.close();
          }
          return gone;
        });
    for (OverlayLayer<?> layer : layers) {
      if (snapshots.stream().noneMatch(each -> each.isOf(layer))) {
        snapshots.add(new LayerSnapshot<>(layer));
      }
    }
  }

  /** Removes all snapshots if the notification restarts time. */
  public void notified(StreamNotification notification) {
    if (notification.restartsTime()) {
      snapshots.forEach(LayerSnapshot::clear);
    }
  }

  /** Ends all subscriptions; the processing thread has ended or calls this. */
  public void close() {
    snapshots.forEach(LayerSnapshot::close);
    snapshots.clear();
  }

  /** Keeps the newest snapshot of one layer. */
  private static final class LayerSnapshot<T> {
    private final OverlayLayer<T> layer;
    private final AutoCloseable subscription;
    private T latest;

    LayerSnapshot(OverlayLayer<T> layer) {
      this.layer = layer;
      this.subscription = layer.subscribe().apply(snapshot -> latest = snapshot);
    }

    boolean isOf(OverlayLayer<?> other) {
      return layer == other;
    }

    void clear() {
      latest = null;
    }

    Marks<T> latest() {
      return latest == null ? null : new Marks<>(latest, layer.overlay());
    }

    void close() {
      try {
        subscription.close();
      } catch (Exception broken) {
        throw new IllegalStateException("layer " + layer.name() + " cannot be left", broken);
      }
    }
  }
}
