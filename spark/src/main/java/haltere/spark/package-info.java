/** One chain over many recordings on Apache Spark; nothing else depends on this module. */
package haltere.spark;
