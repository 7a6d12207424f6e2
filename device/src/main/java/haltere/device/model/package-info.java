/** Drivers of the known cameras: their commands over USB to start, stop and configure. */
package haltere.device.model;
