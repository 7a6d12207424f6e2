/** How formats, filters, scenes, cameras and outputs of other jars are found. */
package haltere.core.extension;
