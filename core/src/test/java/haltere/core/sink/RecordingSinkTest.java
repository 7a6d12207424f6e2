package haltere.core.sink;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import haltere.core.event.EventPacket;
import haltere.core.format.RecordingWriter;
import haltere.core.stream.Reset;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class RecordingSinkTest {
  private final List<String> calls = new ArrayList<>();

  private final RecordingWriter writer =
      new RecordingWriter() {
        @Override
        public void write(EventPacket packet) throws IOException {
          if (packet.size() > 5) {
            throw new IOException("disk full");
          }
          calls.add("write " + packet.size());
        }

        @Override
        public List<String> losses() {
          return List.of();
        }

        @Override
        public void finish() {
          calls.add("finish");
        }

        @Override
        public void close() {
          calls.add("close");
        }
      };

  private static EventPacket packet(int events) {
    EventPacket packet = new EventPacket(events);
    for (int i = 0; i < events; i++) {
      packet.append(i, 0, 0, true);
    }
    return packet;
  }

  @Test
  void itWritesUntilPlaybackJumpsAndCountsTheRest() throws IOException {
    try (RecordingSink sink = new RecordingSink(writer)) {
      sink.notified(new Reset(Reset.Cause.SEEK));
      sink.packet(packet(3));
      sink.notified(new Reset(Reset.Cause.CLOCK_RESTARTED));
      sink.packet(packet(2));
      sink.notified(new Reset(Reset.Cause.REWIND));
      sink.packet(packet(4));
      sink.finish();
      assertEquals(5, sink.events());
      assertEquals(4, sink.eventsAfterStop());
      assertEquals(Reset.Cause.REWIND, sink.stoppedBy().orElseThrow().cause());
    }
    assertEquals(List.of("write 3", "write 2", "finish", "close"), calls);
  }

  @Test
  void whatCannotBeWrittenIsSaid() {
    RecordingSink sink = new RecordingSink(writer);
    assertThrows(UncheckedIOException.class, () -> sink.packet(packet(6)));
    assertEquals(0, sink.events());
  }
}
