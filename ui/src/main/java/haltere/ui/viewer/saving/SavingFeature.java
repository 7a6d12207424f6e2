package haltere.ui.viewer.saving;

import haltere.ui.viewer.action.ViewerActions;
import haltere.ui.viewer.controls.FileDialogs;
import haltere.ui.viewer.feature.StatusLine;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.feature.ViewerFeature;
import haltere.ui.viewer.picture.Overlays;
import java.nio.file.Path;

/**
 * Saves and loads chains, saves pictures, records. A file that is there is replaced; the file
 * dialog has asked.
 *
 * <p>Thread rule: JavaFX thread only.
 */
public final class SavingFeature implements ViewerFeature {

  private ViewerContext window;
  private Saving saving;
  private RecordingControl recording;

  @Override
  public void install(ViewerContext installed) {
    window = installed;
    StatusLine status = window.status();
    saving = new Saving(window.background(), window.editor(), status::showError);
    recording = new RecordingControl(window.background(), status::showError, status::setActivity);
    // what is open is about to be closed, or is closed with the window
    window.sessions().sessionProperty().subscribe((was, is) -> recording.stop());
    FileDialogs dialogs = window.dialogs();
    ViewerActions actions = window.actions();
    actions.add("load-chain", () -> dialogs.chainToLoad().ifPresent(this::loadChain));
    actions.add(
        "save-chain", () -> dialogs.chainToSave().ifPresent(this::saveChain), this::obstacle);
    actions.add("record", recording.recordingProperty(), this::toggleRecording, this::obstacle);
    actions.add(
        "save-picture", () -> dialogs.picture().ifPresent(this::savePicture), this::obstacle);
    RecordButton button = new RecordButton(this::toggleRecording, window.background());
    recording.recordingProperty().subscribe((was, is) -> button.setOn(is));
    window.panels().transport().addTool(button);
    window.panels().onPulse(() -> button.pulse(recording.file()));
  }

  private String obstacle() {
    return window.sessions().session().isPresent() ? "" : "nothing is open";
  }

  /** Puts a saved chain in place of the one that is open. */
  public void loadChain(Path file) {
    window.loadChain(file, window.editor());
  }

  /** Saves the chain that is open. */
  public void saveChain(Path file) {
    saving.chain(file);
  }

  /** Saves what is shown as a picture. */
  public void savePicture(Path file) {
    Overlays overlays = window.display().overlays();
    window.ifOpen(open -> saving.picture(file, open, overlays));
  }

  /** Stops the recording that is under way, or asks where the next one goes. */
  public void toggleRecording() {
    if (recording.recordingProperty().get()) {
      recording.stop();
    } else if (window.sessions().session().isPresent()) {
      window.dialogs().recordingToWrite().ifPresent(this::record);
    }
  }

  /** Records what comes out of the chain. */
  public void record(Path file) {
    window.ifOpen(open -> recording.start(file, open));
  }

  /** Whether a recording is under way. */
  boolean isRecording() {
    return recording.recordingProperty().get();
  }
}
