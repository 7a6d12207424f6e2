/** Where the program starts: the launcher, and what it must know before a window can open. */
package haltere.ui;
