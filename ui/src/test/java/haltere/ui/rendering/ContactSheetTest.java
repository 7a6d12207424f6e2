package haltere.ui.rendering;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.FilterChain;
import haltere.core.chain.Filters;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.overlay.MarkStyle;
import haltere.core.pipeline.Pipeline;
import haltere.core.pipeline.PipelineCounters;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.ui.viewer.BlobSource;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Pictures of a stream at several moments. */
class ContactSheetTest {
  /** The object tracker is not sure of the blob before. */
  private static final long DECIDED_US = 100_000;

  private static BufferedImage sheet(long lengthUs, boolean toItsEnd) throws IOException {
    try (FilterChain chain = new FilterChain(BlobSource.GEOMETRY);
        BlobSource blob = new BlobSource(lengthUs)) {
      chain.add(Filters.named("object-tracker"));
      ContactSheet sheet = new ContactSheet(chain);
      BufferedImage[] drawn = new BufferedImage[1];
      StreamHandler sink =
          new StreamHandler() {
            @Override
            public void packet(EventPacket packet) {
              sheet.packet(packet);
              if (!toItsEnd && drawn[0] == null && packet.lastTimeUs() > DECIDED_US) {
                drawn[0] = sheet.draw().orElseThrow();
              }
            }

            @Override
            public void notified(StreamNotification notification) {
              sheet.notified(notification);
            }
          };
      Pipeline.run(blob, chain, List.of(sink), new PipelineCounters());
      return toItsEnd ? sheet.draw().orElseThrow() : drawn[0];
    }
  }

  /** Whether the first picture has marks of objects. */
  private static boolean hasObject(BufferedImage sheet) {
    int colour = MarkColours.argb(MarkStyle.of(MarkStyle.Role.ESTIMATE, 1), true) & 0xFFFFFF;
    for (int y = 0; y < 420; y++) {
      for (int x = 0; x < 420; x++) {
        if ((sheet.getRGB(x, y) & 0xFFFFFF) == colour) {
          return true;
        }
      }
    }
    return false;
  }

  @Test
  void objectReportedLateIsDrawnAtItsMoment() throws IOException {
    assertFalse(hasObject(sheet(2_000_000, false)), "not known yet");
    assertTrue(hasObject(sheet(1_000_000, true)), "known at the end");
  }

  @Test
  void withoutEventsThereIsNoPicture() {
    ContactSheet sheet = new ContactSheet(new FilterChain(BlobSource.GEOMETRY));
    assertEquals(Optional.empty(), sheet.draw());
  }

  @ParameterizedTest
  @ValueSource(
      longs = {47_000, 81_000, 96_000, 131_000, 170_000, 350_000, 730_000, 1_100_000, 2_900_000})
  void momentsAreEquidistant(long lengthUs) {
    SensorGeometry sensor = new SensorGeometry(210, 105);
    ContactSheet sheet = new ContactSheet(new FilterChain(sensor));
    EventPacket packet = new EventPacket(1);
    // the column of the last event tells the time
    for (long us = 0; us < lengthUs; us += lengthUs / 2_100) {
      packet.clear();
      packet.append(us, (int) (210 * us / lengthUs), 0, true);
      sheet.packet(packet);
    }
    List<Integer> columns = lastColumns(sheet.draw().orElseThrow());
    assertTrue(columns.size() >= 5 && columns.size() <= 8, columns + " moments");
    int distance = columns.get(1) - columns.get(0);
    for (int i = 1; i < columns.size(); i++) {
      assertEquals(distance, columns.get(i) - columns.get(i - 1), 2, columns.toString());
    }
    int margins = columns.get(0) + 210 - columns.get(columns.size() - 1);
    assertTrue(margins <= 2 * distance + 4, columns + " reach over the whole stream");
  }

  /** The last column with an event in each picture of 420 by 210 pixels, of two by two a pixel. */
  private static List<Integer> lastColumns(BufferedImage sheet) {
    List<Integer> columns = new ArrayList<>();
    int background = ColourMap.DARK.background() & 0xFFFFFF;
    for (int bottom = 209; bottom < sheet.getHeight(); bottom += 214) {
      for (int left = 0; left < sheet.getWidth(); left += 424) {
        int last = 209;
        while (last >= 0 && (sheet.getRGB(left + 2 * last, bottom) & 0xFFFFFF) == background) {
          last--;
        }
        int behind = sheet.getRGB(left, bottom) >>> 24;
        if (last < 209) {
          assertEquals(255, behind);
          columns.add(last);
        } else {
          assertEquals(0, behind, "behind the last picture it is transparent");
        }
      }
    }
    return columns;
  }
}
