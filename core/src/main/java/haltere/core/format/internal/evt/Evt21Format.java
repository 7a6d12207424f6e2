package haltere.core.format.internal.evt;

import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingWriter;
import haltere.core.format.ViolationCounts;
import haltere.core.format.WriteOptions;
import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;

/** Prophesee RAW in the encoding EVT2.1: read in both layouts, written in the current one. */
public final class Evt21Format extends EvtFormat {
  private static final int PROBE_BYTES = 64 * 1024;

  private final boolean legacy;

  /** Called by the service loader. */
  public Evt21Format() {
    this(false);
  }

  private Evt21Format(boolean legacy) {
    this.legacy = legacy;
  }

  @Override
  public String name() {
    return "evt21";
  }

  @Override
  public String description() {
    return "Prophesee RAW, EVT2.1";
  }

  @Override
  public Set<String> extensions() {
    return new LinkedHashSet<>(List.of("evt21", "raw"));
  }

  @Override
  String encoding() {
    return "EVT21";
  }

  @Override
  TriggerWords.WordEncoding words() {
    return legacy ? TriggerWords.WordEncoding.EVT21_LEGACY : TriggerWords.WordEncoding.EVT21;
  }

  @Override
  EvtDecoder decoder(SensorGeometry geometry, long firstTurnUs, ViolationCounts violations) {
    return new Evt21Decoder(geometry, firstTurnUs, legacy, violations);
  }

  /** Detects the layout: by the header, else by the words. */
  @Override
  EvtFormat fitted(RecordingFile file, PropheseeHeader header, List<String> remarks)
      throws IOException {
    String stated =
        header
            .formatOption("endianness")
            .or(() -> header.value("endianness"))
            .orElse("")
            .toLowerCase(Locale.ROOT);
    if (stated.equals("legacy") || stated.equals("little")) {
      return new Evt21Format(stated.equals("legacy"));
    }
    byte[] start = file.read(header.dataOffset(), PROBE_BYTES);
    boolean swapped =
        Evt21Decoder.plausibleWords(start, 0, true) > Evt21Decoder.plausibleWords(start, 0, false);
    if (swapped) {
      remarks.add("the halves of the words are swapped (legacy), which the header does not state");
    }
    return new Evt21Format(swapped);
  }

  @Override
  public Optional<RecordingWriter> create(Path file, WriteOptions options) throws IOException {
    return Optional.of(new Evt21Writer(file, options));
  }
}
