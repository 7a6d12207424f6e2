package haltere.core.simulation.internal.fly;

import haltere.core.simulation.internal.sensor.SeededRandom;

/**
 * The manoeuvres of a fly as a function of time: one in each slot of a grid, at a seeded time in
 * it. Slots take turns: a step of the frequency, a step of the amplitudes against each other, a
 * saccade. All are over before the slot ends, so that the sum of those before a time has a closed
 * form.
 *
 * <p>Thread rule: immutable.
 */
final class Manoeuvres {
  /** A saccade lasts 80 ms (35 degrees on a magnetic tether, Bender and Dickinson 2006). */
  static final double SACCADE_S = 0.08;

  private static final int KINDS = 3;
  private static final double SETTLED = 16;

  private final ManoeuvreSettings settings;
  private final long seed;
  private final double slotS;
  private final double slack;

  Manoeuvres(ManoeuvreSettings settings, long seed) {
    this.settings = settings;
    this.seed = seed;
    double busy = Math.max(settings.holdS(), SACCADE_S) + SETTLED * settings.timeConstantS();
    slotS = settings.everyS() == 0 ? 0 : Math.max(settings.everyS(), busy);
    slack = slotS - busy;
  }

  private boolean none(double seconds) {
    return slotS == 0 || seconds < 0;
  }

  private long slot(double seconds) {
    return (long) Math.floor(seconds / slotS);
  }

  /** Start of the manoeuvre of a slot, seconds from the beginning of the scene. */
  double beginS(long slot) {
    return slot * slotS + slack * SeededRandom.firstDouble(seed, "manoeuvre", slot);
  }

  private int sign(String purpose, long item) {
    return (SeededRandom.firstLong(seed, purpose, item) & 1) == 0 ? 1 : -1;
  }

  /** Change of the frequency, hertz. */
  double frequencyHz(double seconds) {
    if (none(seconds) || slot(seconds) % KINDS != 0) {
      return 0;
    }
    return settings.frequencyStepHz() * step(seconds - beginS(slot(seconds)));
  }

  /** Integral of {@link #frequencyHz} from the beginning, cycles. */
  double cycles(double seconds) {
    if (none(seconds)) {
      return 0;
    }
    long slot = slot(seconds);
    double over = (slot + KINDS - 1) / KINDS * settings.holdS();
    if (slot % KINDS == 0) {
      over += stepIntegral(seconds - beginS(slot));
    }
    return settings.frequencyStepHz() * over;
  }

  /** Amplitude of the left wing over that of the right, radians. */
  double asymmetryRad(double seconds) {
    if (none(seconds)) {
      return 0;
    }
    long slot = slot(seconds);
    double since = seconds - beginS(slot);
    return switch ((int) (slot % KINDS)) {
      case 1 -> sign("asymmetry", slot) * settings.asymmetryRad() * step(since);
      case 2 -> {
        // The outer wing has the larger amplitude: the right one in a turn to the left.
        double share = Math.min(1, Math.max(0, since / SACCADE_S));
        double bump = StrictMath.sin(Math.PI * share);
        yield -turnSign(slot / KINDS) * settings.asymmetryRad() * bump * bump;
      }
      default -> 0;
    };
  }

  /** Turn of the heading by all saccades so far, radians. */
  double turnRad(double seconds) {
    if (none(seconds) || settings.turnRad() == 0) {
      return 0;
    }
    long slot = slot(seconds);
    long saccade = slot / KINDS;
    double turned = saccade % 2 == 1 ? turnSign(saccade - 1) : 0;
    if (slot % KINDS == 2) {
      double share = Math.min(1, Math.max(0, (seconds - beginS(slot)) / SACCADE_S));
      turned += turnSign(saccade) * share * share * (3 - 2 * share);
    }
    return turned * settings.turnRad();
  }

  /** Saccades come in pairs of opposite turns, the first of which is to a seeded side. */
  private int turnSign(long saccade) {
    int first = sign("turn", saccade / 2);
    return saccade % 2 == 0 ? first : -first;
  }

  private double step(double since) {
    double tau = settings.timeConstantS();
    double hold = settings.holdS();
    if (since <= 0) {
      return 0;
    }
    return since <= hold
        ? 1 - StrictMath.exp(-since / tau)
        : (1 - StrictMath.exp(-hold / tau)) * StrictMath.exp(-(since - hold) / tau);
  }

  private double stepIntegral(double since) {
    double tau = settings.timeConstantS();
    double hold = settings.holdS();
    if (since <= 0) {
      return 0;
    }
    double rise = Math.min(since, hold);
    double area = rise - tau * (1 - StrictMath.exp(-rise / tau));
    if (since > hold) {
      area += tau * (1 - StrictMath.exp(-hold / tau)) * (1 - StrictMath.exp(-(since - hold) / tau));
    }
    return area;
  }
}
