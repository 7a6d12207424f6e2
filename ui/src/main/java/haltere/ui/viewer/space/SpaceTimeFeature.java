package haltere.ui.viewer.space;

import haltere.ui.viewer.controls.Icons;
import haltere.ui.viewer.feature.PanelLayout;
import haltere.ui.viewer.feature.ViewBar;
import haltere.ui.viewer.feature.WindowFeature;
import haltere.ui.viewer.session.ViewerSession;
import java.util.Optional;
import javafx.beans.property.BooleanProperty;

/**
 * The view of events in space and time, beside the picture. Events are accumulated only while it is
 * shown.
 */
public final class SpaceTimeFeature extends WindowFeature {
  private SpaceTimePanel panel;
  private BooleanProperty shown;
  private Optional<SpaceTimeSink> sink = Optional.empty();

  @Override
  protected void install() {
    panel = new SpaceTimePanel(window.display().marksProperty());
    shown = window.addPanel("space-time", PanelLayout.Position.BESIDE, () -> panel);
    ViewBar bar = window.panels().viewBar();
    bar.tool("tool-space-time", Icons.CUBE, "Events in space and time (Ctrl+T)", shown);
    shown.subscribe((was, is) -> follow(window.sessions().session()));
    window
        .sessions()
        .onChange(
            (was, is) -> {
              was.ifPresent(this::leave);
              follow(is);
            });
    panel.onSpan(this::setSpan);
    window.display().coloursProperty().subscribe(panel::setColours);
    window.panels().onPulse(() -> sink.ifPresent(open -> panel.update(open.exchange().fetch())));
  }

  private void setSpan(double spanUs) {
    sink.ifPresent(open -> open.setSpan((long) spanUs));
    window.ifOpen(open -> open.player().refresh());
  }

  private void follow(Optional<ViewerSession> session) {
    session.ifPresent(this::leave);
    if (shown.get() && session.isPresent()) {
      SpaceTimeSink made = new SpaceTimeSink(session.get().chain());
      made.setSpan(panel.view().spanUs());
      panel.setSensor(session.get().player().playable().geometry());
      session.get().player().addSink(made);
      sink = Optional.of(made);
    }
  }

  private void leave(ViewerSession session) {
    sink.ifPresent(
        left -> session.player().removeSink(left).whenComplete((done, closed) -> left.close()));
    sink = Optional.empty();
  }
}
