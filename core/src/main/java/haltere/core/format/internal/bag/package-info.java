/**
 * Bags of ROS: messages of many topics, of which one with events is read.
 *
 * <p><b>Containers.</b> ROS 1 bags (version 2.0): records in chunks that are compressed with LZ4,
 * bzip2 or not at all. MCAP: the same with LZ4 or Zstandard, or messages without chunks. ROS 2 bags
 * in SQLite files: a table of messages. A container's walk finds the messages, in the order of the
 * file; what is in them is decoded by the same code whatever the container.
 *
 * <p><b>Messages.</b> {@code dvs_msgs/EventArray} and {@code prophesee_event_msgs/EventArray} hold
 * events one by one; {@code event_camera_msgs/EventPacket} and its predecessor {@code
 * event_array_msgs/EventArray} bytes in an encoding that they name: {@code evt3}, {@code libcaer},
 * {@code libcaer_cmp}, {@code mono}. Messages of the encoding {@code trigger} are counted.
 *
 * <p><b>What a time means.</b> It depends on the message. An EventArray has a time of ROS for each
 * event, microseconds since 1970. {@code libcaer} and {@code libcaer_cmp} add the time of ROS at
 * which the driver started to the camera's. {@code mono} and {@code evt3} are the camera's own
 * clock; {@code evt3} has no base of time, so that the words' turns of 16.8 s are counted as in a
 * RAW file. When a message was recorded is not used.
 *
 * <p><b>Rows</b> count from the top in all of these messages.
 *
 * <p><b>Damage.</b> Messages before it are read. Behind a damaged chunk the next one is found by
 * the chunk's length or, where that cannot be, by the index at the file's end. No length in a file
 * makes memory grow: chunks and messages are decompressed and decoded piece by piece.
 */
package haltere.core.format.internal.bag;
