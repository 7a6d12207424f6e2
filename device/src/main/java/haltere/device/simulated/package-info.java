/** Scenes that behave as cameras: live, tunable, and lossy when nobody takes their events. */
package haltere.device.simulated;
