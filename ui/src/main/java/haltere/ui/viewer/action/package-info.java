/**
 * Commands: menus, keys, command palette and list of keys are built from the same {@code
 * ViewerAction}s. The table {@code actions.txt} has menu, name, key and help of each.
 */
package haltere.ui.viewer.action;
