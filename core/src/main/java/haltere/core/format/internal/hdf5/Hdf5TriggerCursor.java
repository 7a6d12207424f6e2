package haltere.core.format.internal.hdf5;

import haltere.core.event.SensorSample;
import haltere.core.event.Trigger;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.decoding.RowCursor;
import haltere.core.format.internal.decoding.SampleCursor;
import java.io.IOException;

/**
 * Reads the triggers of Prophesee's files, a list beside the events. They are few, so a seek reads
 * them from the first one on.
 *
 * <p>Thread rule: one thread.
 */
final class Hdf5TriggerCursor implements SampleCursor {
  private final EventTable.TriggerColumns columns;
  private final long fileBytes;
  private final ViolationCounts violations;
  private final ChunkDecompressor decompressor = new ChunkDecompressor();
  private final NumberColumn time;
  private final NumberColumn polarity;
  private final NumberColumn channel;
  private long row;
  private Trigger trigger;

  Hdf5TriggerCursor(
      ContainerFile file, EventTable.TriggerColumns columns, ViolationCounts violations) {
    this.columns = columns;
    this.violations = violations;
    fileBytes = file.bytes().size();
    DatasetRows rows = new DatasetRows(file, columns.time().dataset(), decompressor);
    time = new NumberColumn(rows, columns.time());
    polarity = new NumberColumn(rows, columns.polarity());
    channel = new NumberColumn(rows, columns.channel());
  }

  @Override
  public SampleStep next(long untilOffset) throws IOException {
    trigger = null;
    while (trigger == null) {
      if (row >= columns.rows()) {
        return SampleStep.END;
      }
      try {
        if (time.load(row) <= 0) {
          return SampleStep.END;
        }
        polarity.load(row);
        channel.load(row);
        row++;
        trigger = read();
      } catch (DamagedPacketException damaged) {
        violations.add(Violation.INCOMPLETE_SAMPLE, offset());
        row = Math.max(row + 1, time.rows().behindChunk(row));
      }
    }
    return SampleStep.SAMPLE;
  }

  /** The loaded trigger; null if its numbers are invalid. */
  private Trigger read() {
    long timeUs = time.value(0, 0);
    long number = channel.value(0, 0);
    if (timeUs == RowCursor.NO_NUMBER || number < 0 || number > Integer.MAX_VALUE) {
      violations.add(Violation.INCOMPLETE_SAMPLE, offset());
      return null;
    }
    return new Trigger(
        timeUs,
        Trigger.Source.EXTERNAL_INPUT,
        polarity.value(0, 0) > 0 ? Trigger.Edge.RISING : Trigger.Edge.FALLING,
        (int) number);
  }

  @Override
  public SensorSample sample() {
    return trigger;
  }

  /** {@inheritDoc} Proportional to the rows read, as that of the events. */
  @Override
  public long offset() {
    return (long) (fileBytes * ((double) row / columns.rows()));
  }

  @Override
  public void restore(long[] state, int at) {
    row = 0;
  }

  @Override
  public void close() {
    decompressor.close();
  }
}
