/**
 * ROS bags: messages of several topics, one of which is read for events.
 *
 * <p><b>Containers.</b> ROS 1 bags (version 2.0): records in chunks, uncompressed or compressed
 * with LZ4 or bzip2. MCAP: the same with LZ4 or Zstandard, or messages without chunks. ROS 2 bags
 * in SQLite files: a table of messages. A container's walk finds the messages, in the order of the
 * file; their decoders are shared by all containers.
 *
 * <p><b>Messages.</b> {@code dvs_msgs/EventArray} and {@code prophesee_event_msgs/EventArray} hold
 * single events; {@code event_camera_msgs/EventPacket} and its predecessor {@code
 * event_array_msgs/EventArray} bytes in a stated encoding: {@code evt3}, {@code libcaer}, {@code
 * libcaer_cmp}, {@code mono}. Messages of the encoding {@code trigger} are counted.
 *
 * <p><b>Times.</b> They depend on the message. An EventArray has the ROS time of each event,
 * microseconds since 1970. {@code libcaer} and {@code libcaer_cmp} add the ROS time of the driver's
 * start to the camera's time. {@code mono} and {@code evt3} have the camera's clock; {@code evt3}
 * has no time base, so that the wraps after 16.8 s are counted as in a RAW file. The time of
 * recording of a message is not used.
 *
 * <p><b>Rows</b> count from the top in all of these messages.
 *
 * <p><b>Damage.</b> Messages before it are read. After a damaged chunk the next one is found by the
 * chunk's length or, if that is impossible, by the index at the file's end. Memory is independent
 * of stated lengths: chunks and messages are decompressed and decoded piece by piece.
 */
package haltere.core.format.internal.bag;
