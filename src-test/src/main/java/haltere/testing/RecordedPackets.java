package haltere.testing;

import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.json.internal.Json;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * Properties of a real recording, as determined by independent programs. They are in {@code
 * recorded-packets.json}. Coordinates are the source's own: rows count from the corner that {@code
 * sensor} names.
 *
 * @param file its name in {@link Recorded#folder()}
 * @param format name of its format
 * @param sensor its size
 * @param on number of ON events
 * @param off number of OFF events
 * @param firstUs time of the first event
 * @param lastUs time of the last event
 * @param minX leftmost column with an event
 * @param maxX rightmost column with an event
 * @param minY lowest row with an event
 * @param maxY highest row with an event
 * @param head its first five events
 * @param tail its last two events
 * @param crc32 of all events, as {@link StreamRecorder#crc32()} forms it
 * @param otherWords words that are not polarity events
 */
public record RecordedPackets(
    String file,
    String format,
    SensorGeometry sensor,
    long on,
    long off,
    long firstUs,
    long lastUs,
    int minX,
    int maxX,
    int minY,
    int maxY,
    List<EventRow> head,
    List<EventRow> tail,
    String crc32,
    long otherWords) {
  /**
   * An event in plain numbers.
   *
   * @param timeUs microseconds
   * @param x column
   * @param y row
   * @param on 1 for ON, 0 for OFF
   */
  public record EventRow(long timeUs, int x, int y, int on) {}

  private static final Map<String, RecordedPackets> CATALOGUE = catalogue();

  /** Tmpdiff128, 2007: the oldest format. */
  public static final RecordedPackets TMPDIFF128 = known("dvs128-tmpdiff128-2007.dat");

  /** DVS128, a dark box moved before the camera; the header names no chip. */
  public static final RecordedPackets DARK_BOX = known("dvs128-moving-dark-box.aedat");

  /** The first events of {@link #DARK_BOX}, in the repository. */
  public static final RecordedPackets DARK_BOX_CUT = known("dvs128-moving-dark-box-cut.aedat");

  /** DVS128, a person walking; the header names the chip and has no end line. */
  public static final RecordedPackets WALKING = known("dvs128-walking-10s.aedat");

  /** DVS128, a pendulum; the header has its end line. */
  public static final RecordedPackets PENDULUM = known("dvs128-pendulum.aedat");

  /** DAVIS240C, a rotating disk, with frames and inertial samples in between. */
  public static final RecordedPackets ROTATING_DISK =
      known("davis240c-rotating-disk-imu-aps.aedat");

  /** A synthetic bar that turns, in the DAVIS's layout; the header names no chip. */
  public static final RecordedPackets ROTATING_BAR = known("synthetic-rotating-bar.aedat");

  /**
   * The recordings of jAER's old formats.
   *
   * @return AEDAT-1.0 first
   */
  public static List<RecordedPackets> aedat() {
    return List.of(
        TMPDIFF128, DARK_BOX_CUT, DARK_BOX, WALKING, PENDULUM, ROTATING_DISK, ROTATING_BAR);
  }

  /** Prophesee Gen3, dense; the header states no size. */
  public static final RecordedPackets GEN3_EVT2 = known("gen3-evt2.raw");

  /** The same events in words of EVT2.1 whose halves are swapped, written by another program. */
  public static final RecordedPackets GEN3_EVT21 =
      GEN3_EVT2.as("gen3-evt21-by-evutils.raw", "evt21");

  /** IMX636, sparse: hardly any vector words. */
  public static final RecordedPackets IMX636_EVT3 = known("imx636-evt3.raw");

  /** Prophesee Gen4, the scene of {@link #IMX636_EVT3} on another clock. */
  public static final RecordedPackets GEN4_DAT = known("gen4.dat");

  /** N-CARS, events of the kind 2D; the header states no size. */
  public static final RecordedPackets NCARS_DAT = known("ncars-sample.dat");

  /** Event Stream, DVS. */
  public static final RecordedPackets DVS_ES = known("dvs.es");

  /** A digit of N-MNIST. */
  public static final RecordedPackets NMNIST = known("nmnist-sample.bin");

  /**
   * The recordings of Prophesee's raw formats.
   *
   * @return EVT2 first
   */
  public static List<RecordedPackets> prophesee() {
    return List.of(GEN3_EVT2, GEN3_EVT21, IMX636_EVT3, GEN4_DAT, NCARS_DAT);
  }

  /**
   * The recordings of Event Stream and of data sets.
   *
   * @return Event Stream first
   */
  public static List<RecordedPackets> dataSets() {
    return List.of(DVS_ES, NMNIST);
  }

  /** DVS128, a hand's gesture, recorded by DV in 2024. */
  public static final RecordedPackets DVS128_GESTURE = known("dvs128-gesture.aedat4");

  /** DAVIS346, with packets of frames, inertial samples and triggers in between. */
  public static final RecordedPackets DAVIS346_FRAMES = known("davis346-events-frames-imu.aedat4");

  /** DVXplorer, with packets of inertial samples in between. */
  public static final RecordedPackets DVXPLORER = known("dvxplorer-sample.aedat4");

  /** A bag of ROS 1, Prophesee, whose words are EVT3. */
  public static final RecordedPackets EVT3_BAG = known("evt3-eventpacket.bag");

  /** The first chunk of {@link #EVT3_BAG}, in the repository. */
  public static final RecordedPackets EVT3_BAG_CUT = known("evt3-eventpacket-cut.bag");

  /** A bag of ROS 2 in an SQLite file, Prophesee, with external triggers among the words. */
  public static final RecordedPackets TRIGGERS_BAG = known("evt3-with-triggers.db3");

  /**
   * The recordings of ROS.
   *
   * @return ROS 1 first
   */
  public static List<RecordedPackets> ros() {
    return List.of(EVT3_BAG_CUT, EVT3_BAG, TRIGGERS_BAG);
  }

  /**
   * The recordings of DV.
   *
   * @return AEDAT-4.0
   */
  public static List<RecordedPackets> dv() {
    return List.of(DVS128_GESTURE, DAVIS346_FRAMES, DVXPLORER);
  }

  /** The events of {@link #DAVIS346_FRAMES} as eventcv writes HDF5: deflate and shuffle. */
  public static final RecordedPackets EVENTCV_HDF5 =
      DAVIS346_FRAMES.as("davis346-by-eventcv.h5", "hdf5");

  /** The same as evutils writes them, of the DSEC kind: Blosc with Zstandard. */
  public static final RecordedPackets EVUTILS_HDF5 =
      DAVIS346_FRAMES.as("davis346-by-evutils.h5", "hdf5");

  /**
   * The recordings in HDF5, which hold the events of {@link #DAVIS346_FRAMES}.
   *
   * @return eventcv's first
   */
  public static List<RecordedPackets> hdf5() {
    return List.of(EVENTCV_HDF5, EVUTILS_HDF5);
  }

  /** Reads {@code recorded-packets.json}. */
  private static Map<String, RecordedPackets> catalogue() {
    String name = "recorded-packets.json";
    Map<String, RecordedPackets> catalogue = new HashMap<>();
    try (InputStream stream = RecordedPackets.class.getResourceAsStream(name)) {
      String text = new String(stream.readAllBytes(), StandardCharsets.UTF_8);
      Map<?, ?> whole = (Map<?, ?>) Json.parse(text, name);
      for (Object one : (List<?>) whole.get("recordings")) {
        RecordedPackets known = of((Map<?, ?>) one);
        catalogue.put(known.file(), known);
      }
    } catch (IOException unreadable) {
      throw new UncheckedIOException(unreadable);
    }
    return Map.copyOf(catalogue);
  }

  private static RecordedPackets of(Map<?, ?> one) {
    return new RecordedPackets(
        (String) one.get("file"),
        (String) one.get("format"),
        new SensorGeometry(
            (int) number(one, "width"),
            (int) number(one, "height"),
            Origin.valueOf((String) one.get("origin"))),
        number(one, "on"),
        number(one, "off"),
        number(one, "firstUs"),
        number(one, "lastUs"),
        (int) number(one, "minX"),
        (int) number(one, "maxX"),
        (int) number(one, "minY"),
        (int) number(one, "maxY"),
        rows(one, "head"),
        rows(one, "tail"),
        (String) one.get("crc32"),
        number(one, "otherWords"));
  }

  private static long number(Map<?, ?> one, String name) {
    return ((Number) one.get(name)).longValue();
  }

  private static List<EventRow> rows(Map<?, ?> one, String name) {
    return ((List<?>) one.get(name)).stream().map(row -> row((List<?>) row)).toList();
  }

  private static EventRow row(List<?> row) {
    long[] numbers = row.stream().mapToLong(number -> ((Number) number).longValue()).toArray();
    return new EventRow(numbers[0], (int) numbers[1], (int) numbers[2], (int) numbers[3]);
  }

  private static RecordedPackets known(String file) {
    return Objects.requireNonNull(CATALOGUE.get(file), file);
  }

  /** The same events in another file, which holds nothing else. */
  private RecordedPackets as(String otherFile, String otherFormat) {
    return new RecordedPackets(
        otherFile,
        otherFormat,
        sensor,
        on,
        off,
        firstUs,
        lastUs,
        minX,
        maxX,
        minY,
        maxY,
        head,
        tail,
        crc32,
        0);
  }

  /**
   * Number of all events.
   *
   * @return ON and OFF
   */
  public long events() {
    return on + off;
  }

  /**
   * Opens the recording as a user would; the running test ends here if it is missing.
   *
   * @return a reader at its start
   * @throws IOException if it cannot be read
   */
  public RecordingReader open() throws IOException {
    return open(ReadOptions.DEFAULT);
  }

  /**
   * Opens the recording; the running test ends here if it is missing.
   *
   * @param options of the reader
   * @return a reader at its start
   * @throws IOException if it cannot be read
   */
  public RecordingReader open(ReadOptions options) throws IOException {
    return Recordings.open(Recorded.file(file), options);
  }

  @Override
  public String toString() {
    return file;
  }
}
