package haltere.core.stream;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class StreamGrammarTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(10, 8);
  private static final StreamStarted START = new StreamStarted(SENSOR, "a test");
  private static final EndOfStream END = new EndOfStream(9);
  private static final DeviceLost LOST = new DeviceLost("the camera", 9);
  private static final Reset RESET = new Reset(Reset.Cause.SEEK);
  private static final DataLost GAP = new DataLost(1, 1, 0, 1, "the test");

  private final List<String> passed = new ArrayList<>();
  private final StreamGrammar grammar =
      new StreamGrammar(
          new StreamHandler() {
            @Override
            public void packet(EventPacket packet) {
              passed.add("packet");
            }

            @Override
            public void notified(StreamNotification notification) {
              passed.add(notification.getClass().getSimpleName());
            }
          });

  @Test
  void validStreamsPassUnchanged() {
    grammar.notified(START);
    grammar.packet(event(5, 0, 0));
    grammar.packet(new EventPacket(0));
    grammar.notified(GAP);
    grammar.packet(event(4, 9, 7));
    grammar.notified(RESET);
    grammar.packet(event(0, 0, 0));
    grammar.notified(LOST);
    assertFalse(grammar.ended());
    grammar.notified(END);
    assertTrue(grammar.ended());
    grammar.notified(START);
    grammar.notified(END);
    assertEquals(
        List.of(
            "StreamStarted",
            "packet",
            "packet",
            "DataLost",
            "packet",
            "Reset",
            "packet",
            "DeviceLost",
            "EndOfStream",
            "StreamStarted",
            "EndOfStream"),
        passed);
  }

  @Test
  void elementsBeforeTheStartAreRejected() {
    refused("a packet came before the start of the stream", () -> grammar.packet(event(0, 0, 0)));
    refused(END, "the end of stream came before the start of the stream");
    refused(RESET, RESET + " came before the start of the stream");
    refused(LOST, LOST + " came before the start of the stream");
  }

  @Test
  void secondStartIsRejected() {
    grammar.notified(START);
    refused(START, "the stream started while the stream was running");
  }

  @Test
  void onlyTheEndMayFollowADeviceLoss() {
    grammar.notified(START);
    grammar.notified(LOST);
    refused("a packet came after the device was lost", () -> grammar.packet(event(0, 0, 0)));
    refused(GAP, GAP + " came after the device was lost");
    refused(LOST, LOST + " came after the device was lost");
    refused(START, "the stream started after the device was lost");
    grammar.notified(END);
  }

  @Test
  void onlyAStartMayFollowTheEnd() {
    grammar.notified(START);
    grammar.notified(END);
    refused("a packet came after the end of the stream", () -> grammar.packet(event(0, 0, 0)));
    refused(END, "the end of stream came after the end of the stream");
    refused(RESET, RESET + " came after the end of the stream");
  }

  @Test
  void descendingTimesAreRejected() {
    grammar.notified(START);
    grammar.packet(event(5, 0, 0));
    grammar.packet(event(5, 0, 0));
    refused(
        "time went back from 5 us to 4 us without a notification",
        () -> grammar.packet(event(4, 0, 0)));
    EventPacket packet = EventPacket.of(new long[] {9, 8}, new int[2]);
    refused(
        "time went back from 9 us to 8 us without a notification", () -> grammar.packet(packet));
  }

  @Test
  void pixelsOutsideTheSensorAreRejected() {
    grammar.notified(START);
    refused("pixel (10, 0) is outside of 10x8", () -> grammar.packet(event(0, 10, 0)));
    refused("pixel (0, 8) is outside of 10x8", () -> grammar.packet(event(0, 0, 8)));
  }

  private void refused(StreamNotification notification, String message) {
    refused(message, () -> grammar.notified(notification));
  }

  private void refused(String message, Runnable call) {
    int before = passed.size();
    assertEquals(message, assertThrows(IllegalStateException.class, call::run).getMessage());
    assertEquals(before, passed.size(), "what is refused is not passed on");
  }

  private static EventPacket event(long timeUs, int x, int y) {
    EventPacket packet = new EventPacket(1);
    packet.append(timeUs, x, y, true);
    return packet;
  }
}
