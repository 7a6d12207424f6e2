/** Where packets and results go: files, tables, a mailbox for the screen. */
package haltere.core.sink;
