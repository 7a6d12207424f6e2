package haltere.device.protocol;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorSample;
import java.nio.ByteBuffer;

/**
 * Decodes the bytes of a camera into packets, samples and clock resets, in the order of the stream.
 * All state is in the object. Invalid bytes are counted, not thrown.
 *
 * <p>Thread rule: one thread; {@link #unknownWords} may be called from any.
 */
public interface WireDecoder {
  /** Reason for the return of {@link #decode}. */
  enum Stop {
    /** The input has no complete word left; a remainder has been counted and skipped. */
    INPUT_USED,
    /** The packet has the requested number of events. */
    PACKET_FULL,
    /** A frame, an inertial sample or a trigger: {@link #sample}. */
    SAMPLE,
    /** The camera's clock was reset here; later times may be smaller. */
    CLOCK_RESET
  }

  /**
   * Decodes until something other than an event, or the end of input or packet.
   *
   * @param in bytes of one transfer; its position is advanced past the decoded bytes
   * @param out events are appended; their times never descend
   * @param maxEvents events that the packet may hold, more than it holds
   * @return the reason
   */
  Stop decode(ByteBuffer in, EventPacket out, int maxEvents);

  /**
   * The sample found by {@link #decode}.
   *
   * @return the sample; only after {@link Stop#SAMPLE}
   */
  SensorSample sample();

  /**
   * Handles missing bytes that {@link DroppedWords} summarise: incomplete data are dropped, and the
   * next time is arbitrary.
   */
  void breakOff();

  /**
   * Handles missing bytes of unknown content: incomplete data are dropped, and events whose row or
   * time may be among the missing bytes. The camera's clock does not go back.
   */
  void breakOffUnknown();

  /**
   * Number of invalid words, incomplete words and impossible times.
   *
   * @return a count since the decoder was created
   */
  long unknownWords();

  /**
   * An empty summary for bytes dropped before this decoder.
   *
   * @return a summary
   */
  DroppedWords droppedWords();
}
