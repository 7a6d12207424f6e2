/** The open file: its facts in a panel, its warnings in a banner. */
package haltere.ui.viewer.file;
