package haltere.testing.evaluation;

import java.util.HashMap;
import java.util.Map;

/**
 * How far tracks are from the objects they stand for. Errors are those of the plane, so the square
 * of an RMSE is the sum of those of its two axes. NaN where there is nothing to take a mean of.
 *
 * @param pairs pairs with positions
 * @param positionRmse root of the mean squared distance
 * @param velocityPairs pairs of settled tracks in which both velocities are known
 * @param velocityRmse root of the mean squared difference of the velocities
 * @param relativeVelocityRmse the same over the root of the mean squared true speed
 * @param speedBias mean of estimated over true speed, less 1, over the pairs that truly move
 * @param speedDeviation standard deviation of estimated over true speed of these
 */
public record Accuracy(
    long pairs,
    double positionRmse,
    long velocityPairs,
    double velocityRmse,
    double relativeVelocityRmse,
    double speedBias,
    double speedDeviation) {
  /**
   * Computes the errors.
   *
   * @param frames truth and tracks, for the age of the tracks
   * @param correspondences which stands for which in these frames
   * @param settledUs from which age on, since its first row, the velocity of a track counts
   * @return the errors
   */
  public static Accuracy of(Frames frames, Correspondences correspondences, long settledUs) {
    Map<Integer, Long> bornUs = new HashMap<>();
    for (Frame frame : frames.list()) {
      frame.tracks().forEach(track -> bornUs.putIfAbsent(track.id(), track.timeUs()));
    }
    double positions = 0;
    long velocityPairs = 0;
    double velocities = 0;
    double speeds = 0;
    long moving = 0;
    double ratioMean = 0;
    double ratioSquares = 0;
    for (Match match : correspondences.matches()) {
      ObjectPoint truth = match.truth();
      ObjectPoint track = match.track();
      double distance = truth.distanceTo(track);
      positions += distance * distance;
      boolean settled = track.timeUs() - bornUs.get(track.id()) >= settledUs;
      if (settled && !Double.isNaN(truth.speed()) && !Double.isNaN(track.speed())) {
        double error = Math.hypot(track.vx() - truth.vx(), track.vy() - truth.vy());
        velocities += error * error;
        speeds += truth.speed() * truth.speed();
        velocityPairs++;
        if (truth.speed() > 0) {
          // Welford's running mean and sum of squares.
          double ratio = track.speed() / truth.speed();
          double difference = ratio - ratioMean;
          moving++;
          ratioMean += difference / moving;
          ratioSquares += difference * (ratio - ratioMean);
        }
      }
    }
    long pairs = correspondences.matches().size();
    return new Accuracy(
        pairs,
        Math.sqrt(positions / pairs),
        velocityPairs,
        Math.sqrt(velocities / velocityPairs),
        Math.sqrt(velocities / speeds),
        moving == 0 ? Double.NaN : ratioMean - 1,
        Math.sqrt(ratioSquares / moving));
  }
}
