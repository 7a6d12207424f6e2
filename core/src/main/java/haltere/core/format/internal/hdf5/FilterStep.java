package haltere.core.format.internal.hdf5;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A step of the compression of chunks, by its registered number.
 *
 * @param number of the filter
 * @param name in the file, may be empty
 * @param values its parameters
 */
record FilterStep(int number, String name, int[] values) {
  static final int DEFLATE = 1;
  static final int SHUFFLE = 2;
  static final int FLETCHER32 = 3;
  static final int LZF = 32000;
  static final int BLOSC = 32001;
  static final int LZ4 = 32004;
  static final int ZSTD = 32015;
  static final int ECF = 36559;

  private static final int BLOSC_METHOD = 6;
  private static final int BLOSC_SNAPPY = 3;
  private static final List<String> BLOSC_METHODS =
      List.of("blosclz", "lz4", "lz4hc", "snappy", "zlib", "zstd");
  private static final int MAX_STEPS = 32;

  static List<FilterStep> read(Metadata body) throws haltere.core.format.RecordingProblem {
    int version = body.u1();
    int count = body.u1();
    if (version < 1 || version > 2 || count > MAX_STEPS) {
      throw body.problem("a compression of " + count + " steps");
    }
    if (version == 1) {
      body.skip(6);
    }
    List<FilterStep> steps = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      int number = body.u2();
      int nameSize = version == 1 || number >= 256 ? body.u2() : 0;
      body.skip(2);
      int values = body.u2();
      String name = body.part(version == 1 ? (nameSize + 7) / 8 * 8 : nameSize).text(nameSize);
      Metadata numbers = body.part(4L * values);
      int[] read = new int[values];
      for (int k = 0; k < values; k++) {
        read[k] = (int) numbers.u4();
      }
      if (version == 1 && values % 2 == 1) {
        body.skip(4);
      }
      steps.add(new FilterStep(number, name, read));
    }
    return steps;
  }

  /** Method of a compression step, such as "lzf"; empty for other steps. */
  Optional<String> compression() {
    return switch (number) {
      case DEFLATE -> Optional.of("deflate");
      case LZF -> Optional.of("lzf");
      case BLOSC -> Optional.of("blosc" + bloscMethod());
      case LZ4 -> Optional.of("lz4");
      case ZSTD -> Optional.of("zstd");
      case ECF -> Optional.of("ecf");
      default -> Optional.empty();
    };
  }

  private String bloscMethod() {
    int method = value(BLOSC_METHOD, 0);
    return method < 0 || method >= BLOSC_METHODS.size()
        ? ""
        : " (" + BLOSC_METHODS.get(method) + ")";
  }

  int value(int index, int otherwise) {
    return index < values.length ? values[index] : otherwise;
  }

  /**
   * Message for users about an unsupported filter; empty for supported ones.
   *
   * @param elementBytes size of the elements of its dataset
   */
  Optional<String> obstacle(int elementBytes) {
    if (number == ECF && elementBytes != EcfBlock.EVENT_BYTES) {
      return Optional.of("ECF, filter 36559, which is for events of 16 bytes; copy it again");
    }
    if (number == BLOSC && value(BLOSC_METHOD, 0) == BLOSC_SNAPPY) {
      return Optional.of(
          "Snappy within Blosc, filter 32001, which is not supported; replace it with "
              + "h5repack -f GZIP=1 (HDF5 tools) where it is installed");
    }
    return switch (number) {
      case DEFLATE, SHUFFLE, FLETCHER32, LZF, BLOSC, LZ4, ZSTD, ECF -> Optional.empty();
      default ->
          Optional.of(
              known(number)
                  + ", filter "
                  + number
                  + (name.isEmpty() ? "" : " (" + name + ")")
                  + ", which is not supported; replace it with h5repack -f GZIP=1 (HDF5 tools) "
                  + "where it is installed");
    };
  }

  private static String known(int number) {
    return switch (number) {
      case 4 -> "SZIP";
      case 5 -> "N-bit";
      case 6 -> "scale and offset";
      case 307 -> "bzip2";
      case 32008 -> "bitshuffle";
      case 32013 -> "ZFP";
      case 32026 -> "Blosc2";
      default -> "an unknown method";
    };
  }
}
