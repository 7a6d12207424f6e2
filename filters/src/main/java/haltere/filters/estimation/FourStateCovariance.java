package haltere.filters.estimation;

/**
 * A covariance of four states, its upper triangle on primitive fields: symmetric by construction,
 * for use at every event. What an update does to it is {@link FourStateEkf}'s.
 *
 * <p>Thread rule: not safe for use by two threads at a time.
 */
final class FourStateCovariance {
  double e00;
  double e01;
  double e02;
  double e03;
  double e11;
  double e12;
  double e13;
  double e22;
  double e23;
  double e33;

  /** Sets it to a diagonal. */
  void setVariances(double v0, double v1, double v2, double v3) {
    e00 = v0;
    e11 = v1;
    e22 = v2;
    e33 = v3;
    e01 = 0;
    e02 = 0;
    e03 = 0;
    e12 = 0;
    e13 = 0;
    e23 = 0;
  }

  /** Takes sixteen entries, row by row, of which the upper triangle is read. */
  void read(double[] p) {
    e00 = p[0];
    e01 = p[1];
    e02 = p[2];
    e03 = p[3];
    e11 = p[5];
    e12 = p[6];
    e13 = p[7];
    e22 = p[10];
    e23 = p[11];
    e33 = p[15];
  }

  /** Gives all sixteen entries, row by row. */
  void write(double[] out) {
    out[0] = e00;
    out[1] = e01;
    out[2] = e02;
    out[3] = e03;
    out[4] = e01;
    out[5] = e11;
    out[6] = e12;
    out[7] = e13;
    out[8] = e02;
    out[9] = e12;
    out[10] = e22;
    out[11] = e23;
    out[12] = e03;
    out[13] = e13;
    out[14] = e23;
    out[15] = e33;
  }

  void copy(FourStateCovariance other) {
    e00 = other.e00;
    e01 = other.e01;
    e02 = other.e02;
    e03 = other.e03;
    e11 = other.e11;
    e12 = other.e12;
    e13 = other.e13;
    e22 = other.e22;
    e23 = other.e23;
    e33 = other.e33;
  }

  /** One entry; for reading now and then, not for the hot path. */
  double get(int row, int column) {
    int i = Math.min(row, column);
    int j = Math.max(row, column);
    return switch (4 * i + j) {
      case 0 -> e00;
      case 1 -> e01;
      case 2 -> e02;
      case 3 -> e03;
      case 5 -> e11;
      case 6 -> e12;
      case 7 -> e13;
      case 10 -> e22;
      case 11 -> e23;
      case 15 -> e33;
      default -> throw new IndexOutOfBoundsException(row + ", " + column);
    };
  }

  /** P ← F P Fᵀ with an F that is 1 on its diagonal and 0 below. */
  void transform(double f01, double f02, double f03, double f12, double f13, double f23) {
    // B = F P, as far as it is needed: row i is row i of P plus rows below it.
    double b00 = e00 + f01 * e01 + f02 * e02 + f03 * e03;
    double b01 = e01 + f01 * e11 + f02 * e12 + f03 * e13;
    double b02 = e02 + f01 * e12 + f02 * e22 + f03 * e23;
    double b03 = e03 + f01 * e13 + f02 * e23 + f03 * e33;
    double b11 = e11 + f12 * e12 + f13 * e13;
    double b12 = e12 + f12 * e22 + f13 * e23;
    double b13 = e13 + f12 * e23 + f13 * e33;
    double b22 = e22 + f23 * e23;
    double b23 = e23 + f23 * e33;
    // P = B Fᵀ: column j is column j of B plus columns to its right.
    e00 = b00 + f01 * b01 + f02 * b02 + f03 * b03;
    e01 = b01 + f12 * b02 + f13 * b03;
    e02 = b02 + f23 * b03;
    e03 = b03;
    e11 = b11 + f12 * b12 + f13 * b13;
    e12 = b12 + f23 * b13;
    e13 = b13;
    e22 = b22 + f23 * b23;
    e23 = b23;
  }

  /** P ← F P Fᵀ with any F, sixteen entries, row by row. */
  void transform(double[] f) {
    double a0 = f[0];
    double a1 = f[1];
    double a2 = f[2];
    double a3 = f[3];
    double r00 = a0 * e00 + a1 * e01 + a2 * e02 + a3 * e03;
    double r01 = a0 * e01 + a1 * e11 + a2 * e12 + a3 * e13;
    double r02 = a0 * e02 + a1 * e12 + a2 * e22 + a3 * e23;
    double r03 = a0 * e03 + a1 * e13 + a2 * e23 + a3 * e33;
    double b0 = f[4];
    double b1 = f[5];
    double b2 = f[6];
    double b3 = f[7];
    double r10 = b0 * e00 + b1 * e01 + b2 * e02 + b3 * e03;
    double r11 = b0 * e01 + b1 * e11 + b2 * e12 + b3 * e13;
    double r12 = b0 * e02 + b1 * e12 + b2 * e22 + b3 * e23;
    double r13 = b0 * e03 + b1 * e13 + b2 * e23 + b3 * e33;
    double c0 = f[8];
    double c1 = f[9];
    double c2 = f[10];
    double c3 = f[11];
    double r20 = c0 * e00 + c1 * e01 + c2 * e02 + c3 * e03;
    double r21 = c0 * e01 + c1 * e11 + c2 * e12 + c3 * e13;
    double r22 = c0 * e02 + c1 * e12 + c2 * e22 + c3 * e23;
    double r23 = c0 * e03 + c1 * e13 + c2 * e23 + c3 * e33;
    double d0 = f[12];
    double d1 = f[13];
    double d2 = f[14];
    double d3 = f[15];
    double r30 = d0 * e00 + d1 * e01 + d2 * e02 + d3 * e03;
    double r31 = d0 * e01 + d1 * e11 + d2 * e12 + d3 * e13;
    double r32 = d0 * e02 + d1 * e12 + d2 * e22 + d3 * e23;
    double r33 = d0 * e03 + d1 * e13 + d2 * e23 + d3 * e33;
    e00 = r00 * a0 + r01 * a1 + r02 * a2 + r03 * a3;
    e01 = r00 * b0 + r01 * b1 + r02 * b2 + r03 * b3;
    e02 = r00 * c0 + r01 * c1 + r02 * c2 + r03 * c3;
    e03 = r00 * d0 + r01 * d1 + r02 * d2 + r03 * d3;
    e11 = r10 * b0 + r11 * b1 + r12 * b2 + r13 * b3;
    e12 = r10 * c0 + r11 * c1 + r12 * c2 + r13 * c3;
    e13 = r10 * d0 + r11 * d1 + r12 * d2 + r13 * d3;
    e22 = r20 * c0 + r21 * c1 + r22 * c2 + r23 * c3;
    e23 = r20 * d0 + r21 * d1 + r22 * d2 + r23 * d3;
    e33 = r30 * d0 + r31 * d1 + r32 * d2 + r33 * d3;
  }
}
