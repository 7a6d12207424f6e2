package haltere.ui.viewer;

import haltere.core.chain.FilterChain;
import haltere.core.chain.Outlet;
import haltere.core.playback.Slicing;
import haltere.filters.wing.WingBeat;
import haltere.ui.viewer.feature.WindowFeature;

/**
 * Slices of one wing beat: their length follows the beats of a wing tracker in the chain; 5 ms
 * until it has found some.
 */
final class BeatExposure extends WindowFeature {
  private static final double MAX_DEVIATION = 0.003;
  private static final long BETWEEN_NANOS = 200_000_000;

  private Outlet.Subscription subscription = () -> {};

  /** Written on the processing thread. */
  private volatile double periodUs = Double.NaN;

  @Override
  protected void install() {
    window.editor().onChange(this::follow);
    window.playback().beatsProperty().subscribe((was, is) -> follow());
    window.panels().every(BETWEEN_NANOS, this::pulse);
    window.actions().add("slices-beat", window.playback().beatsProperty());
  }

  private void follow() {
    if (window.playback().beatsProperty().get()) {
      window.read(this::subscribe, this::say);
    }
  }

  private void say(boolean found) {
    if (!found) {
      String advice = "One wing beat: add a wing tracker to the chain; until then it lasts 5 ms.";
      window.status().setActivity(advice);
    }
  }

  /** On the processing thread. */
  private boolean subscribe(FilterChain chain) {
    subscription.close();
    subscription = () -> {};
    for (Outlet<?> outlet : chain.outlets()) {
      if (outlet.type() == WingBeat.class) {
        subscription = outlet.subscribe(beat -> periodUs = ((WingBeat) beat).periodUs());
        return true;
      }
    }
    return false;
  }

  private void pulse() {
    double wanted = periodUs;
    if (wanted >= 1
        && window.playback().beatsProperty().get()
        && window.playback().slicingProperty().get() instanceof Slicing.ByTime now
        && Math.abs(now.sliceUs() - wanted) > MAX_DEVIATION * wanted) {
      window.playback().setBeat(Math.round(wanted));
    }
  }
}
