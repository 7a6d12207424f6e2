/**
 * What a person can do, once for all: menus, keys, the command palette and the list of keys are
 * made from the same {@code ViewerAction}s. The table {@code actions.txt} says of each command
 * where it stands, what it is called, its key and its help.
 */
package haltere.ui.viewer.action;
