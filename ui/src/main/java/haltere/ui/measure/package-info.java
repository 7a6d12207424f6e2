/**
 * Numbers about a part of the picture: how many events it has and how regularly they come. Knows no
 * toolkit.
 */
package haltere.ui.measure;
