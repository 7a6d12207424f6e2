package haltere.core.format.internal.aedat2;

import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Full scale of the inertial sensor of a DAVIS camera, from the settings of jAER in the header, or
 * its defaults.
 *
 * @param accelerationG acceleration of 32,768 steps, in standard gravities
 * @param rotationDegS rate of rotation of 32,768 steps, in degrees per second
 * @param stated whether the header states both
 */
record InertialRange(int accelerationG, int rotationDegS, boolean stated) {
  private static final Pattern ACCELERATION = Pattern.compile("\"ImuAccelScaleG(2|4|8|16)\"");
  private static final Pattern ROTATION =
      Pattern.compile("\"GyroFullScaleDegPerSec(250|500|1000|2000)\"");
  private static final int DEFAULT_G = 4;
  private static final int DEFAULT_DEG_S = 500;

  /** From the text of a header. */
  static InertialRange of(byte[] header) {
    String text = new String(header, StandardCharsets.ISO_8859_1);
    int acceleration = last(ACCELERATION, text);
    int rotation = last(ROTATION, text);
    return new InertialRange(
        acceleration == 0 ? DEFAULT_G : acceleration,
        rotation == 0 ? DEFAULT_DEG_S : rotation,
        acceleration != 0 && rotation != 0);
  }

  /** That the range is assumed, if the header does not state it. */
  Optional<String> remark() {
    return stated
        ? Optional.empty()
        : Optional.of(
            "the header does not state the range of the inertial sensor; "
                + accelerationG
                + " g and "
                + rotationDegS
                + " degrees a second, the usual ones, are assumed");
  }

  private static int last(Pattern pattern, String text) {
    int found = 0;
    for (Matcher matcher = pattern.matcher(text); matcher.find(); ) {
      found = Integer.parseInt(matcher.group(1));
    }
    return found;
  }
}
