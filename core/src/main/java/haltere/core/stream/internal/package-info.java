/** Daemon threads, for all stages. Depends on no other package of Haltere. */
package haltere.core.stream.internal;
