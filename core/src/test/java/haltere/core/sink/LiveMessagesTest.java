package haltere.core.sink;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import haltere.core.event.SensorGeometry;
import haltere.core.json.internal.Json;
import haltere.core.stream.DataLost;
import haltere.core.stream.DeviceLost;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Clock;
import java.time.Instant;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;

class LiveMessagesTest {
  enum Side {
    LEFT
  }

  record Row(
      @Column("t_us") long timeUs,
      int id,
      @Column(decimals = 2) double xPx,
      float share,
      boolean seen,
      Side side,
      String name,
      OptionalLong beat) {}

  private final LiveMessages messages =
      new LiveMessages(Clock.fixed(Instant.ofEpochSecond(12, 345_678_999), ZoneOffset.UTC));

  private static String text(byte[] line) {
    return new String(line, StandardCharsets.US_ASCII);
  }

  @Test
  void resultMessageHasOriginSendTimeAndColumns() {
    Row row = new Row(7, 3, 1.005, 0.5f, true, Side.LEFT, "a\"b\\\n\u00e4", OptionalLong.of(9));
    assertEquals(
        "{\"number\":5,\"sent_us\":12345678,\"from\":\"tracker/rows\",\"row\":{\"t_us\":7,\"id\":3,"
            + "\"x_px\":1.00,\"share\":0.5,\"seen\":true,\"side\":\"LEFT\","
            + "\"name\":\"a\\\"b\\\\\\u000a\\u00e4\",\"beat\":9}}\n",
        text(messages.result(5, "tracker/rows", row)));
  }

  @Test
  void emptyTableFieldsAreNull() throws IOException {
    Row row =
        new Row(7, 3, Double.NaN, Float.POSITIVE_INFINITY, false, null, null, OptionalLong.empty());
    Map<?, ?> read = (Map<?, ?>) Json.parse(text(messages.result(1, "a/b", row)), "a message");
    assertEquals(
        Arrays.asList(7L, 3L, null, null, false, null, null, null),
        new ArrayList<>(((Map<?, ?>) read.get("row")).values()));
  }

  @Test
  void numbersHaveAPointInEveryLocale() {
    Locale usual = Locale.getDefault();
    try {
      Locale.setDefault(Locale.GERMANY);
      Row row = new Row(-1, 3, 1234.5, 1e-9f, false, Side.LEFT, "", OptionalLong.empty());
      String line = text(messages.result(1, "a/b", row));
      assertEquals(true, line.contains("\"x_px\":1234.50,\"share\":1.0E-9"), line);
    } finally {
      Locale.setDefault(usual);
    }
  }

  @Test
  void notificationsOfTheStreamAreSent() {
    String begin = "{\"number\":2,\"sent_us\":12345678,\"notification\":";
    Map<StreamNotification, String> expected =
        Map.of(
            new StreamStarted(new SensorGeometry(128, 64), "fly"),
            "\"started\",\"source\":\"fly\",\"width\":128,\"height\":64}\n",
            new Reset(Reset.Cause.CLOCK_RESTARTED, 5, 0),
            "\"reset\",\"cause\":\"clock-restarted\",\"last_us\":5,\"next_us\":0}\n",
            new Reset(Reset.Cause.USER),
            "\"reset\",\"cause\":\"user\",\"last_us\":null,\"next_us\":null}\n",
            new DataLost(64, 8, 1, StreamNotification.NO_TIME_US, "USB"),
            "\"data-lost\",\"events\":8,\"from_us\":1,\"to_us\":null,\"place\":\"USB\"}\n",
            new DataLost(-1, -1, 1, 2, "USB"),
            "\"data-lost\",\"events\":null,\"from_us\":1,\"to_us\":2,\"place\":\"USB\"}\n",
            new DeviceLost("dvs128:1", 3),
            "\"device-lost\",\"device\":\"dvs128:1\",\"last_us\":3}\n",
            new EndOfStream(4),
            "\"end\",\"last_us\":4}\n");
    expected.forEach(
        (notification, line) ->
            assertEquals(begin + line, text(messages.notification(2, notification))));
  }

  @Test
  void lossMessagesStateTheirCount() {
    assertEquals(
        "{\"sent_us\":12345678,\"notification\":\"lost\",\"messages\":12,\"place\":\"slow\"}\n",
        text(messages.lost(12, "slow")));
  }

  @Test
  void nonTabularRecordsAreRejected() {
    record Nested(Row row) {}
    assertThrows(IllegalArgumentException.class, () -> messages.result(1, "a/b", new Nested(null)));
  }
}
