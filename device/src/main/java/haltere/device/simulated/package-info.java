/** Scenes that behave as cameras: live, tunable, and with losses if the consumer is too slow. */
package haltere.device.simulated;
