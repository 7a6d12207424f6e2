/** What is wrong with a JSON text. */
package haltere.core.json;
