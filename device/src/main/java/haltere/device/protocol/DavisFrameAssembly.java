package haltere.device.protocol;

import haltere.core.event.Frame;

/**
 * Assembles a frame from its words: start, four numbers of its region, exposure, then column by
 * column the reset and the signal values of the pixels. A pixel is the first minus the second. Only
 * complete frames are returned.
 */
final class DavisFrameAssembly {
  private static final int GLOBAL_START = 8;
  private static final int ROLLING_START = 9;
  private static final int END = 10;
  private static final int RESET_COLUMN = 11;
  private static final int SIGNAL_COLUMN = 12;
  private static final int COLUMN_END = 13;
  private static final int EXPOSURE_START = 14;
  private static final int EXPOSURE_END = 15;
  private static final int REGION_NUMBERS = 4;
  private static final int UNUSED_BITS = 6;
  private static final int WHITE = 1023;
  private static final int SATURATED_RESET = 384;
  private static final int NONE = -1;
  private static final long NO_TIME = Long.MIN_VALUE;

  private final DavisLayout layout;
  private final int[] region = new int[REGION_NUMBERS];
  private short[] resets = {};
  private short[] signals = {};
  private boolean begun;
  private int regionNumbers;
  private int columns;
  private int rows;
  private int resetColumns;
  private int signalColumns;
  private int samples;
  private int column = NONE;
  private long startUs;
  private long exposureStartUs;
  private long exposureEndUs;
  private long readoutStartUs;

  DavisFrameAssembly(DavisLayout layout) {
    this.layout = layout;
  }

  void breakOff() {
    begun = false;
  }

  /** Processes a special word; returns the frame that it completes, else null. */
  Frame mark(int code, long timeUs) {
    switch (code) {
      case GLOBAL_START, ROLLING_START -> begin(timeUs);
      case EXPOSURE_START -> exposureStartUs = timeUs;
      case EXPOSURE_END -> exposureEndUs = timeUs;
      case RESET_COLUMN, SIGNAL_COLUMN -> beginColumn(code, timeUs);
      case COLUMN_END -> endColumn();
      case END -> {
        Frame whole = isWhole() ? finish(timeUs) : null;
        begun = false;
        return whole;
      }
      default -> throw new IllegalArgumentException("no word of a frame: " + code);
    }
    return null;
  }

  private void begin(long timeUs) {
    begun = true;
    startUs = timeUs;
    exposureStartUs = NO_TIME;
    exposureEndUs = NO_TIME;
    readoutStartUs = NO_TIME;
    regionNumbers = 0;
    resetColumns = 0;
    signalColumns = 0;
    column = NONE;
  }

  void regionHigh(int value) {
    if (regionNumbers < REGION_NUMBERS) {
      region[regionNumbers] = value << 8;
    }
  }

  void regionLow(int value) {
    if (regionNumbers < REGION_NUMBERS) {
      region[regionNumbers++] |= value;
      if (regionNumbers == REGION_NUMBERS) {
        setRegion();
      }
    }
  }

  private void setRegion() {
    columns = region[2] - region[0] + 1;
    rows = region[3] - region[1] + 1;
    if (columns < 1 || rows < 1 || region[2] >= layout.columns() || region[3] >= layout.rows()) {
      begun = false;
    } else if (resets.length < columns * rows) {
      resets = new short[columns * rows];
      signals = new short[columns * rows];
    }
  }

  private void beginColumn(int code, long timeUs) {
    if (regionNumbers < REGION_NUMBERS) {
      begun = false;
    }
    if (readoutStartUs == NO_TIME) {
      readoutStartUs = timeUs;
    }
    if (code == SIGNAL_COLUMN && exposureEndUs == NO_TIME) {
      exposureEndUs = timeUs;
    }
    column = code;
    samples = 0;
  }

  void sample(int value) {
    int index = (column == RESET_COLUMN ? resetColumns : signalColumns) * rows + samples++;
    if (begun && column != NONE && samples <= rows && index < columns * rows) {
      int full = layout.doubleSamples() ? Math.min(WHITE, value * 2) : value;
      (column == RESET_COLUMN ? resets : signals)[index] = (short) full;
    }
  }

  private void endColumn() {
    if (samples != rows) {
      begun = false;
    }
    if (column == RESET_COLUMN) {
      resetColumns++;
    } else if (column == SIGNAL_COLUMN) {
      signalColumns++;
    }
    column = NONE;
  }

  private boolean isWhole() {
    return begun && columns > 0 && resetColumns == columns && signalColumns == columns;
  }

  private Frame finish(long endUs) {
    boolean swap = (layout.frameFlips() & 4) != 0;
    int width = swap ? rows : columns;
    int height = swap ? columns : rows;
    byte[] values = new byte[2 * width * height];
    int left = Integer.MAX_VALUE;
    int topRow = Integer.MAX_VALUE;
    for (int corner = 0; corner < 2; corner++) {
      int x = place(region[2 * corner], layout.columns(), 2);
      int y = place(region[2 * corner + 1], layout.rows(), 1);
      left = Math.min(left, swap ? y : x);
      topRow = Math.min(topRow, swap ? x : y);
    }
    for (int c = 0; c < columns; c++) {
      for (int r = 0; r < rows; r++) {
        int x = place(region[0] + c, layout.columns(), 2);
        int y = place(region[1] + r, layout.rows(), 1);
        int at = 2 * (((swap ? x : y) - topRow) * width + (swap ? y : x) - left);
        int value = pixel(c * rows + r) << UNUSED_BITS;
        values[at] = (byte) value;
        values[at + 1] = (byte) (value >> 8);
      }
    }
    long exposureStart = exposureStartUs == NO_TIME ? startUs : exposureStartUs;
    return new Frame(
        new Frame.Times(exposureStart, exposureEndUs, readoutStartUs, endUs),
        left,
        (swap ? layout.columns() : layout.rows()) - topRow - height,
        width,
        height,
        1,
        Frame.Depth.UNSIGNED_16,
        values);
  }

  /** A column or row on the sensor, counted from the left or from the top. */
  private int place(int number, int count, int flipBit) {
    return (layout.frameFlips() & flipBit) != 0 ? count - 1 - number : number;
  }

  private int pixel(int index) {
    int reset = resets[index];
    int signal = signals[index];
    if (reset < SATURATED_RESET || signal == 0) {
      return WHITE;
    }
    return Math.max(0, Math.min(WHITE, reset - signal));
  }
}
