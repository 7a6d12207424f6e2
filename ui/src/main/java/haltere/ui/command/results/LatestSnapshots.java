package haltere.ui.command.results;

import haltere.core.chain.FilterChain;
import haltere.core.overlay.OverlayCanvas;
import haltere.core.overlay.OverlayLayer;
import haltere.ui.rendering.ContactSheet;
import java.util.ArrayList;
import java.util.List;

/**
 * Keeps the last snapshot of each overlay of a chain, so that they can be drawn when the run is
 * over.
 *
 * <p>Thread rule: the processing thread.
 */
public final class LatestSnapshots implements ContactSheet.Marks {
  private static final class Latest<T> {
    private final OverlayLayer<T> layer;
    private T snapshot;

    Latest(OverlayLayer<T> layer) {
      this.layer = layer;
      layer.subscribe().apply(taken -> snapshot = taken);
    }

    void drawAt(long timeUs, OverlayCanvas canvas) {
      if (snapshot != null) {
        layer.overlay().drawAt(snapshot, timeUs, canvas);
      }
    }
  }

  private final List<Latest<?>> layers = new ArrayList<>();

  /** Listens to a chain's overlays from now on. */
  public LatestSnapshots(FilterChain chain) {
    for (OverlayLayer<?> layer : chain.overlays()) {
      layers.add(new Latest<>(layer));
    }
  }

  @Override
  public void drawAt(long timeUs, OverlayCanvas canvas) {
    for (Latest<?> layer : layers) {
      layer.drawAt(timeUs, canvas);
    }
  }
}
