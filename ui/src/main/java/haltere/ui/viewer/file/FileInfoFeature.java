package haltere.ui.viewer.file;

import haltere.core.event.SensorGeometry;
import haltere.ui.viewer.feature.PanelLayout;
import haltere.ui.viewer.feature.WindowFeature;
import haltere.ui.viewer.session.RecordingFacts;
import haltere.ui.viewer.session.SessionRequest;
import haltere.ui.viewer.session.ViewerSession;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * The panel of file information and the banner of warnings. For an unknown camera, the banner asks
 * for it and saves the answer.
 */
public final class FileInfoFeature extends WindowFeature {
  private final FileInfoPanel panel = new FileInfoPanel();
  private final WarningBanner banner = new WarningBanner(this::useSensor);

  @Override
  protected void install() {
    window.addPanel("file-information", PanelLayout.Position.SIDE, () -> panel);
    window.panels().addAbovePicture(banner);
    window.onSession(this::begin);
    window.sessions().factsProperty().subscribe((was, is) -> is.ifPresent(this::show));
  }

  private void begin(ViewerSession made) {
    banner.show(List.of(), Optional.empty());
    banner.show(made.remarks(), Optional.empty());
    panel.say(
        made.request().file().isPresent()
            ? "Reading the file \u2026"
            : "The open source is not a file: " + made.player().playable().name() + ".");
  }

  private void show(RecordingFacts facts) {
    panel.show(facts);
    banner.show(facts.summary().warnings(), facts.assumedSensor());
  }

  private void useSensor(SensorGeometry sensor) {
    Optional<SessionRequest> asked = window.sessions().session().map(ViewerSession::request);
    Optional<Path> file = asked.flatMap(SessionRequest::file);
    if (file.isPresent()) {
      window.sessions().saveSensor(sensor);
      window.sessions().open(file.get(), asked.get().options().withSensor(sensor));
    }
  }
}
