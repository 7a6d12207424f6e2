/** Plain text events, {@code t_us,x,y,on}, as array programs and spreadsheets read them. */
package haltere.core.format.csv;
