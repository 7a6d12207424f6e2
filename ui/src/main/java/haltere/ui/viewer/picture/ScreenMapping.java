package haltere.ui.viewer.picture;

import haltere.ui.rendering.Letters;

/**
 * Maps the visible part of the sensor to pixels of the screen.
 *
 * @param fromX left edge of the part, in pixels of the sensor
 * @param fromY top edge of the part, in pixels of the sensor from its top
 * @param scale units of the view per pixel of the sensor
 * @param density pixels of the screen per unit of the view
 * @param columns pixels of the screen in a row
 * @param rows rows of pixels
 * @param left where the sensor's left edge is, units of the view from the left of the pixels
 * @param bottom where its bottom edge is, units of the view from the top of the pixels
 * @param letters draws the text of marks
 * @param marks whether marks of filters are drawn
 */
record ScreenMapping(
    double fromX,
    double fromY,
    double scale,
    double density,
    int columns,
    int rows,
    double left,
    double bottom,
    Letters letters,
    boolean marks) {}
