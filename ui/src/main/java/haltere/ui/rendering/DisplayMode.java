package haltere.ui.rendering;

/** What the colour of a pixel says about its events. */
public enum DisplayMode {
  /** The polarity of its last event, fading with age. */
  POLARITY("Polarity", "Each pixel in the colour of its last event, fading with age.", false),
  /** The age of its last event, whatever its polarity. */
  TIME_SURFACE("Time surface", "How long ago each pixel had its last event.", false),
  /** The sum of its events, each fading exponentially: ON brightens, OFF darkens. */
  INTENSITY("Intensity", "ON events brighten, OFF events darken, and all fade with age.", true),
  /** How many events it had, fading with age. */
  COUNTS("Event count", "How many events each pixel had, whatever their polarity.", true),
  /** As by polarity, ON events only. */
  ON_ONLY("ON only", "ON events only, fading with age.", false),
  /** As by polarity, OFF events only. */
  OFF_ONLY("OFF only", "OFF events only, fading with age.", false),
  /** The frequency at which it flickers. */
  FREQUENCY("Frequency", "The frequency at which each pixel flickers, 5 Hz to 1 kHz.", true);

  private final String words;
  private final String help;
  private final boolean gathers;

  DisplayMode(String words, String help, boolean gathers) {
    this.words = words;
    this.help = help;
    this.gathers = gathers;
  }

  /** What a menu calls it, one or two words. */
  public String words() {
    return words;
  }

  /** What it shows, one sentence. */
  public String help() {
    return help;
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
