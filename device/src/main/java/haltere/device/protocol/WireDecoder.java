package haltere.device.protocol;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorSample;
import java.nio.ByteBuffer;

/**
 * Turns the bytes of a camera into packets, samples and resets of its clock, in the order of the
 * stream. Pure: all state is in the object. What is wrong in the bytes is counted, never thrown.
 *
 * <p>Thread rule: one thread; {@link #oddWords} may be called from any.
 */
public interface WireDecoder {
  /** Why {@link #decode} came back. */
  enum Stop {
    /** No whole word is left in the input; a rest of it has been counted and skipped. */
    INPUT_USED,
    /** The packet holds as many events as were asked for. */
    PACKET_FULL,
    /** A frame, an inertial sample or a trigger stands here: {@link #sample}. */
    SAMPLE,
    /** The camera's clock was reset here; later times may be smaller. */
    CLOCK_RESET
  }

  /**
   * Decodes until something other than an event, or the end of input or packet.
   *
   * @param in bytes of one transfer; its position moves behind what was decoded
   * @param out events are appended; their times never descend
   * @param maxEvents events that the packet may hold, more than it holds
   * @return why it came back
   */
  Stop decode(ByteBuffer in, EventPacket out, int maxEvents);

  /**
   * What {@link #decode} came to.
   *
   * @return the sample; only after {@link Stop#SAMPLE}
   */
  SensorSample sample();

  /** Bytes are missing here: incomplete data are dropped, and the next time is arbitrary. */
  void breakOff();

  /**
   * Words without a meaning, bytes that are no whole word, and times that cannot be true.
   *
   * @return a count since the decoder was made
   */
  long oddWords();

  /**
   * An empty note of bytes that this decoder will not get.
   *
   * @return a note
   */
  DroppedWords droppedWords();
}
