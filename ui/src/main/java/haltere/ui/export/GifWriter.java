package haltere.ui.export;

import haltere.core.format.AtomicFile;
import java.awt.image.BufferedImage;
import java.awt.image.DataBuffer;
import java.awt.image.IndexColorModel;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.IntStream;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import org.w3c.dom.Element;

/** An animated GIF with endless repetition. */
public final class GifWriter implements FilmWriter {
  private static final String FORMAT = "javax_imageio_gif_image_1.0";
  private static final int COLOURS = 256;

  private final AtomicFile file;
  private final MemoryCacheImageOutputStream stream;
  private final ImageWriter writer;
  private final int delayHundredths;

  /**
   * Starts a film of at most 50 pictures a second, the limit of players; replaces an existing file.
   */
  public GifWriter(Path path, double framesPerSecond) throws IOException {
    delayHundredths = (int) Math.max(2, Math.round(100 / framesPerSecond));
    file = AtomicFile.create(path, true);
    stream = new MemoryCacheImageOutputStream(file.stream());
    writer = ImageIO.getImageWritersByFormatName("gif").next();
    writer.setOutput(stream);
    writer.prepareWriteSequence(null);
  }

  @Override
  public void add(BufferedImage picture) throws IOException {
    BufferedImage image = withPalette(picture);
    IIOMetadata metadata = writer.getDefaultImageMetadata(new ImageTypeSpecifier(image), null);
    IIOMetadataNode root = (IIOMetadataNode) metadata.getAsTree(FORMAT);
    Element control = (Element) root.getElementsByTagName("GraphicControlExtension").item(0);
    control.setAttribute("delayTime", Integer.toString(delayHundredths));
    IIOMetadataNode application = new IIOMetadataNode("ApplicationExtension");
    application.setAttribute("applicationID", "NETSCAPE");
    application.setAttribute("authenticationCode", "2.0");
    // 1, then 0 repetitions: endless
    application.setUserObject(new byte[] {1, 0, 0});
    root.appendChild(new IIOMetadataNode("ApplicationExtensions")).appendChild(application);
    metadata.setFromTree(FORMAT, root);
    writer.writeToSequence(new IIOImage(image, null, metadata), null);
    // else the whole film remains in memory
    stream.flushBefore(stream.getStreamPosition());
  }

  /** With a palette of its colours, without their lowest bits as long as these are too many. */
  private static BufferedImage withPalette(BufferedImage image) {
    int width = image.getWidth();
    int height = image.getHeight();
    int[] pixels = image.getRGB(0, 0, width, height, null, 0, width);
    int[] palette = IntStream.of(pixels).distinct().toArray();
    for (int bits = 0xfefefe; palette.length > COLOURS; bits &= bits << 1) {
      int kept = bits;
      palette = IntStream.of(palette).map(colour -> colour & kept).distinct().toArray();
      Arrays.setAll(pixels, i -> pixels[i] & kept);
    }
    Arrays.sort(palette);
    byte[] entries = new byte[pixels.length];
    for (int i = 0; i < pixels.length; i++) {
      entries[i] = (byte) Arrays.binarySearch(palette, pixels[i]);
    }
    IndexColorModel colours =
        new IndexColorModel(8, palette.length, palette, 0, false, -1, DataBuffer.TYPE_BYTE);
    BufferedImage indexed =
        new BufferedImage(width, height, BufferedImage.TYPE_BYTE_INDEXED, colours);
    indexed.getRaster().setDataElements(0, 0, width, height, entries);
    return indexed;
  }

  @Override
  public void finish() throws IOException {
    writer.endWriteSequence();
    stream.flush();
    file.commit();
  }

  @Override
  public void close() throws IOException {
    writer.dispose();
    file.close();
  }
}
