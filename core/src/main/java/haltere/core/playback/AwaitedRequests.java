package haltere.core.playback;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;

/**
 * What was asked for and is still to be done: jumps whose notification is to be given, and slices
 * to show although playback is paused; with the futures of those who wait.
 *
 * <p>Thread rule: the processing thread only; it completes the futures.
 */
final class AwaitedRequests {
  private final List<CompletableFuture<Void>> jumps = new ArrayList<>();
  private final List<CompletableFuture<Void>> steps = new ArrayList<>();
  private int stepsLeft;

  /** Completes a future when the next notification of a jump has been given. */
  void awaitJump(CompletableFuture<Void> done) {
    jumps.add(done);
  }

  /** Asks for more slices, and completes a future when they have been shown. */
  void addSteps(int slices, CompletableFuture<Void> done) {
    stepsLeft += slices;
    steps.add(done);
  }

  /** Asks for one slice, whatever was asked for before. */
  void awaitSlice(CompletableFuture<Void> done) {
    awaitSlice();
    steps.add(done);
  }

  /** Asks for one slice for which nobody waits. */
  void awaitSlice() {
    stepsLeft = 1;
  }

  /** Whether there are slices to show without waiting for the clock. */
  boolean stepping() {
    return stepsLeft > 0;
  }

  /** A slice has been shown; true if it was the last one asked for. */
  boolean sliceShown() {
    return stepsLeft > 0 && --stepsLeft == 0;
  }

  /** The notification of a jump has been given. */
  void jumped() {
    complete(jumps);
  }

  /** All slices have been shown, or are no longer wanted. */
  void endSteps() {
    stepsLeft = 0;
    complete(steps);
  }

  /** Nothing of it will be done. */
  void fail(Throwable thrown) {
    List<CompletableFuture<Void>> waiting = new ArrayList<>(jumps);
    waiting.addAll(steps);
    jumps.clear();
    steps.clear();
    stepsLeft = 0;
    waiting.forEach(future -> future.completeExceptionally(thrown));
  }

  /** Whoever is told may ask for more at once. */
  private static void complete(List<CompletableFuture<Void>> futures) {
    List<CompletableFuture<Void>> now = List.copyOf(futures);
    futures.clear();
    now.forEach(future -> future.complete(null));
  }
}
