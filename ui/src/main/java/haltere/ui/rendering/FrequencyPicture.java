package haltere.ui.rendering;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.filters.frequency.FrequencyMap;
import haltere.filters.frequency.FrequencyMapSettings;

/** Paints the frequency of each pixel on a logarithmic scale over the range of the map. */
final class FrequencyPicture implements StyleState {
  /** How far back events matter, microseconds. */
  static final long MEMORY_US =
      new FrequencyMap(new SensorGeometry(1, 1), FrequencyMapSettings.defaults()).memoryUs();

  /** Bits of a period's mantissa that make entries of the table: 128 in each octave. */
  private static final int MANTISSA_SHIFT = 16;

  private final SensorGeometry geometry;
  private final FrequencyMap map;
  private final int firstEntry;

  /** Ranked colour of a period by the first bits of its number; at 0 that of the background. */
  private final int[] table;

  private boolean isEmpty = true;

  FrequencyPicture(SensorGeometry geometry, PictureStyle style) {
    this.geometry = geometry;
    FrequencyMapSettings settings = FrequencyMapSettings.defaults();
    map = new FrequencyMap(geometry, settings);
    // periods of the highest frequency may be a little shorter
    firstEntry = bits((float) (0.5e6 / settings.maxFrequencyHz()));
    table = new int[bits((float) (1e6 / settings.minFrequencyHz())) - firstEntry + 2];
    configure(style);
  }

  private static int bits(float periodUs) {
    return Float.floatToIntBits(periodUs) >> MANTISSA_SHIFT;
  }

  @Override
  public void configure(PictureStyle style) {
    double octaves = Math.log(map.settings().maxFrequencyHz() / map.settings().minFrequencyHz());
    table[0] = style.background();
    for (int entry = 1; entry < table.length; entry++) {
      float periodUs = Float.intBitsToFloat((firstEntry + entry - 1) << MANTISSA_SHIFT);
      double share = Math.log(1e6 / periodUs / map.settings().minFrequencyHz()) / octaves;
      table[entry] = style.gradient().colour(share);
    }
    ColourRanks.rank(table, style.background());
  }

  @Override
  public void packet(EventPacket packet) {
    map.add(packet);
  }

  @Override
  public void clear() {
    map.reset();
  }

  @Override
  public double frequencyHz(int x, int y, long nowUs) {
    return map.frequencyHz(x, y, nowUs);
  }

  @Override
  public boolean isEmpty() {
    return isEmpty;
  }

  @Override
  public void paint(long nowUs, int[] ranked) {
    int width = geometry.width();
    int height = geometry.height();
    boolean any = false;
    for (int y = 0; y < height; y++) {
      int to = (height - 1 - y) * width;
      for (int x = 0; x < width; x++) {
        float periodUs = map.periodUs(x, y, nowUs);
        int entry = periodUs == 0 ? 0 : Math.max(0, bits(periodUs) - firstEntry) + 1;
        ranked[to + x] = table[Math.min(entry, table.length - 1)];
        any |= entry > 0;
      }
    }
    isEmpty = !any;
  }
}
