package com.example.imagej;

import com.example.imagej.RecordingStack.Show;
import haltere.core.format.RecordingReader;
import ij.IJ;
import ij.ImagePlus;
import ij.Macro;
import ij.gui.GenericDialog;
import ij.plugin.PlugIn;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;

/** File &gt; Import &gt; Event camera recording: opens a recording as a virtual stack. */
public final class ImportRecording implements PlugIn {
  private static final String TITLE = "Event camera recording";

  @Override
  public void run(String argument) {
    String options = Macro.getOptions() == null ? ask() : Macro.getOptions();
    try {
      if (!options.isEmpty()) {
        double sliceMs = Double.parseDouble(Macro.getValue(options, "slice", "10"));
        String show = Macro.getValue(options, "show", "Signed");
        open(Macro.getValue(options, "recording", ""), sliceMs, show);
      }
    } catch (IOException | RuntimeException problem) {
      IJ.error(TITLE, problem.getMessage());
    }
  }

  /** Asks for the options, in the form of a macro; empty if the dialog was cancelled. */
  private static String ask() {
    GenericDialog dialog = new GenericDialog(TITLE);
    dialog.addFileField("Recording", "", 40);
    dialog.addNumericField("Slice", 10, 3, 8, "ms");
    dialog.addChoice("Show", new String[] {"Signed", "ON", "OFF", "Frames"}, "Signed");
    dialog.showDialog();
    return dialog.wasCanceled()
        ? ""
        : "recording=[%s] slice=%s show=%s "
            .formatted(dialog.getNextString(), dialog.getNextNumber(), dialog.getNextChoice());
  }

  private static void open(String file, double sliceMs, String what) throws IOException {
    RecordingStack.require(sliceMs >= 0.001, "A slice has 0.001 ms or more, not " + sliceMs);
    Show show = Show.valueOf(what.toUpperCase(Locale.ROOT));
    RecordingReader reader = RecordingStack.open(Path.of(file), show);
    try {
      RecordingStack stack = new RecordingStack(reader, Math.round(sliceMs * 1000), show);
      ImagePlus image =
          new ImagePlus(reader.path().getFileName().toString(), stack) {
            @Override
            public void flush() { // called when the image is closed
              super.flush();
              stack.close();
            }
          };
      image.setDimensions(1, 1, stack.getSize());
      image.getCalibration().frameInterval = show == Show.FRAMES ? 0 : sliceMs / 1e3;
      if (show != Show.FRAMES) {
        image.setDisplayRange(show == Show.SIGNED ? -3 : 0, 3); // events of a pixel
      }
      image.show();
    } catch (IOException | RuntimeException problem) {
      reader.close();
      throw problem;
    }
  }
}
