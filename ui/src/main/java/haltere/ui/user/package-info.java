/** Locations of a user's files. */
package haltere.ui.user;
