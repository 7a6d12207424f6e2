package haltere.testing.objects;

import haltere.core.event.EventPacket;
import haltere.core.stream.EventSource;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.filters.object.*;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/** The prototype tracker under test: Proto SET FIRST SEEDS. */
public final class Proto {
  private Proto() {}

  public static void main(String[] args) throws IOException {
    String set = args[0];
    long first = args.length > 1 ? Long.parseLong(args[1]) : 1;
    int seeds = args.length > 2 ? Integer.parseInt(args[2]) : 3;
    double idf = 0;
    double mota = 0;
    int n = 0;
    java.util.Map<String, List<Double>> kinds = new java.util.LinkedHashMap<>();
    for (SceneSets.Later later : SceneSets.of(set, first, seeds)) {
      ObjectScene scene = later.make();
      if (args.length > 3 && !scene.name().contains(args[3])) {
        continue;
      }
      List<TrackRow> rows = new ArrayList<>();
      long start = System.nanoTime();
      long[] events = {0};
      try (EventSource source = scene.events().open()) {
        ObjectTrackerFilter tracker = new ObjectTrackerFilter(source.geometry(), ObjectTrackerSettings.defaults());
        tracker.tracks().subscribe(r -> rows.add(new TrackRow(r.timeUs(), r.id(), r.xPx(), r.yPx(), r.vxPxS(), r.vyPxS(), r.sdXPx(), r.sdYPx(), r.sdVxPxS(), r.sdVyPxS(), r.majorPx(), r.minorPx(), r.angleRad())));
        source.drainTo(
            new StreamHandler() {
              @Override
              public void packet(EventPacket packet) {
                tracker.process(packet);
                events[0] += packet.size();
              }

              @Override
              public void notified(StreamNotification notification) { tracker.notified(notification); }
            });
      }
      double ns = (System.nanoTime() - start) / (double) Math.max(1, events[0]);
      ObjectScore score = ObjectScore.of(scene, rows);
      if (System.getProperty("brief") != null) {
        System.out.printf("%s %.2f/%.2f ", scene.name().substring(0, Math.min(14, scene.name().length())), score.idf1(), score.mota());
      } else System.out.printf(
          "%-40s IDF1 %.3f MOTA %6.3f HOTA %.3f cov %.3f on %.2f ids %.1f else %.3f off %.2f sw %d lat %.2f vel %.1f%%  %.0f ns/ev%n",
          scene.name(), score.idf1(), score.mota(), score.hota(), score.covered(), score.tracksOnIt(),
          score.identities(), score.elsewhere(), score.offCentre(), score.switches(), score.latencyS(),
          100 * score.accuracy().relativeVelocityRmse(), ns);
      if (System.getProperty("sheet") != null) {
        ContactSheet.draw(scene, rows, java.nio.file.Path.of(System.getProperty("sheet")));
      }
      kinds.computeIfAbsent(scene.kind(), k -> new ArrayList<>()).add(score.idf1());
      idf += score.idf1();
      mota += score.mota();
      n++;
      if (System.getProperty("dump") != null) {
        try (java.io.PrintWriter w = new java.io.PrintWriter(System.getProperty("dump") + "/" + scene.name() + ".csv")) {
          w.println("t_us,id,x_px,y_px,vx_px_s,vy_px_s,major_px,minor_px,angle_rad");
          for (TrackRow r : rows) {
            w.printf("%d,%d,%.2f,%.2f,%.2f,%.2f,%.2f,%.2f,%.3f%n", r.timeUs(), r.id(), r.xPx(), r.yPx(), r.vxPxS(), r.vyPxS(), r.majorPx(), r.minorPx(), r.angleRad());
          }
        }
      }
    }
    if (System.getProperty("brief") != null) System.out.println();
    if (System.getProperty("brief") == null) kinds.forEach((k, v) -> System.out.printf("%-30s %.3f worst %.3f (%d)%n", k, v.stream().mapToDouble(x -> x).average().orElse(0), v.stream().mapToDouble(x -> x).min().orElse(0), v.size()));
    System.out.printf("ALL IDF1 %.4f MOTA %.4f over %d%n", idf / n, mota / n, n);
  }
}
