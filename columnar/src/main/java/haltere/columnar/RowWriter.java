package haltere.columnar;

import haltere.core.json.internal.Json;
import haltere.core.sink.ColumnUnit;
import haltere.core.sink.RowFields;
import haltere.core.sink.TableMetadata;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.LinkedHashMap;
import java.util.Map;
import org.apache.hadoop.conf.Configuration;
import org.apache.parquet.conf.ParquetConfiguration;
import org.apache.parquet.hadoop.api.WriteSupport;
import org.apache.parquet.io.api.Binary;
import org.apache.parquet.io.api.RecordConsumer;
import org.apache.parquet.schema.LogicalTypeAnnotation;
import org.apache.parquet.schema.MessageType;
import org.apache.parquet.schema.PrimitiveType;
import org.apache.parquet.schema.PrimitiveType.PrimitiveTypeName;
import org.apache.parquet.schema.Type;
import org.apache.parquet.schema.Types;

/**
 * Writes the components of records as Parquet columns, and the metadata at the end.
 *
 * @param <R> type of the rows
 */
final class RowWriter<R extends Record> extends WriteSupport<R> implements RowFields.Values {
  private final RowFields fields;
  private final TableMetadata metadata;
  private final MessageType schema;
  private RecordConsumer out;
  private int index;

  RowWriter(RowFields fields, TableMetadata metadata) {
    this.fields = fields;
    this.metadata = metadata;
    Type[] columns = new Type[fields.names().size()];
    for (int i = 0; i < columns.length; i++) {
      columns[i] = type(fields.kinds().get(i)).named(fields.names().get(i));
    }
    schema = new MessageType("row", columns);
  }

  private static Types.PrimitiveBuilder<PrimitiveType> type(RowFields.FieldKind kind) {
    return switch (kind) {
      case LONG -> Types.optional(PrimitiveTypeName.INT64);
      case INTEGER -> Types.optional(PrimitiveTypeName.INT32);
      case DOUBLE -> Types.optional(PrimitiveTypeName.DOUBLE);
      case FLOAT -> Types.optional(PrimitiveTypeName.FLOAT);
      case FLAG -> Types.optional(PrimitiveTypeName.BOOLEAN);
      case TEXT -> Types.optional(PrimitiveTypeName.BINARY).as(LogicalTypeAnnotation.stringType());
    };
  }

  @Override
  @SuppressWarnings("deprecation") // abstract all the same
  public WriteContext init(Configuration unused) {
    return context();
  }

  @Override
  public WriteContext init(ParquetConfiguration unused) {
    return context();
  }

  private WriteContext context() {
    Map<String, String> units = new LinkedHashMap<>();
    for (String name : fields.names()) {
      ColumnUnit.of(name).ifPresent(unit -> units.put(name, unit.symbol()));
    }
    return new WriteContext(schema, Map.of("haltere.units", Json.write(units)));
  }

  @Override
  public FinalizedWriteContext finalizeWrite() {
    try {
      return new FinalizedWriteContext(metadata.entries());
    } catch (IOException thrown) {
      throw new UncheckedIOException(thrown);
    }
  }

  @Override
  public void prepareForWrite(RecordConsumer consumer) {
    out = consumer;
  }

  @Override
  public void write(R row) {
    out.startMessage();
    for (index = 0; index < schema.getFieldCount(); index++) {
      fields.write(index, row, this);
    }
    out.endMessage();
  }

  private void start() {
    out.startField(schema.getFieldName(index), index);
  }

  private void end() {
    out.endField(schema.getFieldName(index), index);
  }

  @Override
  public void number(long value) {
    start();
    if (fields.kinds().get(index) == RowFields.FieldKind.LONG) {
      out.addLong(value);
    } else {
      out.addInteger((int) value);
    }
    end();
  }

  @Override
  public void number(double value, int decimals) {
    if (!Double.isNaN(value)) {
      start();
      out.addDouble(value);
      end();
    }
  }

  @Override
  public void number(float value, int decimals) {
    if (!Float.isNaN(value)) {
      start();
      out.addFloat(value);
      end();
    }
  }

  @Override
  public void flag(boolean value) {
    start();
    out.addBoolean(value);
    end();
  }

  @Override
  public void text(CharSequence value) {
    start();
    out.addBinary(Binary.fromString(value.toString()));
    end();
  }

  @Override
  public void nothing() {
    // a field that was not started is null
  }
}
