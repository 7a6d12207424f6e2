package haltere.testing.benchmark;

import haltere.core.chain.EventFilter;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * What tracks cost on top of clusters, measured by turns: both take the same pieces of 65,536
 * events one after the other in one program, so that what else the machine does slows down both. A
 * run gives the median over pieces, of the times and of their ratio; as the compiler makes other
 * choices in each program, several are run.
 *
 * <p>Run: {@code ./gradlew :src-test:tracksByTurns [-Pruns=10]}
 */
public final class TracksByTurns {
  private static final int PIECE_PACKETS = 16;
  private static final int WARMING_PIECES = 320;
  private static final int PIECES = 480;

  /** So many pieces in a row are filtered first by the same filter. */
  private static final int FIRST_PIECES = 16;

  private TracksByTurns() {}

  /**
   * Runs programs that measure, or measures.
   *
   * @param arguments how many programs, or the word "measure" and a share of noise
   * @throws IOException if a program cannot be started
   */
  public static void main(String[] arguments) throws IOException {
    if (arguments[0].equals("measure")) {
      measure(TwentyDots.events(Double.parseDouble(arguments[1])));
      return;
    }
    int runs = Integer.parseInt(arguments[0]);
    for (String noiseShare : List.of("0", "0.5")) {
      List<double[]> results = new ArrayList<>();
      for (int run = 0; run < runs; run++) {
        results.add(measured(noiseShare));
      }
      print(noiseShare, results);
    }
  }

  /** Starts a program, and gives back its medians: of clusters, of tracks, of their ratio. */
  private static double[] measured(String noiseShare) throws IOException {
    Process process =
        new ProcessBuilder(
                ProcessHandle.current().info().command().orElse("java"),
                "-XX:+UseSerialGC",
                "-cp",
                System.getProperty("java.class.path"),
                TracksByTurns.class.getName(),
                "measure",
                noiseShare)
            .redirectError(ProcessBuilder.Redirect.INHERIT)
            .start();
    try (var output = process.getInputStream()) {
      String line = new String(output.readAllBytes(), StandardCharsets.UTF_8).strip();
      if (line.isEmpty()) {
        throw new IOException("the program that measures ended without a word");
      }
      return Arrays.stream(line.split(" ")).mapToDouble(Double::parseDouble).toArray();
    }
  }

  private static void measure(Workload events) {
    Turn clusters = new Turn(TwentyDots.clusters(), events);
    Turn tracks = new Turn(TwentyDots.tracks(), events.again());
    double[] ofClusters = new double[PIECES];
    double[] ofTracks = new double[PIECES];
    double[] ratios = new double[PIECES];
    for (int piece = -WARMING_PIECES; piece < PIECES; piece++) {
      // The first of the two finds the events less near, so they take turns at that as well.
      boolean clustersFirst = Math.floorMod(piece / FIRST_PIECES, 2) == 0;
      double first = (clustersFirst ? clusters : tracks).nanosecondsAnEvent();
      double second = (clustersFirst ? tracks : clusters).nanosecondsAnEvent();
      if (piece >= 0) {
        ofClusters[piece] = clustersFirst ? first : second;
        ofTracks[piece] = clustersFirst ? second : first;
        ratios[piece] = ofTracks[piece] / ofClusters[piece];
      }
    }
    System.out.println(median(ofClusters) + " " + median(ofTracks) + " " + median(ratios));
  }

  /** One of the two filters, and where it is in the events. */
  private record Turn(EventFilter filter, Workload events) {
    /** Filters the next piece. */
    double nanosecondsAnEvent() {
      long startNs = System.nanoTime();
      for (int k = 0; k < PIECE_PACKETS; k++) {
        if (events.atStart()) {
          filter.reset();
        }
        filter.process(events.nextPacket());
      }
      return (System.nanoTime() - startNs) / (double) (PIECE_PACKETS * Workload.PACKET_EVENTS);
    }
  }

  private static double median(double[] values) {
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    return sorted[sorted.length / 2];
  }

  private static void print(String noiseShare, List<double[]> results) {
    System.out.printf(
        Locale.ROOT,
        "%s of the events noise: clusters %s ns an event, tracks %s ns, ratio %s%n",
        noiseShare,
        meanAndError(results, 0, "%.1f"),
        meanAndError(results, 1, "%.1f"),
        meanAndError(results, 2, "%.3f"));
  }

  private static String meanAndError(List<double[]> results, int index, String format) {
    double[] values = results.stream().mapToDouble(result -> result[index]).toArray();
    double mean = Arrays.stream(values).average().orElse(Double.NaN);
    double squares = Arrays.stream(values).map(value -> (value - mean) * (value - mean)).sum();
    double error = Math.sqrt(squares / (values.length * Math.max(1.0, values.length - 1)));
    return String.format(Locale.ROOT, format + " +- " + format, mean, error);
  }
}
