package haltere.ui.viewer.saving;

import haltere.core.chain.FilterChain;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorSample;
import haltere.core.playback.Playable;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.ui.export.FilmWriter;
import haltere.ui.viewer.picture.DisplayOptions;
import haltere.ui.viewer.picture.DisplaySink;
import haltere.ui.viewer.picture.Overlays;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.function.LongConsumer;

/**
 * Plays a stretch of a recording through a chain, without a clock, and makes a picture with
 * overlays at even distances of recording time.
 *
 * <p>Thread rule: everything happens on the calling thread.
 */
final class ClipExport implements StreamHandler {
  /** Sent through the chain before the stretch, so that trackers are warm. */
  private static final long RUN_UP_US = 500_000;

  /** Films longer than this are asked for by mistake. */
  static final long MAX_PICTURES = 20_000;

  private final Playable playable;
  private final FilterChain chain;
  private final DisplaySink display;
  private final Overlays overlays;
  private final FilmWriter film;
  private final long fromUs;
  private final long toUs;
  private final double pictureUs;
  private final EventPacket slice = new EventPacket(4096);
  private LongConsumer progress;
  private long pictures;
  private long lastUs;

  /**
   * An export.
   *
   * @param playable closed by the caller
   * @param chain for its sensor
   * @param options how events are shown
   * @param overlays what lies over them
   * @param fromUs start on the elapsed timeline
   * @param toUs end, not included
   * @param pictureUs recording time from one picture to the next
   */
  ClipExport(
      Playable playable,
      FilterChain chain,
      DisplayOptions options,
      Overlays overlays,
      FilmWriter film,
      long fromUs,
      long toUs,
      double pictureUs)
      throws IOException {
    long wanted = Math.round((toUs - fromUs) / pictureUs);
    if (wanted > MAX_PICTURES) {
      throw new IOException(
          "that would be "
              + wanted
              + " pictures; mark a shorter part or choose a higher speed (the film has the speed of"
              + " playback)");
    }
    this.playable = playable;
    this.chain = chain;
    this.display = DisplaySink.direct(playable.geometry(), chain, options);
    this.overlays = overlays;
    display.setRegion(overlays.region());
    this.film = film;
    this.fromUs = fromUs;
    this.toUs = toUs;
    this.pictureUs = pictureUs;
    this.lastUs = fromUs;
  }

  /**
   * Runs, telling at each picture where on the elapsed timeline it is, and returns how many
   * pictures the film has.
   */
  long run(LongConsumer toTell) throws IOException {
    progress = toTell;
    try {
      long start = Math.max(0, fromUs - RUN_UP_US);
      if (start > 0) {
        playable.seek(start);
      }
      while (lastUs < toUs && playable.next(this)) {
        stopIfAsked();
      }
      // the last picture, also where the recording ends before it
      while (nextUs() <= toUs + 0.5) {
        shoot();
      }
      film.finish();
      return pictures;
    } catch (UncheckedIOException problem) {
      throw problem.getCause();
    } finally {
      display.close();
    }
  }

  private double nextUs() {
    return fromUs + (pictures + 1) * pictureUs;
  }

  @Override
  public void packet(EventPacket packet) {
    long[] times = packet.timesUs();
    int[] addresses = packet.addresses();
    for (int i = 0; i < packet.size(); i++) {
      long elapsedUs = playable.elapsedUs(times[i]);
      if (elapsedUs >= toUs) {
        lastUs = elapsedUs;
        break;
      }
      while (elapsedUs >= nextUs()) {
        shoot();
      }
      slice.append(times[i], addresses[i]);
      lastUs = Math.max(lastUs, elapsedUs);
    }
    pass();
  }

  private void pass() {
    if (slice.size() > 0) {
      chain.process(slice);
      display.packet(slice);
      slice.clear();
    }
  }

  private static void stopIfAsked() throws IOException {
    if (Thread.currentThread().isInterrupted()) {
      throw new IOException("the export was ended");
    }
  }

  private void shoot() {
    pass();
    long offsetUs = offsetUs();
    display.endSlice(Math.round(nextUs() - pictureUs) + offsetUs, Math.round(nextUs()) + offsetUs);
    try {
      stopIfAsked();
      film.add(display.picture(overlays));
    } catch (IOException problem) {
      throw new UncheckedIOException(problem);
    }
    progress.accept(Math.round(nextUs()));
    pictures++;
  }

  /** From the elapsed timeline to the source's clock. */
  private long offsetUs() {
    return -playable.elapsedUs(0);
  }

  @Override
  public void notified(StreamNotification notification) {
    chain.notified(notification);
    display.notified(notification);
  }

  @Override
  public void sample(SensorSample sample) {
    chain.sample(sample);
  }
}
