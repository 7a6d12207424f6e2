"""Other programs' view of HDF5 files, for Hdf5PeersTest.

peers/hdf5.py check                    exits with 0 if the packages are there
peers/hdf5.py read FILE...             a line per file and program: events and CRC-32 of int64 t,x,y,p rows
peers/hdf5.py index FILE               exits with 0 if ms_to_idx is what DSEC says it is
peers/hdf5.py write EVENTS W H FOLDER  from int64 t,x,y,p rows, a file for each way in which h5py stores them
"""
import os
import sys
import zlib

import h5py
import hdf5plugin
import numpy as np
from evutils.io import EventReader


def rows(t, x, y, p):
    table = np.empty((len(t), 4), dtype="<i8")
    table[:, 0], table[:, 1], table[:, 2], table[:, 3] = t, x, y, p
    return table


def by_h5py(path):
    with h5py.File(path) as file:
        e = file["events"]
        return rows(e["t"][:] + file["t_offset"][()], e["x"][:], e["y"][:], e["p"][:])


def by_evutils(path):
    parts = []
    with EventReader(path, n_events=100_000) as reader:
        for batch in reader:
            e = batch[0] if isinstance(batch, tuple) else batch
            parts.append(rows(e["t"], e["x"], e["y"], e["p"]))
    return np.concatenate(parts)


def read(paths):
    for path in paths:
        for name, reader in (("h5py", by_h5py), ("evutils", by_evutils)):
            table = reader(path)
            print(name, len(table), "%08x" % zlib.crc32(table.tobytes()))


def index(path):
    with h5py.File(path) as file:
        t, index = file["events/t"][:], file["ms_to_idx"][:]
    wanted = np.searchsorted(t, np.arange(len(index)) * 1000)
    sys.exit(0 if np.array_equal(index, wanted) and index[-1] == len(t) else 1)


def write(events, width, height, folder):
    table = np.fromfile(events, dtype="<i8").reshape(-1, 4)
    t, x, y, p = table[:, 0], table[:, 1].astype("u2"), table[:, 2].astype("u2"), table[:, 3].astype("u1")
    count = len(t)

    def columns(name, chunks=None, growing=False, libver="earliest", times=t, signs=p, **packing):
        with h5py.File(os.path.join(folder, name + ".h5"), "w", libver=libver) as file:
            file.attrs["width"], file.attrs["height"] = width, height
            for key, values in dict(t=times, x=x, y=y, p=signs).items():
                file.create_dataset(
                    "events/" + key, data=values, chunks=chunks, maxshape=(None,) if growing else None, **packing
                )

    for libver in ("earliest", "v108", "latest"):
        columns("run-" + libver, libver=libver)
        columns("one-chunk-" + libver, (count,), libver=libver, compression="gzip")
        columns("fixed-" + libver, (1000,), libver=libver, compression="gzip", shuffle=True, fletcher32=True)
        columns("many-fixed-" + libver, (7,), libver=libver)
        columns("growing-" + libver, (1000,), True, libver=libver, compression="lzf")
        columns("many-growing-" + libver, (3,), True, libver=libver)
    for method in ("blosclz", "lz4", "lz4hc", "zlib", "zstd"):
        for shuffle in (0, 1, 2):
            packing = hdf5plugin.Blosc(cname=method, clevel=5, shuffle=shuffle)
            columns(f"blosc-{method}-{shuffle}", (10_000 + shuffle % 2,), **packing)
    columns("zstd", (1000,), **hdf5plugin.Zstd())
    columns("lz4", (9000,), **hdf5plugin.LZ4(nbytes=4096))
    columns("odd-types", (1000,), times=t.astype(">i8"), signs=p.astype(bool))
    elements = np.zeros(count, dtype=[("x", "<u2"), ("y", "<u2"), ("p", "<i2"), ("t", "<i8")])
    elements["t"], elements["x"], elements["y"], elements["p"] = t, x, y, p
    with h5py.File(os.path.join(folder, "elements.h5"), "w") as file:
        file.create_dataset("CD/events", data=elements, chunks=(1000,), compression="gzip")
        file.attrs["geometry"] = f"{width}x{height}"


if sys.argv[1] == "read":
    read(sys.argv[2:])
elif sys.argv[1] == "index":
    index(sys.argv[2])
elif sys.argv[1] == "write":
    write(sys.argv[2], int(sys.argv[3]), int(sys.argv[4]), sys.argv[5])
