package haltere.core.simulation.internal.flight;

/**
 * A detection in one camera's picture of {@link FlightScene}; a row of the table that {@code
 * haltere orient} reads.
 *
 * @param tUs time, microseconds
 * @param camera the camera's name
 * @param object number of the body, 0
 * @param xPx column of its centre
 * @param yPx row of its centre
 * @param angleRad angle of its line, modulo pi, in (−pi/2, pi/2]
 * @param areaPx area of its outline, square pixels
 * @param eccentricity long axis over short axis of its outline
 */
public record FlightDetection(
    long tUs,
    String camera,
    int object,
    double xPx,
    double yPx,
    double angleRad,
    double areaPx,
    double eccentricity) {}
