package haltere.filters.wing;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.Unit;

/**
 * What a person says about where the fly is, as offsets from what was found, so that it holds when
 * the fly is found again or moves.
 */
public record WingPositionSettings(
    @Help("Added to the centre that was found, to the right.")
        @Range(min = -1000, max = 1000)
        @Unit("px")
        double bodyOffsetXPx,
    @Help("Added to the centre that was found, upwards.")
        @Range(min = -1000, max = 1000)
        @Unit("px")
        double bodyOffsetYPx,
    @Help("Added to the heading that was found.")
        @Range(min = -3.141592653589793, max = 3.141592653589793)
        @Unit("rad")
        double headingOffsetRad,
    @Help("Exchanges head and tail.") boolean flipHeading,
    @Help("Added to the radius of the region of interest that was found.")
        @Range(min = -500, max = 500)
        @Unit("px")
        double regionOffsetPx,
    @Help("Events nearer to the hinge than this are left out.")
        @Range(min = 0, max = 200)
        @Unit("px")
        double innerRadiusPx,
    @Help("Whether the hinges follow the body as it sways.") boolean followsHinges,
    @Help("Whether the heading follows the body as it turns, by the symmetry of the strokes.")
        boolean followsHeading) {}
