/** The one place that knows a JSON library: text to plain Java maps and lists, and back. */
package haltere.core.json.internal;
