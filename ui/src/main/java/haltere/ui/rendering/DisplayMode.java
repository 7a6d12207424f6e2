package haltere.ui.rendering;

/** Meaning of the colour of a pixel. */
public enum DisplayMode {
  /** The polarity of its last event, fading with age. */
  POLARITY("Polarity", false),
  /** The age of its last event, whatever its polarity. */
  TIME_SURFACE("Time surface", false),
  /** The sum of its events, each fading exponentially: ON brightens, OFF darkens. */
  INTENSITY("Intensity", true),
  /** How many events it had, fading with age. */
  COUNTS("Event count", true),
  /** As by polarity, ON events only. */
  ON_ONLY("ON only", false),
  /** As by polarity, OFF events only. */
  OFF_ONLY("OFF only", false),
  /** The frequency at which it flickers. */
  FREQUENCY("Frequency", true);

  private final String label;
  private final boolean gathers;

  DisplayMode(String label, boolean gathers) {
    this.label = label;
    this.gathers = gathers;
  }

  /** Label in menus, one or two words. */
  public String label() {
    return label;
  }

  /** Whether all events of a pixel count, not just its last one. */
  boolean gathers() {
    return gathers;
  }

  /** Whether events of a polarity are shown at all. */
  boolean shows(boolean on) {
    return this == ON_ONLY ? on : this != OFF_ONLY || !on;
  }
}
