/** Where the program keeps what belongs to a user. */
package haltere.ui.user;
