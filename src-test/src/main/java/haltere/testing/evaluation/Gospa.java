package haltere.testing.evaluation;

import haltere.filters.estimation.Assignment;
import java.util.List;

/**
 * Generalised optimal sub-pattern assignment metric with p = 2 and α = 2, and its parts.
 *
 * <p>A. S. Rahmathullah, Á. F. García-Fernández and L. Svensson (2017), "Generalized optimal
 * sub-pattern assignment metric", FUSION, proposition 1: over all ways to pair truth with tracks,
 * the least of
 *
 * <pre>
 *   Σ of pairs d²  +  c²/2 · (missed objects + false tracks)
 * </pre>
 *
 * <p>of which GOSPA is the root. It knows no identities.
 *
 * @param mean GOSPA, over several frames its mean
 * @param localisation the pairs' part of the sum, over several frames its mean
 * @param missed the missed objects' part, likewise
 * @param falseTracks the false tracks' part, likewise
 */
public record Gospa(double mean, double localisation, double missed, double falseTracks) {
  /**
   * GOSPA of one frame.
   *
   * @param frame truth and tracks
   * @param cutOff c, the greatest distance of a pair, finite and positive
   * @return GOSPA and its parts
   */
  public static Gospa of(Frame frame, double cutOff) {
    return of(frame, cutOff, new Assignment(frame.truth().size(), frame.tracks().size()));
  }

  /**
   * GOSPA over time.
   *
   * @param frames truth and tracks
   * @param cutOff c, the greatest distance of a pair, finite and positive
   * @return means over the frames; NaN if there is none
   */
  public static Gospa of(Frames frames, double cutOff) {
    Assignment assignment = new Assignment(frames.mostTruth(), frames.mostTracks());
    int n = frames.list().size();
    double mean = 0;
    double localisation = 0;
    double missed = 0;
    double falseTracks = 0;
    for (Frame frame : frames.list()) {
      Gospa gospa = of(frame, cutOff, assignment);
      mean += gospa.mean;
      localisation += gospa.localisation;
      missed += gospa.missed;
      falseTracks += gospa.falseTracks;
    }
    return new Gospa(mean / n, localisation / n, missed / n, falseTracks / n);
  }

  /**
   * The root of the mean square.
   *
   * @return √(localisation + missed + falseTracks)
   */
  public double rms() {
    return Math.sqrt(localisation + missed + falseTracks);
  }

  private static Gospa of(Frame frame, double cutOff, Assignment assignment) {
    if (!(cutOff > 0) || Double.isInfinite(cutOff)) {
      throw new IllegalArgumentException("cut-off must be positive and finite: " + cutOff);
    }
    List<ObjectPoint> truth = frame.truth();
    List<ObjectPoint> tracks = frame.tracks();
    double half = cutOff * cutOff / 2;
    assignment.start(truth.size(), tracks.size());
    for (int i = 0; i < truth.size(); i++) {
      for (int j = 0; j < tracks.size(); j++) {
        double distance = truth.get(i).distanceTo(tracks.get(j));
        if (distance < cutOff) {
          assignment.setCost(i, j, distance * distance);
        }
      }
    }
    assignment.solve(half, half);
    double localisation = 0;
    int pairs = 0;
    for (int i = 0; i < truth.size(); i++) {
      int j = assignment.columnOf(i);
      if (j != Assignment.NONE) {
        double distance = truth.get(i).distanceTo(tracks.get(j));
        localisation += distance * distance;
        pairs++;
      }
    }
    double missed = half * (truth.size() - pairs);
    double falseTracks = half * (tracks.size() - pairs);
    double gospa = Math.sqrt(localisation + missed + falseTracks);
    return new Gospa(gospa, localisation, missed, falseTracks);
  }
}
