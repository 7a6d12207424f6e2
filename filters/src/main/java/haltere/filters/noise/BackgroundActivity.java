package haltere.filters.noise;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import java.util.Arrays;
import java.util.Objects;
import java.util.function.Consumer;

/**
 * Passes an event if enough of its eight neighbours fired shortly before it: moving edges fire
 * neighbouring pixels one after the other, noise fires single ones. The pixel itself does not
 * count, so a pixel that fires continuously does not support itself; all events count as support
 * for their neighbours, whether they pass or not.
 *
 * <p>After T. Delbruck, "Frame-free dynamic digital vision", Intl. Symp. on Secure-Life
 * Electronics, 2008, with a number of neighbours as in the spatio-temporal correlation filter of S.
 * Guo and T. Delbruck, "Low cost and latency event camera background activity denoising", IEEE
 * TPAMI 2023.
 *
 * <p>The correlation time is a setting, or chosen every 0.1 s from the measured noise, see {@code
 * docs/using.md}.
 *
 * <p>The last times of the pixels are in a map with a border of one silent pixel, so that every
 * pixel has eight neighbours, as 32-bit microseconds since an epoch, which halves the memory of a
 * look-up. The epoch advances every 18 minutes of event time, without loss, since times older than
 * the longest correlation time support no event.
 *
 * <p>Thread rule: not safe for use by two threads at a time.
 *
 * @since 0.1
 */
public final class BackgroundActivity {
  /**
   * Relative times stay within 0 to this, so that neither a difference of two of them nor of one
   * and {@link #NEVER} overflows.
   */
  private static final int LAST_RELATIVE_US = 1 << 30;

  /** Earlier than any relative time by more than any correlation time. */
  private static final int NEVER = -(1 << 30);

  /** Events processed together in three steps, which is faster than in one. */
  private static final int BLOCK = 1024;

  private final Consumer<? super BackgroundActivityShare> listener;
  private final SupportTime automatic;
  private final int stride;
  private final int mapSize;
  private int[] lastUs;

  /** For each event of a block: the index of a neighbour, then 1 if it is supported, else 0. */
  private final int[] block = new int[BLOCK];

  private BackgroundActivitySettings settings;
  private long epochUs;
  private boolean empty = true;
  private int supportUs;
  private boolean isWindowOpen;
  private long windowEndUs;
  private long windowEvents;
  private long windowPassed;

  /**
   * A filter in its initial state.
   *
   * @param geometry of the sensor
   * @param settings of the filter
   */
  public BackgroundActivity(SensorGeometry geometry, BackgroundActivitySettings settings) {
    this(geometry, settings, share -> {});
  }

  /**
   * A filter in its initial state.
   *
   * @param geometry of the sensor
   * @param settings of the filter
   * @param listener called after each window of 100 ms with events
   */
  public BackgroundActivity(
      SensorGeometry geometry,
      BackgroundActivitySettings settings,
      Consumer<? super BackgroundActivityShare> listener) {
    this.settings = Objects.requireNonNull(settings, "settings");
    this.listener = Objects.requireNonNull(listener, "listener");
    automatic = new SupportTime(geometry);
    stride = geometry.width() + 2;
    mapSize = Math.multiplyExact(stride, geometry.height() + 2);
    makeMaps();
  }

  /** Creates a map for each polarity if polarities must match, else one for all events. */
  private void makeMaps() {
    lastUs = new int[settings.samePolarity() ? Math.multiplyExact(2, mapSize) : mapSize];
    reset();
  }

  /** Removes all events. */
  public void reset() {
    clearTimes();
    automatic.reset();
    isWindowOpen = false;
    chooseSupport();
  }

  private void clearTimes() {
    Arrays.fill(lastUs, NEVER);
    empty = true;
  }

  private void chooseSupport() {
    supportUs = settings.isAutomatic() ? automatic.supportUs() : settings.correlationUs();
  }

  /**
   * The settings.
   *
   * @return the settings in force
   */
  public BackgroundActivitySettings settings() {
    return settings;
  }

  /**
   * Applies settings from the next packet on. The state is kept unless the matching of polarities
   * changes.
   *
   * @param newSettings the settings to use
   */
  public void apply(BackgroundActivitySettings newSettings) {
    boolean sameMaps = newSettings.samePolarity() == settings.samePolarity();
    if (newSettings.isAutomatic() != settings.isAutomatic()) {
      automatic.reset();
    }
    settings = newSettings;
    chooseSupport();
    if (!sameMaps) {
      makeMaps();
    }
  }

  /**
   * Removes the events without support.
   *
   * @param packet filtered in place
   */
  public void filter(EventPacket packet) {
    int passed = 0;
    int from = 0;
    while (from < packet.size()) {
      moveEpoch(packet.timeUs(from));
      moveWindow(packet.timeUs(from));
      int end = Math.min(packet.size(), from + BLOCK);
      long endUs = Math.min(windowEndUs, epochUs + LAST_RELATIVE_US);
      int to = packet.timeUs(end - 1) < endUs ? end : packet.indexAtOrAfter(endUs, from);
      findIndices(packet.addresses(), from, to);
      if (settings.isAutomatic()) {
        automatic.count(packet.addresses(), from, to);
      }
      if (settings.neighbours() > 1) {
        findSupported(packet.timesUs(), from, to);
      } else {
        findAny(packet.timesUs(), from, to);
      }
      int passedBefore = passed;
      passed = passSupported(packet, from, to, passed);
      windowEvents += to - from;
      windowPassed += passed - passedBefore;
      from = to;
    }
    packet.truncate(passed);
  }

  /** Finds each event's lower left neighbour; with the border its index is y * stride + x. */
  private void findIndices(int[] addresses, int from, int to) {
    int[] found = block;
    int polarityMask = settings.samePolarity() ? EventAddress.ON_BIT : 0;
    for (int i = from; i < to; i++) {
      int address = addresses[i];
      found[i - from] =
          (address & polarityMask) * mapSize
              + EventAddress.y(address) * stride
              + EventAddress.x(address);
    }
  }

  /**
   * Finds events with any support by the latest of the neighbours' times, without unpredictable
   * branches.
   */
  private void findAny(long[] timesUs, int from, int to) {
    int[] indices = block;
    int[] last = lastUs;
    for (int i = from; i < to; i++) {
      int relativeUs = (int) (timesUs[i] - epochUs);
      int left = indices[i - from];
      int latest = Math.max(Math.max(last[left], last[left + 1]), last[left + 2]);
      left += stride;
      latest = Math.max(latest, Math.max(last[left], last[left + 2]));
      last[left + 1] = relativeUs;
      left += stride;
      latest = Math.max(latest, Math.max(Math.max(last[left], last[left + 1]), last[left + 2]));
      indices[i - from] = relativeUs - latest;
    }
    if (settings.isAutomatic()) {
      automatic.countDelays(indices, to - from);
    }
    int tooOldUs = supportUs + 1;
    for (int i = 0; i < to - from; i++) {
      indices[i] = indices[i] - tooOldUs >>> 31;
    }
  }

  /** Finds events with enough supporting neighbours, by counting sign bits. */
  private void findSupported(long[] timesUs, int from, int to) {
    int[] indices = block;
    int[] last = lastUs;
    int correlationUs = supportUs;
    int tooFew = settings.neighbours() - 1;
    for (int i = from; i < to; i++) {
      int relativeUs = (int) (timesUs[i] - epochUs);
      int tooOld = relativeUs - correlationUs - 1;
      int left = indices[i - from];
      int support =
          (tooOld - last[left] >>> 31)
              + (tooOld - last[left + 1] >>> 31)
              + (tooOld - last[left + 2] >>> 31);
      left += stride;
      support += (tooOld - last[left] >>> 31) + (tooOld - last[left + 2] >>> 31);
      last[left + 1] = relativeUs;
      left += stride;
      support +=
          (tooOld - last[left] >>> 31)
              + (tooOld - last[left + 1] >>> 31)
              + (tooOld - last[left + 2] >>> 31);
      indices[i - from] = tooFew - support >>> 31;
    }
  }

  /** Moves the supported events to the front. */
  private int passSupported(EventPacket packet, int from, int to, int passedBefore) {
    long[] timesUs = packet.timesUs();
    int[] addresses = packet.addresses();
    int[] supported = block;
    int passed = passedBefore;
    for (int i = from; i < to; i++) {
      // moved in any case: the next event overwrites it unless it passes
      timesUs[passed] = timesUs[i];
      addresses[passed] = addresses[i];
      passed += supported[i - from];
    }
    return passed;
  }

  /** Ends the windows before an event's time. */
  private void moveWindow(long timeUs) {
    if (!isWindowOpen || timeUs < windowEndUs - SupportTime.WINDOW_US) {
      long start = Math.floorDiv(timeUs, SupportTime.WINDOW_US) * SupportTime.WINDOW_US;
      windowEndUs = start + SupportTime.WINDOW_US;
      windowEvents = 0;
      windowPassed = 0;
      isWindowOpen = true;
    } else if (timeUs >= windowEndUs) {
      double passed = windowPassed / (double) windowEvents;
      listener.accept(
          new BackgroundActivityShare(windowEndUs, supportUs, windowEvents, passed, 1 - passed));
      long windows = (timeUs - windowEndUs) / SupportTime.WINDOW_US + 1;
      if (settings.isAutomatic()) {
        automatic.endWindow(windows, settings.neighbours(), settings.samePolarity() ? 2 : 1);
        chooseSupport();
      }
      windowEndUs += windows * SupportTime.WINDOW_US;
      windowEvents = 0;
      windowPassed = 0;
    }
  }

  /** Advances the epoch for an event's time: see the class comment. */
  private void moveEpoch(long timeUs) {
    long relativeUs = timeUs - epochUs;
    if (!empty && relativeUs >= 0 && relativeUs < LAST_RELATIVE_US) {
      return;
    }
    if (empty || relativeUs < 0 || relativeUs >= 2L * LAST_RELATIVE_US) {
      // the memory is empty, or older than any correlation time
      clearTimes();
      epochUs = timeUs;
    } else {
      // keeps the times within the longest correlation time before the event
      int shiftUs = (int) (relativeUs - BackgroundActivitySettings.MAX_CORRELATION_US);
      for (int i = 0; i < lastUs.length; i++) {
        lastUs[i] = lastUs[i] < shiftUs ? NEVER : lastUs[i] - shiftUs;
      }
      epochUs += shiftUs;
    }
    empty = false;
  }
}
