package haltere.core.format.internal.aedat2;

import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.decoding.FileCursor;
import haltere.core.format.internal.reader.DecodingReader;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import java.util.Optional;

/** Common parts of the readers of AEDAT-1.0 and AEDAT-2.0 have in common. */
final class AedatReader {
  private static final int FIRST_BYTES = 256 * 1024;
  private static final int MAX_HEADER = 16 * 1024 * 1024;

  private AedatReader() {}

  static AedatHeader header(RecordingFile file) throws IOException {
    for (int headBytes = FIRST_BYTES; headBytes <= MAX_HEADER; headBytes *= 4) {
      ByteBuffer bytes = ByteBuffer.allocate((int) Math.min(headBytes, Math.max(1, file.size())));
      file.read(bytes, 0);
      Optional<AedatHeader> header =
          AedatHeader.parse(bytes.array(), bytes.limit(), bytes.limit() >= file.size());
      if (header.isPresent()) {
        return header.get();
      }
    }
    throw new RecordingProblem(
        file.path(), MAX_HEADER, "the text header does not end; this is not an AEDAT recording");
  }

  static RecordingReader open(
      String formatName,
      RecordingFile file,
      AedatHeader header,
      AedatSensor sensor,
      List<String> remarks,
      int recordBytes,
      ReadOptions options)
      throws IOException {
    ViolationCounts found = new ViolationCounts();
    if (header.cutOff()) {
      found.add(Violation.CUT_OFF, header.dataOffset());
    }
    InertialRange range = InertialRange.of(file.read(0, header.dataOffset()));
    boolean fromCamera =
        sensor.layout() == AedatSensor.AddressLayout.DAVIS && header.sensor().isEmpty();
    Optional<String> rangeRemark = fromCamera ? range.remark() : Optional.empty();
    return new DecodingReader(
        formatName,
        file,
        sensor.geometry(),
        remarks,
        options,
        found,
        violations ->
            new FileCursor(
                file,
                header.dataOffset(),
                ByteOrder.BIG_ENDIAN,
                new RecordDecoder(
                    sensor.decoder(), recordBytes, header.firstTurnUs().orElse(0), violations),
                violations),
        Optional.of(
            violations ->
                new AedatSampleCursor(
                    file,
                    header.dataOffset(),
                    recordBytes,
                    sensor,
                    header.firstTurnUs().orElse(0),
                    range,
                    rangeRemark,
                    violations)));
  }
}
