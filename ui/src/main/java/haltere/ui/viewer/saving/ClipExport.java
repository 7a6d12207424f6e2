package haltere.ui.viewer.saving;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorSample;
import haltere.core.stream.StreamNotification;
import haltere.ui.export.FilmWriter;
import haltere.ui.export.GifWriter;
import haltere.ui.export.Mp4Writer;
import haltere.ui.viewer.picture.DisplayOptions;
import haltere.ui.viewer.picture.DisplaySink;
import haltere.ui.viewer.picture.Overlays;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;

/** Exports a part as a film: pictures with overlays at equal intervals of recording time. */
final class ClipExport extends PartExport {
  /** Most pictures of the film per second. */
  private static final double MAX_FRAMES_PER_SECOND = 25;

  /** Maximum number of pictures; longer films are probably a mistake. */
  private static final long MAX_PICTURES = 20_000;

  private final DisplaySink display;
  private final Overlays overlays;
  private final FilmWriter film;
  private final double pictureUs;

  /** Whether the slice of the next picture has begun. */
  private boolean inSlice;

  private final EventPacket slice = new EventPacket(4096);
  private long pictures;

  /**
   * An export.
   *
   * @param file its name gives the format
   * @param options how events are shown
   * @param overlays overlays of the pictures
   * @param speed recording time per time of the film
   */
  ClipExport(ExportedPart part, Path file, DisplayOptions options, Overlays overlays, double speed)
      throws IOException {
    super(part);
    // a slice that is longer than a picture is shown as one, as on the screen
    double longestUs = Math.max(speed * 1e6 / MAX_FRAMES_PER_SECOND, part.sliceUs());
    pictureUs = Math.max(1, Math.min(longestUs, part.toUs() - part.fromUs()));
    long wanted = Math.round((part.toUs() - part.fromUs()) / pictureUs);
    if (wanted > MAX_PICTURES) {
      String advice = "mark a shorter part or choose a higher speed, which is that of playback";
      throw new IOException("that would be " + wanted + " pictures; " + advice);
    }
    this.overlays = overlays;
    film = film(file, Math.min(MAX_FRAMES_PER_SECOND, speed * 1e6 / pictureUs));
    display = DisplaySink.direct(part.playable().geometry(), part.chain(), options);
    display.renderer().setRegion(overlays.region());
  }

  private static FilmWriter film(Path file, double framesPerSecond) throws IOException {
    String name = file.getFileName().toString().toLowerCase(Locale.ROOT);
    if (name.endsWith(".gif")) {
      return new GifWriter(file, framesPerSecond);
    }
    if (name.endsWith(".mp4")) {
      return new Mp4Writer(file, framesPerSecond);
    }
    throw new IOException(file.getFileName() + ": a film's name ends in .gif or .mp4");
  }

  /** The begin of the next picture's slice, or its end. */
  private double nextUs() {
    return part.fromUs() + (pictures + 1) * pictureUs - (inSlice ? 0 : part.sliceUs());
  }

  @Override
  void take(EventPacket packet, long offsetUs) throws IOException {
    int done = 0;
    while (packet.lastTimeUs() + offsetUs >= nextUs()) {
      int end = packet.indexAtOrAfter((long) Math.ceil(nextUs()) - offsetUs, done);
      pass(packet, done, end);
      advance();
      done = end;
    }
    pass(packet, done, packet.size());
  }

  private void pass(EventPacket packet, int from, int to) {
    if (from < to) {
      slice.clear();
      slice.append(packet, from, to);
      part.chain().process(slice);
      display.packet(slice);
    }
  }

  /** Begins the slice of the next picture, or takes the picture. */
  private void advance() throws IOException {
    // from the elapsed timeline to the source's clock
    long atUs = Math.round(nextUs()) - part.playable().elapsedUs(0);
    display.endSlice(atUs - part.sliceUs(), atUs);
    if (inSlice) {
      report(Math.round(nextUs()));
      film.add(display.picture(overlays));
      pictures++;
    }
    inSlice = !inSlice || part.sliceUs() >= pictureUs;
  }

  @Override
  public void notified(StreamNotification notification) {
    part.chain().notified(notification);
    display.notified(notification);
  }

  @Override
  public void sample(SensorSample sample) {
    part.chain().sample(sample);
    display.sample(sample);
  }

  @Override
  String finish() throws IOException {
    // the last picture, even if the recording ends before it
    while (nextUs() <= part.toUs() + 0.5) {
      advance();
    }
    film.finish();
    return pictures + (pictures == 1 ? " picture" : " pictures");
  }

  @Override
  public void close() throws IOException {
    display.close();
    film.close();
  }
}
