package haltere.testing.wings;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.ChainStage;
import haltere.core.chain.EventFilter;
import haltere.core.chain.FilterChain;
import haltere.core.chain.FilterFailure;
import haltere.core.chain.Outlet;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.AtomicFile;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import haltere.core.pipeline.JobResults;
import haltere.core.pipeline.OutletTables;
import haltere.core.pipeline.RecordingJob;
import haltere.core.simulation.internal.fly.FlyScene;
import haltere.core.simulation.internal.fly.FlySceneSettings;
import haltere.core.sink.TableMetadata;
import haltere.core.stream.EventQueues;
import haltere.core.stream.SharedWork;
import haltere.filters.wing.WingBeat;
import haltere.filters.wing.WingTrackerSettings;
import haltere.filters.wing.tracker.WingTrackerFilter;
import haltere.testing.SceneEvents;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A recording job on two threads writes the same files as on one, and ends its threads. */
@Timeout(120)
class JobOnTwoThreadsTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);

  @TempDir Path folder;
  private Path recording;

  @BeforeEach
  void writeRecording() throws IOException {
    recording = folder.resolve("fly.aedat");
    EventPacket events =
        SceneEvents.of(new FlyScene(FlySceneSettings.defaults().with("run.durationS=0.4")));
    try (RecordingWriter writer =
        Recordings.forWriting(recording).create(recording, WriteOptions.of(SENSOR)).orElseThrow()) {
      writer.write(events);
      writer.finish();
    }
  }

  @AfterEach
  void noThreadIsLeft() throws InterruptedException {
    for (Thread thread : Thread.getAllStackTraces().keySet()) {
      if (thread.getName().equals("haltere-filter")) {
        thread.join(60_000);
        assertFalse(thread.isAlive());
      }
    }
  }

  @Test
  void tablesAreIdenticalOnOneAndTwoThreads() throws IOException {
    Map<String, String> one = tables(1, false);
    assertTrue(one.get("beats.csv").lines().count() > 50);
    assertEquals(one, tables(2, false));
  }

  @Test
  void throwingSubscriberDoesNotChangeTheTables() throws IOException {
    assertEquals(tables(1, true), tables(2, true));
  }

  @Test
  void exceptionInSharedWorkEndsTheJobWithTheNameOfTheFilter() {
    RecordingJob job =
        RecordingJob.of(
            recording,
            sensor -> {
              FilterChain chain = new FilterChain(sensor);
              chain.add("broken", new Broken());
              return chain;
            },
            (reader, chain) -> tablesOf(chain, folder.resolve("broken")));
    FilterFailure failure = assertThrows(FilterFailure.class, () -> job.onThreads(2).run());
    assertEquals("broken", failure.stage().name());
    assertSame(IllegalStateException.class, failure.getCause().getClass());
  }

  /** Throws where the second of two parts takes its events. */
  private static final class Broken implements EventFilter {
    private final EventQueues queues =
        new EventQueues(
            2,
            (part, events) -> {
              if (part == 1) {
                throw new IllegalStateException("broken");
              }
            });

    @Override
    public void share(SharedWork work) {
      queues.share(work);
    }

    @Override
    public void process(EventPacket packet) {
      for (int i = 0; i < packet.size(); i++) {
        queues.add(i % 2, packet.timeUs(i), packet.address(i));
      }
      queues.process();
    }

    @Override
    public void reset() {}
  }

  private Map<String, String> tables(int threads, boolean withBadSubscriber) throws IOException {
    Path to = Files.createDirectory(folder.resolve("tables-" + threads));
    RecordingJob.of(
            recording,
            sensor -> {
              FilterChain chain = new FilterChain(sensor);
              chain.add(
                  "wing-tracker", new WingTrackerFilter(sensor, WingTrackerSettings.defaults()));
              if (withBadSubscriber) {
                chain
                    .outlet("beats", WingBeat.class)
                    .subscribe(
                        beat -> {
                          throw new IllegalStateException("host");
                        },
                        thrown -> {});
              }
              return chain;
            },
            (reader, chain) -> tablesOf(chain, to))
        .onThreads(threads)
        .run();
    Map<String, String> tables = new TreeMap<>();
    try (Stream<Path> files = Files.list(to)) {
      for (Path file : files.toList()) {
        tables.put(file.getFileName().toString(), Files.readString(file));
      }
    }
    return tables;
  }

  private static JobResults tablesOf(FilterChain chain, Path to) throws IOException {
    return OutletTables.open(
        chain,
        new OutletTables.Naming() {
          @Override
          public Path file(ChainStage stage, Outlet<?> outlet) {
            return to.resolve(outlet.name() + ".csv");
          }

          @Override
          public boolean isWritten(ChainStage stage, Outlet<?> outlet) {
            return !outlet.name().equals("measurements");
          }
        },
        file -> AtomicFile.create(file, false),
        TableMetadata.NONE);
  }
}
