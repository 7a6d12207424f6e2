/**
 * Settings of a filter as an annotated immutable record, and the schema, text and JSON forms that
 * are read off it.
 */
package haltere.core.settings;
