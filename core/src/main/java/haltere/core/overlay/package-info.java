/**
 * Drawing as data: marks in sensor coordinates on a small canvas that is independent of a toolkit.
 */
package haltere.core.overlay;
