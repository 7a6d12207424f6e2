/** The start page of a window without a recording. */
package haltere.ui.viewer.start;
