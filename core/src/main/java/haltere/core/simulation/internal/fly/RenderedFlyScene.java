package haltere.core.simulation.internal.fly;

import haltere.core.simulation.internal.sensor.PhotoreceptorArray;
import haltere.core.simulation.internal.sensor.SceneSensor;

/**
 * A tethered fly as images from geometry and events from the physics of a pixel: a test bed for
 * wing trackers that shares no rule of theirs.
 *
 * <p>A wing is a half-transparent membrane with an outline. It strokes about its hinge and pitches
 * about its long axis, so that its apparent chord and the distances of its edges from the axis
 * change. Between two images no point of a wing moves by more than 0.35 pixels; the light on a
 * pixel is linear between them ({@link FlyRenderer}, {@link PhotoreceptorArray}).
 *
 * <p>The truth of a wing is that of its long axis as the images show it, the mean of both edges
 * ({@link WingPlanform#edgeRad}); its pitch axis cannot be seen.
 *
 * <p>The same settings make the same events, bit for bit, on every machine. The stream is made as
 * it is pulled, in constant memory, and ends only if the settings give it a length.
 *
 * <p>Thread rule: pulled by one thread at a time; {@link #truthAt} and {@link #imageAt} may be
 * called by any thread.
 */
public final class RenderedFlyScene extends TetheredFlyScene {
  private static final int STRETCH_US = 100;
  private static final int SPEED_SAMPLES = 4;

  /** Motion of a wing's outline from one image to the next. */
  private static final double STEP_PX = 0.35;

  private final RenderedFlySceneSettings settings;
  private final WingPlanform planform;
  private final WingPitch pitch;
  private final ApparentStroke apparent;
  private final PhotoreceptorArray pixels;
  private final FlyRenderer renderer;

  /**
   * A scene at its beginning.
   *
   * @param settings of the scene
   */
  public RenderedFlyScene(RenderedFlySceneSettings settings) {
    this(settings, MAX_EVENTS);
  }

  /** A scene with a maximum number of events per packet. */
  RenderedFlyScene(RenderedFlySceneSettings settings, int maxEvents) {
    this(
        settings,
        maxEvents,
        new SceneSensor<>(
            settings.pixel(),
            settings.noise(),
            settings.sensor(),
            settings.run(),
            bus ->
                new PhotoreceptorArray(
                    settings.pixel(),
                    settings.photoreceptor(),
                    settings.sensor(),
                    settings.run().seed(),
                    bus)));
  }

  private RenderedFlyScene(
      RenderedFlySceneSettings settings, int maxEvents, SceneSensor<PhotoreceptorArray> sensor) {
    super(
        "rendered-fly",
        sensor,
        settings.run(),
        maxEvents,
        new FlyKinematics(
            settings.sensor(),
            settings.fly().body(),
            settings.stroke(),
            settings.fly().manoeuvres(),
            settings.run().seed()),
        STRETCH_US);
    this.settings = settings;
    pixels = sensor.pixels();
    planform = new WingPlanform(settings.fly().wing());
    pitch = new WingPitch(settings.fly().pitch(), kinematics.waveform());
    apparent = new ApparentStroke(planform, pitch, kinematics.waveform());
    renderer = new FlyRenderer(settings, planform);
    int changes = image(0, renderer, before);
    for (int i = 0; i < changes; i++) {
      pixels.settle(renderer.changed(i), renderer.light(renderer.changed(i)));
    }
  }

  @Override
  FlyTruth.Wing wing(FlyPose pose, int side) {
    return apparent.at(pose, side);
  }

  /**
   * The image at a time, before any pixel low-passes it.
   *
   * @param timeUs microseconds on the clock of the events
   * @return light of each pixel as a share of the background, row after row from the bottom
   */
  public double[] imageAt(long timeUs) {
    double seconds = (timeUs - startUs()) * US;
    FlyPose pose = new FlyPose();
    kinematics.sample(seconds, pose);
    FlyRenderer one = new FlyRenderer(settings, planform);
    image(seconds, one, pose);
    double[] light = new double[geometry().width() * geometry().height()];
    for (int pixel = 0; pixel < light.length; pixel++) {
      light[pixel] = one.light(pixel);
    }
    return light;
  }

  private int image(double seconds, FlyRenderer to, FlyPose pose) {
    to.background(pose, seconds);
    for (int side = 0; side < 2; side++) {
      wing(to, side, pose, pose, 1);
    }
    return to.findChanges();
  }

  @Override
  void makeStretch(long fromUs) {
    int steps = steps();
    renderer.background(before, fromUs * US);
    double doneUs = fromUs;
    for (int step = 1; step <= steps; step++) {
      double untilUs = fromUs + STRETCH_US * (double) step / steps;
      for (int side = 0; side < 2; side++) {
        wing(renderer, side, before, after, (double) step / steps);
      }
      int changes = renderer.findChanges();
      for (int i = 0; i < changes; i++) {
        int pixel = renderer.changed(i);
        pixels.change(pixel, doneUs, untilUs, renderer.light(pixel));
      }
      doneUs = untilUs;
    }
  }

  /** Number of images between two poses. */
  private int steps() {
    double maxPx = 0;
    for (int side = 0; side < 2; side++) {
      double angle = angle(side, before, after, 0);
      double projection = projection(side, before, after, 0);
      for (int i = 1; i <= SPEED_SAMPLES; i++) {
        double nextAngle = angle(side, before, after, (double) i / SPEED_SAMPLES);
        double nextProjection = projection(side, before, after, (double) i / SPEED_SAMPLES);
        double moved =
            planform.reachPx() * Math.abs(nextAngle - angle)
                + planform.acrossPx() * Math.abs(nextProjection - projection);
        maxPx = Math.max(maxPx, moved);
        angle = nextAngle;
        projection = nextProjection;
      }
    }
    return 1 + (int) (SPEED_SAMPLES * maxPx / STEP_PX);
  }

  /** Renders a wing at a fraction of the interval between two poses. */
  private void wing(FlyRenderer to, int side, FlyPose one, FlyPose next, double share) {
    double heading = between(one.heading, next.heading, share);
    double angle = angle(side, one, next, share);
    to.wing(
        side,
        between(one.hingeX[side], next.hingeX[side], share),
        between(one.hingeY[side], next.hingeY[side], share),
        side == FlyKinematics.LEFT ? heading + angle : heading - angle,
        projection(side, one, next, share));
  }

  private double projection(int side, FlyPose one, FlyPose next, double share) {
    return pitch.projection(2 * Math.PI * between(one.cycles[side], next.cycles[side], share));
  }
}
