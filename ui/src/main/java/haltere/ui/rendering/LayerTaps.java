package haltere.ui.rendering;

import haltere.core.chain.FilterChain;
import haltere.core.overlay.Overlay;
import haltere.core.overlay.OverlayCanvas;
import haltere.core.overlay.OverlayLayer;
import haltere.core.stream.DataLost;
import haltere.core.stream.StreamNotification;
import java.util.ArrayList;
import java.util.List;

/**
 * Listens to the overlays of the filters that are on, and keeps the newest snapshot of each.
 *
 * <p>Thread rule: the processing thread only.
 */
public final class LayerTaps {
  /** A snapshot of results with what draws it. */
  public record Marks<T>(T snapshot, Overlay<T> overlay) {
    /** Draws it as it is at the time that is shown. */
    public void draw(long timeUs, OverlayCanvas canvas) {
      overlay.drawAt(snapshot, timeUs, canvas);
    }
  }

  private final FilterChain chain;
  private final List<LayerTap<?>> taps = new ArrayList<>();

  /** Taps of the filters of a chain, from now on. */
  public LayerTaps(FilterChain chain) {
    this.chain = chain;
    followChain();
  }

  /** The newest snapshots, of filters that are on now, whoever switched them. */
  public List<Marks<?>> marks() {
    followChain();
    List<Marks<?>> marks = new ArrayList<>(taps.size());
    for (LayerTap<?> tap : taps) {
      Marks<?> latest = tap.latest();
      if (latest != null) {
        marks.add(latest);
      }
    }
    return marks;
  }

  /** Listens to the filters that are on now, so that nothing of what comes next is missed. */
  public void followChain() {
    List<OverlayLayer<?>> layers = chain.overlays();
    taps.removeIf(
        tap -> {
          boolean gone = layers.stream().noneMatch(tap::isOf);
          if (gone) {
            tap.close();
          }
          return gone;
        });
    for (OverlayLayer<?> layer : layers) {
      if (taps.stream().noneMatch(tap -> tap.isOf(layer))) {
        taps.add(new LayerTap<>(layer));
      }
    }
  }

  /** Forgets all snapshots where the stream goes on elsewhere; whether it does. */
  public boolean notified(StreamNotification notification) {
    boolean anew = notification.endsContinuity() && !(notification instanceof DataLost);
    if (anew) {
      taps.forEach(LayerTap::clear);
    }
    return anew;
  }

  /** Ends all subscriptions; the processing thread has ended or calls this. */
  public void close() {
    taps.forEach(LayerTap::close);
    taps.clear();
  }

  /** Keeps the newest snapshot of one layer. */
  private static final class LayerTap<T> {
    private final OverlayLayer<T> layer;
    private final AutoCloseable subscription;
    private T latest;

    LayerTap(OverlayLayer<T> layer) {
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
