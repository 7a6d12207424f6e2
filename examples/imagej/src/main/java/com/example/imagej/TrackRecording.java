package com.example.imagej;

import haltere.core.chain.FilterChain;
import haltere.core.chain.Filters;
import haltere.core.chain.Outlet;
import haltere.core.event.EventPacket;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.overlay.OverlayLayer;
import haltere.core.sink.CsvSink;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.filters.object.ObjectTrack;
import haltere.filters.wing.WingEstimate;
import ij.IJ;
import ij.ImagePlus;
import ij.Macro;
import ij.WindowManager;
import ij.gui.GenericDialog;
import ij.gui.Overlay;
import ij.measure.ResultsTable;
import ij.plugin.PlugIn;
import java.io.IOException;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BiConsumer;

/** Plugins &gt; Haltere &gt; Track wings, Track objects: tracks the recording of the image. */
public final class TrackRecording implements PlugIn {
  /** Maximum number of rows of the results table, which takes some 200 MB. */
  private static final int MAX_ROWS = 1_000_000;

  @Override
  public void run(String what) {
    boolean isWings = what.equals("wings");
    ImagePlus image = WindowManager.getCurrentImage();
    String rateHz = isWings ? "1000" : "100";
    try {
      if (image == null || !(image.getStack() instanceof RecordingStack stack)) {
        throw new IllegalArgumentException("Import a recording first");
      }
      if (Macro.getOptions() != null) {
        rateHz = Macro.getValue(Macro.getOptions(), "rate", rateHz);
      } else {
        GenericDialog dialog = new GenericDialog("Track " + what);
        dialog.addNumericField("Rate", Double.parseDouble(rateHz), 0, 8, "Hz");
        dialog.showDialog();
        if (dialog.wasCanceled()) {
          return;
        }
        rateHz = String.valueOf(dialog.getNextNumber());
      }
      track(image, stack, isWings, rateHz);
    } catch (IOException | RuntimeException problem) {
      IJ.error("Track " + what, problem.getMessage());
    }
  }

  private static void track(ImagePlus image, RecordingStack stack, boolean isWings, String rateHz)
      throws IOException {
    ResultsTable table = ResultsTable.getResultsTable();
    table.reset();
    IJ.resetEscape();
    String tracker = isWings ? "wing-tracker" : "object-tracker";
    try (RecordingReader reader = Recordings.open(stack.reader.path());
        FilterChain chain = new FilterChain(reader.geometry())) {
      chain.add(Filters.named(tracker));
      chain.set(tracker, isWings ? "output.rateHz" : "reportRateHz", rateHz);
      SlicedChain sliced = new SlicedChain(chain, stack);
      Outlet<? extends Record> results =
          isWings
              ? chain.outlet("estimates", WingEstimate.class)
              : chain.outlet("objects", ObjectTrack.class);
      results.subscribe(row -> add(row, sliced, table));
      while (!IJ.escapePressed() && reader.next(sliced)) {
        IJ.showProgress((double) reader.positionBytes() / reader.sizeBytes());
      }
      image.setOverlay(sliced.overlay);
    } finally {
      IJ.showProgress(1);
    }
    table.show("Results");
  }

  /** Adds a row with the columns of Haltere's own tables, and the slice. */
  private static void add(Record row, SlicedChain sliced, ResultsTable table) {
    if (table.size() == MAX_ROWS) {
      return;
    }
    table.incrementCounter();
    int column = 0;
    for (RecordComponent component : row.getClass().getRecordComponents()) {
      String name = CsvSink.columns(row.getClass()).get(column++);
      try {
        Object value = component.getAccessor().invoke(row);
        if (value instanceof Number number) {
          table.addValue(name, number.doubleValue());
        } else {
          table.addValue(name, value.toString());
        }
      } catch (ReflectiveOperationException problem) {
        throw new IllegalStateException(problem);
      }
    }
    table.addValue("Slice", sliced.number((long) table.getValue("t_us", table.size() - 1)));
  }

  /** Sends a stream through a chain, and draws at the end of each slice what the filters show. */
  private static final class SlicedChain implements StreamHandler {
    private final Overlay overlay = new Overlay();
    private final FilterChain chain;
    private final RecordingStack stack;
    private final List<BiConsumer<Long, RoiCanvas>> layers = new ArrayList<>();
    private final EventPacket part = new EventPacket(0);
    private int slice = 1;
    private long lastUs;

    SlicedChain(FilterChain chain, RecordingStack stack) {
      this.chain = chain;
      this.stack = stack;
      chain.overlays().forEach(this::follow);
    }

    private <T> void follow(OverlayLayer<T> layer) {
      AtomicReference<T> newest = new AtomicReference<>();
      layer.subscribe().apply(newest::set);
      layers.add(
          (timeUs, canvas) -> {
            if (newest.get() != null) {
              layer.overlay().drawAt(newest.get(), timeUs, canvas);
            }
          });
    }

    /** The slice at a time before now: starts ascend in a segment. */
    int number(long timeUs) {
      int number = Math.min(slice, stack.getSize());
      while (number > 1
          && stack.startUs(number) > timeUs
          && stack.startUs(number - 1) < stack.startUs(number)) {
        number--;
      }
      return number;
    }

    @Override
    public void packet(EventPacket packet) {
      int to;
      for (int from = 0; from < packet.size(); from = to) {
        lastUs = packet.timeUs(from);
        while (slice < stack.getSize() && stack.endUs(slice) <= lastUs) {
          drawSlice();
        }
        to = packet.indexAtOrAfter(stack.endUs(slice), from);
        part.clear();
        part.append(packet, from, to);
        chain.packet(part);
      }
    }

    private void drawSlice() {
      RoiCanvas canvas = new RoiCanvas(overlay, stack.getHeight(), slice);
      long timeUs = Math.min(lastUs, stack.endUs(slice));
      layers.forEach(layer -> layer.accept(timeUs, canvas));
      slice++;
    }

    @Override
    public void notified(StreamNotification notification) {
      chain.notified(notification);
      if (notification instanceof Reset || notification instanceof EndOfStream) {
        long endUs;
        do { // all slices of the segment
          endUs = stack.endUs(slice);
          drawSlice();
        } while (slice <= stack.getSize() && endUs < Long.MAX_VALUE);
      }
    }
  }
}
