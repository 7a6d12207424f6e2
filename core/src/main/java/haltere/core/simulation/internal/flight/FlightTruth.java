package haltere.core.simulation.internal.flight;

/**
 * The truth about the body of {@link FlightScene} at one time.
 *
 * @param tUs time on the clock of the events, microseconds
 * @param xM position, metres
 * @param yM position, metres
 * @param zM position, metres
 * @param vxMS velocity, metres a second
 * @param vyMS velocity, metres a second
 * @param vzMS velocity, metres a second
 * @param ux axis, a unit vector from tail to head
 * @param uy axis
 * @param uz axis
 */
public record FlightTruth(
    long tUs,
    double xM,
    double yM,
    double zM,
    double vxMS,
    double vyMS,
    double vzMS,
    double ux,
    double uy,
    double uz) {}
