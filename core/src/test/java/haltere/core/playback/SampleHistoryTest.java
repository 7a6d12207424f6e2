package haltere.core.playback;

import static haltere.core.playback.EngineRig.SENSOR;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.Frame;
import haltere.core.event.SensorSample;
import haltere.core.event.Trigger;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;

/** Samples beside the events that are kept. */
class KeptSamplesTest {
  private static final int ROOM = 4 * EventHistory.CHUNK_EVENTS;

  @Test
  void samplesKeepTheirPositionsAcrossClockRestarts() throws IOException {
    Reset restarted = new Reset(Reset.Cause.CLOCK_RESTARTED, 30, 5);
    BufferedPlayable kept =
        new BufferedPlayable(
            new ScriptedPlayable(
                new StreamStarted(SENSOR, "script"),
                trigger(4),
                EngineRig.events(10, 20),
                trigger(22),
                trigger(25),
                EngineRig.events(30),
                trigger(35),
                restarted,
                trigger(2),
                EngineRig.events(5, 6),
                trigger(9),
                new EndOfStream(9)),
            ROOM);
    List<String> first = words(kept);
    kept.seek(0);
    assertEquals(
        List.of(
            "start", "t4", "10 20", "t22", "t25", "30", "t35", "reset", "t2", "5 6", "t9", "end"),
        first);
    assertEquals(first, words(kept));
    kept.seek(13);
    assertEquals(
        List.of("start", "t25", "30", "t35", "reset", "t2", "5 6", "t9", "end"), words(kept));
    List<String> copied = words(kept.copy(14, 21));
    assertEquals(List.of("start", "t25", "30"), copied.subList(0, 3));
    assertFalse(copied.contains("t35") || copied.contains("5"), copied.toString());
    kept.seek(5);
    kept.next(new StreamRecorder());
    kept.copy(0, 100);
    assertEquals("20", words(kept).get(0), "a copy leaves playback where it is");
  }

  private static Trigger trigger(long timeUs) {
    return new Trigger(timeUs, Trigger.Source.EXTERNAL_INPUT, Trigger.Edge.RISING, 0);
  }

  private static List<String> words(Playable playable) throws IOException {
    List<String> words = new ArrayList<>();
    while (playable.next(
        new StreamHandler() {
          @Override
          public void packet(EventPacket packet) {
            words.add(
                LongStream.range(0, packet.size())
                    .mapToObj(i -> Long.toString(packet.timeUs((int) i)))
                    .collect(Collectors.joining(" ")));
          }

          @Override
          public void sample(SensorSample sample) {
            words.add("t" + sample.timeUs());
          }

          @Override
          public void notified(StreamNotification notification) {
            words.add(
                notification instanceof StreamStarted
                    ? "start"
                    : notification instanceof EndOfStream ? "end" : "reset");
          }
        })) {
      // to the end
    }
    return words;
  }

  @Test
  void samplesAreBoundedAndRemovedWithTheirEvents() {
    SplittableRandom random = new SplittableRandom(11);
    long roomBytes = 24 * 1024;
    EventHistory history = new EventHistory(ROOM, roomBytes);
    List<SensorSample> all = new ArrayList<>();
    EventPacket packet = new EventPacket(1000);
    long timeUs = 0;
    for (int i = 0; i < 400; i++) {
      packet.clear();
      for (int event = random.nextInt(1000); event >= 0; event--) {
        packet.append(timeUs++, 1, 1, true);
      }
      history.append(packet, 0);
      SensorSample sample = random.nextInt(8) == 0 ? frame(timeUs++) : trigger(timeUs++);
      all.add(sample);
      history.append(sample, 0);
    }
    history.read(Long.MIN_VALUE);
    long bytes = 0;
    List<SensorSample> read = new ArrayList<>();
    while (!history.atEnd()) {
      history.next(
          packet,
          offset -> assertEquals(0, offset),
          new StreamHandler() {
            @Override
            public void packet(EventPacket events) {}

            @Override
            public void sample(SensorSample sample) {
              assertTrue(sample.timeUs() > history.fromUs());
              read.add(sample);
            }

            @Override
            public void notified(StreamNotification notification) {}
          });
    }
    for (SensorSample sample : read) {
      bytes += sample instanceof Frame ? 4096 : 0;
    }
    assertTrue(bytes > roomBytes / 2 && bytes <= roomBytes, bytes + " bytes of frames");
    assertEquals(all.subList(all.size() - read.size(), all.size()), read, "the newest, in order");
  }

  private static Frame frame(long timeUs) {
    return new Frame(
        new Frame.Times(timeUs, timeUs + 5),
        0,
        0,
        64,
        64,
        1,
        Frame.Depth.UNSIGNED_8,
        new byte[4096]);
  }
}
