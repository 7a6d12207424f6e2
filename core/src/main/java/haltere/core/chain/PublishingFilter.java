package haltere.core.chain;

import haltere.core.overlay.Overlay;
import haltere.core.overlay.OverlayLayer;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;

/**
 * A filter with outlets, each declared in one line:
 *
 * <pre>{@code
 * private final Outlet<Speed> speeds = outlet("speeds", Speed.class);
 * }</pre>
 *
 * <p>Thread rule: as {@link EventFilter}.
 *
 * @param <S> its settings record
 * @since 0.1
 */
public abstract class PublishingFilter<S extends Record> implements ConfigurableFilter<S> {
  private final List<Outlet<?>> outlets = new ArrayList<>();
  private final List<OverlayLayer<?>> overlays = new ArrayList<>();

  /** A filter without an outlet. */
  protected PublishingFilter() {}

  /**
   * Adds an outlet; only during construction.
   *
   * @param name lower case words joined by hyphens, unique within the filter
   * @param type class of the results
   * @param <T> type of the results
   * @return what the filter publishes to
   */
  protected final <T> Outlet<T> outlet(String name, Class<T> type) {
    return add(new Outlet<>(name, type));
  }

  /**
   * Adds an outlet whose results are published out of order; only during construction.
   *
   * @param name unique within the filter
   * @param type class of the results
   * @param order in which a table has them
   * @param <T> type of the results
   * @return the outlet
   */
  protected final <T> Outlet<T> outlet(String name, Class<T> type, ResultOrder<T> order) {
    return add(new Outlet<>(name, type, Optional.of(order)));
  }

  private <T> Outlet<T> add(Outlet<T> made) {
    outlets.add(made);
    return made;
  }

  /**
   * Adds an outlet whose results can be drawn; only during construction.
   *
   * @param name lower case words joined by hyphens, unique within the filter
   * @param type class of the results
   * @param layer name of the layer for users
   * @param overlay draws a result
   * @param <T> type of the results
   * @return what the filter publishes to
   */
  protected final <T> Outlet<T> drawnOutlet(
      String name, Class<T> type, String layer, Overlay<T> overlay) {
    Outlet<T> made = outlet(name, type);
    overlays.add(new OverlayLayer<T>(layer, made::follow, overlay));
    return made;
  }

  @Override
  public final List<Outlet<?>> outlets() {
    return Collections.unmodifiableList(outlets);
  }

  @Override
  public final List<OverlayLayer<?>> overlays() {
    return Collections.unmodifiableList(overlays);
  }
}
