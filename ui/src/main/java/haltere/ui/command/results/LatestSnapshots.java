package haltere.ui.command.results;

import haltere.core.chain.FilterChain;
import haltere.core.overlay.OverlayCanvas;
import haltere.core.overlay.OverlayLayer;
import haltere.ui.rendering.ContactSheet;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;

/**
 * Keeps the last snapshot of each overlay of a chain, so that they can be drawn when the run is
 * over.
 *
 * <p>Thread rule: the processing thread.
 */
public final class LatestSnapshots implements ContactSheet.Marks {
  private final List<ContactSheet.Marks> layers = new ArrayList<>();

  /** Listens to a chain's overlays from now on. */
  public LatestSnapshots(FilterChain chain) {
    chain.overlays().forEach(layer -> layers.add(latest(layer)));
  }

  private static <T> ContactSheet.Marks latest(OverlayLayer<T> layer) {
    AtomicReference<T> last = new AtomicReference<>();
    layer.subscribe().apply(last::set);
    return (timeUs, canvas) -> {
      if (last.get() != null) {
        layer.overlay().drawAt(last.get(), timeUs, canvas);
      }
    };
  }

  @Override
  public void drawAt(long timeUs, OverlayCanvas canvas) {
    layers.forEach(layer -> layer.drawAt(timeUs, canvas));
  }
}
