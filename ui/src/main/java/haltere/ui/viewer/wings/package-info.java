/** Tracked wings: where the fly is, the numbers of the wing's filters, logs. */
package haltere.ui.viewer.wings;
