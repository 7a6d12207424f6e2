package haltere.ui.rendering;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.FilterChain;
import haltere.core.chain.Filters;
import haltere.core.event.EventPacket;
import haltere.core.overlay.MarkStyle;
import haltere.core.pipeline.Pipeline;
import haltere.core.pipeline.PipelineCounters;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.ui.viewer.BlobSource;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.Test;

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
                drawn[0] = sheet.draw();
              }
            }

            @Override
            public void notified(StreamNotification notification) {
              sheet.notified(notification);
            }
          };
      Pipeline.run(blob, chain, List.of(sink), new PipelineCounters());
      return toItsEnd ? sheet.draw() : drawn[0];
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
  void anObjectThatIsReportedLaterIsInThePictureOfItsMoment() throws IOException {
    assertFalse(hasObject(sheet(2_000_000, false)), "not known yet");
    assertTrue(hasObject(sheet(1_000_000, true)), "known at the end");
  }
}
