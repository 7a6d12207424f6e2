package haltere.core.simulation.internal.flight;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.simulation.RunSettings;
import haltere.core.simulation.Scene;
import haltere.core.simulation.internal.sensor.BackgroundNoise;
import haltere.core.simulation.internal.sensor.EventMerger;
import haltere.core.simulation.internal.sensor.PacketCutter;
import haltere.core.simulation.internal.sensor.PixelSettings;
import haltere.core.simulation.internal.sensor.SeededRandom;
import haltere.core.simulation.internal.sensor.SensorSettings;
import haltere.core.stream.StreamHandler;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * A dark elongated body in free flight with saccades, in front of a bright background, seen by one
 * of several cameras; {@link #detections} has the detections of all cameras.
 *
 * <p>A pixel makes an OFF event when the body's outline comes over it and an ON event when it
 * leaves it, at the time of the crossing and a random while later. The same settings make the same
 * events, and scenes that differ in {@code view.camera} only show the same flight. Thread rule:
 * pulled by one thread at a time; the truth and the detections may be queried by any thread.
 */
public final class FlightScene implements Scene<FlightTruth> {
  private static final int MAX_EVENTS = 4096;
  private static final int STEP_US = 200;
  private static final double JITTER_US = 100;

  private final FlightSettings settings;
  private final SensorGeometry geometry;
  private final FlightPath path;
  private final List<FlightCamera> cameras;
  private final FlightCamera camera;
  private final SeededRandom random;
  private final EventMerger merger;
  private final BackgroundNoise noise;
  private final PacketCutter cutter;
  private final double[] before = new double[5];
  private final double[] now = new double[5];
  private long doneUs;

  /**
   * A scene at its beginning.
   *
   * @param settings of the scene
   * @throws IllegalArgumentException if there is no such camera, or the room reaches the cameras
   */
  public FlightScene(FlightSettings settings) {
    FlightViewSettings view = settings.view();
    if (view.camera() >= view.cameras()) {
      throw new IllegalArgumentException(
          "view.camera is "
              + view.camera()
              + ", there are "
              + view.cameras()
              + " cameras, counted from 0");
    }
    if (view.roomM() >= 0.8 * view.distanceM()) {
      throw new IllegalArgumentException(
          "view.roomM is " + view.roomM() + ", it must be below 0.8 of view.distanceM");
    }
    this.settings = settings;
    SensorSettings sensor = settings.sensor();
    long seed = settings.run().seed();
    geometry = new SensorGeometry(sensor.widthPx(), sensor.heightPx());
    path = new FlightPath(settings.body(), settings.view().roomM(), seed);
    cameras =
        IntStream.range(0, settings.view().cameras())
            .mapToObj(i -> FlightCamera.inRing(i, settings.view(), sensor, seed))
            .toList();
    camera = cameras.get(settings.view().camera());
    random = SeededRandom.of(seed, "crossings", settings.view().camera());
    merger = new EventMerger(new PixelSettings(1, 0, 0, 0, 0, 0, 0), sensor, settings.run());
    noise = new BackgroundNoise(settings.noise(), sensor, seed * 31 + settings.view().camera());
    cutter = new PacketCutter(settings.run(), geometry, "flight", MAX_EVENTS, this::makeInterval);
    outline(camera, 0, now);
  }

  @Override
  public SensorGeometry geometry() {
    return geometry;
  }

  @Override
  public boolean next(StreamHandler handler) {
    return cutter.next(handler);
  }

  @Override
  public Class<FlightTruth> truthType() {
    return FlightTruth.class;
  }

  @Override
  public List<FlightTruth> truthRows(long timeUs) {
    return List.of(truthAt(timeUs));
  }

  /**
   * The truth at a time.
   *
   * @param timeUs microseconds on the clock of the events
   * @return position, velocity and axis
   */
  public FlightTruth truthAt(long timeUs) {
    double seconds = (timeUs - startUs()) * 1e-6;
    double[] position = new double[3];
    double[] velocity = new double[3];
    double[] axis = new double[3];
    path.position(seconds, position);
    path.velocity(seconds, velocity);
    path.axis(seconds, axis);
    return new FlightTruth(
        timeUs,
        position[0],
        position[1],
        position[2],
        velocity[0],
        velocity[1],
        velocity[2],
        axis[0],
        axis[1],
        axis[2]);
  }

  @Override
  public RunSettings run() {
    return settings.run();
  }

  /**
   * The cameras.
   *
   * @return as many as the settings state
   */
  public List<FlightCamera> cameras() {
    return cameras;
  }

  /**
   * Time of the n-th picture of all cameras.
   *
   * @param picture from 0 on
   * @return microseconds, {@link #startUs()} for the first
   */
  public long pictureTimeUs(long picture) {
    return startUs() + Math.round(picture * 1e6 / settings.detection().rateHz());
  }

  /**
   * Detections of the n-th pictures, with noise, outliers and gaps.
   *
   * @param picture from 0 on
   * @return at most one for each camera
   */
  public List<FlightDetection> detections(long picture) {
    return detections(picture, new boolean[cameras.size()]);
  }

  /**
   * Detections of the n-th pictures, and which of them are outliers.
   *
   * @param picture from 0 on
   * @param outliers receives, for each camera, whether its angle is an outlier
   * @return at most one for each camera
   */
  public List<FlightDetection> detections(long picture, boolean[] outliers) {
    FlightDetectionSettings detection = settings.detection();
    long timeUs = pictureTimeUs(picture);
    double[] ellipse = new double[5];
    List<FlightDetection> all = new ArrayList<>();
    for (int i = 0; i < cameras.size(); i++) {
      SeededRandom chance = SeededRandom.of(settings.run().seed() * 64 + i, "detection", picture);
      boolean missing = chance.nextDouble() < detection.missingShare();
      outliers[i] = chance.nextDouble() < detection.outlierShare();
      outline(cameras.get(i), timeUs - startUs(), ellipse);
      double half = 0.5 * (ellipse[2] - ellipse[4]);
      double root = Math.hypot(half, ellipse[3]);
      double mean = 0.5 * (ellipse[2] + ellipse[4]);
      double angle = lineAngle(cameras.get(i), timeUs);
      double minRad = Math.toRadians(detection.outlierDeg());
      double off = chance.between(minRad, Math.PI - minRad);
      double noisy = angle + Math.toRadians(detection.angleSdDeg()) * chance.gaussian();
      double x = ellipse[0] + detection.placeSdPx() * chance.gaussian();
      double y = ellipse[1] + detection.placeSdPx() * chance.gaussian();
      if (!missing) {
        all.add(
            new FlightDetection(
                timeUs,
                cameras.get(i).id(),
                0,
                x,
                y,
                wrapped(outliers[i] ? angle + off : noisy),
                Math.PI * Math.sqrt((mean + root) * (mean - root)),
                Math.sqrt((mean + root) / (mean - root))));
      }
    }
    return all;
  }

  /** Projected angle of the line through the body's centre along its axis. */
  private double lineAngle(FlightCamera from, long timeUs) {
    FlightTruth truth = truthAt(timeUs);
    double[] ahead = new double[2];
    double[] behind = new double[2];
    double step = 1e-6;
    from.project(
        new double[] {
          truth.xM() + step * truth.ux(),
          truth.yM() + step * truth.uy(),
          truth.zM() + step * truth.uz()
        },
        ahead);
    from.project(
        new double[] {
          truth.xM() - step * truth.ux(),
          truth.yM() - step * truth.uy(),
          truth.zM() - step * truth.uz()
        },
        behind);
    return StrictMath.atan2(ahead[1] - behind[1], ahead[0] - behind[0]);
  }

  private static double wrapped(double angle) {
    double wrapped = Math.IEEEremainder(angle, Math.PI);
    return wrapped <= -Math.PI / 2 ? Math.PI / 2 : wrapped;
  }

  private void outline(FlightCamera from, long elapsedUs, double[] ellipse) {
    double[] position = new double[3];
    double[] axis = new double[3];
    path.position(elapsedUs * 1e-6, position);
    path.axis(elapsedUs * 1e-6, axis);
    from.outline(
        position, axis, settings.body().lengthM() / 2, settings.body().widthM() / 2, ellipse);
  }

  private long makeInterval(EventPacket out) {
    for (int step = 0; step < 5; step++) {
      System.arraycopy(now, 0, before, 0, 5);
      doneUs += STEP_US;
      outline(camera, doneUs, now);
      addCrossings();
    }
    noise.addUntil(doneUs, merger);
    merger.release(doneUs, out);
    return doneUs;
  }

  private void addCrossings() {
    double reachX = Math.sqrt(Math.max(before[2], now[2])) + 1;
    double reachY = Math.sqrt(Math.max(before[4], now[4])) + 1;
    int fromX = (int) Math.ceil(Math.max(0, Math.min(before[0], now[0]) - reachX));
    int toX = (int) Math.min(geometry.width() - 1, Math.max(before[0], now[0]) + reachX);
    int fromY = (int) Math.ceil(Math.max(0, Math.min(before[1], now[1]) - reachY));
    int toY = (int) Math.min(geometry.height() - 1, Math.max(before[1], now[1]) + reachY);
    for (int y = fromY; y <= toY; y++) {
      for (int x = fromX; x <= toX; x++) {
        double was = inside(before, x, y);
        double is = inside(now, x, y);
        if (was > 0 != is > 0) {
          double share = was / (was - is);
          double timeUs = doneUs - STEP_US * (1 - share) + JITTER_US * random.nextDouble();
          merger.add(timeUs, EventAddress.pack(x, y, was > 0));
        }
      }
    }
  }

  /** Positive inside of an ellipse, negative outside. */
  private static double inside(double[] ellipse, int x, int y) {
    double dx = x - ellipse[0];
    double dy = y - ellipse[1];
    double determinant = ellipse[2] * ellipse[4] - ellipse[3] * ellipse[3];
    return 1
        - (ellipse[4] * dx * dx - 2 * ellipse[3] * dx * dy + ellipse[2] * dy * dy) / determinant;
  }
}
