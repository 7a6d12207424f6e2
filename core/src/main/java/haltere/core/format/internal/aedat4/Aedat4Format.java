package haltere.core.format.internal.aedat4;

import haltere.core.event.Origin;
import haltere.core.event.SampleKind;
import haltere.core.event.SensorGeometry;
import haltere.core.format.FileHead;
import haltere.core.format.ProbeResult;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingFormat;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Support;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.format.WriteOptions;
import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.decoding.SensorGuess;
import haltere.core.format.internal.reader.DecodingReader;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;

/** AEDAT-4.0, the format of DV, dv-processing and jAER 3: read and written. */
public final class Aedat4Format implements RecordingFormat {
  private static final int PROBE_PACKETS = 256;
  private static final int ANY_SIDE = 1 << 15;

  /** Called by the service loader. */
  public Aedat4Format() {}

  @Override
  public String name() {
    return "aedat4";
  }

  @Override
  public String description() {
    return "AEDAT-4.0 (DV, dv-processing, jAER 3)";
  }

  @Override
  public Set<String> extensions() {
    return new LinkedHashSet<>(List.of("aedat4", "aedat"));
  }

  @Override
  public ProbeResult probe(FileHead head) {
    return head.startsWith(Aedat4Header.MAGIC)
        ? new ProbeResult(Support.CERTAIN, "its header says AEDAT-4.0")
        : new ProbeResult(Support.NONE, "it has no line #!AER-DAT4.0");
  }

  @Override
  public RecordingReader open(Path file, ReadOptions options) throws IOException {
    return RecordingFile.reading(
        file,
        bytes -> {
          Aedat4Opening opening = new Aedat4Opening(bytes, options);
          return opening.open(opening.requested());
        });
  }

  /**
   * Opens a recording with several streams of events.
   *
   * @param file a file of this format
   * @param options the user's options
   * @param stream number of the stream to read; empty for the first with events
   * @return a reader at its start
   * @throws IOException a {@link RecordingProblem} if the file is not valid or has no such stream
   */
  public RecordingReader open(Path file, ReadOptions options, OptionalInt stream)
      throws IOException {
    return RecordingFile.reading(file, bytes -> new Aedat4Opening(bytes, options).open(stream));
  }

  /**
   * The streams listed in a file, including those that are not read.
   *
   * @param file a file of this format
   * @return in order of their numbers
   * @throws IOException a {@link RecordingProblem} if the file is not valid
   */
  public static List<Aedat4Stream> streams(Path file) throws IOException {
    try (RecordingFile bytes = new RecordingFile(file)) {
      return Aedat4Header.read(bytes).streams();
    }
  }

  @Override
  public Set<SampleKind> writableSamples() {
    return EnumSet.allOf(SampleKind.class);
  }

  @Override
  public Optional<RecordingWriter> create(Path file, WriteOptions options) throws IOException {
    return Optional.of(Aedat4Writer.create(file, options, Aedat4Compression.LZ4));
  }

  private final class Aedat4Opening {
    private final RecordingFile file;
    private final ReadOptions options;
    private final Aedat4Header header;
    private final List<String> remarks = new ArrayList<>();
    private final ViolationCounts violations = new ViolationCounts();
    private final Aedat4Cursor.Layout layout;

    Aedat4Opening(RecordingFile file, ReadOptions options) throws IOException {
      this.file = file;
      this.options = options;
      header = Aedat4Header.read(file);
      layout = layout();
    }

    private Aedat4Cursor.Layout layout() throws IOException {
      Set<Integer> known =
          header.streams().stream().map(Aedat4Stream::id).collect(Collectors.toSet());
      long end = file.size();
      long table = header.tablePosition();
      boolean cutOff = table >= end;
      if (table >= header.dataOffset() && table < end) {
        if (DataTable.isThere(file, table)) {
          end = table;
        } else {
          violations.add(Violation.IMPOSSIBLE_LENGTH, Aedat4Header.TABLE_POSITION_OFFSET);
        }
      }
      Map<String, String> metadata = new TreeMap<>();
      header.streams().forEach(stream -> metadata.putAll(stream.metadata()));
      return new Aedat4Cursor.Layout(
          known, header.dataOffset(), end, cutOff, metadata, header.compression());
    }

    /** The stream of the user's choice: its number, or its camera if that has one stream only. */
    OptionalInt requested() throws RecordingProblem {
      if (options.topic().isEmpty()) {
        return OptionalInt.empty();
      }
      String name = options.topic().get();
      List<Aedat4Stream> events = header.streams().stream().filter(Aedat4Stream::isEvents).toList();
      List<Aedat4Stream> found =
          events.stream()
              .filter(
                  stream ->
                      name.equals(Integer.toString(stream.id()))
                          || name.equals(stream.source().orElse(null)))
              .toList();
      if (found.size() != 1) {
        throw new RecordingProblem(
            file.path(),
            "it has "
                + found.size()
                + " streams of events named "
                + name
                + "; its streams of events: "
                + names(events));
      }
      return OptionalInt.of(found.get(0).id());
    }

    private static String names(List<Aedat4Stream> streams) {
      return streams.stream()
          .map(stream -> stream.id() + stream.source().map(name -> " (" + name + ")").orElse(""))
          .collect(Collectors.joining(", "));
    }

    RecordingReader open(OptionalInt wanted) throws IOException {
      if (!header.described()) {
        remarks.add(
            "the description of the streams is damaged; packets are recognised by their content");
      }
      List<Aedat4Stream> events = header.streams().stream().filter(Aedat4Stream::isEvents).toList();
      int stream = wanted.isPresent() ? wanted.getAsInt() : first(events);
      if (wanted.isPresent() && events.stream().noneMatch(known -> known.id() == stream)) {
        throw new RecordingProblem(
            file.path(),
            "there are no events in stream "
                + stream
                + ", but in "
                + events.stream()
                    .map(known -> Integer.toString(known.id()))
                    .collect(Collectors.joining(", ")));
      }
      if (events.size() > 1) {
        remarks.add(
            "there are "
                + events.size()
                + " streams of events; stream "
                + stream
                + " is read; --topic chooses another: "
                + names(events.stream().filter(other -> other.id() != stream).toList()));
      }
      Optional<Aedat4Stream> description =
          header.streams().stream().filter(known -> known.id() == stream).findFirst();
      SensorGeometry geometry = geometry(description, stream);
      return new DecodingReader(
          name(),
          file,
          geometry,
          remarks,
          options,
          violations,
          counts -> new Aedat4Cursor(file, layout, geometry, stream, counts),
          Optional.of(counts -> samples(geometry, description, counts)));
    }

    /** Of several streams of a kind, the one of the same camera is read, else the first. */
    private Aedat4SampleCursor samples(
        SensorGeometry geometry, Optional<Aedat4Stream> events, ViolationCounts counts) {
      Set<Integer> passed = new HashSet<>();
      Map<String, Aedat4Stream> taken = new HashMap<>();
      for (Aedat4Stream known : header.streams()) {
        boolean sample = SamplePayload.isKnown(known.type());
        boolean sameCamera = events.isEmpty() || known.source().equals(events.get().source());
        if (sample && sameCamera) {
          taken.putIfAbsent(known.type(), known);
        }
      }
      for (Aedat4Stream known : header.streams()) {
        boolean chosen = taken.computeIfAbsent(known.type(), type -> known).equals(known);
        if (!chosen || !SamplePayload.isKnown(known.type())) {
          passed.add(known.id());
        }
      }
      boolean fromBottom = geometry.origin() == Origin.BOTTOM;
      return new Aedat4SampleCursor(
          file, layout, passed, new SamplePayload(geometry.height(), fromBottom), counts);
    }

    private int first(List<Aedat4Stream> events) throws IOException {
      if (!events.isEmpty()) {
        return events.get(0).id();
      }
      OptionalInt found = header.described() ? OptionalInt.empty() : firstWithEvents();
      if (found.isEmpty()) {
        remarks.add("it holds no stream of events");
      }
      return found.orElse(-1);
    }

    /** By the content of the first packets. */
    private OptionalInt firstWithEvents() throws IOException {
      Decompressor decompressor = new Decompressor(file);
      try {
        PacketWalk walk = layout.walk(decompressor.window(), new ViolationCounts());
        for (int i = 0; i < PROBE_PACKETS && walk.find(); i++) {
          try {
            decompressor.open(walk.payload(), walk.size());
            decompressor.gather(16);
            String type =
                FlatTable.identifier(decompressor.data(), decompressor.from(), decompressor.to());
            if (type.equals(Aedat4Stream.EVENTS)) {
              return OptionalInt.of(walk.stream());
            }
            walk.pass();
          } catch (DamagedPacketException e) {
            walk.passDamaged();
          }
        }
        return OptionalInt.empty();
      } finally {
        decompressor.close();
      }
    }

    private SensorGeometry geometry(Optional<Aedat4Stream> description, int stream)
        throws IOException {
      Origin origin =
          description.isPresent() && description.get().countsRowsFromBottom()
              ? Origin.BOTTOM
              : Origin.TOP;
      Optional<Aedat4Stream> sized =
          description.isPresent()
              ? description
              : header.streams().stream().filter(other -> other.width() > 0).findFirst();
      if (sized.isPresent() && sized.get().width() > 0 && sized.get().height() > 0) {
        return new SensorGeometry(sized.get().width(), sized.get().height(), origin);
      }
      if (options.sensor().isPresent()) {
        SensorGeometry given = options.sensor().get();
        return new SensorGeometry(given.width(), given.height(), origin);
      }
      SensorGeometry guess = guess(stream, origin);
      remarks.add(
          "the header does not state the sensor's size; "
              + guess
              + " was taken from the events (--sensor WxH states it)");
      return guess;
    }

    private SensorGeometry guess(int stream, Origin origin) throws IOException {
      SensorGeometry any = new SensorGeometry(ANY_SIDE, ANY_SIDE);
      try (Aedat4Cursor cursor =
          new Aedat4Cursor(file, layout, any, stream, new ViolationCounts())) {
        return SensorGuess.of(cursor, origin);
      }
    }
  }
}
