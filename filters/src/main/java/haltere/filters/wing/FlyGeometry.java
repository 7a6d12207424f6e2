package haltere.filters.wing;

import haltere.core.sink.Column;

/**
 * Geometry of the fly. Pixels: x to the right, y up, origin at the centre of the bottom left one.
 *
 * @param centreX body centre, the middle between the hinges
 * @param centreY body centre
 * @param headingRad direction from tail to head, counterclockwise from +x, in [0, 2 pi)
 * @param sizePx radius of the region of interest about the hinges, about the length of a wing
 * @param leftHingeX hinge of the left wing
 * @param leftHingeY hinge of the left wing
 * @param rightHingeX hinge of the right wing
 * @param rightHingeY hinge of the right wing
 * @param headTailConfidence confidence of head and tail, 0 to 1
 * @param initialisedAtUs time at which the fly was found, microseconds
 */
public record FlyGeometry(
    @Column(decimals = 4) double centreX,
    @Column(decimals = 4) double centreY,
    @Column(decimals = 6) double headingRad,
    @Column(decimals = 3) double sizePx,
    @Column(decimals = 4) double leftHingeX,
    @Column(decimals = 4) double leftHingeY,
    @Column(decimals = 4) double rightHingeX,
    @Column(decimals = 4) double rightHingeY,
    @Column(decimals = 4) double headTailConfidence,
    long initialisedAtUs)
    implements WingResult {}
