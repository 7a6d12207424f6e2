"""Other programs' view of our files, for FormatsPeersTest.

peers/formats.py check           exits with 0 if the packages are there
peers/formats.py read FILE...    a line per file and program: events and CRC-32 of int64 t,x,y,p rows
"""
import csv
import sys
import zlib

import event_stream
import evt3
import faery
import numpy as np
from expelliarmus import Wizard


def rows(t, x, y, p):
    table = np.empty((len(t), 4), dtype="<i8")
    table[:, 0], table[:, 1], table[:, 2], table[:, 3] = t, x, y, p
    return table


def by_faery(path):
    text = faery.CsvProperties(
        has_header=True, separator=b",", t_index=0, x_index=1, y_index=2, on_index=3,
        t_scale=0.0, on_value=b"1", off_value=b"0", skip_errors=False)
    if path.endswith(".csv"):
        stream = faery.events_stream_from_file(path, dimensions_fallback=(640, 480), csv_properties=text)
    else:
        stream = faery.events_stream_from_file(path)
    e = stream.to_array()
    # faery counts the rows of an Event Stream from the other side than those who made the format.
    y = stream.dimensions()[1] - 1 - e["y"].astype("i8") if path.endswith(".es") else e["y"]
    return rows(e["t"], e["x"], y, e["on"] if "on" in e.dtype.names else e["p"])


def by_expelliarmus(path):
    encoding = "evt2" if path.endswith(".raw") else "dat"
    e = Wizard(encoding=encoding).read(path)
    return rows(e["t"], e["x"], e["y"], e["p"])


def by_evt3(path):
    e = evt3.decode_file(path)
    return rows(e.t, e.x, e.y, e.p)


def by_event_stream(path):
    with event_stream.Decoder(path) as decoder:
        e = np.concatenate(list(decoder))
    return rows(e["t"], e["x"], e["y"], e["on"])


def by_numpy(path):
    if path.endswith(".csv"):
        return np.loadtxt(path, dtype="<i8", delimiter=",", skiprows=1)
    e = np.load(path)
    return rows(e["t"], e["x"], e["y"], e["p"])


def by_python(path):
    with open(path, newline="") as text:
        table = list(csv.DictReader(text))
    return rows(*([int(row[name]) for row in table] for name in ("t_us", "x", "y", "on")))


READERS = {
    "evt2.raw": (by_faery, by_expelliarmus),
    "evt3.raw": (by_faery, by_evt3),
    "dat": (by_faery, by_expelliarmus),
    "es": (by_faery, by_event_stream),
    "csv": (by_faery, by_numpy, by_python),
    "npz": (by_numpy,),
}

if sys.argv[1] == "read":
    for path in sys.argv[2:]:
        for reader in READERS[path.split(".", 1)[1]]:
            table = reader(path)
            print(path.split("/")[-1], reader.__name__, len(table), "%08x" % zlib.crc32(table.tobytes()))
