package haltere.filters.wing;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.Unit;

/**
 * Manual position of the fly, as offsets from the estimate, which remain valid when the fly moves
 * or is found again.
 */
public record WingPositionSettings(
    @Help("Offset of the body from the estimated centre, to the right.")
        @Range(min = -1000, max = 1000)
        @Unit("px")
        double bodyOffsetXPx,
    @Help("Offset of the body from the estimated centre, upwards.")
        @Range(min = -1000, max = 1000)
        @Unit("px")
        double bodyOffsetYPx,
    @Help("Offset from the estimated heading, counterclockwise.")
        @Range(min = -3.141592653589793, max = 3.141592653589793)
        @Unit("rad")
        double headingOffsetRad,
    @Help("Exchanges head and tail.") boolean flipHeading,
    @Help("Offset from the estimated radius of the region of interest.")
        @Range(min = -500, max = 500)
        @Unit("px")
        double regionOffsetPx,
    @Help("Events nearer to the hinge than this are ignored.")
        @Range(min = 0, max = 200)
        @Unit("px")
        double innerRadiusPx,
    @Help(value = "Hinges follow the sway of the body.", label = "Hinge tracking")
        boolean followsHinges,
    @Help(value = "The heading follows the symmetry of the strokes.", label = "Heading tracking")
        boolean followsHeading) {}
