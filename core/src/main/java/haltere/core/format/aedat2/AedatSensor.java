package haltere.core.format.aedat2;

import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * Decides which camera an AEDAT file comes from: by the header, else by what the user says, else by
 * the addresses of its first records.
 *
 * @param layout how to read the address words
 * @param geometry the sensor
 * @param remarks what was assumed, a line each
 */
public record AedatSensor(Layout layout, SensorGeometry geometry, List<String> remarks) {
  /** The two meanings of an address word. */
  public enum Layout {
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

  /** Sizes by how the chip's class is called in jAER, without its package and in lower case. */
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
   * Decides.
   *
   * @param header of the file
   * @param options what the user says
   * @param records whole 8-byte records of the file's start, or an empty buffer
   * @return the decision with its reasons
   */
  public static AedatSensor of(AedatHeader header, ReadOptions options, ByteBuffer records) {
    List<String> remarks = new ArrayList<>();
    String chip = header.chip().map(name -> name.substring(name.lastIndexOf('.') + 1)).orElse("");
    String lower = chip.toLowerCase(Locale.ROOT);
    String hardware = header.hardware().orElse("").toLowerCase(Locale.ROOT);
    Addresses addresses = new Addresses(records);
    Optional<SensorGeometry> chipSize =
        DAVIS_CHIPS.entrySet().stream()
            .filter(entry -> lower.startsWith(entry.getKey()))
            .map(Map.Entry::getValue)
            .findFirst();
    Optional<SensorGeometry> stated = header.sensor().isPresent() ? header.sensor() : chipSize;
    Layout layout;
    if (lower.equals("dvs128") || lower.equals("tmpdiff128")) {
      return new AedatSensor(Layout.DVS128, DVS128_SIZE, remarks);
    } else if (chipSize.isPresent() || lower.startsWith("davis")) {
      layout = Layout.DAVIS;
    } else if (header.sensor().isPresent()) {
      layout = header.sensor().get().equals(DVS128_SIZE) ? Layout.DVS128 : Layout.DAVIS;
    } else if (chip.isEmpty() && hardware.startsWith("dvs128")) {
      return new AedatSensor(Layout.DVS128, DVS128_SIZE, remarks);
    } else if (chip.isEmpty() && hardware.startsWith("davis")) {
      layout = Layout.DAVIS;
    } else {
      layout = addresses.layout(options.sensor());
      if (options.sensor().isEmpty()) {
        remarks.add(
            (chip.isEmpty() ? "the header names no camera" : "the camera " + chip + " is not known")
                + "; its addresses look like a "
                + (layout == Layout.DVS128 ? "DVS128's" : "DAVIS's"));
      }
    }
    if (stated.isPresent()) {
      return new AedatSensor(layout, stated.get(), remarks);
    }
    if (options.sensor().isPresent()) {
      return new AedatSensor(layout, options.sensor().get(), remarks);
    }
    if (layout == Layout.DVS128) {
      return new AedatSensor(layout, DVS128_SIZE, remarks);
    }
    SensorGeometry guess = addresses.davisSize();
    remarks.add(
        "the header does not say how large the sensor is; "
            + guess
            + " was taken from the first addresses (--sensor WxH states it)");
    return new AedatSensor(layout, guess, remarks);
  }

  /**
   * The decoder of the layout.
   *
   * @return for the geometry
   */
  public AddressDecoder decoder() {
    return layout == Layout.DVS128
        ? new Dvs128AddressDecoder(geometry)
        : new DavisAddressDecoder(geometry);
  }

  /**
   * What the addresses at the start of a file tell. Early records weigh most, because a damaged
   * place in a file shifts all records behind it.
   */
  private static final class Addresses {
    private double fitDvs128;
    private double fitDavis;
    private int maxX;
    private int maxY;

    Addresses(ByteBuffer records) {
      double place = 4;
      for (int at = records.position(); at + 8 <= records.limit(); at += 8) {
        int word = records.getInt(at);
        double weight = 1 / (place * place);
        place++;
        fitDvs128 += (word & 0x7fff_0000) == 0 ? weight : 0;
        if (word < 0 || (word & 0x400) != 0) {
          // A sample or an external input; of the latter only the lowest bits carry more.
          fitDavis += word < 0 || (word & 0x3f8) == 0 ? weight : 0;
        } else if ((word & 0x3ff) == 0) {
          fitDavis += weight;
          maxX = Math.max(maxX, word >>> 12 & 0x3ff);
          maxY = Math.max(maxY, word >>> 22);
        }
      }
    }

    Layout layout(Optional<SensorGeometry> sensor) {
      if (fitDvs128 != fitDavis) {
        return fitDvs128 > fitDavis ? Layout.DVS128 : Layout.DAVIS;
      }
      boolean large = sensor.isPresent() && sensor.get().longerSide() > 128;
      return large ? Layout.DAVIS : Layout.DVS128;
    }

    SensorGeometry davisSize() {
      return DAVIS_SIZES.stream()
          .filter(size -> size.contains(maxX, maxY))
          .findFirst()
          .orElseThrow();
    }
  }
}
