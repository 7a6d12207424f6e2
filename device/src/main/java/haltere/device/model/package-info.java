/**
 * The cameras that are known: what each must be told, over USB, to start, to stop and to be set up.
 */
package haltere.device.model;
