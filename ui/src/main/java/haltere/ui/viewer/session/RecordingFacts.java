package haltere.ui.viewer.session;

import haltere.core.event.EventPacket;
import haltere.core.event.Frame;
import haltere.core.event.SensorGeometry;
import haltere.core.event.SensorSample;
import haltere.core.event.Trigger;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingClock;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.format.summary.RateProfile;
import haltere.core.format.summary.RecordingSummary;
import haltere.core.playback.Mark;
import haltere.core.settings.Parameter;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.ui.viewer.picture.FrameLayer;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * The facts of a recording after a complete scan.
 *
 * @param file where it is
 * @param sizeBytes of the file
 * @param summary counts, times, gaps and warnings
 * @param profile event rate over the elapsed timeline
 * @param clock origin of its times
 * @param compression method of compression; empty if the format does not state it
 * @param header properties of camera and chain, by name
 * @param triggers in their order, the first {@link #MAX_LISTED}
 * @param signals those of them that are not the camera's own frame timing
 * @param frames times of frames in their order, the first {@link #MAX_LISTED}
 * @param usedBits bits that are set in any value of a frame of 16 bits
 * @param assumedSensor the sensor, if it was guessed
 */
public record RecordingFacts(
    Path file,
    long sizeBytes,
    RecordingSummary summary,
    RateProfile profile,
    RecordingClock clock,
    Optional<String> compression,
    Map<String, String> header,
    List<Mark> triggers,
    List<Mark> signals,
    List<Mark> frames,
    int usedBits,
    Optional<SensorGeometry> assumedSensor) {
  /** Maximum number of listed triggers and frames. */
  public static final int MAX_LISTED = 100_000;

  private static final int PROFILE_BINS = 2000;
  private static final Set<Trigger.Source> FRAME_TIMING =
      Set.of(Trigger.Source.EXPOSURE, Trigger.Source.FRAME_READOUT);

  /** Reads a recording from its start to its end; background thread. */
  public static RecordingFacts scan(Path file, ReadOptions options) throws IOException {
    try (RecordingReader reader = Recordings.open(file, options.withSamples(true))) {
      Moments moments = new Moments(new RateProfile.Collector(reader.segments(), PROFILE_BINS));
      // low priority: the window must stay responsive
      RecordingSummary summary =
          RecordingSummary.scan(reader, (done, total) -> Thread.yield(), moments);
      return new RecordingFacts(
          file,
          reader.sizeBytes(),
          summary,
          moments.rates.profile(),
          reader.clock(),
          reader.compression(),
          reader.metadata(),
          List.copyOf(moments.triggers),
          List.copyOf(moments.signals),
          List.copyOf(moments.frames),
          moments.usedBits,
          assumedSensor(reader, options));
    }
  }

  /** The sensor, if the reader makes fewer assumptions once it is stated. */
  private static Optional<SensorGeometry> assumedSensor(RecordingReader reader, ReadOptions options)
      throws IOException {
    if (options.sensor().isPresent()) {
      return Optional.empty();
    }
    SensorGeometry sensor = reader.geometry();
    try (RecordingReader reopened = Recordings.open(reader.path(), options.withSensor(sensor))) {
      return reopened.remarks().size() < reader.remarks().size()
          ? Optional.of(sensor)
          : Optional.empty();
    }
  }

  /** Collects samples. */
  private static final class Moments implements StreamHandler {
    private final RateProfile.Collector rates;
    private final List<Mark> triggers = new ArrayList<>();
    private final List<Mark> signals = new ArrayList<>();
    private final List<Mark> frames = new ArrayList<>();
    private int usedBits;

    Moments(RateProfile.Collector rates) {
      this.rates = rates;
    }

    @Override
    public void packet(EventPacket packet) {
      rates.packet(packet);
    }

    @Override
    public void notified(StreamNotification notification) {
      rates.notified(notification);
    }

    @Override
    public void sample(SensorSample sample) {
      // times before the first event count as the start
      long elapsedUs = Math.max(0, rates.elapsedUs(sample.timeUs()));
      if (sample instanceof Trigger trigger) {
        Mark mark = new Mark(label(trigger), elapsedUs);
        add(mark, triggers);
        if (!FRAME_TIMING.contains(trigger.source())) {
          add(mark, signals);
        }
      } else if (sample instanceof Frame frame) {
        usedBits |= FrameLayer.usedBits(frame);
        add(new Mark("Frame", elapsedUs), frames);
      }
    }

    private static void add(Mark mark, List<Mark> list) {
      if (list.size() < MAX_LISTED) {
        list.add(mark);
      }
    }
  }

  /** Name of a trigger, such as "Exposure begins" or "Trigger 1 rising". */
  public static String label(Trigger trigger) {
    boolean begins = trigger.edge() != Trigger.Edge.FALLING;
    String edge = " " + Parameter.text(trigger.edge());
    return switch (trigger.source()) {
      case EXPOSURE -> "Exposure " + (begins ? "begins" : "ends");
      case FRAME_READOUT -> "Readout " + (begins ? "begins" : "ends");
      case CLOCK_RESET -> "Clock reset";
      case EXTERNAL_INPUT -> "Trigger " + trigger.channel() + edge;
      case SIGNAL_GENERATOR -> "Generator " + trigger.channel() + edge;
    };
  }
}
