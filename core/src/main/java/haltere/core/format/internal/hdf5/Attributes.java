package haltere.core.format.internal.hdf5;

import haltere.core.format.RecordingProblem;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.HashMap;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalLong;

/** The attributes of a group or dataset that are a single number or a text. */
final class Attributes {
  private static final int MAX_TEXT = 4096;

  private final Map<String, Number> numbers = new HashMap<>();
  private final Map<String, String> texts = new HashMap<>();

  private Attributes() {}

  static Attributes of(ContainerFile file, ObjectHeader header) throws IOException {
    Attributes attributes = new Attributes();
    for (ObjectHeader.HeaderMessage message : header.all(ObjectHeader.ATTRIBUTE)) {
      if (!message.shared()) {
        attributes.read(file, message.body());
      }
    }
    return attributes;
  }

  private void read(ContainerFile file, Metadata body) throws IOException {
    int version = body.u1();
    int flags = body.u1();
    int nameSize = body.u2();
    int typeSize = body.u2();
    int spaceSize = body.u2();
    if (version < 1 || version > 3) {
      throw body.problem("an attribute that cannot be");
    }
    if (version == 3) {
      body.skip(1);
    }
    int multiple = version == 1 ? 8 : 1;
    String name = body.part(padded(nameSize, multiple)).text(nameSize);
    Metadata typeBody = body.part(padded(typeSize, multiple));
    Metadata spaceBody = body.part(padded(spaceSize, multiple));
    if (version > 1 && flags != 0) {
      return;
    }
    ElementType type = ElementType.read(typeBody);
    long elements = 1;
    for (long length : Dataspace.read(spaceBody)) {
      elements = length == 1 ? elements : 0;
    }
    if (elements != 1) {
      return;
    }
    if (type.isNumber()) {
      numbers.put(name, number(type, body.bytes(type.bytes())));
    } else if (type.kind() == 's' && type.bytes() <= MAX_TEXT) {
      texts.put(name, body.text(type.bytes()));
    } else if (type.kind() == 'v') {
      texts.put(name, new GlobalHeap(file).text(body, MAX_TEXT));
    }
  }

  private static int padded(int size, int multiple) {
    return (size + multiple - 1) / multiple * multiple;
  }

  static Number number(ElementType type, byte[] bytes) {
    ByteBuffer buffer =
        ByteBuffer.wrap(bytes)
            .order(type.bigEndian() ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN);
    if (type.kind() == 'f') {
      return type.bytes() == 8 ? buffer.getDouble() : (double) buffer.getFloat();
    }
    return NumberColumn.whole(buffer, 0, type);
  }

  OptionalLong whole(String name) throws RecordingProblem {
    Number number = numbers.get(name);
    return number == null ? OptionalLong.empty() : OptionalLong.of(number.longValue());
  }

  OptionalDouble real(String name) {
    Number number = numbers.get(name);
    return number == null ? OptionalDouble.empty() : OptionalDouble.of(number.doubleValue());
  }

  String text(String name) {
    return texts.getOrDefault(name, "");
  }
}
