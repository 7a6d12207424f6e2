package com.example.imagej;

import haltere.core.event.EventPacket;
import haltere.core.event.Frame;
import haltere.core.event.SensorSample;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.format.TimeSegment;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import ij.IJ;
import ij.VirtualStack;
import ij.process.FloatProcessor;
import ij.process.ImageProcessor;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Virtual stack of a recording: slices are read when they are shown, so that memory is bounded. */
final class RecordingStack extends VirtualStack {
  /** Content of a slice: ON minus OFF events, events of one polarity, or grey values of a frame. */
  enum Show {
    SIGNED,
    ON,
    OFF,
    FRAMES
  }

  /** Start of a slice; within a segment, the clock of the recording never goes back. */
  private record Start(int segment, long timeUs) {}

  /** Maximum number of slices, whose list takes 30 MB. */
  private static final int MAX_SLICES = 1_000_000;

  final RecordingReader reader;
  private final Show show;
  private final List<Start> starts = new ArrayList<>();

  RecordingStack(RecordingReader reader, long sliceUs, Show show) throws IOException {
    super(reader.geometry().width(), reader.geometry().height());
    this.reader = reader;
    this.show = show;
    setBitDepth(32);
    if (show == Show.FRAMES) {
      reader.drainTo(StreamHandler.ofSamples(this::addFrame));
    }
    for (int i = 0; i < reader.segments().size() && show != Show.FRAMES; i++) {
      TimeSegment segment = reader.segments().get(i);
      for (long us = segment.firstUs(); us <= segment.lastUs(); us += sliceUs) {
        add(new Start(i, us));
      }
    }
    require(!starts.isEmpty(), "The recording has nothing of that to show");
  }

  static RecordingReader open(Path file, Show show) throws IOException {
    return Recordings.open(file, ReadOptions.DEFAULT.withSamples(show == Show.FRAMES));
  }

  private void addFrame(SensorSample sample) {
    if (sample instanceof Frame) {
      Start last = starts.isEmpty() ? new Start(0, Long.MIN_VALUE) : starts.get(getSize() - 1);
      add(new Start(last.segment + (sample.timeUs() < last.timeUs ? 1 : 0), sample.timeUs()));
    }
  }

  private void add(Start start) {
    starts.add(start);
    require(starts.size() <= MAX_SLICES, "More than a million slices; choose longer ones");
  }

  static void require(boolean holds, String otherwise) {
    if (!holds) {
      throw new IllegalArgumentException(otherwise);
    }
  }

  @Override
  public int getSize() {
    return starts.size();
  }

  long startUs(int slice) {
    return starts.get(slice - 1).timeUs;
  }

  /** Start of the next slice of the segment; {@link Long#MAX_VALUE} for the last one. */
  long endUs(int slice) {
    boolean isLast =
        slice == getSize() || starts.get(slice).segment != starts.get(slice - 1).segment;
    return isLast ? Long.MAX_VALUE : startUs(slice + 1);
  }

  @Override
  public String getSliceLabel(int slice) {
    return startUs(slice) / 1e6 + " s";
  }

  @Override
  public synchronized ImageProcessor getProcessor(int slice) {
    Painter painter = new Painter(startUs(slice), endUs(slice));
    try {
      reader.seek(starts.get(slice - 1).segment, startUs(slice));
      while (!painter.isDone && reader.next(painter)) {
        // until the slice is complete
      }
    } catch (IOException problem) {
      IJ.log("Slice " + slice + ": " + problem.getMessage());
    }
    return painter.picture;
  }

  synchronized void close() {
    try {
      reader.close();
    } catch (IOException problem) {
      IJ.log(problem.getMessage());
    }
  }

  /** Draws the picture of a slice. */
  private final class Painter implements StreamHandler {
    private final FloatProcessor picture = new FloatProcessor(getWidth(), getHeight());
    private final long startUs;
    private final long endUs;
    private boolean isDone;

    Painter(long startUs, long endUs) {
      this.startUs = startUs;
      this.endUs = endUs;
    }

    @Override
    public void packet(EventPacket packet) {
      int end = packet.indexAtOrAfter(show == Show.FRAMES ? startUs + 1 : endUs);
      for (int i = 0; i < end && show != Show.FRAMES; i++) {
        if (show == Show.SIGNED || packet.isOn(i) == (show == Show.ON)) {
          add(packet.x(i), packet.y(i), show == Show.SIGNED && !packet.isOn(i) ? -1 : 1);
        }
      }
      isDone = end < packet.size();
    }

    @Override
    public void sample(SensorSample sample) {
      if (sample instanceof Frame frame && frame.timeUs() == startUs) {
        for (int i = 0; i < frame.width() * frame.height() * frame.channels(); i++) {
          int pixel = i / frame.channels();
          int x = pixel % frame.width();
          int y = pixel / frame.width();
          double value = frame.value(x, y, i % frame.channels()) / frame.channels();
          add(frame.left() + x, frame.bottom() + y, value);
        }
        isDone = true;
      }
    }

    private void add(int x, int y, double value) {
      int row = getHeight() - 1 - y; // rows count from the top
      if (x >= 0 && x < getWidth() && row >= 0 && row < getHeight()) {
        picture.setf(x, row, (float) (picture.getf(x, row) + value));
      }
    }

    @Override
    public void notified(StreamNotification notification) {
      isDone |= notification instanceof Reset reset && reset.cause() == Reset.Cause.CLOCK_RESTARTED;
    }
  }
}
