package haltere.core.format;

import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import java.util.Objects;
import java.util.Optional;

/**
 * Properties of a recording that its file does not state, given by the user.
 *
 * @param sensor size of the sensor if the file does not state it; the file has priority
 * @param format name of the format, which overrides detection by content
 * @param topic stream of events to read if there are several: the name of a bag's topic, the number
 *     or camera of an AEDAT-4 stream, the path of a group or table of an HDF5 file, or the name of
 *     an array of a NumPy file
 * @param origin origin of rows in plain tables of events (text, NumPy, HDF5) that do not state it;
 *     the default is the top
 * @param packetEvents events per packet at most, 1 to 1,048,576
 * @param samples whether frames, inertial samples and triggers are read as well
 * @param keepIndex whether the index for seeking is stored in a file beside the recording; an
 *     existing one is always used
 * @since 0.1
 */
public record ReadOptions(
    Optional<SensorGeometry> sensor,
    Optional<String> format,
    Optional<String> topic,
    Optional<Origin> origin,
    int packetEvents,
    boolean samples,
    boolean keepIndex) {
  /** The default options. */
  public static final ReadOptions DEFAULT =
      new ReadOptions(
          Optional.empty(),
          Optional.empty(),
          Optional.empty(),
          Optional.empty(),
          8192,
          false,
          false);

  /** Checks the values. */
  public ReadOptions {
    Objects.requireNonNull(sensor, "sensor");
    Objects.requireNonNull(format, "format");
    Objects.requireNonNull(topic, "topic");
    Objects.requireNonNull(origin, "origin");
    if (packetEvents < 1 || packetEvents > 1 << 20) {
      throw new IllegalArgumentException(
          "packets hold 1 to " + (1 << 20) + " events, not " + packetEvents);
    }
  }

  /**
   * The same options with another sensor.
   *
   * @param geometry the sensor's size
   * @return new options
   */
  public ReadOptions withSensor(SensorGeometry geometry) {
    return new ReadOptions(
        Optional.of(geometry), format, topic, origin, packetEvents, samples, keepIndex);
  }

  /**
   * The same options with another format.
   *
   * @param name a format's name
   * @return new options
   */
  public ReadOptions withFormat(String name) {
    return new ReadOptions(
        sensor, Optional.of(name), topic, origin, packetEvents, samples, keepIndex);
  }

  /**
   * The same options with another topic.
   *
   * @param name of a topic of events
   * @return new options
   */
  public ReadOptions withTopic(String name) {
    return new ReadOptions(
        sensor, format, Optional.of(name), origin, packetEvents, samples, keepIndex);
  }

  /**
   * The same options with another origin of rows.
   *
   * @param from of plain tables that do not state it
   * @return new options
   */
  public ReadOptions withOrigin(Origin from) {
    return new ReadOptions(
        sensor, format, topic, Optional.of(from), packetEvents, samples, keepIndex);
  }

  /**
   * The same options with another size of packets.
   *
   * @param events events per packet at most
   * @return new options
   */
  public ReadOptions withPacketEvents(int events) {
    return new ReadOptions(sensor, format, topic, origin, events, samples, keepIndex);
  }

  /**
   * The same options with or without samples.
   *
   * @param wanted whether frames, inertial samples and triggers are read as well
   * @return new options
   */
  public ReadOptions withSamples(boolean wanted) {
    return new ReadOptions(sensor, format, topic, origin, packetEvents, wanted, keepIndex);
  }

  /**
   * The same options with another index.
   *
   * @param kept whether the index is kept in a file beside the recording
   * @return new options
   */
  public ReadOptions withKeptIndex(boolean kept) {
    return new ReadOptions(sensor, format, topic, origin, packetEvents, samples, kept);
  }
}
