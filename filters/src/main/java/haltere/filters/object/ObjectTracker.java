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
  final double joinNow = p("joinnow", 3);
  final double partS = p("parts", 0.5);
  final int apartTimes = (int) p("apart", 3);
  final double gapMax = p("gapmax", 0);
  final double gapRate = p("gaprate", 0);
  final double cauchy = p("cauchy", 2);
  final double fuseNat = p("fuse", -1);
  final double turn = p("turn", 1);
  final double limboS = p("limbo", 1);
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
  private final List<Group> groups = new ArrayList<>();
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
      if (groups.isEmpty() && t > tickStartUs + 1_000_000) {
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
    Group best = null;
    double bestLog = 0;
    for (Group g : groups) {
      if (g.id == 0) {
        continue;
      }
      g.box();
      double quiet = g.isMoving() ? 0 : (now - g.seenUs) * 1e-6;
      double size = Math.max(g.size(), o.shape.size());
      double sd = size * (0.5 + Math.min(quiet, 1)) * 0.5;
      double dx = gap(o.middleX() - 0.5 * (g.lowX + g.highX), o.shape.halfX + 0.5 * (g.highX - g.lowX));
      double dy = gap(o.middleY() - 0.5 * (g.lowY + g.highY), o.shape.halfY + 0.5 * (g.highY - g.lowY));
      double log =
          returns
              + Math.log(width * (double) height / (2 * Math.PI * sd * sd + size * size))
              - (dx * dx + dy * dy) / (2 * sd * sd);
      if (log > bestLog) {
        bestLog = log;
        best = g;
      }
    }
    objects.add(o);
    if (best == null || best.isMoving()) {
      Group g = new Group();
      g.bornUs = now;
      g.seenUs = now;
      g.parts.add(o);
      o.group = g;
      groups.add(g);
      return;
    }
    if (DEBUG) System.out.printf("t %d resume %d by (%d) at %.0f,%.0f log %.1f%n", now, best.id, o.serial, o.middleX(), o.middleY(), bestLog);
    // the whole group goes on, moved to where this part is within it
    double dx = o.middleX() - 0.5 * (best.lowX + best.highX);
    double dy = o.middleY() - 0.5 * (best.lowY + best.highY);
    double shiftX = Math.signum(dx) * gap(dx, Math.max(0, 0.5 * (best.highX - best.lowX) - o.shape.halfX));
    double shiftY = Math.signum(dy) * gap(dy, Math.max(0, 0.5 * (best.highY - best.lowY) - o.shape.halfY));
    Obj nearest = null;
    double least = Double.POSITIVE_INFINITY;
    for (Obj p : best.parts) {
      p.s.setMean(0, p.x() + shiftX);
      p.s.setMean(2, p.y() + shiftY);
      p.walkedX += shiftX;
      p.walkedY += shiftY;
      double d =
          Math.hypot(
              gap(p.middleX() - o.middleX(), p.shape.halfX + o.shape.halfX),
              gap(p.middleY() - o.middleY(), p.shape.halfY + o.shape.halfY));
      if (d < least) {
        least = d;
        nearest = p;
      }
      if (best.lost) {
        objects.add(p);
      }
      p.resting = 0.5;
      p.moving = 0.4;
      p.gone = 0.1;
    }
    best.lost = false;
    best.seenUs = now;
    if (nearest != null && least < 3) {
      double r = nearest.rate;
      fuse(nearest, o);
      nearest.rate = Math.max(o.rate, 0.5 * r);
      nearest.s.setMean(1, o.vx());
      nearest.s.setMean(3, o.vy());
      nearest.s.covariance().setTo(o.s.covariance());
      nearest.moving = 0.9;
      nearest.resting = 0.05;
      nearest.gone = 0.05;
      nearest.seenUs = now;
      objects.remove(o);
    } else {
      best.parts.add(o);
      o.group = best;
    }
  }

  private static double gap(double d, double reach) {
    return Math.max(0, Math.abs(d) - reach);
  }

  // ---- relations

  private double[][] prior = new double[0][];
  private double[][] motion = new double[0][];

  private void relate() {
    int ticks = (int) Math.round(decideS / DT);
    double fade = Math.exp(-DT / evidenceS);
    int n = objects.size();
    if (prior.length < n) {
      prior = new double[2 * n][2 * n];
      motion = new double[2 * n][2 * n];
    }
    for (int i = 0; i < n; i++) {
      objects.get(i).index = i;
    }
    for (int i = 0; i < n; i++) {
      Obj a = objects.get(i);
      for (int j = i + 1; j < n; j++) {
        Obj b = objects.get(j);
        double gapLog = gapLog(a, b);
        prior[i][j] = gapLog;
        prior[j][i] = gapLog;
        Obj first = a.serial < b.serial ? a : b;
        Obj second = first == a ? b : a;
        double e = first.evidence.getOrDefault(second.serial, 0.0);
        if (gapLog < -20) {
          first.evidence.remove(second.serial);
          e = 0;
        } else if (a.moving >= 0.5 && b.moving >= 0.5) {
          e *= fade;
          int m = Math.min(ticks, Math.min(a.age, b.age) - 1);
          if (m > ticks / 3) {
            e += motionLog(a, b, m) * DT / decideS;
          }
          e += gapRate * DT * Math.min(0, gapLog);
          first.evidence.put(second.serial, e);
        }
        motion[i][j] = e;
        motion[j][i] = e;
      }
    }
    splitGroups();
    joinGroups(ticks);
    fuseParts(ticks);
  }

  /** Log odds that two sets of parts are one object. */
  private double score(List<Obj> a, List<Obj> b) {
    double gap = -99;
    double sum = 0;
    double weights = 1e-9;
    for (Obj o : a) {
      for (Obj u : b) {
        if (o == u) {
          continue;
        }
        gap = Math.max(gap, prior[o.index][u.index]);
        double w = o.rate * u.rate * o.moving * u.moving;
        sum += w * motion[o.index][u.index];
        weights += w;
      }
    }
    return gap + sum / weights;
  }

  private void splitGroups() {
    for (int k = groups.size() - 1; k >= 0; k--) {
      Group g = groups.get(k);
      if (g.lost || g.parts.size() < 2) {
        continue;
      }
      List<Obj> byRate = new ArrayList<>(g.parts);
      byRate.sort((a, b) -> Double.compare(a.rate, b.rate));
      for (Obj o : byRate) {
        if (o.moving < 0.5 || g.parts.size() < 2) {
          continue;
        }
        List<Obj> rest = new ArrayList<>();
        for (Obj u : g.parts) {
          if (u != o && u.moving >= 0.5) {
            rest.add(u);
          }
        }
        if (!rest.isEmpty() && score(List.of(o), rest) < -keepNat) {
          if (DEBUG) System.out.printf("t %d split (%d) from %d at %.0f,%.0f score %.1f%n", tickStartUs, o.serial, g.id, o.middleX(), o.middleY(), score(List.of(o), rest));
          g.parts.remove(o);
          Group n = new Group();
          n.bornUs = o.bornUs;
          n.seenUs = g.seenUs;
          n.parts.add(o);
          o.group = n;
          groups.add(n);
        }
      }
    }
  }

  private void joinGroups(int ticks) {
    for (int i = 0; i < groups.size(); i++) {
      Group a = groups.get(i);
      if (a.lost || !a.isMoving() || a.novelty() < joinNovel) {
        continue;
      }
      for (int j = i + 1; j < groups.size(); j++) {
        Group b = groups.get(j);
        if (b.lost || !b.isMoving() || b.novelty() < joinNovel) {
          continue;
        }
        int age = Math.min(age(a), age(b));
        if (age < ticks / 3) {
          continue;
        }
        double total = score(a.parts, b.parts);
        boolean both = a.id > 0 && b.id > 0;
        if (total > (both ? keepNat : age > limboS / DT ? joinAt : joinNow)) {
          Group into = a.id == 0 && b.id > 0 || b.id > 0 && b.id < a.id ? b : a;
          Group from = into == a ? b : a;
          if (DEBUG) System.out.printf("t %d join %d and %d at %.0f,%.0f %.0f,%.0f total %.1f%n", tickStartUs, into.id, from.id, into.parts.get(0).middleX(), into.parts.get(0).middleY(), from.parts.get(0).middleX(), from.parts.get(0).middleY(), total);
          for (Obj o : from.parts) {
            o.group = into;
          }
          into.parts.addAll(from.parts);
          into.bornUs = Math.min(into.bornUs, from.bornUs);
          groups.remove(from);
          if (from == a) {
            i--;
            break;
          }
          j--;
        }
      }
    }
  }

  private static int age(Group g) {
    int age = 0;
    for (Obj o : g.parts) {
      age = Math.max(age, o.age);
    }
    return age;
  }

  /** Parts of one object that touch and go together are one part. */
  private void fuseParts(int ticks) {
    for (Group g : groups) {
      if (g.lost) {
        continue;
      }
      for (int i = 0; i < g.parts.size(); i++) {
        Obj a = g.parts.get(i);
        for (int j = i + 1; j < g.parts.size(); j++) {
          Obj b = g.parts.get(j);
          if (prior[a.index][b.index] >= odds && motion[a.index][b.index] > fuseNat) {
            Obj into = a.rate * a.age >= b.rate * b.age ? a : b;
            Obj from = into == a ? b : a;
            fuse(into, from);
            g.parts.remove(from);
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
  }

  private double gapLog(Obj a, Obj b) {
    double box =
        Math.hypot(
            gap(a.middleX() - b.middleX(), a.shape.halfX + b.shape.halfX),
            gap(a.middleY() - b.middleY(), a.shape.halfY + b.shape.halfY));
    double size =
        gapMax > 0
            ? Math.max(a.shape.size(), b.shape.size())
            : Math.sqrt(a.shape.size() * b.shape.size());
    double prior = gapLog(box, size);
    return box > 8 * size + 50 ? -99 : prior < -20 ? prior : gapLog(a.shape.distance(b.shape, b.x() - a.x(), b.y() - a.y()), size);
  }

  private double gapLog(double distance, double size) {
    double g = Math.max(0, distance - 3) / (kappa * size);
    return cauchy > 0 ? odds - cauchy * 0.5 * Math.log1p(g * g) : odds - g;
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
        b.middleX() - a.middleX(),
        b.middleY() - a.middleY(),
        n * DT,
        maxSize > 0
            ? Math.max(a.shape.size(), b.shape.size())
            : Math.sqrt(a.shape.size() * b.shape.size()));
  }

  /** Log ratio of a slip under one motion and under two, with the covariance of its measurement. */
  private double motionLog(
      double ax,
      double ay,
      double bx,
      double by,
      double xx,
      double xy,
      double yy,
      double lineX,
      double lineY,
      double seconds,
      double size) {
    double bend = rho * rho * size * size + 2;
    double apart = 0.5 * (ax * ax + ay * ay + bx * bx + by * by);
    double dx = ax - bx;
    double dy = ay - by;
    double turned = turn * turn * seconds * seconds;
    // a turn moves parts across the line between them
    double oneXx = xx + bend + turned * lineY * lineY;
    double oneYy = yy + bend + turned * lineX * lineX;
    double oneXy = xy - turned * lineX * lineY;
    double oneDet = oneXx * oneYy - oneXy * oneXy;
    double twoXx = oneXx + apart;
    double twoYy = oneYy + apart;
    double twoDet = twoXx * twoYy - oneXy * oneXy;
    double one = (oneYy * dx * dx - 2 * oneXy * dx * dy + oneXx * dy * dy) / oneDet;
    double two = (twoYy * dx * dx - 2 * oneXy * dx * dy + twoXx * dy * dy) / twoDet;
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
    if (DEBUG && System.getProperty("map") != null && o.serial == 1 && tick % 20 == 0) {
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
    if (DEBUG && found.size() != 1) System.out.println("found " + found.size() + " in " + o.serial + " labels " + labels + " size " + t.size() + " cell " + t.cellPx + " total " + t.solidTotal);
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
    List<Component> all = o.components.stream().filter(c -> c.seen).toList();
    if (all.size() < 2) {
      return;
    }
    Component first = all.get(0);
    for (Component c : all) {
      first = c.mass > first.mass ? c : first;
    }
    for (Component c : all) {
      if (c != first && c.age >= apartTimes && first.age >= apartTimes) {
        leave(o, all, c, now);
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

  private void leave(Obj o, List<Component> all, Component c, long now) {
    Obj n = new Obj();
    n.s.set(o.s);
    n.shape.clear(o.shape.cellPx);
    for (int k = 0; k < ShapeTemplate.CELLS; k++) {
      if (nearestLabel(o, all, k) == c.label) {
        n.shape.add(k, o.shape.mass[k]);
        o.shape.total -= o.shape.mass[k];
        o.shape.mass[k] = 0;
      }
    }
    int m = Math.min(6, c.age - 1);
    if (m > 1) {
      double s = m * EVERY * DT;
      n.s.setMean(1, n.vx() + (c.displacementX(m) - o.displacementX(m * EVERY)) / s);
      n.s.setMean(3, n.vy() + (c.displacementY(m) - o.displacementY(m * EVERY)) / s);
    }
    o.components.remove(c);
    for (Obj u : objects) {
      if (u != o) {
        Obj first = u.serial < o.serial ? u : o;
        double e = first.evidence.getOrDefault(first == u ? o.serial : u.serial, 0.0);
        u.evidence.put(n.serial, e);
      }
    }
    n.group = o.group;
    o.group.parts.add(n);
    double share = n.shape.total / (n.shape.total + o.shape.total);
    n.rate = o.rate * share;
    o.rate *= 1 - share;
    n.events = o.events * share;
    n.novelty = o.novelty * share;
    n.farthest = o.farthest;
    n.bornUs = o.bornUs;
    n.bornTick = tick;
    n.seenUs = now;
    n.moving = o.moving;
    n.resting = o.resting;
    n.gone = o.gone;
    n.shape.refresh();
    o.shape.refresh();
    recentre(n);
    recentre(o);
    n.shape.refresh();
    o.shape.refresh();
    objects.add(n);
  }

  private void fuse(Obj into, Obj from) {
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
    into.novelty += from.novelty;
    if (from.moving > into.moving) {
      into.moving = from.moving;
      into.resting = from.resting;
      into.gone = from.gone;
    }
    into.seenUs = Math.max(into.seenUs, from.seenUs);
    into.bornUs = Math.min(into.bornUs, from.bornUs);
    into.shape.refresh();
    recentre(into);
    into.shape.refresh();
  }

  // ---- life

  private void live(long now) {
    for (int k = 0; k < groups.size(); k++) {
      Group g = groups.get(k);
      if (g.lost) {
        if ((now - g.seenUs) * 1e-6 > rememberS) {
          groups.remove(k--);
        }
        continue;
      }
      boolean moving = g.isMoving();
      if (moving) {
        g.seenUs = now;
        double vx = g.vx();
        double vy = g.vy();
        for (int i = g.parts.size() - 1; i >= 0; i--) {
          Obj o = g.parts.get(i);
          if (o.moving < 0.5) {
            // it goes along with the others
            o.s.setMean(1, vx);
            o.s.setMean(3, vy);
            if ((now - o.seenUs) * 1e-6 > partS || o.gone > 0.5) {
              g.parts.remove(i);
              objects.remove(o);
            }
          }
        }
      }
      if (g.id == 0) {
        if (!moving) {
          groups.remove(k--);
          objects.removeAll(g.parts);
          continue;
        }
        boolean old = now - g.bornUs >= decideS * 1e6 && g.events() >= 40;
        if (old && g.novelty() > novel && isApart(g)) {
          g.id = ++ids;
          for (double[] h : g.history) {
            rows.add(row((long) h[0], g.id, h));
          }
          g.history.clear();
          if (DEBUG) System.out.printf("show %d t %d parts %d at %.0f,%.0f novelty %.1f events %.0f%n", g.id, now, g.parts.size(), g.parts.get(0).middleX(), g.parts.get(0).middleY(), g.novelty(), g.events());
          if (DEBUG) {
            for (Group other : groups) {
              if (other != g && other.id > 0 && !other.lost && other.isMoving()) {
                Obj a = g.parts.get(0);
                Obj b = other.parts.get(0);
                int m = Math.min(30, Math.min(a.age, b.age) - 1);
                System.out.printf("   against %d prior %.1f motion %.1f u %.1f,%.1f and %.1f,%.1f sd %.1f %.1f sizes %.0f %.0f ages %d %d%n", other.id, prior[a.index][b.index], motion[a.index][b.index], a.displacementX(m), a.displacementY(m), b.displacementX(m), b.displacementY(m), a.s.sd(1) * m * DT, a.s.sd(3) * m * DT, a.shape.size(), b.shape.size(), a.age, b.age);
              }
            }
          }
        }
      } else if (g.existence() < 0.5) {
        if (DEBUG) System.out.printf("lose %d t %d at %.0f,%.0f%n", g.id, now, g.parts.get(0).middleX(), g.parts.get(0).middleY());
        g.lost = true;
        objects.removeAll(g.parts);
      }
    }
  }

  private boolean isApart(Group g) {
    for (Group other : groups) {
      if (other != g && other.id > 0 && !other.lost && other.isMoving() && scoreIndexed(g, other) > ((tickStartUs - g.bornUs) * 1e-6 > limboS ? joinAt : -keepNat)) {
        return false;
      }
    }
    return true;
  }

  private double scoreIndexed(Group a, Group b) {
    return score(a.parts, b.parts);
  }

  private static Row row(long t, int id, double[] h) {
    return new Row(t, id, h[1], h[2], h[3], h[4], h[5], h[6], h[7], h[8], h[9]);
  }

  private void publish(long now) {
    for (Group g : groups) {
      if (g.lost || g.parts.isEmpty()) {
        continue;
      }
      g.box();
      Obj main = g.parts.get(0);
      double major = main.shape.major;
      double minor = main.shape.minor;
      double angle = main.shape.angle;
      if (g.parts.size() > 1) {
        double hx = 0.5 * (g.highX - g.lowX);
        double hy = 0.5 * (g.highY - g.lowY);
        major = Math.max(hx, hy);
        minor = Math.min(hx, hy);
        angle = hx >= hy ? 0 : Math.PI / 2;
      }
      double[] h = {
        now,
        Math.max(0, Math.min(width - 1, 0.5 * (g.lowX + g.highX))),
        Math.max(0, Math.min(height - 1, 0.5 * (g.lowY + g.highY))),
        g.vx(),
        g.vy(),
        major,
        minor,
        angle,
        g.existence(),
        g.weight()
      };
      if (g.id > 0) {
        rows.add(row(now, g.id, h));
      } else {
        g.history.add(h);
      }
    }
  }
}
