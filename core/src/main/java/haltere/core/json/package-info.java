/** Errors of JSON texts. */
package haltere.core.json;
