/** Tables in Apache Parquet, found as a service; nothing else depends on this module. */
package haltere.columnar;
