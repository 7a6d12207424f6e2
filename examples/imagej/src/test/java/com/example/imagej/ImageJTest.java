package com.example.imagej;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import ij.IJ;
import ij.ImagePlus;
import ij.Macro;
import ij.Menus;
import ij.WindowManager;
import ij.gui.Roi;
import ij.macro.Interpreter;
import ij.measure.ResultsTable;
import ij.process.ImageProcessor;
import java.awt.HeadlessException;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * The commands in ImageJ without a display: they and Haltere are loaded from ImageJ's folder of
 * plugins, with the loader that ImageJ has for it.
 */
class ImageJTest {
  private static final Path BOX = Path.of(System.getProperty("box"));
  private static final Path SIMULATED = Path.of(System.getProperty("simulated"));
  private static final long BOX_ON = 26_806;
  private static final long BOX_OFF = 29_194;
  private static final long BOX_US = 951_943_803 - 946_459_683;

  @TempDir Path folder;

  /**
   * ImageJ learns commands when it makes its menus, for which it needs a display; this needs none.
   */
  @BeforeAll
  @SuppressWarnings("unchecked")
  static void learnCommands() throws IOException {
    try {
      IJ.run("About ImageJ...", "");
    } catch (HeadlessException withoutDisplay) {
      assertNotNull(Menus.getCommands());
    }
    try (InputStream config = IJ.getClassLoader().getResourceAsStream("plugins.config")) {
      String lines = new String(config.readAllBytes(), StandardCharsets.UTF_8);
      Matcher line = Pattern.compile("(?m)^[^#\n]+, \"(.+)\", (.+)$").matcher(lines);
      while (line.find()) {
        Menus.getCommands().put(line.group(1), line.group(2));
      }
    }
    assertTrue(Menus.getCommands().containsKey("Track wings..."));
  }

  @BeforeEach
  void withoutWindows() {
    Interpreter.batchMode = true;
  }

  @AfterEach
  void closeImages() {
    while (WindowManager.getCurrentImage() != null) {
      WindowManager.getCurrentImage().close();
    }
    Interpreter.batchMode = false;
  }

  private static ImagePlus open(Path recording, String options) {
    IJ.run("Event camera recording...", "recording=[" + recording + "] " + options);
    return WindowManager.getCurrentImage();
  }

  private static double sum(ImagePlus image) {
    double sum = 0;
    for (int slice = 1; slice <= image.getStackSize(); slice++) {
      ImageProcessor picture = image.getStack().getProcessor(slice);
      for (int i = 0; i < picture.getPixelCount(); i++) {
        sum += picture.getf(i);
      }
    }
    return sum;
  }

  @Test
  void recordingOpensAsAStackOfAllItsEvents() {
    ImagePlus signed = open(BOX, "slice=10 show=Signed");
    assertEquals(128, signed.getWidth());
    assertEquals(128, signed.getHeight());
    assertEquals(BOX_US / 10_000 + 1, signed.getNFrames());
    assertEquals(0.01, signed.getCalibration().frameInterval);
    assertTrue(signed.getStack().isVirtual());
    assertEquals(BOX_ON - BOX_OFF, sum(signed));
    assertEquals(BOX_ON, sum(open(BOX, "slice=1000 show=ON")));
    assertEquals(BOX_OFF, sum(open(BOX, "slice=33.3 show=OFF")));
  }

  @Test
  void slicesAreReadInAnyOrderWithRowsFromTheTop() {
    ImagePlus image = open(BOX, "slice=10 show=ON");
    float[] last = (float[]) image.getStack().getPixels(image.getStackSize());
    ImageProcessor first = image.getStack().getProcessor(1);
    assertEquals(1, first.getf(115, 127 - 19), "the first event of the recording");
    assertEquals(1, first.getf(65, 127 - 52), "the second one");
    assertTrue(Arrays.equals(last, (float[]) image.getStack().getPixels(image.getStackSize())));
  }

  @Test
  void framesOpenAsSlices() {
    ImagePlus image = open(SIMULATED.resolve("frames.aedat4"), "show=Frames");
    assertEquals(5, image.getStackSize());
    for (int slice = 5; slice >= 1; slice--) {
      ImageProcessor picture = image.getStack().getProcessor(slice);
      assertEquals(250, picture.getf(0, 0));
      assertEquals(10 * (slice - 1), picture.getf(3, 2));
    }
  }

  @Test
  void trackedObjectsFillResultsTableAndOverlay() throws IOException {
    Path recording = Files.copy(BOX, folder.resolve("box.aedat"));
    String macro = Files.readString(Path.of("track.ijm"));
    IJ.runMacro(macro, recording.toString());
    ResultsTable table = ResultsTable.open(recording + ".objects.csv");
    assertTrue(table.size() > 100, table.size() + " rows");
    assertEquals(1, table.getValue("id", 0));

    Interpreter.batchMode = true;
    ImagePlus image = open(recording, "slice=100");
    IJ.run(image, "Track objects...", "rate=100");
    ResultsTable shown = ResultsTable.getResultsTable();
    assertEquals(table.size(), shown.size());
    long firstUs = 946_459_683;
    for (int row = 0; row < shown.size(); row++) {
      double slice = 1 + Math.floor((shown.getValue("t_us", row) - firstUs) / 100_000);
      assertEquals(slice, shown.getValue("Slice", row));
    }
    boolean[] isMarked = new boolean[image.getStackSize() + 1];
    for (Roi mark : image.getOverlay()) {
      isMarked[mark.getPosition()] = true;
      assertTrue(mark.getStrokeColor() != null);
    }
    int slice = (int) shown.getValue("Slice", shown.size() / 2);
    assertTrue(isMarked[slice], "no mark in slice " + slice);
  }

  @Test
  void trackedWingsFillResultsTableAndOverlay() {
    ImagePlus image = open(SIMULATED.resolve("fly.aedat"), "slice=5");
    IJ.run(image, "Track wings...", "rate=500");
    ResultsTable table = ResultsTable.getResultsTable();
    double[] frequenciesHz = table.getColumn("frequency_hz");
    Arrays.sort(frequenciesHz);
    assertEquals(200, frequenciesHz[frequenciesHz.length / 2], 4);
    assertTrue(table.size() > 2000, table.size() + " rows");
    String edges = String.join(" ", table.getColumnAsStrings("edge"));
    assertTrue(edges.contains("left") && edges.contains("right"), edges);
    assertTrue(image.getOverlay().size() > image.getStackSize());
  }

  @Test
  void errorsAreReported() {
    assertTrue(printed(() -> open(folder.resolve("none.aedat"), "")).contains("none.aedat"));
    assertTrue(printed(() -> open(BOX, "slice=0")).contains("0.001 ms"));
    assertTrue(printed(() -> open(BOX, "show=Frames")).contains("nothing of that"));
    assertTrue(printed(() -> IJ.run("Track objects...", "rate=100")).contains("Import a"));
    assertTrue(WindowManager.getCurrentImage() == null);
    open(BOX, "");
    assertTrue(printed(() -> IJ.run("Track objects...", "rate=-1")).contains("reportRateHz"));
  }

  private static String printed(Runnable action) {
    PrintStream before = System.out;
    ByteArrayOutputStream printed = new ByteArrayOutputStream();
    System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
    try {
      action.run();
    } catch (RuntimeException canceled) {
      assertEquals(Macro.MACRO_CANCELED, canceled.getMessage());
    } finally {
      System.setOut(before);
    }
    return printed.toString(StandardCharsets.UTF_8);
  }
}
