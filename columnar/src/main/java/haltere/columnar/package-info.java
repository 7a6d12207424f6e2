/** Table format Apache Parquet, loaded as a service; no other module depends on this one. */
package haltere.columnar;
