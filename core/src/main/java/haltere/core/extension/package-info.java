/** Discovery of formats, filters, scenes, cameras and outputs in other jars. */
package haltere.core.extension;
