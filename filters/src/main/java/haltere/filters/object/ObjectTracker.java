package haltere.filters.object;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Prototype. */
public final class ObjectTracker {
  /** A row. */
  public record Row(long timeUs, int id, double x, double y, double vx, double vy, double major, double minor, double angle, double existence, double rate) {}

  static double p(String name, double value) {
    String said = System.getProperty("o." + name);
    return said == null ? value : Double.parseDouble(said);
  }

  static final double JOINNOW = p("joinnow", 3);
  static final boolean DEBUG = System.getProperty("dbg") != null;
  static final long TICK_US = 10_000;
  static final double DT = TICK_US * 1e-6;
  final double noiseMemoryS = p("noiseMemory", 5);
  final double birthMemoryS = p("birthMemory", 0.05);
  final double birthNat = p("birth", 12);
  final double acceleration = p("acc", 20);
  final double startSpeed = p("v0", 5);
  final double shapeMemoryS = p("shape", 0.3);
  final double stopHz = p("stop", 1);
  final double goneHz = p("gone", 0.1);
  final double goneSpeed = p("gonespeed", 0);
  final double uncertain = p("uncertain", 1);
  final double maxSize = p("maxsize", 0);
  final double joinAt = p("joinat", 1);
  final double outHz = p("out", 20);
  final double returns = p("returns", 2.3);
  final double joinNovel = p("joinnovel", 10);
  final double forgetS = p("forget", 2);
  final double rememberS = p("remember", 5);
  final double decideS = p("decide", 0.3);
  final double dim = 0.2;
  final double kappa = p("kappa", 0.25);
  final double odds = p("odds", 1.4);
  final double rho = p("rho", 0.15);
  final double evidenceS = p("evidence", 1);
  final double keepNat = p("keep", 3);
  final double travel = p("travel", 0);
  final double minShare = p("share", 0.1);
  final double infoScale = p("info", 0.2);

  private final int width;
  private final int height;
  private final ActivityGrid grid;
  private final float[] clutter; // per pixel, tile order
  private final int[] clutterTick;
  private final float[] recent;
  private final float[] recentCells;
  private double level = 1;
  final double again = p("again", 0);
  final double stillFloor = p("still", 0.02);
  final double novel = p("novel", 20);
  final double againS = p("againS", 0.3);
  private double noisePerTick = 0.2 * DT;
  private double seenTicks;
  private final int cellColumns;
  private final int cellRows;
  private final float[] excess;
  private final float[] background;
  private long tickStartUs = Long.MIN_VALUE;
  private int tick;
  private final List<Obj> objects = new ArrayList<>();
  private final List<Obj> lost = new ArrayList<>();
  private int ids;
  private final List<Row> rows = new ArrayList<>();
  // recent unexplained tiles
  private static final int RING = 1 << 15;
  private final int[] ringTile = new int[RING];
  private final int[] ringMask = new int[RING];
  private final int[] ringTick = new int[RING];
  private long ringCount;
  // index of blocks
  private static final int BLOCK_SHIFT = 4;
  private final int blockColumns;
  private final int blockRows;
  private final int[] blockHead;
  private int[] blockNext = new int[1024];
  private int[] blockObject = new int[1024];
  private int blockEntries;

  public ObjectTracker(SensorGeometry geometry) {
    width = geometry.width();
    height = geometry.height();
    grid = new ActivityGrid(width, height);
    clutter = new float[grid.columns * grid.rows * 16];
    recent = new float[clutter.length];
    clutterTick = new int[grid.columns * grid.rows];
    cellColumns = (grid.columns + 1) / 2;
    cellRows = (grid.rows + 1) / 2;
    excess = new float[cellColumns * cellRows];
    recentCells = new float[cellColumns * cellRows];
    background = new float[cellColumns * cellRows];
    blockColumns = (width >> BLOCK_SHIFT) + 1;
    blockRows = (height >> BLOCK_SHIFT) + 1;
    blockHead = new int[blockColumns * blockRows];
    Arrays.fill(blockHead, -1);
  }

  public List<Row> rows() {
    return rows;
  }

  public void track(EventPacket packet) {
    for (int i = 0; i < packet.size(); i++) {
      long t = packet.timeUs(i);
      if (t >= tickStartUs + TICK_US) {
        advance(t);
      }
      int a = packet.address(i);
      grid.add(EventAddress.x(a), EventAddress.y(a), (int) (t - tickStartUs));
    }
  }

  private void advance(long t) {
    if (tickStartUs == Long.MIN_VALUE) {
      tickStartUs = Math.floorDiv(t, TICK_US) * TICK_US;
      return;
    }
    while (t >= tickStartUs + TICK_US) {
      step();
      tickStartUs += TICK_US;
      grid.next();
      tick++;
      if (objects.isEmpty() && lost.isEmpty() && t > tickStartUs + 1_000_000) {
        tickStartUs = Math.floorDiv(t, TICK_US) * TICK_US;
      }
    }
  }

  private void step() {
    long now = tickStartUs + TICK_US;
    double keepNoise = Math.exp(-DT / noiseMemoryS);
    seenTicks = seenTicks * keepNoise + 1;
    float keepRecentTick = (float) Math.exp(-DT / againS);
    float keepBirth = (float) Math.exp(-DT / birthMemoryS);
    for (int i = 0; i < excess.length; i++) {
      excess[i] *= keepBirth;
      background[i] *= (float) keepNoise;
      recentCells[i] *= keepRecentTick;
    }
    indexObjects();
    associate();
    estimateNoise();
    for (Obj o : objects) {
      update(o, now);
    }
    birth(now);
    splitObjects(now);
    relate();
    live(now);
    publish(now);
  }

  // ---- association

  private void indexObjects() {
    for (int i = 0; i < blockEntries; i++) {
      // heads are cleared below
    }
    Arrays.fill(blockHead, -1);
    blockEntries = 0;
    for (int k = 0; k < objects.size(); k++) {
      Obj o = objects.get(k);
      o.w = 0;
      o.gx = 0;
      o.gy = 0;
      Arrays.fill(o.logs, 0);
      o.factor = o.rate / (o.shape.cellPx * o.shape.cellPx);
      double half = ShapeTemplate.SIDE / 2.0 * o.shape.cellPx;
      double dx = Math.abs(o.vx()) * DT;
      double dy = Math.abs(o.vy()) * DT;
      int c0 = Math.max(0, (int) Math.floor(o.x() - half - dx) >> BLOCK_SHIFT);
      int c1 = Math.min(blockColumns - 1, (int) Math.floor(o.x() + half + dx) >> BLOCK_SHIFT);
      int r0 = Math.max(0, (int) Math.floor(o.y() - half - dy) >> BLOCK_SHIFT);
      int r1 = Math.min(blockRows - 1, (int) Math.floor(o.y() + half + dy) >> BLOCK_SHIFT);
      for (int r = r0; r <= r1; r++) {
        for (int c = c0; c <= c1; c++) {
          if (blockEntries == blockNext.length) {
            blockNext = Arrays.copyOf(blockNext, 2 * blockEntries);
            blockObject = Arrays.copyOf(blockObject, 2 * blockEntries);
          }
          int b = r * blockColumns + c;
          blockObject[blockEntries] = k;
          blockNext[blockEntries] = blockHead[b];
          blockHead[b] = blockEntries++;
        }
      }
    }
  }

  private final Obj[] near = new Obj[16];
  private final double[] nearX = new double[16];
  private final double[] nearY = new double[16];
  private final double[] lambda = new double[16];
  private final int[] cells = new int[16];

  private void associate() {
    double keepNoise = Math.exp(-DT / noiseMemoryS);
    for (int a = 0; a < grid.count(); a++) {
      int tile = grid.tile(a);
      int pixels = grid.pixels(tile);
      double timeS = grid.meanUs(tile) * 1e-6;
      int tx = (tile % grid.columns) << 2;
      int ty = (tile / grid.columns) << 2;
      int count = 0;
      int block = (ty >> BLOCK_SHIFT) * blockColumns + (tx >> BLOCK_SHIFT);
      for (int e = blockHead[block]; e >= 0 && count < near.length; e = blockNext[e]) {
        Obj o = objects.get(blockObject[e]);
        near[count] = o;
        nearX[count] = tx - (o.x() + o.vx() * timeS);
        nearY[count++] = ty - (o.y() + o.vy() * timeS);
      }
      int since = tick - clutterTick[tile];
      float keep = since == 0 ? 1 : (float) Math.pow(keepNoise, since);
      float keepRecent = since == 0 ? 1 : (float) Math.exp(-since * DT / againS);
      clutterTick[tile] = tick;
      int base = tile << 4;
      double unexplained = 0;
      int tileCell = (ty >> 3) * cellColumns + (tx >> 3);
      double expectedRepeats = 0;
      int unexplainedMask = 0;
      for (int bit = 0; bit < 16; bit++) {
        clutter[base + bit] *= keep;
        recent[base + bit] *= keepRecent;
        if ((pixels >> bit & 1) == 0) {
          continue;
        }
        double before = recent[base + bit];
        double repeat = again * before * DT / againS;
        recent[base + bit] += 1;
        double noise = level * (clutter[base + bit] + 1) / (seenTicks + 1 / noisePerTick) + repeat;
        expectedRepeats += repeat;
        double sum = noise;
        int bx = bit & 3;
        int by = bit >> 2;
        for (int k = 0; k < count; k++) {
          Obj o = near[k];
          int cell = o.shape.cell(nearX[k] + bx, nearY[k] + by);
          cells[k] = cell;
          lambda[k] = cell < 0 ? 0 : o.factor * o.shape.density[cell];
          sum += Math.max(o.moving, 0.02) * lambda[k];
        }
        for (int k = 0; k < count; k++) {
          if (lambda[k] == 0) {
            continue;
          }
          Obj o = near[k];
          double mine = Math.max(o.moving, 0.02) * lambda[k];
          double rest = sum - mine;
          double q = lambda[k] / rest;
          o.logs[0] += Math.log1p(q);
          o.logs[1] += Math.log1p(q * Math.sqrt(dim));
          o.logs[2] += Math.log1p(q * dim);
          double w = mine / sum;
          if (w < 0.01) {
            continue;
          }
          int cell = cells[k];
          o.w += w;
          double still = 0.5 * (before + stillFloor) + 0.5 * (recentCells[tileCell] / 64 + stillFloor);
          o.novelty += w * Math.max(-3, Math.min(3, Math.log(lambda[k] * againS / DT / still)));
          o.gx -= w * o.shape.gradientX[cell];
          o.gy -= w * o.shape.gradientY[cell];
          o.shape.mass[cell] += (float) w;
          o.shape.total += w;
        }
        double w0 = noise / sum;
        double fresh = w0 * (1 - repeat / noise);
        clutter[base + bit] += (float) w0;
        unexplained += fresh;
        if (w0 > 0.5) {
          unexplainedMask |= 1 << bit;
        }
      }
      int cell = (ty >> 3) * cellColumns + (tx >> 3);
      recentCells[cell] += Integer.bitCount(pixels);
      excess[cell] += (float) unexplained;
      background[cell] += (float) unexplained;
      if (unexplainedMask != 0) {
        int r = (int) (ringCount++ & RING - 1);
        ringTile[r] = tile;
        ringMask[r] = unexplainedMask;
        ringTick[r] = tick;
      }
    }
  }

  private void estimateNoise() {
    double mean = 0;
    for (float b : background) {
      mean += b;
    }
    mean /= background.length;
    double winsorised = 0;
    for (float b : background) {
      winsorised += Math.min(b, 3 * mean);
    }
    winsorised /= background.length;
    double now = 0;
    double top = 0;
    for (float e : excess) {
      top += e;
    }
    top /= excess.length;
    for (float e : excess) {
      now += Math.min(e, 3 * top);
    }
    now /= excess.length;
    double usual = winsorised / seenTicks * birthMemoryS / DT;
    level = seenTicks < 20 ? 1 : Math.max(1, now / Math.max(usual, 1e-9));
    // one tick and pixel in 500 s of prior
    noisePerTick = Math.max((winsorised + 0.2 * 0.5 * 64) / (64 * (seenTicks + 50)), 1e-3 * DT);
  }

  // ---- update

  private void update(Obj o, long now) {
    double size = o.shape.size();
    double speed = o.speed() / size;
    double fx = o.x() + o.vx() * birthMemoryS;
    double fy = o.y() + o.vy() * birthMemoryS;
    boolean leaving = fx < 0 || fy < 0 || fx > width - 1 || fy > height - 1;
    double in =
        inside(o.middleX() + o.vx() * birthMemoryS, o.shape.halfX, width)
            * inside(o.middleY() + o.vy() * birthMemoryS, o.shape.halfY, height);
    double vanish = (goneHz + outHz * (1 - in) * (1 - in)) * DT;
    double stop = stopHz * DT;
    double m = o.moving;
    double s = o.resting;
    double g = o.gone;
    double nextM = m * (1 - stop - vanish) + s * stop;
    double nextS = m * stop + s * (1 - stop - DT / forgetS);
    double nextG = g + m * vanish + s * DT / forgetS;
    double best = Double.NEGATIVE_INFINITY;
    double[] e = new double[3];
    for (int j = 0; j < 3; j++) {
      e[j] = o.logs[j] - Math.pow(dim, 0.5 * j) * o.rate;
      best = Math.max(best, e[j]);
    }
    double sum = 0;
    for (double one : e) {
      sum += Math.exp(one - best) / 3;
    }
    double log = Math.max(-30, Math.min(30, best + Math.log(sum)));
    nextM *= Math.exp(log);
    double z = nextM + nextS + nextG;
    o.moving = nextM / z;
    o.resting = nextS / z;
    o.gone = nextG / z;
    // predict
    double beforeX = o.x();
    double beforeY = o.y();
    double q = acceleration * size * size;
    for (int i = 0; i < 4; i += 2) {
      o.s.shear(i, i + 1, DT);
      o.s.addNoise(i, q * DT * DT * DT / 3);
      o.s.addNoise(i, i + 1, q * DT * DT / 2);
      o.s.addNoise(i + 1, q * DT);
    }
    if (o.moving < 0.5) {
      double keep = Math.exp(-DT / 0.1);
      o.s.setMean(1, o.vx() * keep);
      o.s.setMean(3, o.vy() * keep);
    }
    if (o.w > 0.5) {
      correct(o);
      double keep = Math.exp(-DT * o.moving / Math.min(shapeMemoryS, 0.05 + o.age * DT));
      o.shape.decay(keep);
      double beta = 1 - Math.exp(-DT * o.moving / Math.min(0.5, 0.05 + o.age * DT));
      o.rate = Math.max(0.05, o.rate + beta * (o.w - o.rate));
      o.events += o.w;
      if (o.moving > 0.5) {
        o.seenUs = now;
      }
    } else {
      double beta = 1 - Math.exp(-DT * o.moving / 0.5);
      o.rate = Math.max(0.05, o.rate + beta * (o.w - o.rate));
    }
    o.walkedX += o.x() - beforeX;
    o.walkedY += o.y() - beforeY;
    o.walk();
    recentre(o);
    o.shape.refresh();
  }

  /** Share of an interval that is within the picture. */
  private static double inside(double middle, double half, double size) {
    double low = Math.max(0, middle - half);
    double high = Math.min(size - 1, middle + half);
    return Math.max(0, high - low) / (2 * half);
  }

  private final double[] row = new double[4];

  /** Maximum likelihood displacement of the template: Newton's step, with Fisher's information. */
  private void correct(Obj o) {
    ShapeTemplate t = o.shape;
    double scale = o.w * infoScale;
    double xx = scale * t.infoXx;
    double xy = scale * t.infoXy;
    double yy = scale * t.infoYy;
    // two independent directions of the information
    double angle = 0.5 * Math.atan2(2 * xy, xx - yy);
    double spread = Math.hypot(0.5 * (xx - yy), xy);
    double mean = 0.5 * (xx + yy);
    for (int k = 0; k < 2; k++) {
      double info = k == 0 ? mean + spread : mean - spread;
      if (info < 1e-4) {
        continue;
      }
      double c = k == 0 ? Math.cos(angle) : -Math.sin(angle);
      double s = k == 0 ? Math.sin(angle) : Math.cos(angle);
      double shift = infoScale * (c * o.gx + s * o.gy) / info;
      row[0] = c;
      row[2] = s;
      // earlier direction has moved the state along its own direction only, which is orthogonal
      o.s.project(row);
      o.s.correct(shift, 1 / info);
    }
  }

  private void recentre(Obj o) {
    ShapeTemplate t = o.shape;
    double cell = t.wantedCell();
    double far = Math.max(Math.abs(t.middleX), Math.abs(t.middleY));
    if (cell != t.cellPx || far > 1.5 * t.cellPx) {
      double dx = t.middleX;
      double dy = t.middleY;
      t.resample(cell, dx, dy);
      o.s.setMean(0, o.x() + dx);
      o.s.setMean(2, o.y() + dy);
      o.anchorX += dx;
      o.anchorY += dy;
      for (Component c : o.components) {
        c.x -= dx;
        c.y -= dy;
      }
    }
  }

  // ---- births

  private final boolean[] done() {
    return new boolean[excess.length];
  }

  private void birth(long now) {
    boolean[] done = null;
    double expectedFactor = birthMemoryS / DT;
    for (int c = 0; c < excess.length; c++) {
      if (excess[c] < 2 || llr(c, expectedFactor) < 2) {
        continue;
      }
      if (done == null) {
        done = done();
      }
      if (done[c]) {
        continue;
      }
      int[] stack = new int[excess.length];
      int top = 0;
      stack[top++] = c;
      done[c] = true;
      double total = 0;
      for (int at = 0; at < top; at++) {
        int here = stack[at];
        total += llr(here, expectedFactor);
        for (int dy = -1; dy <= 1; dy++) {
          for (int dx = -1; dx <= 1; dx++) {
            int nx = here % cellColumns + dx;
            int ny = here / cellColumns + dy;
            if (nx >= 0 && ny >= 0 && nx < cellColumns && ny < cellRows) {
              int n = ny * cellColumns + nx;
              if (!done[n] && llr(n, expectedFactor) >= 2) {
                done[n] = true;
                stack[top++] = n;
              }
            }
          }
        }
      }
      if (total >= birthNat && objects.size() < 400) {
        create(stack, top, now);
        for (int k = 0; k < top; k++) {
          excess[stack[k]] = 0;
        }
      }
    }
  }

  private double llr(int c, double expectedFactor) {
    double mu = level * (background[c] + 1) / (seenTicks + 1 / (64 * noisePerTick)) * expectedFactor;
    double e = excess[c];
    return e > mu ? e * Math.log(e / mu) - (e - mu) : 0;
  }

  private void create(int[] stack, int top, long now) {
    boolean[] mine = new boolean[excess.length];
    for (int k = 0; k < top; k++) {
      mine[stack[k]] = true;
    }
    int window = (int) Math.round(2 * birthMemoryS / DT);
    double n = 0;
    double sx = 0;
    double sy = 0;
    double st = 0;
    double sxx = 0;
    double syy = 0;
    double stt = 0;
    double sxt = 0;
    double syt = 0;
    long first = Math.max(0, ringCount - RING);
    for (long i = ringCount - 1; i >= first; i--) {
      int r = (int) (i & RING - 1);
      if (tick - ringTick[r] > window) {
        break;
      }
      int tile = ringTile[r];
      int tx = (tile % grid.columns) << 2;
      int ty = (tile / grid.columns) << 2;
      if (!mine[(ty >> 3) * cellColumns + (tx >> 3)]) {
        continue;
      }
      double t = (ringTick[r] - tick) * DT;
      for (int bit = 0; bit < 16; bit++) {
        if ((ringMask[r] >> bit & 1) != 0) {
          double x = tx + (bit & 3);
          double y = ty + (bit >> 2);
          n++;
          sx += x;
          sy += y;
          st += t;
          sxx += x * x;
          syy += y * y;
          stt += t * t;
          sxt += x * t;
          syt += y * t;
        }
      }
    }
    if (n < 6) {
      return;
    }
    double mx = sx / n;
    double my = sy / n;
    double mt = st / n;
    double vxx = sxx / n - mx * mx;
    double vyy = syy / n - my * my;
    double vtt = Math.max(stt / n - mt * mt, DT * DT / 12);
    double half = Math.max(2, 2 * Math.sqrt(Math.max(vxx, vyy)));
    double prior = startSpeed * 2 * half;
    double r = Math.max(0.25 * (vxx + vyy), 1);
    double keep = prior * prior / (prior * prior + r / (n * vtt));
    double vx = keep * (sxt / n - mx * mt) / vtt;
    double vy = keep * (syt / n - my * mt) / vtt;
    double pv = (1 - keep) * prior * prior + 1;
    Obj o = new Obj();
    o.s.setMean(0, mx - vx * mt);
    o.s.setMean(1, vx);
    o.s.setMean(2, my - vy * mt);
    o.s.setMean(3, vy);
    o.s.setVariances(r / n + pv * mt * mt, pv, r / n + pv * mt * mt, pv);
    o.s.addNoise(0, 1, -pv * mt);
    o.s.addNoise(2, 3, -pv * mt);
    o.shape.clear(Math.max(ShapeTemplate.MIN_CELL_PX, 2 * half / (ShapeTemplate.SIDE / 2)));
    for (long i = ringCount - 1; i >= first; i--) {
      int q = (int) (i & RING - 1);
      if (tick - ringTick[q] > window) {
        break;
      }
      int tile = ringTile[q];
      int tx = (tile % grid.columns) << 2;
      int ty = (tile / grid.columns) << 2;
      if (!mine[(ty >> 3) * cellColumns + (tx >> 3)]) {
        continue;
      }
      double t = (ringTick[q] - tick) * DT;
      for (int bit = 0; bit < 16; bit++) {
        if ((ringMask[q] >> bit & 1) != 0) {
          o.shape.spread(tx + (bit & 3) - o.x() - vx * t, ty + (bit >> 2) - o.y() - vy * t, 1, 1);
        }
      }
      ringMask[q] = 0;
    }
    o.bornUs = now;
    o.bornTick = tick;
    o.seenUs = now;
    o.events = n;
    o.rate = n / window;
    o.shape.refresh();
    resumeOrAdd(o, now);
  }

  private void resumeOrAdd(Obj o, long now) {
    Obj best = null;
    double bestLog = 0;
    for (int list = 0; list < 2; list++) {
      for (Obj old : list == 0 ? objects : lost) {
        if (old.id == 0) {
          continue;
        }
        double quiet = old.moving >= 0.5 ? 0 : (now - old.seenUs) * 1e-6;
        double size = Math.max(old.shape.size(), o.shape.size());
        double sd = size * (0.5 + Math.min(quiet, 1)) * 0.5;
        double dx = gap(o.middleX() - old.middleX(), o.shape.halfX + old.shape.halfX);
        double dy = gap(o.middleY() - old.middleY(), o.shape.halfY + old.shape.halfY);
        double log =
            returns
                + Math.log(width * (double) height / (2 * Math.PI * sd * sd + size * size))
                - (dx * dx + dy * dy) / (2 * sd * sd);
        if (log > bestLog) {
          bestLog = log;
          best = old;
        }
      }
    }
    if (best != null && (best.moving < 0.5 || lost.contains(best))) {
      if (DEBUG) System.out.printf("t %d resume %d by (%d) at %.0f,%.0f log %.1f%n", now, best.id, o.serial, o.middleX(), o.middleY(), bestLog);
      // it goes on as the old one
      Obj old = best;
      double dx = o.middleX() - old.middleX();
      double dy = o.middleY() - old.middleY();
      double shiftX = Math.signum(dx) * gap(dx, Math.max(0, old.shape.halfX - o.shape.halfX));
      double shiftY = Math.signum(dy) * gap(dy, Math.max(0, old.shape.halfY - o.shape.halfY));
      old.s.setMean(0, old.x() + shiftX);
      old.s.setMean(2, old.y() + shiftY);
      old.walkedX += shiftX;
      old.walkedY += shiftY;
      old.moving = 0.9;
      old.resting = 0.05;
      old.gone = 0.05;
      old.seenUs = now;
      double r = old.rate;
      join(old, o);
      old.rate = Math.max(o.rate, 0.5 * r);
      old.s.setMean(1, o.vx());
      old.s.setMean(3, o.vy());
      old.s.covariance().setTo(o.s.covariance());
      if (lost.remove(old)) {
        objects.add(old);
      }
      return;
    }
    objects.add(o);
  }

  private static double gap(double d, double reach) {
    return Math.max(0, Math.abs(d) - reach);
  }

  // ---- relations

  private void relate() {
    int ticks = (int) Math.round(decideS / DT);
    double fade = Math.exp(-DT / evidenceS);
    for (int i = 0; i < objects.size(); i++) {
      Obj a = objects.get(i);
      for (int j = i + 1; j < objects.size(); j++) {
        Obj b = objects.get(j);
        double gapLog = gapLog(a, b);
        if (gapLog < -20) {
          a.evidence.remove(b.serial);
          continue;
        }
        if (a.moving < 0.5 || b.moving < 0.5) {
          continue;
        }
        int n = Math.min(ticks, Math.min(a.age, b.age) - 1);
        double old = a.evidence.getOrDefault(b.serial, 0.0);
        double now = old * fade;
        if (n > ticks / 3) {
          now += motionLog(a, b, n) * DT / decideS;
        }
        a.evidence.put(b.serial, now);
      }
    }
    for (int i = 0; i < objects.size(); i++) {
      Obj a = objects.get(i);
      for (int j = i + 1; j < objects.size(); j++) {
        Obj b = objects.get(j);
        if (a.moving < 0.5 || b.moving < 0.5 || a.novelty < joinNovel || b.novelty < joinNovel) {
          continue;
        }
        double total = gapLog(a, b) + a.evidence.getOrDefault(b.serial, 0.0);
        boolean bothOld = a.id > 0 && b.id > 0;
        if (total > (bothOld ? Math.max(keepNat, joinAt) : joinAt) && Math.min(a.age, b.age) > (total > JOINNOW ? ticks / 3 : ticks)) {
          Obj into = a.id == 0 && b.id > 0 || b.id > 0 && b.id < a.id ? b : a;
          Obj from = into == a ? b : a;
          join(into, from);
          objects.remove(from);
          if (from == a) {
            i--;
            break;
          }
          j--;
        }
      }
    }
  }

  private double gapLog(Obj a, Obj b) {
    double box =
        Math.hypot(
            gap(a.middleX() - b.middleX(), a.shape.halfX + b.shape.halfX),
            gap(a.middleY() - b.middleY(), a.shape.halfY + b.shape.halfY));
    double size = Math.sqrt(a.shape.size() * b.shape.size());
    double prior = gapLog(box, size);
    return prior < -20 ? prior : gapLog(a.shape.distance(b.shape, b.x() - a.x(), b.y() - a.y()), size);
  }

  private double gapLog(double distance, double size) {
    return odds - Math.max(0, distance - 3) / (kappa * size);
  }

  private double motionLog(Obj a, Obj b, int n) {
    double t2 = n * DT * n * DT * uncertain;
    double xx = (a.s.covariance(1, 1) + b.s.covariance(1, 1)) * t2;
    double xy = (a.s.covariance(1, 3) + b.s.covariance(1, 3)) * t2;
    double yy = (a.s.covariance(3, 3) + b.s.covariance(3, 3)) * t2;
    return motionLog(
        a.displacementX(n),
        a.displacementY(n),
        b.displacementX(n),
        b.displacementY(n),
        xx,
        xy,
        yy,
        maxSize > 0
            ? Math.max(a.shape.size(), b.shape.size())
            : Math.sqrt(a.shape.size() * b.shape.size()));
  }

  /** Log ratio of a slip under one motion and under two, with the covariance of its measurement. */
  private double motionLog(
      double ax, double ay, double bx, double by, double xx, double xy, double yy, double size) {
    double bend = rho * rho * size * size + 2;
    double apart = 0.5 * (ax * ax + ay * ay + bx * bx + by * by);
    double dx = ax - bx;
    double dy = ay - by;
    double oneXx = xx + bend;
    double oneYy = yy + bend;
    double oneDet = oneXx * oneYy - xy * xy;
    double twoXx = oneXx + apart;
    double twoYy = oneYy + apart;
    double twoDet = twoXx * twoYy - xy * xy;
    double one = (oneYy * dx * dx - 2 * xy * dx * dy + oneXx * dy * dy) / oneDet;
    double two = (twoYy * dx * dx - 2 * xy * dx * dy + twoXx * dy * dy) / twoDet;
    return 0.5 * Math.log(twoDet / oneDet) - 0.5 * (one - two);
  }

  // ---- components and splits

  private static final int EVERY = 5;
  private final int[] label = new int[ShapeTemplate.CELLS];
  private final int[] stack = new int[ShapeTemplate.CELLS];

  private long now0;

  private void splitObjects(long now) {
    now0 = now;
    if (tick % EVERY != 0) {
      return;
    }
    int n = objects.size();
    for (int i = 0; i < n; i++) {
      Obj o = objects.get(i);
      if (o.moving >= 0.5 && o.w > 0) {
        findComponents(o);
        if (o.components.size() > 1) {
          split(o, now);
        }
      }
    }
  }

  private void findComponents(Obj o) {
    ShapeTemplate t = o.shape;
    Arrays.fill(label, 0);
    int labels = 0;
    List<double[]> found = new ArrayList<>();
    for (int c = 0; c < ShapeTemplate.CELLS; c++) {
      if (!t.core[c] || label[c] != 0) {
        continue;
      }
      labels++;
      int top = 0;
      stack[top++] = c;
      label[c] = labels;
      double m = 0;
      double mx = 0;
      double my = 0;
      int x0 = 99;
      int x1 = -99;
      int y0 = 99;
      int y1 = -99;
      while (top > 0) {
        int h = stack[--top];
        int hx = h % ShapeTemplate.SIDE;
        int hy = h / ShapeTemplate.SIDE;
        double w = t.mass[h];
        m += w;
        mx += w * ShapeTemplate.x(h);
        my += w * ShapeTemplate.y(h);
        x0 = Math.min(x0, hx);
        x1 = Math.max(x1, hx);
        y0 = Math.min(y0, hy);
        y1 = Math.max(y1, hy);
        for (int dy = -1; dy <= 1; dy++) {
          for (int dx = -1; dx <= 1; dx++) {
            int nx = hx + dx;
            int ny = hy + dy;
            if (nx >= 0 && ny >= 0 && nx < ShapeTemplate.SIDE && ny < ShapeTemplate.SIDE) {
              int q = ny * ShapeTemplate.SIDE + nx;
              if (t.core[q] && label[q] == 0) {
                label[q] = labels;
                stack[top++] = q;
              }
            }
          }
        }
      }
      if (m > minShare * t.solidTotal && m > 3) {
        double cell = t.cellPx;
        found.add(
            new double[] {
              m, mx / m * cell, my / m * cell, (x1 - x0 + 1) * cell / 2, (y1 - y0 + 1) * cell / 2, labels
            });
      }
    }
    if (DEBUG && System.getProperty("map") != null && o.id == 1 && tick % 20 == 0) {
      StringBuilder b = new StringBuilder("map " + now0 + " labels " + labels + " found " + found.size() + " cell " + t.cellPx + "\n");
      for (int r = ShapeTemplate.SIDE - 1; r >= 0; r--) {
        for (int c = 0; c < ShapeTemplate.SIDE; c++) {
          int q = r * ShapeTemplate.SIDE + c;
          b.append(t.solid[q] ? (char) ('0' + Math.min(9, (int) (t.density[q] * 200))) : '.');
        }
        b.append('\n');
      }
      System.out.print(b);
    }
    if (DEBUG && found.size() != 1) System.out.println("found " + found.size() + " in " + o.id + " labels " + labels + " size " + t.size() + " cell " + t.cellPx + " total " + t.solidTotal);
    for (Component c : o.components) {
      c.seen = false;
    }
    found.sort((a, b) -> Double.compare(b[0], a[0]));
    List<Component> fresh = new ArrayList<>();
    for (double[] f : found) {
      Component best = null;
      double bestD = Double.POSITIVE_INFINITY;
      for (Component c : o.components) {
        double d = Math.hypot(f[1] - c.x, f[2] - c.y);
        if (!c.seen && d < bestD && d < Math.max(c.size(), 2 * Math.max(f[3], f[4]))) {
          bestD = d;
          best = c;
        }
      }
      if (best == null) {
        best = new Component();
        fresh.add(best);
      } else if (best.unseen > 0) {
        best.age = 0; // its path has a gap
      }
      best.seen = true;
      best.unseen = 0;
      best.mass = f[0];
      best.x = f[1];
      best.y = f[2];
      best.halfX = f[3];
      best.halfY = f[4];
      best.label = (int) f[5];
      best.walk(o.walkedX + o.anchorX + best.x, o.walkedY + o.anchorY + best.y);
    }
    o.components.addAll(fresh);
    o.components.removeIf(c -> !c.seen && ++c.unseen > evidenceS / (EVERY * DT));
  }

  private void split(Obj o, long now) {
    int ticks = (int) Math.round(decideS / DT / EVERY);
    double fade = Math.exp(-EVERY * DT / evidenceS);
    List<Component> all = o.components.stream().filter(c -> c.seen).toList();
    if (all.size() < 2) {
      return;
    }
    int[] group = new int[all.size()];
    for (int i = 0; i < group.length; i++) {
      group[i] = i;
    }
    for (int i = 0; i < all.size(); i++) {
      Component a = all.get(i);
      for (int j = i + 1; j < all.size(); j++) {
        Component b = all.get(j);
        Component first = a.serial < b.serial ? a : b;
        Component second = first == a ? b : a;
        double size = Math.sqrt(a.size() * b.size());
        double prior =
            gapLog(
                Math.hypot(gap(a.x - b.x, a.halfX + b.halfX), gap(a.y - b.y, a.halfY + b.halfY)), size);
        double e = first.evidence.getOrDefault(second.serial, 0.0) * fade;
        int m = Math.min(ticks, Math.min(a.age, b.age) - 1);
        if (m > ticks / 3) {
          e +=
              motionLog(
                      a.displacementX(m), a.displacementY(m), b.displacementX(m), b.displacementY(m), 0, 0, 0, size)
                  * EVERY * DT / decideS;
        }
        first.evidence.put(second.serial, e);
        if (DEBUG) System.out.printf("t %d o %d c %d %d at %.0f,%.0f prior %.1f e %.1f m %d%n", now, o.id, a.serial, b.serial, a.x-b.x, a.y-b.y, prior, e, m);
        if (prior + e > -keepNat) {
          int from = Math.max(group[i], group[j]);
          int to = Math.min(group[i], group[j]);
          for (int k = 0; k < group.length; k++) {
            if (group[k] == from) {
              group[k] = to;
            }
          }
        }
      }
    }
    double[] mass = new double[all.size()];
    int largest = 0;
    for (int i = 0; i < group.length; i++) {
      mass[group[i]] += all.get(i).mass;
    }
    for (int i = 0; i < mass.length; i++) {
      largest = mass[i] > mass[largest] ? i : largest;
    }
    for (int g = 0; g < group.length; g++) {
      if (g != largest && mass[g] > 0) {
        leave(o, all, group, g, now);
      }
    }
  }

  private int nearestLabel(Obj o, List<Component> all, int k) {
    if (label[k] != 0 || o.shape.mass[k] == 0) {
      return label[k];
    }
    double x = ShapeTemplate.x(k) * o.shape.cellPx;
    double y = ShapeTemplate.y(k) * o.shape.cellPx;
    int best = 0;
    double least = Double.POSITIVE_INFINITY;
    for (Component c : all) {
      double d = Math.hypot(gap(x - c.x, c.halfX), gap(y - c.y, c.halfY));
      if (d < least) {
        least = d;
        best = c.label;
      }
    }
    return best;
  }

  private void leave(Obj o, List<Component> all, int[] group, int g, long now) {
    Obj n = new Obj();
    n.s.set(o.s);
    n.shape.clear(o.shape.cellPx);
    double relX = 0;
    double relY = 0;
    double total = 0;
    for (int i = 0; i < group.length; i++) {
      if (group[i] != g) {
        continue;
      }
      Component c = all.get(i);
      for (int k = 0; k < ShapeTemplate.CELLS; k++) {
        if (nearestLabel(o, all, k) == c.label) {
          n.shape.add(k, o.shape.mass[k]);
          o.shape.total -= o.shape.mass[k];
          o.shape.mass[k] = 0;
        }
      }
      int m = Math.min(6, c.age - 1);
      if (m > 1) {
        relX += c.mass * (c.displacementX(m) / (m * EVERY * DT) - o.displacementX(m * EVERY) / (m * EVERY * DT));
        relY += c.mass * (c.displacementY(m) / (m * EVERY * DT) - o.displacementY(m * EVERY) / (m * EVERY * DT));
        total += c.mass;
      }
      o.components.remove(c);
    }
    if (total > 0) {
      n.s.setMean(1, n.vx() + relX / total);
      n.s.setMean(3, n.vy() + relY / total);
    }
    double share = n.shape.total / (n.shape.total + o.shape.total);
    n.rate = o.rate * share;
    o.rate *= 1 - share;
    n.events = 40;
    n.farthest = o.farthest;
    n.bornUs = now - (long) (0.5 * decideS * 1e6);
    n.bornTick = tick;
    n.seenUs = now;
    n.moving = o.moving;
    n.resting = o.resting;
    n.gone = o.gone;
    n.evidence.put(o.serial, -2 * keepNat);
    o.evidence.put(n.serial, -2 * keepNat);
    n.shape.refresh();
    o.shape.refresh();
    recentre(n);
    recentre(o);
    n.shape.refresh();
    o.shape.refresh();
    objects.add(n);
  }

  private void join(Obj into, Obj from) {
    if (DEBUG) System.out.printf("t %d join %d (%d) and %d (%d) at %.0f,%.0f %.0f,%.0f gap %.1f ev %.1f%n", tickStartUs, into.id, into.serial, from.id, from.serial, into.middleX(), into.middleY(), from.middleX(), from.middleY(), gapLog(into, from), into.evidence.getOrDefault(from.serial, from.evidence.getOrDefault(into.serial, 0.0)));
    double dx = from.x() - into.x();
    double dy = from.y() - into.y();
    double half = into.shape.cellPx * ShapeTemplate.SIDE / 2;
    double needX = Math.abs(dx) + from.shape.halfX + Math.abs(from.shape.middleX);
    double needY = Math.abs(dy) + from.shape.halfY + Math.abs(from.shape.middleY);
    double share = from.rate / (from.rate + into.rate);
    while (half < Math.max(needX, needY) * 1.05) {
      into.shape.resample(into.shape.cellPx * Math.sqrt(2), 0, 0);
      half = into.shape.cellPx * ShapeTemplate.SIDE / 2;
    }
    into.shape.absorb(from.shape, dx, dy);
    into.s.setMean(1, into.vx() + share * (from.vx() - into.vx()));
    into.s.setMean(3, into.vy() + share * (from.vy() - into.vy()));
    into.rate += from.rate;
    into.events += from.events;
    into.shape.refresh();
    recentre(into);
    into.shape.refresh();
  }

  // ---- life

  private void live(long now) {
    for (int i = 0; i < objects.size(); i++) {
      Obj o = objects.get(i);
      if (o.id == 0) {
        if (o.moving < 0.5) {
          objects.remove(i--);
          continue;
        }
        boolean old = now - o.bornUs >= decideS * 1e6 && o.events >= 40;
        if (old && o.novelty > novel && o.farthest > travel * o.shape.size() + 1 && isApart(o)) {
          o.id = ++ids;
          for (double[] h : o.history) {
            rows.add(row((long) h[0], o.id, h));
          }
          if (DEBUG) System.out.printf("show %d (%d) t %d at %.0f,%.0f size %.0f novelty %.1f events %.0f per event %.2f far %.1f rate %.1f%n", o.id, o.serial, now, o.middleX(), o.middleY(), o.shape.size(), o.novelty, o.events, o.novelty / o.events, o.farthest, o.rate);
        }
      } else if (o.existence() < 0.5) {
        if (DEBUG) System.out.printf("lose %d (%d) t %d at %.0f,%.0f v %.0f,%.0f size %.0f m %.2f s %.2f quiet %.2f%n", o.id, o.serial, now, o.middleX(), o.middleY(), o.vx(), o.vy(), o.shape.size(), o.moving, o.resting, (now - o.seenUs) * 1e-6);
        objects.remove(i--);
        lost.add(o);
      }
    }
    lost.removeIf(o -> (now - o.seenUs) * 1e-6 > rememberS);
  }

  private boolean isApart(Obj o) {
    for (Obj other : objects) {
      if (other != o && other.id > 0 && other.moving >= 0.5) {
        double e = o.evidence.getOrDefault(other.serial, other.evidence.getOrDefault(o.serial, 0.0));
        if (gapLog(o, other) + e > -keepNat) {
          return false;
        }
      }
    }
    return true;
  }

  private static Row row(long t, int id, double[] h) {
    return new Row(t, id, h[1], h[2], h[3], h[4], h[5], h[6], h[7], h[8], h[9]);
  }

  private void publish(long now) {
    for (Obj o : objects) {
      double[] h = {
        now,
        Math.max(0, Math.min(width - 1, o.middleX())),
        Math.max(0, Math.min(height - 1, o.middleY())),
        o.vx(),
        o.vy(),
        o.shape.major,
        o.shape.minor,
        o.shape.angle,
        o.existence(),
        o.rate
      };
      if (o.id > 0) {
        rows.add(row(now, o.id, h));
      } else {
        o.history.add(h);
      }
    }
  }
}
