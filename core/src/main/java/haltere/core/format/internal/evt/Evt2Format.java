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

/** Prophesee RAW in the encoding EVT2: read and written. */
public final class Evt2Format extends EvtFormat {
  /** Called by the service loader. */
  public Evt2Format() {}

  @Override
  public String name() {
    return "evt2";
  }

  @Override
  public String description() {
    return "Prophesee RAW, EVT2";
  }

  @Override
  public Set<String> extensions() {
    return new LinkedHashSet<>(List.of("evt2", "raw"));
  }

  @Override
  String encoding() {
    return "EVT2";
  }

  @Override
  TriggerWords.WordEncoding words() {
    return TriggerWords.WordEncoding.EVT2;
  }

  @Override
  EvtDecoder decoder(SensorGeometry geometry, long firstTurnUs, ViolationCounts violations) {
    return new Evt2Decoder(geometry, firstTurnUs, violations);
  }

  @Override
  public Optional<RecordingWriter> create(Path file, WriteOptions options) throws IOException {
    return Optional.of(new Evt2Writer(file, options));
  }
}
