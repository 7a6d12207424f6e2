/** Start of the program: the launcher, and checks before a window opens. */
package haltere.ui;
