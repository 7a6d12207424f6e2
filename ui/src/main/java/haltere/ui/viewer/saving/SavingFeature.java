package haltere.ui.viewer.saving;

import haltere.core.chain.ChainFile;
import haltere.ui.rendering.Pictures;
import haltere.ui.viewer.action.ViewerActions;
import haltere.ui.viewer.controls.FileDialogs;
import haltere.ui.viewer.feature.PlaybackOutput;
import haltere.ui.viewer.feature.WindowFeature;
import haltere.ui.viewer.picture.Overlays;
import java.nio.file.Path;

/**
 * Saves and loads chains, saves pictures, records. Existing files are replaced after confirmation
 * in the file dialog.
 */
public final class SavingFeature extends WindowFeature {
  private PlaybackOutput<RecordedFile> recording;

  @Override
  protected void install() {
    recording = new PlaybackOutput<>(window);
    FileDialogs dialogs = window.dialogs();
    ViewerActions actions = window.actions();
    actions.add(
        "load-chain",
        () -> dialogs.open("Load chain", "Chains", "*.json").ifPresent(this::loadChain));
    actions.add(
        "save-chain",
        () ->
            dialogs.save("Save chain", "chain.json", "Chains", "*.json").ifPresent(this::saveChain),
        window::nothingOpen);
    actions.add("record", recording.runningProperty(), this::toggleRecording, window::nothingOpen);
    actions.add(
        "save-picture", () -> dialogs.picture().ifPresent(this::savePicture), window::nothingOpen);
    RecordButton button = new RecordButton(this::toggleRecording, window.background());
    recording.runningProperty().subscribe((was, is) -> button.setOn(is));
    window.panels().transport().addTool(button);
    window
        .panels()
        .every(
            RecordButton.NUMBERS_NANOS,
            () -> button.pulse(recording.output().map(RecordedFile::file)));
  }

  /** Replaces the open chain by a saved one. */
  public void loadChain(Path file) {
    window.loadChain(file, window.editor());
  }

  /** Saves the chain that is open. */
  public void saveChain(Path file) {
    window.read(ChainFile::write, json -> window.save(file, json));
  }

  /** Saves the shown picture. */
  public void savePicture(Path file) {
    Overlays overlays = window.display().overlays();
    window.ifOpen(
        open ->
            window.read(
                chain -> open.display().picture(overlays),
                image -> window.save(file, () -> Pictures.write(file, image))));
  }

  /** Stops the running recording, or asks for the file of the next one. */
  public void toggleRecording() {
    recording.toggle(
        () ->
            window
                .dialogs()
                .save("Record to", "recording.aedat4", "AEDAT-4", "*.aedat4")
                .ifPresent(this::record));
  }

  /** Records the events that the chain passes. */
  public void record(Path file) {
    record(open -> RecordedFile.of(file, open));
  }

  void record(PlaybackOutput.Factory<RecordedFile> factory) {
    recording.start(factory);
  }
}
