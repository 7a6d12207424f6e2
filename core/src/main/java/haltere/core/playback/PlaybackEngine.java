package haltere.core.playback;

import haltere.core.chain.FilterChain;
import haltere.core.stream.StreamNotification;
import java.util.concurrent.CompletableFuture;

/** The work of a {@link Player}. */
final class PlaybackEngine {
  /** Most events that go to the chain at a time. */
  static final int CHUNK_EVENTS = 4096;

  private final Playable playable;
  private final PlayerOptions options;

  PlaybackEngine(Playable playable, FilterChain chain, PlayerOptions options) {
    this.playable = playable;
    this.options = options;
  }

  CompletableFuture<Void> submit(PlaybackCommand command) {
    return CompletableFuture.failedFuture(new UnsupportedOperationException(command.toString()));
  }

  CompletableFuture<Void> start() {
    return CompletableFuture.failedFuture(new UnsupportedOperationException("start"));
  }

  PlayerStatus status() {
    return new PlayerStatus(
        PlayerStatus.State.PAUSED,
        0,
        StreamNotification.NO_TIME_US,
        playable.durationUs().orElse(-1),
        options.speed(),
        0,
        0,
        "",
        0,
        0,
        0,
        0,
        0,
        "");
  }

  Playable playable() {
    return playable;
  }

  void close() {}
}
