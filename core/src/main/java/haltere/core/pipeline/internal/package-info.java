/** Provenance of results: the program, its chain, and checksums of files. */
package haltere.core.pipeline.internal;
