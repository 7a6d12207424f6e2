package haltere.device.usb;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.camera.CameraOptions.WhenFull;
import haltere.device.protocol.Dvs128Decoder;
import haltere.testing.Waiting;
import java.io.InterruptedIOException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Transfers that end in ways that the emulated buses do not produce. */
@Timeout(60)
class TransferRingTest {
  private static final int TRANSFERS = 4;
  private static final int WAITING = 8;
  private static final int BYTES = 64;
  private static final int MAX_FAILURES = 16;

  private final ManualTransfers device = new ManualTransfers();
  private final ReceivedBuffers buffers =
      new ReceivedBuffers(
          TRANSFERS,
          WAITING,
          BYTES,
          WhenFull.DROP_NEWEST,
          new Dvs128Decoder(false)::droppedWords,
          BusWork.ELSEWHERE);
  private final TransferRing ring = new TransferRing(device, 0x86, TRANSFERS, buffers);

  private int takenEvents() throws InterruptedIOException {
    int events = 0;
    for (Received next = buffers.take(0); next != null; next = buffers.take(0)) {
      events += next.bytes().remaining() / Integer.BYTES;
      buffers.release(next);
    }
    return events;
  }

  /** MacOS says of an unplugged device that one transfer failed and the others were cancelled. */
  @Test
  void cancelledTransfersOfALostDeviceDeliverTheirData() throws Exception {
    ring.start();
    device.transfers.get(0).end(TransferEnd.COMPLETED, 3);
    device.transfers.get(1).end(TransferEnd.CANCELLED, 2);
    assertFalse(buffers.isAtEndOfDevice(), "others may carry something still");
    device.transfers.get(2).end(TransferEnd.CANCELLED, 5);
    device.transfers.get(3).end(TransferEnd.CANCELLED, 0);
    device.transfers.get(0).end(TransferEnd.CANCELLED, 1);

    assertEquals(3 + 2 + 5 + 1, takenEvents());
    assertTrue(buffers.isAtEndOfDevice());
    assertTrue(ring.stop());
    assertEquals(TRANSFERS, device.freed);
    assertEquals(0, buffers.counts().lostEvents());
  }

  @Test
  void transfersThatEndDuringStopAreDeliveredAndNotRestarted() throws Exception {
    ring.start();
    CompletableFuture<Boolean> stopped = CompletableFuture.supplyAsync(ring::stop);
    Waiting.until(
        "all transfers to be cancelled",
        () -> device.transfers.stream().allMatch(transfer -> transfer.cancelled));
    device.transfers.get(0).end(TransferEnd.COMPLETED, 2); // before the bus heard of it
    device.transfers.get(1).end(TransferEnd.CANCELLED, 1);
    device.transfers.get(2).end(TransferEnd.FAILED, 0);
    assertFalse(stopped.isDone(), "one is under way");
    device.transfers.get(3).end(TransferEnd.CANCELLED, 0);

    assertTrue(stopped.get());
    assertTrue(device.transfers.stream().allMatch(transfer -> transfer.started == 1));
    assertEquals(TRANSFERS, device.freed);
    assertEquals(3, takenEvents());
  }

  @Test
  void pendingTransferIsNotFreed() {
    ring.start();
    device.transfers.get(0).end(TransferEnd.GONE, 0);

    assertFalse(ring.stop());
    assertEquals(0, device.freed);
  }

  @Test
  void consecutiveErrorsEndTheDeviceButSeparatedErrorsDoNot() throws Exception {
    ring.start();
    ManualTransfers.ManualTransfer first = device.transfers.get(0);
    for (int i = 0; i < 3 * MAX_FAILURES; i++) {
      first.end(i % MAX_FAILURES == 0 ? TransferEnd.COMPLETED : TransferEnd.FAILED, 0);
    }
    assertEquals(1 + 3 * MAX_FAILURES, first.started);

    for (int i = 0; i <= MAX_FAILURES; i++) {
      first.end(TransferEnd.FAILED, 0);
    }
    device.transfers.subList(1, TRANSFERS).forEach(other -> other.end(TransferEnd.CANCELLED, 0));
    takenEvents();

    assertTrue(buffers.isAtEndOfDevice());
  }

  @Test
  void deviceThatRefusesTransfersCountsAsLost() throws Exception {
    device.refusing = true;
    ring.start();

    assertNull(buffers.take(TimeUnit.SECONDS.toNanos(10)));
    assertTrue(buffers.isAtEndOfDevice());
    assertTrue(ring.stop());
  }

  @Test
  void haltIsClearedOnceAfterAllTransfersHaveEnded() {
    ring.start();
    device.transfers.forEach(transfer -> transfer.end(TransferEnd.STALLED, 0));
    ring.recover();
    ring.recover();

    assertEquals(1, device.haltsCleared);
    assertTrue(device.transfers.stream().allMatch(transfer -> transfer.started == 2));
  }
}
