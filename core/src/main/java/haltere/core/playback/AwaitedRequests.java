package haltere.core.playback;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;

/**
 * Pending requests and their futures: jumps whose notification is still to be sent, and slices to
 * show while playback is paused.
 *
 * <p>Thread rule: the processing thread only; it completes the futures.
 */
final class AwaitedRequests {
  private final List<CompletableFuture<Void>> jumps = new ArrayList<>();
  private final List<CompletableFuture<Void>> steps = new ArrayList<>();
  private int stepsLeft;

  /** Completes a future when the next notification of a jump has been sent. */
  void awaitJump(CompletableFuture<Void> done) {
    jumps.add(done);
  }

  /** Requests more slices, and completes a future when they have been shown. */
  void addSteps(int slices, CompletableFuture<Void> done) {
    stepsLeft += slices;
    steps.add(done);
  }

  /** Requests one slice in place of earlier requests. */
  void awaitSlice(CompletableFuture<Void> done) {
    awaitSlice();
    steps.add(done);
  }

  /** The same without a future. */
  void awaitSlice() {
    stepsLeft = 1;
  }

  /** Whether there are slices to show without waiting for the clock. */
  boolean stepping() {
    return stepsLeft > 0;
  }

  /** A slice has been shown; true if it was the last requested one. */
  boolean sliceShown() {
    return stepsLeft > 0 && --stepsLeft == 0;
  }

  /** The notification of a jump has been sent. */
  void jumped() {
    complete(jumps);
  }

  /** Completes all requests for slices. */
  void endSteps() {
    stepsLeft = 0;
    complete(steps);
  }

  /** Fails all requests. */
  void fail(Throwable thrown) {
    List<CompletableFuture<Void>> waiting = new ArrayList<>(jumps);
    waiting.addAll(steps);
    jumps.clear();
    steps.clear();
    stepsLeft = 0;
    waiting.forEach(future -> future.completeExceptionally(thrown));
  }

  /** Completes copies, because a completion may add new requests. */
  private static void complete(List<CompletableFuture<Void>> futures) {
    List<CompletableFuture<Void>> now = List.copyOf(futures);
    futures.clear();
    now.forEach(future -> future.complete(null));
  }
}
