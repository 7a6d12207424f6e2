/** Where results come from: the program, its chain, and checksums of files. */
package haltere.core.pipeline.internal;
