package haltere.core.playback;

import static haltere.core.playback.EngineRig.SENSOR;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.Frame;
import haltere.core.event.SampleKind;
import haltere.core.event.SensorSample;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import haltere.core.format.internal.aedat4.Aedat4Compression;
import haltere.core.format.internal.aedat4.Aedat4Writer;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A recording of frames without events is played by time, as a film. */
class FramesOnlyTest {
  private static final long FIRST_US = 5_000_000;
  private static final long BETWEEN_US = 40_000;
  private static final int FRAMES = 5;

  @TempDir Path folder;
  private Path file;

  /** Writes down frames by their number, and ends of slices as places. */
  private static final class Log implements SliceSink {
    private final List<String> lines = new ArrayList<>();

    @Override
    public void packet(EventPacket packet) {
      throw new AssertionError("there are no events");
    }

    @Override
    public void sample(SensorSample sample) {
      lines.add("frame " + (sample.timeUs() - FIRST_US) / BETWEEN_US);
    }

    @Override
    public void sliceEnd(long fromUs, long toUs) {
      lines.add(String.valueOf((toUs - FIRST_US) / 1000));
    }

    private List<String> take() {
      List<String> taken = List.copyOf(lines);
      lines.clear();
      return taken;
    }
  }

  @BeforeEach
  void write() throws IOException {
    write(FRAMES);
  }

  private void write(int frames) throws IOException {
    file = folder.resolve(frames + "-frames.aedat4");
    WriteOptions options = WriteOptions.of(SENSOR).withSamples(EnumSet.of(SampleKind.FRAME));
    try (RecordingWriter writer = Aedat4Writer.create(file, options, Aedat4Compression.NONE)) {
      for (int i = 0; i < frames; i++) {
        long timeUs = FIRST_US + i * BETWEEN_US;
        Frame.Times times = new Frame.Times(timeUs, timeUs + 1000);
        byte[] rows = new byte[SENSOR.pixels()];
        assertTrue(writer.write(new Frame(times, 0, 0, 16, 16, 1, Frame.Depth.UNSIGNED_8, rows)));
      }
      writer.finish();
    }
  }

  private RecordingPlayable playable() throws IOException {
    return new RecordingPlayable(Recordings.open(file, ReadOptions.DEFAULT.withSamples(true)));
  }

  private EngineRig rig(Log log) throws IOException {
    return rig(log, new Slicing.ByTime(20_000));
  }

  private EngineRig rig(Log log, Slicing slicing) throws IOException {
    EngineRig rig =
        new EngineRig(playable(), PlayerOptions.defaults().withSlicing(slicing).withPaused(true));
    rig.ask(new PlaybackCommand.AddSink(log, false));
    return rig;
  }

  @Test
  void itLastsFromTheFirstToTheLastFrame() throws IOException {
    try (RecordingPlayable playable = playable()) {
      assertEquals((FRAMES - 1) * BETWEEN_US + 1, playable.durationUs().orElseThrow());
    }
  }

  @Test
  void framesComeInTheSliceOfTheirTime() throws IOException {
    Log log = new Log();
    EngineRig rig = rig(log);
    rig.ask(new PlaybackCommand.Play(true));
    rig.run();
    assertEquals(
        List.of(
            "frame 0", "20", "40", "frame 1", "60", "80", "frame 2", "100", "120", "frame 3", "140",
            "160", "frame 4"),
        log.take().subList(0, 13));
    assertTrue(rig.clock.getAsLong() >= 150_000_000, "played at its speed");
  }

  @Test
  void framesComeAtTheirTimeWhereEventsAreToBeCounted() throws IOException {
    Log log = new Log();
    EngineRig rig = rig(log, new Slicing.ByCount(5_000));
    rig.ask(new PlaybackCommand.Play(true));
    rig.run();
    assertEquals(
        List.of("frame 0", "16", "33", "frame 1", "50", "66", "frame 2", "83", "100"),
        log.take().subList(0, 9));
    assertTrue(rig.clock.getAsLong() >= 150_000_000, "played at its speed");
  }

  @Test
  void aSingleFrameIsShownAndNotRepeated() throws IOException {
    write(1);
    Log log = new Log();
    EngineRig rig = rig(log);
    rig.ask(new PlaybackCommand.SetLoop(Loop.ALL));
    rig.ask(new PlaybackCommand.Play(true));
    rig.run();
    assertEquals(List.of("frame 0", "0"), log.take());
    assertEquals(PlayerStatus.State.ENDED, rig.engine.status().state());
  }

  @Test
  void theLastFrameEndsItsSlice() throws IOException {
    Log log = new Log();
    EngineRig rig = rig(log);
    rig.ask(new PlaybackCommand.Seek(150_000));
    rig.run();
    rig.ask(new PlaybackCommand.Step(1));
    rig.run();
    assertEquals(List.of("frame 4", "160"), log.take());
    assertEquals((FRAMES - 1) * BETWEEN_US + 1, rig.engine.status().elapsedUs());
  }

  @Test
  void aSoughtMomentAndStepsGiveTheFramesOfTheirSlices() throws IOException {
    Log log = new Log();
    EngineRig rig = rig(log);
    rig.run();
    log.take();
    rig.ask(new PlaybackCommand.Seek(70_000));
    rig.run();
    assertEquals(List.of("frame 2", "90"), log.take());
    rig.ask(new PlaybackCommand.Step(1));
    rig.run();
    assertEquals(List.of("110"), log.take());
    rig.ask(new PlaybackCommand.Step(-3));
    rig.run();
    assertEquals(List.of("frame 1", "50"), log.take());
  }
}
