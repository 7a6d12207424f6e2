/** The page that a window without a recording begins with. */
package haltere.ui.viewer.start;
