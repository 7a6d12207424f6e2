package haltere.core.sink;

import haltere.core.stream.DataLost;
import haltere.core.stream.DeviceLost;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import java.time.Clock;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;

/**
 * The layout of live results: each message is one line of JSON that ends in a line feed.
 *
 * <pre>{@code
 * {"number":1,"sent_us":1795278123456789,"notification":"started","source":"fly","width":128,"height":128}
 * {"number":2,"sent_us":1795278123457012,"from":"kalman-tracks/tracks","row":{"t_us":1000,"id":1}}
 * {"sent_us":1795278123459000,"notification":"lost","messages":12,"place":"this receiver is too slow"}
 * }</pre>
 *
 * <p>{@code number} counts the messages of a run from 1: a gap shows how many were lost. {@code
 * sent_us} is the time of sending, microseconds since 1970 (UTC). {@code row} is a result; its
 * names are the columns of its table ({@link CsvSink#columns}), and empty fields of a table are
 * null, as is infinity, which JSON does not have. A {@code notification} is one of {@code started},
 * {@code reset}, {@code data-lost}, {@code device-lost}, {@code end} (those of the stream, see
 * {@link StreamNotification}), or {@code lost} (messages dropped because a buffer was full) or
 * {@code refused} (there are too many receivers); these two have no number.
 *
 * <p>Thread rule: one thread at a time.
 *
 * @since 0.1
 */
public final class LiveMessages {
  private final Clock clock;
  private final JsonText text = new JsonText();
  private final Map<Class<? extends Record>, RowFields> types = new HashMap<>();

  /**
   * Messages with the time of a clock.
   *
   * @param clock for the time of sending
   */
  public LiveMessages(Clock clock) {
    this.clock = Objects.requireNonNull(clock, "clock");
  }

  /**
   * The message of a result.
   *
   * @param number of the message
   * @param from stage and outlet, such as {@code cluster-tracker/clusters}
   * @param row a flat record
   * @return a line in ASCII with its line feed
   */
  public byte[] result(long number, String from, Record row) {
    RowFields fields = types.computeIfAbsent(row.getClass(), RowFields::new);
    begin(number);
    text.key("from").text(from);
    text.key("row").open();
    for (int i = 0; i < fields.names().size(); i++) {
      text.key(fields.names().get(i));
      fields.write(i, row, text);
    }
    return text.close().close().take();
  }

  /**
   * The message of a notification.
   *
   * @param number of the message
   * @param notification of the stream
   * @return a line in ASCII with its line feed
   */
  public byte[] notification(long number, StreamNotification notification) {
    begin(number);
    if (notification instanceof StreamStarted started) {
      text.key("notification").text("started");
      text.key("source").text(started.source());
      text.key("width").number(started.geometry().width());
      text.key("height").number(started.geometry().height());
    } else if (notification instanceof Reset reset) {
      text.key("notification").text("reset");
      text.key("cause").text(reset.cause().name().toLowerCase(Locale.ROOT).replace('_', '-'));
      time("last_us", reset.lastUs());
      time("next_us", reset.nextUs());
    } else if (notification instanceof DataLost lost) {
      text.key("notification").text("data-lost");
      text.key("events");
      known(lost.estimatedEvents(), -1);
      time("from_us", lost.fromUs());
      time("to_us", lost.toUs());
      text.key("place").text(lost.place());
    } else if (notification instanceof DeviceLost lost) {
      text.key("notification").text("device-lost");
      text.key("device").text(lost.device());
      time("last_us", lost.lastUs());
    } else if (notification instanceof EndOfStream end) {
      text.key("notification").text("end");
      time("last_us", end.lastUs());
    }
    return text.close().take();
  }

  /**
   * The message about lost messages.
   *
   * @param messages their number
   * @param place where they were dropped, in words for users
   * @return a line in ASCII with its line feed
   */
  public byte[] lost(long messages, String place) {
    text.open();
    sent();
    text.key("notification").text("lost");
    text.key("messages").number(messages);
    text.key("place").text(place);
    return text.close().take();
  }

  /**
   * The only message to a refused receiver.
   *
   * @param place the reason, in words for users
   * @return a line in ASCII with its line feed
   */
  public byte[] refused(String place) {
    text.open();
    sent();
    text.key("notification").text("refused");
    text.key("place").text(place);
    return text.close().take();
  }

  private void begin(long number) {
    text.open();
    text.key("number").number(number);
    sent();
  }

  private void sent() {
    text.key("sent_us").number(ChronoUnit.MICROS.between(Instant.EPOCH, clock.instant()));
  }

  private void time(String key, long timeUs) {
    text.key(key);
    known(timeUs, StreamNotification.NO_TIME_US);
  }

  private void known(long value, long unknown) {
    if (value == unknown) {
      text.nothing();
    } else {
      text.number(value);
    }
  }
}
