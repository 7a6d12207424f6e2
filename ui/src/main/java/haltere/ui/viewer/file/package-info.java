/** What is known of the file that is open: its facts in a panel, its warnings in a banner. */
package haltere.ui.viewer.file;
