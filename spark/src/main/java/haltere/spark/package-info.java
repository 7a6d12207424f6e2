/** One chain over many recordings on Apache Spark; no other module depends on this one. */
package haltere.spark;
