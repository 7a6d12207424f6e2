package haltere.core.playback.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.playback.PlaybackClock;
import haltere.core.simulation.internal.fly.FlyScene;
import haltere.core.simulation.internal.fly.FlySceneSettings;
import haltere.core.stream.EventSource;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.testing.ManualClock;
import java.io.IOException;
import org.junit.jupiter.api.Test;

class PacedSourceTest {
  private final ManualClock time = new ManualClock();

  private static EventSource scene() {
    return new FlyScene(
        FlySceneSettings.defaults().with("run.durationS=0.2", "run.startUs=5000000"));
  }

  private PacedSource paced(EventSource source, double speed) {
    PlaybackClock clock = new PlaybackClock(time, time);
    clock.setSpeed(speed);
    return new PacedSource(source, clock);
  }

  /** Checks when events come and sums them up. */
  private final class Witness implements StreamHandler {
    final double speed;
    long events;
    long hash;
    long firstUs = -1;

    Witness(double speed) {
      this.speed = speed;
    }

    @Override
    public void packet(EventPacket packet) {
      for (int i = 0; i < packet.size(); i++) {
        hash = hash * 31 + packet.timeUs(i) * 7 + packet.address(i);
      }
      events += packet.size();
      if (packet.isEmpty() || speed == 0) {
        return;
      }
      firstUs = firstUs < 0 ? packet.lastTimeUs() : firstUs;
      long passedUs = (long) (time.getAsLong() * speed / 1000);
      assertTrue(packet.lastTimeUs() - firstUs <= passedUs + 1, "an event came before its time");
      assertTrue(passedUs - (packet.timeUs(0) - firstUs) <= 2001, "an event came too late");
      assertTrue(packet.lastTimeUs() - packet.timeUs(0) <= 2000);
    }

    @Override
    public void notified(StreamNotification notification) {
      hash = hash * 31 + notification.getClass().getName().hashCode();
    }
  }

  @Test
  void eventsAreDeliveredAtTheirTimesWithoutLoss() throws IOException {
    Witness plain = new Witness(0);
    scene().drainTo(plain);
    for (double speed : new double[] {1, 0.1, 3}) {
      time.advance(-time.getAsLong());
      Witness witness = new Witness(speed);
      paced(scene(), speed).drainTo(witness);
      assertEquals(plain.events, witness.events);
      assertEquals(plain.hash, witness.hash);
      assertEquals(0.2e9 / speed, time.getAsLong(), 0.01e9 / speed);
    }
  }

  @Test
  void clockJumpsOfTheSourceTakeNoTime() throws IOException {
    EventPacket before = new EventPacket(1);
    before.append(1_000_000_000_000L, 1, 1, true);
    EventPacket after = new EventPacket(1);
    after.append(5, 1, 1, true);
    EventSource jumping =
        new EventSource() {
          private int step;

          @Override
          public SensorGeometry geometry() {
            return new SensorGeometry(8, 8);
          }

          @Override
          public boolean next(StreamHandler handler) {
            switch (step++) {
              case 0 -> handler.packet(before);
              case 1 -> handler.notified(new Reset(Reset.Cause.CLOCK_RESTARTED));
              case 2 -> handler.packet(after);
              default -> {
                return false;
              }
            }
            return true;
          }

          @Override
          public void close() {}
        };
    Witness witness = new Witness(0);
    paced(jumping, 1).drainTo(witness);
    assertEquals(2, witness.events);
    assertEquals(0, time.getAsLong());
  }
}
