package haltere.ui.viewer.saving;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorSample;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import haltere.core.sink.internal.Unchecked;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.StreamNotification;
import haltere.ui.viewer.controls.Texts;
import java.io.IOException;
import java.nio.file.Path;

/** Exports the events that the chain passes; the file name gives the format. */
final class DataExport extends PartExport {
  private final RecordingWriter writer;
  private final EventPacket written = new EventPacket(4096);
  private long events;
  private long lastUs = StreamNotification.NO_TIME_US;
  private boolean ended;

  DataExport(ExportedPart part, Path file) throws IOException {
    super(part);
    writer =
        Recordings.forWriting(file)
            .create(file, WriteOptions.of(part.playable().geometry()).withOverwrite(true))
            .orElseThrow(() -> new IOException(file + ": this format is only read"));
  }

  @Override
  void take(EventPacket packet, long offsetUs) throws IOException {
    lastUs = packet.lastTimeUs();
    part.chain().packet(packet);
    written.clear();
    written.append(packet, packet.indexAtOrAfter(part.fromUs() - offsetUs), packet.size());
    events += written.size();
    writer.write(written);
    report(lastUs + offsetUs);
  }

  @Override
  public void sample(SensorSample sample) {
    long elapsedUs = part.playable().elapsedUs(sample.timeUs());
    if (elapsedUs >= part.fromUs() && elapsedUs < part.toUs()) {
      part.chain().sample(sample);
      Unchecked.write(() -> writer.write(sample));
    }
  }

  @Override
  public void notified(StreamNotification notification) {
    ended |= notification instanceof EndOfStream;
    part.chain().notified(notification);
  }

  @Override
  String finish() throws IOException {
    if (!ended) {
      part.chain().notified(new EndOfStream(lastUs));
    }
    writer.finish();
    return Texts.count(events) + " events";
  }

  @Override
  public void close() throws IOException {
    writer.close();
  }
}
