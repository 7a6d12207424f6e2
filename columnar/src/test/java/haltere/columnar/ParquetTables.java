package haltere.columnar;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.apache.parquet.column.page.PageReadStore;
import org.apache.parquet.example.data.Group;
import org.apache.parquet.example.data.simple.convert.GroupRecordConverter;
import org.apache.parquet.hadoop.ParquetFileReader;
import org.apache.parquet.io.ColumnIOFactory;
import org.apache.parquet.io.LocalInputFile;
import org.apache.parquet.io.RecordReader;
import org.apache.parquet.schema.MessageType;
import org.apache.parquet.schema.PrimitiveType.PrimitiveTypeName;
import org.apache.parquet.schema.Type;

/** Reads tables with the library's own reader. */
final class ParquetTables {
  /** All of a file. */
  record Content(
      List<String> columns,
      List<PrimitiveTypeName> types,
      Map<String, String> metadata,
      int rowGroups,
      List<List<Object>> rows) {}

  private ParquetTables() {}

  static Content read(Path file) throws IOException {
    try (ParquetFileReader reader = ParquetFileReader.open(new LocalInputFile(file))) {
      MessageType schema = reader.getFileMetaData().getSchema();
      List<List<Object>> rows = new ArrayList<>();
      for (PageReadStore pages = reader.readNextRowGroup();
          pages != null;
          pages = reader.readNextRowGroup()) {
        RecordReader<Group> records =
            new ColumnIOFactory()
                .getColumnIO(schema)
                .getRecordReader(pages, new GroupRecordConverter(schema));
        for (long i = 0; i < pages.getRowCount(); i++) {
          rows.add(row(records.read(), schema));
        }
      }
      return new Content(
          schema.getFields().stream().map(Type::getName).toList(),
          schema.getFields().stream()
              .map(column -> column.asPrimitiveType().getPrimitiveTypeName())
              .toList(),
          reader.getFileMetaData().getKeyValueMetaData(),
          reader.getRowGroups().size(),
          rows);
    }
  }

  private static List<Object> row(Group group, MessageType schema) {
    List<Object> values = new ArrayList<>();
    for (int i = 0; i < schema.getFieldCount(); i++) {
      values.add(group.getFieldRepetitionCount(i) == 0 ? null : value(group, i, schema));
    }
    return values;
  }

  private static Object value(Group group, int column, MessageType schema) {
    return switch (schema.getType(column).asPrimitiveType().getPrimitiveTypeName()) {
      case INT64 -> group.getLong(column, 0);
      case INT32 -> group.getInteger(column, 0);
      case DOUBLE -> group.getDouble(column, 0);
      case FLOAT -> group.getFloat(column, 0);
      case BOOLEAN -> group.getBoolean(column, 0);
      default -> group.getString(column, 0);
    };
  }
}
