package haltere.core.format.internal.evt;

import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingWriter;
import haltere.core.format.ViolationCounts;
import haltere.core.format.WriteOptions;
import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** Prophesee RAW in the encoding EVT3, which is written to {@code .raw} files. */
public final class Evt3Format extends EvtFormat {
  /** Called by the service loader. */
  public Evt3Format() {}

  @Override
  public String name() {
    return "evt3";
  }

  @Override
  public String description() {
    return "Prophesee RAW, EVT3";
  }

  @Override
  public Set<String> extensions() {
    return new LinkedHashSet<>(List.of("raw", "evt3"));
  }

  @Override
  String encoding() {
    return "EVT3";
  }

  @Override
  TriggerWords.WordEncoding words() {
    return TriggerWords.WordEncoding.EVT3;
  }

  @Override
  EvtDecoder decoder(SensorGeometry geometry, long firstTurnUs, ViolationCounts violations) {
    return new Evt3Decoder(geometry, firstTurnUs, violations);
  }

  @Override
  public Optional<RecordingWriter> create(Path file, WriteOptions options) throws IOException {
    return Optional.of(new Evt3Writer(file, options));
  }
}
