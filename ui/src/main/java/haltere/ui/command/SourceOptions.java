package haltere.ui.command;

import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import picocli.CommandLine.Option;

/** Properties of recordings that users state because files do not. */
class SourceOptions extends OptionGroup {
  @Option(
      names = "--sensor",
      paramLabel = "WxH",
      converter = SensorConverter.class,
      description = "The sensor's size if the file does not state it, such as 346x260.")
  SensorGeometry sensor;

  @Option(
      names = "--rows",
      paramLabel = "top|bottom",
      description =
          "Origin of the rows in a text, NumPy or HDF5 recording that does not state "
              + "it; default top.")
  Origin rows;

  @Option(
      names = "--topic",
      paramLabel = "NAME",
      description = "Events to read of several: a bag's topic, an AEDAT-4 stream, an HDF5 group.")
  String topic;

  @Option(
      names = "--strict",
      description = "Treat a truncated or damaged recording as an error (status 1).")
  boolean strict;

  /** These options on top of others. */
  ReadOptions apply(ReadOptions to) {
    ReadOptions options = sensor == null ? to : to.withSensor(sensor);
    options = rows == null ? options : options.withOrigin(rows);
    return topic == null ? options : options.withTopic(topic);
  }
}
