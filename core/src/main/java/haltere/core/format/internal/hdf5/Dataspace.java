package haltere.core.format.internal.hdf5;

import haltere.core.format.RecordingProblem;

/** The claimed lengths of a dataset's dimensions; none for a single value. */
final class Dataspace {
  private static final int MAX_DIMENSIONS = 32;

  private Dataspace() {}

  static long[] read(Metadata body) throws RecordingProblem {
    int version = body.u1();
    int rank = body.u1();
    body.skip(1);
    if (version < 1 || version > 2 || rank > MAX_DIMENSIONS) {
      throw body.problem("dimensions that cannot be");
    }
    int kind = 1;
    if (version == 1) {
      body.skip(5);
    } else {
      kind = body.u1();
    }
    long[] lengths = new long[rank];
    for (int i = 0; i < rank; i++) {
      lengths[i] = body.length();
    }
    return kind == 2 ? new long[] {0} : lengths;
  }
}
