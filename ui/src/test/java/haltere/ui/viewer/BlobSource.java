package haltere.ui.viewer;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.EventSource;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamStarted;
import java.util.SplittableRandom;

/**
 * A round blob of events that moves slowly to the right over an otherwise silent sensor: what every
 * tracker must find. An ON and an OFF event every 100 us.
 */
public final class BlobSource implements EventSource {
  public static final SensorGeometry GEOMETRY = new SensorGeometry(128, 128);
  static final double RADIUS = 4;
  static final double Y = 40;
  private static final double START_X = 30;
  private static final double PX_PER_US = 20e-6;
  private static final int EVENTS = 100;
  private static final long STEP_US = 50;

  private final long endUs;
  private final EventPacket packet = new EventPacket(EVENTS);
  private final SplittableRandom random = new SplittableRandom(1);
  private boolean started;
  private boolean ended;
  private long nowUs;

  /**
   * A blob.
   *
   * @param endUs time of its end, microseconds
   */
  public BlobSource(long endUs) {
    this.endUs = endUs;
  }

  /** Where the blob's middle is at a time. */
  static double x(long timeUs) {
    return START_X + PX_PER_US * timeUs;
  }

  @Override
  public SensorGeometry geometry() {
    return GEOMETRY;
  }

  @Override
  public boolean next(StreamHandler handler) {
    if (!started) {
      started = true;
      handler.notified(new StreamStarted(GEOMETRY, "blob"));
      return true;
    }
    if (nowUs >= endUs) {
      if (ended) {
        return false;
      }
      ended = true;
      handler.notified(new EndOfStream(nowUs - STEP_US));
      return true;
    }
    packet.clear();
    for (int i = 0; i < EVENTS && nowUs < endUs; i++, nowUs += STEP_US) {
      double angle = random.nextDouble() * 2 * Math.PI;
      double radius = RADIUS * Math.sqrt(random.nextDouble());
      packet.append(
          nowUs,
          (int) Math.round(x(nowUs) + radius * Math.cos(angle)),
          (int) Math.round(Y + radius * Math.sin(angle)),
          i % 2 == 0);
    }
    handler.packet(packet);
    return true;
  }

  @Override
  public void close() {}
}
