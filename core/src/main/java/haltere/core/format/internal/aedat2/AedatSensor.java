package haltere.core.format.internal.aedat2;

import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingProblem;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * The camera of an AEDAT file: by the header, else by the user's options, else by the addresses of
 * its records.
 *
 * @param layout layout of the address words
 * @param geometry the sensor
 * @param remarks assumptions, a line each
 */
record AedatSensor(AddressLayout layout, SensorGeometry geometry, List<String> remarks) {
  /** The two meanings of an address word. */
  public enum AddressLayout {
    /** {@link Dvs128AddressDecoder}. */
    DVS128,
    /** {@link DavisAddressDecoder}. */
    DAVIS
  }

  static final SensorGeometry DVS128_SIZE = new SensorGeometry(128, 128);

  private static final List<SensorGeometry> DAVIS_SIZES =
      List.of(
          new SensorGeometry(240, 180),
          new SensorGeometry(346, 260),
          new SensorGeometry(640, 480),
          new SensorGeometry(DavisAddressDecoder.MAX_WIDTH, DavisAddressDecoder.MAX_HEIGHT));

  /** Sizes by the chip's class in jAER, without its package and in lower case. */
  private static final Map<String, SensorGeometry> DAVIS_CHIPS =
      Map.of(
          "davis240", DAVIS_SIZES.get(0),
          "dvs240", DAVIS_SIZES.get(0),
          "sbret10", DAVIS_SIZES.get(0),
          "davis346", DAVIS_SIZES.get(1),
          "davis640", DAVIS_SIZES.get(2),
          "davisrgb", DAVIS_SIZES.get(2),
          "cdavis", DAVIS_SIZES.get(2),
          "davis208", new SensorGeometry(208, 192),
          "davis128", DVS128_SIZE,
          "scidvs", new SensorGeometry(126, 112));

  /** Copies the remarks. */
  public AedatSensor {
    remarks = List.copyOf(remarks);
  }

  /**
   * Determines the sensor.
   *
   * @param header of the file
   * @param options the user's options
   * @param file its bytes, read to the end if the header is not sufficient
   * @return the sensor, with remarks
   * @throws RecordingProblem if the camera has no event sensor, or no layout explains the
   *     addresses, and the user names neither format nor sensor
   * @throws IOException if the file cannot be read
   */
  public static AedatSensor of(AedatHeader header, ReadOptions options, RecordingFile file)
      throws IOException {
    List<String> remarks = new ArrayList<>();
    String chip = header.chip().map(name -> name.substring(name.lastIndexOf('.') + 1)).orElse("");
    String lower = chip.toLowerCase(Locale.ROOT);
    String hardware = header.hardware().orElse("").toLowerCase(Locale.ROOT);
    if (lower.startsWith("cochlea") && options.format().isEmpty()) {
      throw new RecordingProblem(
          file.path(),
          "its camera "
              + chip
              + " is a silicon cochlea, not a retina; --format aedat2 reads its words as pixels");
    }
    Optional<SensorGeometry> chipSize =
        DAVIS_CHIPS.entrySet().stream()
            .filter(entry -> lower.startsWith(entry.getKey()))
            .map(Map.Entry::getValue)
            .findFirst();
    Optional<SensorGeometry> stated = header.sensor().isPresent() ? header.sensor() : chipSize;
    AddressLayout layout;
    AddressEvidence evidence = null;
    if (lower.equals("dvs128") || lower.equals("tmpdiff128")) {
      return new AedatSensor(AddressLayout.DVS128, DVS128_SIZE, remarks);
    } else if (chipSize.isPresent() || lower.startsWith("davis")) {
      layout = AddressLayout.DAVIS;
    } else if (header.sensor().isPresent()) {
      layout =
          header.sensor().get().equals(DVS128_SIZE) ? AddressLayout.DVS128 : AddressLayout.DAVIS;
    } else if (chip.isEmpty() && hardware.startsWith("dvs128")) {
      return new AedatSensor(AddressLayout.DVS128, DVS128_SIZE, remarks);
    } else if (chip.isEmpty() && hardware.startsWith("davis")) {
      layout = AddressLayout.DAVIS;
    } else {
      evidence = AddressEvidence.of(file, header.dataOffset());
      boolean isLarge =
          options.sensor().filter(size -> size.longerSide() > DVS128_SIZE.width()).isPresent();
      layout = evidence.layout(isLarge);
      String unknown =
          chip.isEmpty() ? "the header names no camera" : "the camera " + chip + " is not known";
      String camera = layout == AddressLayout.DVS128 ? "DVS128" : "DAVIS";
      boolean isGuess = options.sensor().isEmpty() && options.format().isEmpty();
      if (isGuess && !evidence.isExplained(layout)) {
        throw new RecordingProblem(
            file.path(),
            String.format(
                Locale.ROOT,
                "%s, and its addresses are not events of a DVS128 or a DAVIS (%.0f %% of "
                    + "them fit a %s); name the sensor with --sensor WxH, or the --format",
                unknown,
                100 * evidence.explained(layout),
                camera));
      }
      if (options.sensor().isEmpty() || !evidence.isExplained(layout)) {
        remarks.add(unknown + "; its addresses look like a " + camera + "'s");
      }
    }
    if (stated.isPresent()) {
      return new AedatSensor(layout, stated.get(), remarks);
    }
    if (options.sensor().isPresent()) {
      return new AedatSensor(layout, options.sensor().get(), remarks);
    }
    if (layout == AddressLayout.DVS128) {
      return new AedatSensor(layout, DVS128_SIZE, remarks);
    }
    if (evidence == null) {
      evidence = AddressEvidence.of(file, header.dataOffset());
    }
    SensorGeometry guess = evidence.smallest(DAVIS_SIZES);
    remarks.add(
        "the header does not state the sensor's size; "
            + guess
            + " was taken from the addresses (--sensor WxH states it)");
    return new AedatSensor(layout, guess, remarks);
  }

  /**
   * The decoder of the layout.
   *
   * @return for the geometry
   */
  public AddressDecoder decoder() {
    return layout == AddressLayout.DVS128
        ? new Dvs128AddressDecoder(geometry)
        : new DavisAddressDecoder(geometry);
  }
}
