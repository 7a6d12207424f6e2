package haltere.device.model;

import haltere.core.camera.CameraProblem;
import haltere.core.camera.CameraProblem.Kind;
import haltere.device.protocol.DavisLayout;
import haltere.device.usb.UsbTransport;

/**
 * Properties of a DAVIS camera, as read from it.
 *
 * @param name of its chip
 * @param isSmall whether it is a DAVIS240, else a DAVIS346
 * @param layout of its words
 * @param adcClockMhz clock of exposures, as measured
 * @param usbClockMhz clock of USB delays, nominal
 * @param hasRegion whether it supports a region of interest
 * @param hasNoiseFilter whether it can drop events without neighbours
 * @param hasGlobalShutter whether it has a global shutter
 */
record DavisIdentity(
    String name,
    boolean isSmall,
    DavisLayout layout,
    double adcClockMhz,
    int usbClockMhz,
    boolean hasRegion,
    boolean hasNoiseFilter,
    boolean hasGlobalShutter) {
  /** The logic version whose words and parameters are known. */
  static final int LOGIC_VERSION = 18;

  private static final int LOGIC_PATCH = 1;
  private static final int MPU_9250 = 2;
  private static final int SWAPPED = 4;

  /** Reads the properties of a camera; rejects unknown logic or chips. */
  static DavisIdentity of(UsbTransport transport) throws CameraProblem {
    int version = DavisRegisters.get(transport, DavisRegisters.SYSTEM, 0);
    if (version != LOGIC_VERSION) {
      throw new CameraProblem(
          Kind.UNSUPPORTED,
          "this DAVIS has logic version "
              + version
              + ", and "
              + LOGIC_VERSION
              + " is needed; bring it up to date with the maker's program (flashy)");
    }
    int patch = DavisRegisters.get(transport, DavisRegisters.SYSTEM, 7);
    if (patch < LOGIC_PATCH) {
      throw new CameraProblem(
          Kind.UNSUPPORTED,
          "this DAVIS has patch "
              + patch
              + " of its logic, and "
              + LOGIC_PATCH
              + " is needed; bring it up to date with the maker's program (flashy)");
    }
    int chip = DavisRegisters.get(transport, DavisRegisters.SYSTEM, 1);
    String name =
        switch (chip) {
          case 0 -> "DAVIS240A";
          case 1 -> "DAVIS240B";
          case 2 -> "DAVIS240C";
          case 4 -> "DAVIS346A";
          case 5 -> "DAVIS346B";
          case 9 -> "DAVIS346C";
          default ->
              throw new CameraProblem(
                  Kind.UNSUPPORTED,
                  "this DAVIS has chip " + chip + "; supported are DAVIS240 and DAVIS346");
        };
    boolean isSmall = chip <= 2;
    double deviation = DavisRegisters.get(transport, DavisRegisters.SYSTEM, 6) / 1000.0;
    return new DavisIdentity(
        name,
        isSmall,
        layout(transport, isSmall),
        DavisRegisters.get(transport, DavisRegisters.SYSTEM, 4) * deviation,
        DavisRegisters.get(transport, DavisRegisters.SYSTEM, 5),
        DavisRegisters.get(transport, DavisRegisters.EVENTS, 40) != 0,
        DavisRegisters.get(transport, DavisRegisters.EVENTS, 30) != 0,
        DavisRegisters.get(transport, DavisRegisters.FRAMES, 6) != 0);
  }

  private static DavisLayout layout(UsbTransport transport, boolean isSmall) throws CameraProblem {
    try {
      return new DavisLayout(
          DavisRegisters.get(transport, DavisRegisters.EVENTS, 0),
          DavisRegisters.get(transport, DavisRegisters.EVENTS, 1),
          (DavisRegisters.get(transport, DavisRegisters.EVENTS, 2) & SWAPPED) != 0,
          DavisRegisters.get(transport, DavisRegisters.FRAMES, 2),
          DavisRegisters.get(transport, DavisRegisters.INERTIAL, 1),
          isSmall,
          DavisRegisters.get(transport, DavisRegisters.INERTIAL, 0) == MPU_9250);
    } catch (IllegalArgumentException impossible) {
      throw new CameraProblem(
          Kind.UNSUPPORTED, "this DAVIS reports an impossible sensor: " + impossible.getMessage());
    }
  }
}
