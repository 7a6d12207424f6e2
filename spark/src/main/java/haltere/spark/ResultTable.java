package haltere.spark;

import haltere.core.chain.ChainFile;
import haltere.core.chain.FilterChain;
import haltere.core.event.SensorGeometry;
import haltere.core.pipeline.OutletTables;
import haltere.core.sink.RowFields;
import java.io.IOException;
import java.io.Serializable;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.apache.spark.sql.types.DataType;
import org.apache.spark.sql.types.DataTypes;
import org.apache.spark.sql.types.StructType;

/**
 * Table of results of a chain: an outlet whose results are records.
 *
 * @param name STAGE.OUTLET
 * @param schema column {@link #RECORDING}, then the columns of CSV
 */
record ResultTable(String name, StructType schema) implements Serializable {
  /** Name of the column that names the recording. */
  static final String RECORDING = "recording";

  /** Arbitrary sensor: the outlets of a chain do not depend on it. */
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);

  /** Tables of a chain, in its order. */
  static List<ResultTable> of(String chain) throws IOException {
    List<ResultTable> tables = new ArrayList<>();
    try (FilterChain filters = ChainFile.parse(chain, "the chain", SENSOR)) {
      OutletTables.files(
          filters,
          (stage, outlet) -> {
            String name = stage.name() + "." + outlet.name();
            tables.add(new ResultTable(name, schema(outlet.type().asSubclass(Record.class))));
            return Path.of(name);
          });
    }
    return tables;
  }

  private static StructType schema(Class<? extends Record> type) {
    RowFields fields = new RowFields(type);
    StructType schema = new StructType().add(RECORDING, DataTypes.StringType, false);
    for (int i = 0; i < fields.names().size(); i++) {
      schema = schema.add(fields.names().get(i), type(fields.kinds().get(i)), true);
    }
    return schema;
  }

  private static DataType type(RowFields.FieldKind kind) {
    return switch (kind) {
      case LONG -> DataTypes.LongType;
      case INTEGER -> DataTypes.IntegerType;
      case DOUBLE -> DataTypes.DoubleType;
      case FLOAT -> DataTypes.FloatType;
      case FLAG -> DataTypes.BooleanType;
      case TEXT -> DataTypes.StringType;
    };
  }

  /** Number of columns without the recording. */
  int columns() {
    return schema.size() - 1;
  }
}
