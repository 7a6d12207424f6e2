package haltere.testing;

import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import java.io.IOException;
import java.util.List;

/**
 * What is known of a real recording, from programs that nobody here wrote: a catalogue that tests
 * walk through. Coordinates are the source's own: rows count from the corner that {@code sensor}
 * names.
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

  /** Tmpdiff128, 2007: the oldest format. */
  public static final RecordedPackets TMPDIFF128 =
      new RecordedPackets(
          "dvs128-tmpdiff128-2007.dat",
          "aedat1",
          new SensorGeometry(128, 128),
          49059,
          72211,
          679877510,
          701768090,
          0,
          127,
          0,
          127,
          List.of(
              row(679877510, 44, 58, 1),
              row(679877560, 95, 6, 1),
              row(679877570, 69, 67, 1),
              row(679877570, 70, 94, 0),
              row(679878020, 115, 67, 0)),
          List.of(row(701768010, 63, 81, 1), row(701768090, 68, 63, 1)),
          "6ff429a5",
          0);

  /** DVS128, a dark box moved before the camera; the header names no chip. */
  public static final RecordedPackets DARK_BOX =
      new RecordedPackets(
          "dvs128-moving-dark-box.aedat",
          "aedat2",
          new SensorGeometry(128, 128),
          246923,
          242911,
          946459683,
          986269729,
          0,
          127,
          0,
          127,
          List.of(
              row(946459683, 115, 19, 1),
              row(946461064, 65, 52, 1),
              row(946498741, 118, 27, 1),
              row(946519581, 115, 86, 1),
              row(946526116, 68, 46, 1)),
          List.of(row(986269727, 54, 113, 0), row(986269729, 54, 113, 0)),
          "a8b9031d",
          0);

  /** DVS128, a person walking; the header names the chip and has no end line. */
  public static final RecordedPackets WALKING =
      new RecordedPackets(
          "dvs128-walking-10s.aedat",
          "aedat2",
          new SensorGeometry(128, 128),
          55976,
          69052,
          262847757,
          270891631,
          0,
          127,
          0,
          127,
          List.of(
              row(262847757, 11, 71, 0),
              row(262847856, 30, 124, 1),
              row(262847947, 37, 53, 0),
              row(262847988, 47, 104, 0),
              row(262848061, 28, 102, 1)),
          List.of(row(270891623, 9, 104, 0), row(270891631, 82, 112, 1)),
          "b9680ef5",
          0);

  /** DVS128, a pendulum; the header has its end line. */
  public static final RecordedPackets PENDULUM =
      new RecordedPackets(
          "dvs128-pendulum.aedat",
          "aedat2",
          new SensorGeometry(128, 128),
          153062,
          125476,
          64300579,
          84240611,
          0,
          127,
          0,
          127,
          List.of(
              row(64300579, 85, 6, 0),
              row(64300684, 63, 39, 0),
              row(64300727, 18, 6, 0),
              row(64300775, 11, 51, 0),
              row(64300776, 11, 51, 0)),
          List.of(row(84240565, 83, 24, 0), row(84240611, 0, 26, 1)),
          "55474ee2",
          0);

  /** DAVIS240C, a rotating disk, with frames and inertial samples in between. */
  public static final RecordedPackets ROTATING_DISK =
      new RecordedPackets(
          "davis240c-rotating-disk-imu-aps.aedat",
          "aedat2",
          new SensorGeometry(240, 180),
          163098,
          211198,
          341678,
          3508437,
          0,
          239,
          0,
          179,
          List.of(
              row(341678, 228, 15, 1),
              row(341678, 185, 169, 0),
              row(341685, 4, 164, 1),
              row(341698, 192, 179, 0),
              row(341720, 0, 162, 1)),
          List.of(row(3508431, 188, 49, 0), row(3508437, 195, 47, 0)),
          "9957d985",
          51688);

  /** A synthetic bar that turns, in the DAVIS's layout; the header names no chip. */
  public static final RecordedPackets ROTATING_BAR =
      new RecordedPackets(
          "synthetic-rotating-bar.aedat",
          "aedat2",
          new SensorGeometry(240, 180),
          45000,
          0,
          100000,
          90000000,
          69,
          169,
          39,
          139,
          List.of(
              row(100000, 120, 89, 1),
              row(100000, 121, 89, 1),
              row(100000, 122, 89, 1),
              row(100000, 123, 89, 1),
              row(100000, 124, 89, 1)),
          List.of(row(90000000, 168, 89, 1), row(90000000, 169, 89, 1)),
          "f24e08b3",
          0);

  /**
   * The recordings of jAER's old formats.
   *
   * @return AEDAT-1.0 first
   */
  public static List<RecordedPackets> aedat() {
    return List.of(TMPDIFF128, DARK_BOX, WALKING, PENDULUM, ROTATING_DISK, ROTATING_BAR);
  }

  /** Prophesee Gen3, dense; the header states no size. */
  public static final RecordedPackets GEN3_EVT2 =
      new RecordedPackets(
          "gen3-evt2.raw",
          "evt2",
          new SensorGeometry(640, 480, Origin.TOP),
          185861,
          335391,
          913716224,
          913812095,
          0,
          639,
          0,
          479,
          List.of(
              row(913716224, 35, 443, 1),
              row(913716224, 36, 443, 1),
              row(913716224, 74, 443, 1),
              row(913716224, 75, 443, 1),
              row(913716224, 72, 443, 1)),
          List.of(row(913812094, 4, 474, 0), row(913812095, 12, 471, 0)),
          "e3b4f295",
          0);

  /** The same events in words of EVT2.1 whose halves are swapped, written by another program. */
  public static final RecordedPackets GEN3_EVT21 =
      new RecordedPackets(
          "gen3-evt21-by-evutils.raw",
          "evt21",
          new SensorGeometry(640, 480, Origin.TOP),
          185861,
          335391,
          913716224,
          913812095,
          0,
          639,
          0,
          479,
          List.of(
              row(913716224, 35, 443, 1),
              row(913716224, 36, 443, 1),
              row(913716224, 74, 443, 1),
              row(913716224, 75, 443, 1),
              row(913716224, 72, 443, 1)),
          List.of(row(913812094, 4, 474, 0), row(913812095, 12, 471, 0)),
          "e3b4f295",
          0);

  /** IMX636, sparse: hardly any vector words. */
  public static final RecordedPackets IMX636_EVT3 =
      new RecordedPackets(
          "imx636-evt3.raw",
          "evt3",
          new SensorGeometry(1280, 720, Origin.TOP),
          553295,
          665323,
          11200224,
          21968221,
          0,
          1279,
          0,
          719,
          List.of(
              row(11200224, 484, 315, 1),
              row(11200225, 474, 231, 0),
              row(11200225, 450, 309, 1),
              row(11200227, 492, 253, 0),
              row(11200227, 472, 222, 0)),
          List.of(row(21968220, 442, 316, 1), row(21968221, 471, 350, 0)),
          "ffab0efd",
          457639);

  /** Prophesee Gen4, the scene of {@link #IMX636_EVT3} on another clock. */
  public static final RecordedPackets GEN4_DAT =
      new RecordedPackets(
          "gen4.dat",
          "dat",
          new SensorGeometry(1280, 720, Origin.TOP),
          553295,
          665323,
          5856,
          10773853,
          0,
          1279,
          0,
          719,
          List.of(
              row(5856, 484, 315, 1),
              row(5857, 474, 231, 0),
              row(5857, 450, 309, 1),
              row(5859, 492, 253, 0),
              row(5859, 472, 222, 0)),
          List.of(row(10773852, 442, 316, 1), row(10773853, 471, 350, 0)),
          "dd2c748a",
          0);

  /** N-CARS, events of the kind 2D; the header states no size. */
  public static final RecordedPackets NCARS_DAT =
      new RecordedPackets(
          "ncars-sample.dat",
          "dat",
          new SensorGeometry(304, 240, Origin.TOP),
          1350,
          659,
          0,
          99952,
          0,
          77,
          0,
          41,
          List.of(
              row(0, 25, 8, 0),
              row(35, 67, 35, 0),
              row(152, 56, 27, 1),
              row(202, 74, 39, 1),
              row(244, 49, 28, 1)),
          List.of(row(99851, 51, 4, 1), row(99952, 75, 28, 1)),
          "add26364",
          0);

  /** Event Stream, DVS. */
  public static final RecordedPackets DVS_ES =
      new RecordedPackets(
          "dvs.es",
          "es",
          new SensorGeometry(320, 240, Origin.TOP),
          270001,
          203224,
          0,
          999000,
          0,
          319,
          0,
          239,
          List.of(
              row(0, 0, 239, 1),
              row(0, 1, 239, 1),
              row(0, 2, 239, 1),
              row(0, 3, 239, 1),
              row(0, 4, 239, 1)),
          List.of(row(999000, 113, 77, 1), row(999000, 38, 46, 1)),
          "765d0785",
          0);

  /** A digit of N-MNIST. */
  public static final RecordedPackets NMNIST =
      new RecordedPackets(
          "nmnist-sample.bin",
          "nmnist",
          new SensorGeometry(34, 34, Origin.TOP),
          2145,
          2180,
          654,
          311175,
          0,
          33,
          0,
          33,
          List.of(
              row(654, 7, 15, 1),
              row(2999, 19, 18, 0),
              row(3017, 21, 17, 0),
              row(3893, 10, 18, 0),
              row(4023, 12, 9, 1)),
          List.of(row(310771, 33, 12, 1), row(311175, 21, 14, 1)),
          "8c7731fd",
          0);

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
  public static final RecordedPackets DVS128_GESTURE =
      new RecordedPackets(
          "dvs128-gesture.aedat4",
          "aedat4",
          new SensorGeometry(128, 128, Origin.TOP),
          66767,
          82862,
          1718925184590631L,
          1718925190610468L,
          0,
          127,
          0,
          127,
          List.of(
              row(1718925184590631L, 23, 51, 1),
              row(1718925184590832L, 23, 50, 1),
              row(1718925184590833L, 26, 74, 1),
              row(1718925184590837L, 29, 46, 1),
              row(1718925184590839L, 25, 73, 1)),
          List.of(row(1718925190610432L, 80, 115, 1), row(1718925190610468L, 24, 46, 1)),
          "1f6f6f3c",
          0);

  /** DAVIS346, with packets of frames, inertial samples and triggers in between. */
  public static final RecordedPackets DAVIS346_FRAMES =
      new RecordedPackets(
          "davis346-events-frames-imu.aedat4",
          "aedat4",
          new SensorGeometry(346, 260, Origin.TOP),
          41257,
          37573,
          1589163147368868L,
          1589163149728813L,
          0,
          345,
          2,
          259,
          List.of(
              row(1589163147368868L, 215, 164, 1),
              row(1589163147368950L, 226, 160, 1),
              row(1589163147368974L, 40, 236, 1),
              row(1589163147368981L, 69, 226, 1),
              row(1589163147368988L, 213, 165, 1)),
          List.of(row(1589163149728809L, 240, 171, 1), row(1589163149728813L, 233, 205, 1)),
          "0e1b7379",
          472);

  /** DVXplorer, with packets of inertial samples in between. */
  public static final RecordedPackets DVXPLORER =
      new RecordedPackets(
          "dvxplorer-sample.aedat4",
          "aedat4",
          new SensorGeometry(320, 240, Origin.TOP),
          55023,
          56931,
          1605537493718345L,
          1605537494308262L,
          0,
          319,
          0,
          239,
          List.of(
              row(1605537493718345L, 154, 204, 0),
              row(1605537493718348L, 149, 206, 0),
              row(1605537493718349L, 148, 199, 1),
              row(1605537493718354L, 139, 30, 0),
              row(1605537493718360L, 130, 181, 1)),
          List.of(row(1605537494308261L, 90, 132, 0), row(1605537494308262L, 88, 237, 1)),
          "01d6e90a",
          59);

  /** A bag of ROS 1, Prophesee, whose words are EVT3. */
  public static final RecordedPackets EVT3_BAG =
      new RecordedPackets(
          "evt3-eventpacket.bag",
          "rosbag",
          new SensorGeometry(640, 480, Origin.TOP),
          125183,
          218291,
          7139845,
          9218023,
          0,
          639,
          0,
          479,
          List.of(
              row(7139845, 479, 441, 0),
              row(7139854, 503, 443, 0),
              row(7139856, 340, 219, 0),
              row(7139858, 1, 393, 0),
              row(7139868, 560, 384, 0)),
          List.of(row(9218021, 579, 417, 0), row(9218023, 39, 374, 0)),
          "03df4072",
          5957);

  /** A bag of ROS 2 in an SQLite file, Prophesee, with external triggers among the words. */
  public static final RecordedPackets TRIGGERS_BAG =
      new RecordedPackets(
          "evt3-with-triggers.db3",
          "rosbag2",
          new SensorGeometry(1280, 720, Origin.TOP),
          41439,
          41030,
          14224870,
          15476187,
          0,
          1279,
          0,
          719,
          List.of(
              row(14224870, 354, 604, 1),
              row(14224883, 835, 577, 1),
              row(14224884, 54, 188, 0),
              row(14224890, 67, 110, 0),
              row(14224895, 732, 333, 0)),
          List.of(row(15476176, 1188, 344, 1), row(15476187, 15, 157, 0)),
          "e04d3cb2",
          53226);

  /**
   * The recordings of ROS.
   *
   * @return ROS 1 first
   */
  public static List<RecordedPackets> ros() {
    return List.of(EVT3_BAG, TRIGGERS_BAG);
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
      new RecordedPackets(
          "davis346-by-eventcv.h5",
          "hdf5",
          DAVIS346_FRAMES.sensor(),
          DAVIS346_FRAMES.on(),
          DAVIS346_FRAMES.off(),
          DAVIS346_FRAMES.firstUs(),
          DAVIS346_FRAMES.lastUs(),
          DAVIS346_FRAMES.minX(),
          DAVIS346_FRAMES.maxX(),
          DAVIS346_FRAMES.minY(),
          DAVIS346_FRAMES.maxY(),
          DAVIS346_FRAMES.head(),
          DAVIS346_FRAMES.tail(),
          DAVIS346_FRAMES.crc32(),
          0);

  /** The same as evutils writes them, of the DSEC kind: Blosc with Zstandard. */
  public static final RecordedPackets EVUTILS_HDF5 =
      new RecordedPackets(
          "davis346-by-evutils.h5",
          "hdf5",
          DAVIS346_FRAMES.sensor(),
          DAVIS346_FRAMES.on(),
          DAVIS346_FRAMES.off(),
          DAVIS346_FRAMES.firstUs(),
          DAVIS346_FRAMES.lastUs(),
          DAVIS346_FRAMES.minX(),
          DAVIS346_FRAMES.maxX(),
          DAVIS346_FRAMES.minY(),
          DAVIS346_FRAMES.maxY(),
          DAVIS346_FRAMES.head(),
          DAVIS346_FRAMES.tail(),
          DAVIS346_FRAMES.crc32(),
          0);

  /**
   * The recordings in HDF5, which hold the events of {@link #DAVIS346_FRAMES}.
   *
   * @return eventcv's first
   */
  public static List<RecordedPackets> hdf5() {
    return List.of(EVENTCV_HDF5, EVUTILS_HDF5);
  }

  private static EventRow row(long timeUs, int x, int y, int on) {
    return new EventRow(timeUs, x, y, on);
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
   * @param options what is said about it
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
