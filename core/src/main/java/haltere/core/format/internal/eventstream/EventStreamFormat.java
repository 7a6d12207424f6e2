package haltere.core.format.internal.eventstream;

import haltere.core.event.EventAddress;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.FileHead;
import haltere.core.format.ProbeResult;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Support;
import haltere.core.format.ViolationCounts;
import haltere.core.format.WriteOptions;
import haltere.core.format.internal.decoding.FileCursor;
import haltere.core.format.internal.decoding.StreamedFormat;
import haltere.core.format.internal.reader.DecodingReader;
import java.io.IOException;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * Event Stream 2: DVS read and written; of ATIS the pixel events are read; generic and colour files
 * are read as streams without pixel events.
 */
public final class EventStreamFormat implements StreamedFormat {
  /** Called by the service loader. */
  public EventStreamFormat() {}

  @Override
  public String name() {
    return "es";
  }

  @Override
  public String description() {
    return "Event Stream 2, DVS and ATIS";
  }

  @Override
  public Set<String> extensions() {
    return Set.of("es");
  }

  @Override
  public ProbeResult probe(FileHead head) {
    return head.startsWith("Event Stream")
        ? new ProbeResult(Support.CERTAIN, "it begins with Event Stream")
        : new ProbeResult(Support.NONE, "it does not begin with Event Stream");
  }

  @Override
  public RecordingReader openStream(RecordingFile file, ReadOptions options) throws IOException {
    EventStreamHeader header =
        EventStreamHeader.parse(file.read(0, EventStreamHeader.MAX_BYTES))
            .orElseThrow(
                () ->
                    new RecordingProblem(
                        file.path(), "the header of the Event Stream is incomplete"));
    if (header.version() != 2) {
      throw new RecordingProblem(
          file.path(),
          EventStreamHeader.MAGIC.length,
          "version " + header.version() + " of Event Stream is unknown, only 2 is read");
    }
    List<String> remarks = new ArrayList<>();
    EventStreamDecoder.StreamKind kind = kind(file, header);
    SensorGeometry geometry = geometry(file, header, kind, options);
    if (kind == EventStreamDecoder.StreamKind.GENERIC
        || kind == EventStreamDecoder.StreamKind.COLOUR) {
      remarks.add("its messages are not pixel events with a polarity");
    }
    return new DecodingReader(
        name(),
        file,
        geometry,
        remarks,
        options,
        new ViolationCounts(),
        violations ->
            new FileCursor(
                file,
                header.dataOffset(),
                ByteOrder.LITTLE_ENDIAN,
                new EventStreamDecoder(kind, geometry, violations),
                violations));
  }

  private static EventStreamDecoder.StreamKind kind(RecordingFile file, EventStreamHeader header)
      throws RecordingProblem {
    return switch (header.kind()) {
      case EventStreamHeader.GENERIC -> EventStreamDecoder.StreamKind.GENERIC;
      case EventStreamHeader.DVS -> EventStreamDecoder.StreamKind.DVS;
      case EventStreamHeader.ATIS -> EventStreamDecoder.StreamKind.ATIS;
      case EventStreamHeader.COLOUR -> EventStreamDecoder.StreamKind.COLOUR;
      default ->
          throw new RecordingProblem(
              file.path(),
              EventStreamHeader.MAGIC.length + 3L,
              "events of type " + header.kind() + " are not known");
    };
  }

  private static SensorGeometry geometry(
      RecordingFile file,
      EventStreamHeader header,
      EventStreamDecoder.StreamKind kind,
      ReadOptions options)
      throws RecordingProblem {
    if (kind == EventStreamDecoder.StreamKind.GENERIC) {
      return options.sensor().orElse(new SensorGeometry(1, 1, Origin.TOP));
    }
    int maxSide = EventAddress.MAX_COORDINATE + 1;
    if (header.width() < 1
        || header.height() < 1
        || header.width() > maxSide
        || header.height() > maxSide) {
      throw new RecordingProblem(
          file.path(),
          EventStreamHeader.MAGIC.length + 4L,
          "the header's size " + header.width() + "x" + header.height() + " is impossible");
    }
    return new SensorGeometry(header.width(), header.height(), Origin.TOP);
  }

  @Override
  public Optional<RecordingWriter> create(Path file, WriteOptions options) throws IOException {
    return Optional.of(new EventStreamWriter(file, options));
  }
}
