/**
 * What a person can do, once for all: menus, keys, the command palette and the list of keys are
 * made from the same {@code ViewerAction}s.
 */
package haltere.ui.viewer.action;
