package haltere.ui.export;

import haltere.core.format.AtomicFile;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** An animated GIF with endless repetition. */
public final class GifWriter implements FilmWriter {
  private static final String FORMAT = "javax_imageio_gif_image_1.0";

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
  public void add(BufferedImage image) throws IOException {
    IIOMetadata metadata =
        writer.getDefaultImageMetadata(
            ImageTypeSpecifier.createFromRenderedImage(image), writer.getDefaultWriteParam());
    IIOMetadataNode root = (IIOMetadataNode) metadata.getAsTree(FORMAT);
    IIOMetadataNode control = child(root, "GraphicControlExtension");
    control.setAttribute("disposalMethod", "none");
    control.setAttribute("userInputFlag", "FALSE");
    control.setAttribute("transparentColorFlag", "FALSE");
    control.setAttribute("delayTime", Integer.toString(delayHundredths));
    control.setAttribute("transparentColorIndex", "0");
    IIOMetadataNode application = new IIOMetadataNode("ApplicationExtension");
    application.setAttribute("applicationID", "NETSCAPE");
    application.setAttribute("authenticationCode", "2.0");
    // 1, then 0 repetitions: endless
    application.setUserObject(new byte[] {1, 0, 0});
    child(root, "ApplicationExtensions").appendChild(application);
    metadata.setFromTree(FORMAT, root);
    writer.writeToSequence(new IIOImage(image, null, metadata), null);
    // else the whole film remains in memory
    stream.flushBefore(stream.getStreamPosition());
  }

  private static IIOMetadataNode child(IIOMetadataNode root, String name) {
    for (int i = 0; i < root.getLength(); i++) {
      if (root.item(i).getNodeName().equals(name)) {
        return (IIOMetadataNode) root.item(i);
      }
    }
    IIOMetadataNode made = new IIOMetadataNode(name);
    root.appendChild(made);
    return made;
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
