"""Makes the files beside it, which FlydraFileTest reads: python make.py SEEN.csv (h5py 3.16, PyTables 3.11).
SEEN.csv: haltere simulate flight x.aedat --duration 0.6 --observations SEEN.csv --set view.cameras=3 --set run.seed=21
--set run.startUs=1600000000000000 --set detection.missingShare=0.1"""
import csv, math, os, sys
import h5py, numpy as np, tables as PT
here = os.path.dirname(os.path.abspath(__file__))
rows = list(csv.DictReader(open(sys.argv[1])))
start = 1600000000000000
FRAME0 = 1000

class Info2D(PT.IsDescription):  # as in Flydra: flydra_core/data_descriptions.py
    camn = PT.UInt16Col(pos=0); frame = PT.Int64Col(pos=1)
    timestamp = PT.FloatCol(pos=2); cam_received_timestamp = PT.FloatCol(pos=3)
    x = PT.Float32Col(pos=4); y = PT.Float32Col(pos=5); area = PT.Float32Col(pos=6); slope = PT.Float32Col(pos=7)
    eccentricity = PT.Float32Col(pos=8); frame_pt_idx = PT.UInt8Col(pos=9); cur_val = PT.UInt8Col(pos=10)
    mean_val = PT.Float32Col(pos=11); sumsqf_val = PT.Float32Col(pos=12)
class CamSyncInfo(PT.IsDescription):
    cam_id = PT.StringCol(256, pos=0); camn = PT.UInt16Col(pos=1); hostname = PT.StringCol(2048, pos=2)
class TextLog(PT.IsDescription):
    mainbrain_timestamp = PT.FloatCol(pos=0); cam_id = PT.StringCol(255, pos=1); message = PT.StringCol(4*1024*1024, pos=2)
class FilteredObservations(PT.IsDescription):  # flydra_kalman_utils.py
    obj_id = PT.UInt32Col(pos=0); frame = PT.Int64Col(pos=1)
    x = PT.Float32Col(pos=2); y = PT.Float32Col(pos=3); z = PT.Float32Col(pos=4); obs_2d_idx = PT.UInt64Col(pos=5)
    hz_line0 = PT.Float32Col(pos=6); hz_line1 = PT.Float32Col(pos=7); hz_line2 = PT.Float32Col(pos=8)
    hz_line3 = PT.Float32Col(pos=9); hz_line4 = PT.Float32Col(pos=10); hz_line5 = PT.Float32Col(pos=11)

seen = {}
for r in rows:
    seen[((int(r['t_us']) - start) // 10000, int(r['camera'][-1]))] = r
frames = sorted({k for k, c in seen})
def slope(r): return math.tan(float(r['angle_rad'])) if r['angle_rad'] else math.nan

with PT.open_file(os.path.join(here, 'flydra.h5'), 'w') as h5:
    packed = PT.Filters(1, complib='zlib')
    d2 = h5.create_table('/', 'data2d_distorted', Info2D, '', packed, chunkshape=(64,))
    ci = h5.create_table('/', 'cam_info', CamSyncInfo, '', packed, chunkshape=(3,))
    h5.create_table('/', 'textlog', TextLog)
    ml = h5.create_table('/', 'ML_estimates', FilteredObservations, '', packed, chunkshape=(16,))
    idxs = h5.create_vlarray('/', 'ML_estimates_2d_idxs', PT.UInt16Atom(), chunkshape=(16,))
    for c in range(3):
        ci.row['cam_id'] = 'camera_%d' % c; ci.row['camn'] = 11 + c; ci.row['hostname'] = 'host'; ci.row.append()
    for k in frames:
        pairs = []
        for c in (2, 0, 1):
            t = start * 1e-6 + 0.01 * k
            def put(x, y, area, s, ecc, pt):
                w = d2.row
                w['camn'] = 11 + c; w['frame'] = FRAME0 + k; w['timestamp'] = math.nan if (k + c) % 3 == 0 else t
                w['cam_received_timestamp'] = t + 0.003 + 0.001 * c
                w['x'] = x; w['y'] = y; w['area'] = area; w['slope'] = s; w['eccentricity'] = ecc; w['frame_pt_idx'] = pt
                w.append()
            r = seen.get((k, c))
            if r is None:
                put(math.nan, math.nan, math.nan, math.nan, math.nan, 0)  # Flydra's row of a frame without a point
                continue
            pt = 0
            if (k + c) % 2:
                put(1, 2, 3, 0.5, 2, 0); pt = 1  # a point of nothing
            put(float(r['x_px']), float(r['y_px']), float(r['area_px']), slope(r), float(r['eccentricity']), pt)
            pairs += [11 + c, pt]
        if len(pairs) >= 4:
            idxs.append(np.array(pairs, np.uint16))
            m = ml.row
            m['obj_id'] = 42; m['frame'] = FRAME0 + k; m['x'] = m['y'] = m['z'] = math.nan; m['obs_2d_idx'] = len(idxs) - 1
            for i in range(6): m['hz_line%d' % i] = math.nan
            m.append()

def lists(name, table, **more):
    """A group with one list per column, cameras by their numbers, and lines by slope and intercept."""
    with h5py.File(os.path.join(here, name), 'w', libver='latest') as h5:
        for key, value in table.items(): h5.create_dataset('data2d_distorted/' + key, data=value, **more)
one = sorted(rows, key=lambda r: (int(r['t_us']), r['camera']))
def column(f, t=float): return np.array([f(r) for r in one], t)
x = column(lambda r: float(r['x_px'])); y = column(lambda r: float(r['y_px'])); m = column(slope)
table = dict(camn=column(lambda r: int(r['camera'][-1]), np.int32), frame=column(lambda r: (int(r['t_us']) - start) // 10000, np.int64),
             timestamp=column(lambda r: int(r['t_us']) * 1e-6), x=x, slope=m, intercept=y - m * x)
lists('lists.h5', table, compression='gzip')
lists('text-slope.h5', dict(table, slope=np.array(['steep'] * len(one), 'S8')), compression='gzip')
