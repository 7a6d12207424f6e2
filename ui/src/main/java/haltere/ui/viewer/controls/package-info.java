/** Buttons, icons, fields, dialogs and texts in one style. Depends on settings and units only. */
package haltere.ui.viewer.controls;
