package haltere.testing;

import haltere.core.chain.ChainFile;
import haltere.core.chain.FilterChain;
import haltere.core.chain.FilterProvider;
import haltere.core.chain.Filters;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.json.JsonProblem;
import haltere.core.settings.SettingsJson;
import haltere.core.settings.SettingsProblem;
import haltere.core.settings.SettingsProvider;
import haltere.core.settings.SettingsSchema;
import haltere.core.simulation.SceneProvider;
import haltere.core.simulation.Scenes;
import haltere.core.sink.LineAddress;
import haltere.core.sink.LineOutput;
import haltere.core.sink.LineOutputs;
import haltere.filters.orientation.camera.CameraFile;
import haltere.filters.orientation.camera.CameraModel;
import java.io.IOException;
import java.net.Socket;
import java.net.SocketException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Contract for arbitrary bytes as a chain, settings, cameras, an address of live results, or from a
 * peer at such an address: they are parsed, and the result can be written and read again, or they
 * are refused in one line. Nothing else may be thrown.
 *
 * <p>{@code ./gradlew fuzz -Pformat=NAME} has a fuzzer that is guided by coverage look for bytes
 * for which that does not hold (TextFuzzTest).
 *
 * <p>Thread rule: one thread.
 */
public final class TextFuzzer {
  private static final SensorGeometry SENSOR = new SensorGeometry(64, 48);
  private static final int EVENTS = 300;
  private static final double STEP_US = 300;

  private static Path file;
  private static LineOutput output;
  private static Throwable peerFault;

  private TextFuzzer() {}

  /**
   * Reads bytes as a chain, and has it process some events.
   *
   * @param bytes any
   * @throws IOException if what was understood is not understood again
   */
  public static void checkChain(byte[] bytes) throws IOException {
    FilterChain read;
    try {
      read = ChainFile.parse(text(bytes), "chain", SENSOR);
    } catch (JsonProblem refused) {
      isOneLine(refused);
      return;
    }
    try (FilterChain chain = read) {
      String written = ChainFile.write(chain);
      try (FilterChain again = ChainFile.parse(written, "chain", SENSOR)) {
        same(written, ChainFile.write(again));
      }
      EventPacket packet = EventPackets.uniform(SENSOR, 1, EVENTS, 0, STEP_US);
      chain.process(packet);
    }
  }

  /**
   * Reads bytes as the settings of each filter and scene.
   *
   * @param bytes any
   * @throws IOException if what was understood is not understood again
   */
  public static void checkSettings(byte[] bytes) throws IOException {
    Map<?, ?> values = values(bytes);
    List<SettingsProvider<?>> providers = new ArrayList<>();
    for (FilterProvider<?> filter : Filters.all().values()) {
      providers.add(filter);
    }
    for (SceneProvider<?> scene : Scenes.all().values()) {
      providers.add(scene);
    }
    for (SettingsProvider<?> provider : providers) {
      checkSettings(values, provider.schema());
    }
  }

  private static <S extends Record> void checkSettings(Map<?, ?> values, SettingsSchema<S> schema) {
    try {
      S settings = SettingsJson.fromMap(values, schema, note -> {});
      same(settings, SettingsJson.fromMap(SettingsJson.toMap(settings, schema), schema));
    } catch (SettingsProblem refused) {
      isOneLine(refused);
    }
  }

  /** Names and values, one pair a line. */
  private static Map<?, ?> values(byte[] bytes) {
    Map<String, Object> values = new LinkedHashMap<>();
    for (String line : text(bytes).split("\n")) {
      int at = line.indexOf('=');
      if (at > 0) {
        values.put(line.substring(0, at), value(line.substring(at + 1)));
      }
    }
    return values;
  }

  private static Object value(String text) {
    try {
      return Long.valueOf(text);
    } catch (NumberFormatException noInteger) {
      try {
        return Double.valueOf(text);
      } catch (NumberFormatException noNumber) {
        return text.equals("true") || text.equals("false") ? (Object) text.equals("true") : text;
      }
    }
  }

  /**
   * Reads bytes as a file of cameras.
   *
   * @param bytes any
   * @throws IOException if the file cannot be written, or is refused as none should be
   */
  public static void checkCamera(byte[] bytes) throws IOException {
    if (file == null) {
      file = Files.createTempFile("haltere-fuzz", ".json");
      file.toFile().deleteOnExit();
    }
    ReplacedFile.write(file, bytes);
    try {
      for (CameraModel camera : CameraFile.read(file).cameras()) {
        camera.id();
      }
    } catch (JsonProblem refused) {
      isOneLine(refused);
    }
  }

  /**
   * Reads bytes as the address of live results.
   *
   * @param bytes any
   */
  public static void checkAddress(byte[] bytes) {
    try {
      LineAddress address = LineAddress.parse(text(bytes));
      same(address, LineAddress.parse(address.toString()));
      LineOutputs.check(address.toString());
    } catch (IllegalArgumentException refused) {
      isOneLine(refused);
    }
  }

  /**
   * Sends bytes from a peer to an address of ZeroMQ.
   *
   * @param bytes any
   * @throws IOException if the address no longer accepts connections
   */
  public static void checkSubscriber(byte[] bytes) throws IOException {
    if (output == null) {
      Thread.setDefaultUncaughtExceptionHandler((thread, fault) -> peerFault = fault);
      output = LineOutputs.open("zmq://127.0.0.1:0");
    }
    try (Socket peer = new Socket("127.0.0.1", LineAddress.parse(output.address()).port())) {
      peer.getOutputStream().write(bytes);
      output.send("a/b", bytes);
      peer.shutdownOutput();
      while (peer.getInputStream().read() >= 0) {
        // data of the publisher before it disconnects
      }
    } catch (SocketException reset) {
      // disconnected before all was sent
    }
    if (peerFault != null) {
      throw new IllegalStateException(peerFault);
    }
  }

  private static String text(byte[] bytes) {
    return new String(bytes, StandardCharsets.UTF_8);
  }

  private static void isOneLine(Exception refused) {
    String line = refused.getMessage();
    if (line == null || line.isBlank()) {
      throw new IllegalStateException("refused without a word", refused);
    }
  }

  private static void same(Object first, Object second) {
    if (!first.equals(second)) {
      throw new IllegalStateException(first + " is read again as " + second);
    }
  }
}
