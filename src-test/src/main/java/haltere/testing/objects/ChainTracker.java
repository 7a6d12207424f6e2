package haltere.testing.objects;

import haltere.core.chain.FilterChain;
import haltere.core.chain.Filters;
import haltere.core.chain.Outlet;
import haltere.core.sink.CsvSink;
import haltere.core.stream.EventSource;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.List;

/**
 * A chain of filters with their default settings whose last outlet of the stated name publishes the
 * rows of a table of tracks, as {@code haltere track} runs it.
 *
 * @param filters names of the filters, in order
 * @param outlet name of the outlet
 */
public record ChainTracker(List<String> filters, String outlet) implements TrackerUnderTest {
  /** Copies the list. */
  public ChainTracker {
    filters = List.copyOf(filters);
  }

  @Override
  public List<TrackRow> track(String scene, EventSource events) throws IOException {
    FilterChain chain = new FilterChain(events.geometry());
    filters.forEach(name -> chain.add(Filters.named(name)));
    Outlet<?> tracks =
        chain.outlets().stream()
            .filter(one -> one.name().equals(outlet))
            .reduce((first, second) -> second)
            .orElseThrow(() -> new IllegalArgumentException(filters + " have no outlet " + outlet));
    ByteArrayOutputStream table = new ByteArrayOutputStream();
    run(chain, tracks.type().asSubclass(Record.class), tracks, table, events);
    return TrackTable.read(
        new InputStreamReader(
            new ByteArrayInputStream(table.toByteArray()), StandardCharsets.UTF_8));
  }

  private static <R extends Record> void run(
      FilterChain chain,
      Class<R> type,
      Outlet<?> tracks,
      ByteArrayOutputStream table,
      EventSource events)
      throws IOException {
    try (CsvSink<R> sink = CsvSink.on(table, type)) {
      tracks.subscribe(row -> sink.accept(type.cast(row)));
      events.drainTo(chain);
      sink.finish();
    } finally {
      chain.close();
    }
  }
}
