package haltere.testing.benchmark;

import haltere.core.event.EventPacket;
import haltere.core.simulation.internal.road.RoadScene;
import haltere.core.simulation.internal.road.RoadSceneSettings;
import haltere.filters.object.ObjectTrack;
import haltere.filters.object.ObjectTrackerFilter;
import haltere.filters.object.ObjectTrackerSettings;
import haltere.filters.plane.RoadMapping;
import haltere.filters.road.LineCounter;
import haltere.filters.road.RoadMotion;
import haltere.filters.road.VehiclePrior;
import haltere.filters.road.VehiclesOnRoad;
import haltere.testing.evaluation.RoadEvaluation;
import java.io.IOException;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import org.openjdk.jmh.infra.Blackhole;

/**
 * What a road adds to the object tracker: time of an event of a simulated road of 20 s, whose rows
 * are taken, without and with the motion of vehicles, their positions in metres and counting lines.
 *
 * <p>Run: {@code ./gradlew :src-test:jmh -Pbench=RoadBenchmark}
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 5, time = 2)
@Measurement(iterations = 5, time = 2)
public class RoadBenchmark {
  /** Objects in the picture alone, or vehicles as well. */
  @Param({"objects", "vehicles"})
  public String results;

  /** Time between two groups of vehicles: dense and free traffic. */
  @Param({"1", "5"})
  public String pauseS;

  private Workload workload;
  private ObjectTrackerFilter tracker;
  private Blackhole rows;

  /**
   * Makes the filter and the events.
   *
   * @param blackhole takes the results
   * @throws IOException never, for the scene is simulated
   */
  @Setup
  public void setUp(Blackhole blackhole) throws IOException {
    rows = blackhole;
    RoadSceneSettings settings =
        RoadSceneSettings.defaults()
            .with("run.seed=1", "run.durationS=20", "traffic.pauseS=" + pauseS);
    RoadScene scene = new RoadScene(settings);
    workload = Workload.of(scene);
    tracker = new ObjectTrackerFilter(scene.geometry(), ObjectTrackerSettings.defaults());
    tracker.tracks().subscribe(results.equals("vehicles") ? vehicles(scene) : rows::consume);
  }

  private Consumer<ObjectTrack> vehicles(RoadScene scene) {
    RoadMapping mapping = RoadEvaluation.mapping(scene);
    VehiclePrior prior = VehiclePrior.defaults();
    tracker.apply(new RoadMotion(mapping, prior));
    VehiclesOnRoad vehicles = new VehiclesOnRoad(mapping, prior);
    LineCounter counter =
        new LineCounter(RoadEvaluation.LANES, RoadEvaluation.LINES, rows::consume);
    return row -> vehicles.apply(row).ifPresent(counter);
  }

  /**
   * Filters a packet.
   *
   * @return its events
   */
  @Benchmark
  @OperationsPerInvocation(Workload.PACKET_EVENTS)
  public int filter() {
    if (workload.atStart()) {
      tracker.reset();
    }
    EventPacket packet = workload.nextPacket();
    tracker.process(packet);
    return packet.size();
  }
}
