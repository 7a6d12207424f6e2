/** Tracked wings: position of the fly, numbers of the filters, logs. */
package haltere.ui.viewer.wings;
