package haltere.ui.command;

import haltere.core.chain.FilterChain;
import haltere.core.chain.FilterProvider;
import haltere.core.chain.Filters;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.Conversion;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Copies a recording to another format, or a part of it, or what filters leave of it. */
@Command(
    name = "convert",
    description = "Write a recording, or a part of it, in the format that OUT's name ends in.")
final class ConvertCommand extends Subcommand {
  @Parameters(index = "0", paramLabel = "IN", description = "A recording.")
  Path in;

  @Parameters(index = "1", paramLabel = "OUT", description = "The new recording.")
  Path out;

  @Option(
      names = "--from",
      paramLabel = "US",
      description = "First time to copy, in microseconds on the recording's own clock.")
  Long fromUs;

  @Option(
      names = "--to",
      paramLabel = "US",
      description = "First time not to copy any more, in microseconds.")
  Long toUs;

  @Option(
      names = "--filter",
      paramLabel = "NAME",
      description =
          "Let events through this filter, with its default settings; may be repeated,"
              + " in order.")
  List<String> filters = List.of();

  @Mixin ReadingOptions reading;
  @Mixin WritingOptions writing;

  ConvertCommand(Surroundings surroundings) {
    super(surroundings);
  }

  @Override
  public Integer call() throws IOException {
    checkArguments();
    writing.checkRecording(out);
    WritingOptions.checkDifferent(in, out);
    convert();
    return OK;
  }

  private void checkArguments() {
    if (fromUs != null && toUs != null && fromUs >= toUs) {
      throw wrongArguments("--from " + fromUs + " must be before --to " + toUs);
    }
    for (String name : filters) {
      if (!Filters.all().containsKey(name)) {
        throw wrongArguments(
            "there is no filter named "
                + name
                + "; there are "
                + String.join(", ", Filters.all().keySet()));
      }
    }
  }

  private void convert() throws IOException {
    Conversion.Result done;
    try (RecordingReader reader = reading.open(in);
        RecordingWriter writer = new StrictWriter(writing.create(out, reader.geometry()), reader);
        ProgressBar bar = progressBar("converting", in)) {
      FilterChain chain = chain(reader.geometry());
      Conversion conversion =
          new Conversion(
              fromUs == null ? Long.MIN_VALUE : fromUs,
              toUs == null ? Long.MAX_VALUE : toUs,
              filters.isEmpty() ? Optional.empty() : Optional.of(chain),
              bar);
      done = conversion.run(reader, writer);
      chain.close();
    }
    for (String warning : done.warnings()) {
      warning(in + ": " + warning);
    }
    if (done.eventsRead() == 0) {
      warning(in + ": there are no events" + (isPart() ? " in this stretch of time" : ""));
    }
    message(
        "wrote "
            + out
            + " ("
            + Quantities.events(done.eventsWritten())
            + (filters.isEmpty() ? "" : " of " + Quantities.count(done.eventsRead()))
            + ")");
  }

  private boolean isPart() {
    return fromUs != null || toUs != null;
  }

  private FilterChain chain(SensorGeometry geometry) {
    FilterChain chain = new FilterChain(geometry);
    for (String name : filters) {
      FilterProvider<?> provider = Filters.named(name);
      chain.add(provider);
    }
    return chain;
  }

  /** Completes nothing that a strict user objects to. */
  private final class StrictWriter implements RecordingWriter {
    private final RecordingWriter writer;
    private final RecordingReader reader;

    StrictWriter(RecordingWriter writer, RecordingReader reader) {
      this.writer = writer;
      this.reader = reader;
    }

    @Override
    public void write(EventPacket packet) throws IOException {
      writer.write(packet);
    }

    @Override
    public List<String> losses() {
      return writer.losses();
    }

    @Override
    public void finish() throws IOException {
      reading.requireWhole(reader);
      writer.finish();
    }

    @Override
    public void close() throws IOException {
      writer.close();
    }
  }
}
