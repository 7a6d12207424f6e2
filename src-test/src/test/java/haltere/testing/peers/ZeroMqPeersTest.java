package haltere.testing.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.core.sink.LineOutput;
import haltere.core.sink.LineOutputs;
import haltere.testing.Waiting;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** ZeroMQ's own library, libzmq behind Python's pyzmq, subscribes to live results. */
@Timeout(300)
class ZeroMqPeersTest {
  @TempDir Path folder;

  @Test
  void libzmqReceivesSubscribedTopics() throws Exception {
    PythonPrograms programs = PythonPrograms.orSkip("zeromq.py", folder);
    try (LineOutput output = LineOutputs.open("zmq://127.0.0.1:0")) {
      String address = output.address().replace("zmq:", "tcp:");
      CompletableFuture<Optional<List<String>>> printed =
          CompletableFuture.supplyAsync(
              () -> {
                try {
                  return programs.run("read", address, "wanted/", "3");
                } catch (IOException e) {
                  throw new UncheckedIOException(e);
                }
              });
      Waiting.until("a subscriber", () -> output.receivers() == 1);
      String longRow = "x".repeat(1000);
      for (String row : List.of("1", longRow, "3")) {
        output.send("other/rows", line("not this"));
        output.send("wanted/rows", line(row));
      }
      assertEquals(
          Optional.of(List.of("wanted/rows 1", "wanted/rows " + longRow, "wanted/rows 3")),
          printed.get(2, TimeUnit.MINUTES),
          programs.errors());
      Waiting.until("its end", () -> output.receivers() == 0);
      assertEquals(0, output.lost());
    }
  }

  private static byte[] line(String text) {
    return (text + "\n").getBytes(StandardCharsets.US_ASCII);
  }
}
