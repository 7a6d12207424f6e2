package haltere.core.playback;

import haltere.core.stream.internal.Daemon;
import java.util.ArrayDeque;
import java.util.concurrent.CompletableFuture;

/** The processing thread of a {@link Player} and its queue of commands. */
final class PlaybackThread {
  private record Request(PlaybackCommand command, CompletableFuture<Void> done) {}

  private final PlaybackEngine engine;
  private final Sleeper sleeper;
  private final Object lock = new Object();
  private final ArrayDeque<Request> requests = new ArrayDeque<>();
  private Thread thread;
  private boolean closing;

  PlaybackThread(PlaybackEngine engine, Sleeper sleeper) {
    this.engine = engine;
    this.sleeper = sleeper;
  }

  PlayerStatus status() {
    return engine.status();
  }

  Playable playable() {
    return engine.playable();
  }

  CompletableFuture<Void> submit(PlaybackCommand command) {
    CompletableFuture<Void> done = new CompletableFuture<>();
    synchronized (lock) {
      if (closing) {
        return CompletableFuture.failedFuture(closed());
      }
      requests.add(new Request(command, done));
    }
    sleeper.wake();
    return done;
  }

  CompletableFuture<Void> start() {
    synchronized (lock) {
      if (closing) {
        return CompletableFuture.failedFuture(closed());
      }
      if (thread != null) {
        throw new IllegalStateException("the player has been started already");
      }
      CompletableFuture<Void> started = new CompletableFuture<>();
      thread = Daemon.thread(() -> run(started), "haltere-player");
      thread.start();
      return started;
    }
  }

  private void run(CompletableFuture<Void> started) {
    try {
      engine.start(started);
      while (work()) {
        long nanos = engine.turn();
        if (nanos > 0) {
          sleeper.sleep(nanos);
        }
      }
    } catch (InterruptedException interrupted) {
      Thread.currentThread().interrupt();
    } catch (Error fault) {
      engine.fail(fault);
      throw fault;
    } finally {
      finish();
    }
  }

  /** Applies commands; false at the end. */
  private boolean work() {
    while (true) {
      Request next;
      boolean superseded;
      synchronized (lock) {
        if (closing) {
          return false;
        }
        next = requests.poll();
        if (next == null) {
          return true;
        }
        superseded =
            next.command() instanceof PlaybackCommand.Seek
                && !requests.isEmpty()
                && requests.peek().command() instanceof PlaybackCommand.Seek;
        if (superseded) {
          CompletableFuture<Void> done = next.done();
          requests
              .peek()
              .done()
              .whenComplete(
                  (nothing, thrown) -> {
                    if (thrown == null) {
                      done.complete(null);
                    } else {
                      done.completeExceptionally(thrown);
                    }
                  });
        }
      }
      if (!superseded) {
        engine.apply(next.command(), next.done());
      }
    }
  }

  private void finish() {
    ArrayDeque<Request> left;
    synchronized (lock) {
      closing = true;
      left = new ArrayDeque<>(requests);
      requests.clear();
    }
    engine.close();
    left.forEach(one -> one.done().completeExceptionally(closed()));
  }

  private static IllegalStateException closed() {
    return new IllegalStateException("the player is closed");
  }

  void close() {
    Thread running;
    boolean first;
    synchronized (lock) {
      first = !closing;
      closing = true;
      running = thread;
    }
    sleeper.wake();
    if (running == null) {
      if (first) {
        finish();
      }
      return;
    }
    if (running == Thread.currentThread()) {
      return;
    }
    try {
      running.join();
    } catch (InterruptedException interrupted) {
      Thread.currentThread().interrupt();
    }
  }
}
