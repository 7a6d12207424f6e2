package haltere.core.playback;

import haltere.core.chain.FilterChain;
import haltere.core.stream.StreamHandler;
import java.util.function.Consumer;

/** A command to a player, applied between two packets. */
sealed interface PlaybackCommand {
  record Play(boolean on) implements PlaybackCommand {}

  record Toggle() implements PlaybackCommand {}

  record Step(int slices) implements PlaybackCommand {}

  record Seek(long elapsedUs) implements PlaybackCommand {}

  record Rewind() implements PlaybackCommand {}

  record SetSpeed(double speed) implements PlaybackCommand {}

  record SetSlicing(Slicing slicing) implements PlaybackCommand {}

  record SetLoop(Loop loop) implements PlaybackCommand {}

  record UserReset() implements PlaybackCommand {}

  record Edit(Consumer<FilterChain> change, boolean manual) implements PlaybackCommand {}

  record Read(Consumer<FilterChain> reader) implements PlaybackCommand {}

  record Refresh() implements PlaybackCommand {}

  record AddSink(StreamHandler sink, boolean raw) implements PlaybackCommand {}

  record RemoveSink(StreamHandler sink) implements PlaybackCommand {}
}
