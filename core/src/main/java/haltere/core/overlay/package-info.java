/** Drawing as data: marks in sensor coordinates on a small canvas that knows no toolkit. */
package haltere.core.overlay;
