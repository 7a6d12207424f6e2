"""Other programs' view of AEDAT-4 files, for Aedat4PeersTest.

peers/aedat4.py check                   exits with 0 if the packages are there
peers/aedat4.py read FILE...            a line per file and program: events and CRC-32 of int64 t,x,y,p rows
peers/aedat4.py readings FILE           a line per program and reading: what, time and values
peers/aedat4.py read-cut FILE...        the same of files that end within a packet
peers/aedat4.py write EVENTS W H FILE   from int64 t,x,y,p rows, one file FILE-<compression>.aedat4 each
"""
import sys
import zlib

import aedat
import dv_processing as dv
import numpy as np


def rows(t, x, y, p):
    table = np.empty((len(t), 4), dtype="<i8")
    table[:, 0], table[:, 1], table[:, 2], table[:, 3] = t, x, y, p
    return table


def by_dv(path):
    reader = dv.io.MonoCameraRecording(path)
    parts = []
    while True:
        batch = reader.getNextEventBatch()
        if batch is None:
            break
        e = batch.numpy()
        parts.append(rows(e["timestamp"], e["x"], e["y"], e["polarity"]))
    return np.concatenate(parts)


def by_aedat(path):
    parts = []
    for packet in aedat.Decoder(path):
        if "events" in packet:
            e = packet["events"]
            parts.append(rows(e["t"], e["x"], e["y"], e["on"]))
    return np.concatenate(parts)


def by_aedat_to_the_cut(path):
    """It gives all whole packets, and then complains of the one that is cut."""
    parts = []
    try:
        for packet in aedat.Decoder(path):
            if "events" in packet:
                e = packet["events"]
                parts.append(rows(e["t"], e["x"], e["y"], e["on"]))
    except RuntimeError as cut:
        if "fill whole buffer" not in str(cut):
            raise
    return np.concatenate(parts)


def read(paths, by_aedat=by_aedat):
    for path in paths:
        for name, reader in (("dv-processing", by_dv), ("aedat", by_aedat)):
            table = reader(path)
            print(name, len(table), "%08x" % zlib.crc32(table.tobytes()))


def readings(path):
    reader = dv.io.MonoCameraRecording(path)
    while (frame := reader.getNextFrame()) is not None:
        picture = np.ascontiguousarray(frame.image)
        length = int(frame.exposure.total_seconds() * 1e6 + 0.5)
        place = (frame.positionX, frame.positionY) + picture.shape[1::-1]
        print("dv-processing frame", frame.timestamp, length, *place, "%08x" % zlib.crc32(picture.tobytes()))
    while (batch := reader.getNextImuBatch()) is not None:
        for i in batch:
            values = (i.accelerometerX, i.accelerometerY, i.accelerometerZ, i.gyroscopeX, i.gyroscopeY, i.gyroscopeZ,
                      i.temperature, i.magnetometerX, i.magnetometerY, i.magnetometerZ)
            print("dv-processing sample", i.timestamp, "%08x" % zlib.crc32(np.array(values, "<f4").tobytes()))
    while (batch := reader.getNextTriggerBatch()) is not None:
        for trigger in batch:
            print("dv-processing trigger", trigger.timestamp, int(trigger.type))
    for packet in aedat.Decoder(path):
        if "frame" in packet:
            f = packet["frame"]
            picture = np.ascontiguousarray(f["pixels"])
            length = f["exposure_end_t"] - f["exposure_begin_t"]
            place = (f["offset_x"], f["offset_y"], f["width"], f["height"])
            print("aedat frame", f["exposure_begin_t"], length, *place, "%08x" % zlib.crc32(picture.tobytes()))
        for i in packet.get("imus", ()):
            values = [i[axis + "_" + c] for axis in ("accelerometer", "gyroscope") for c in "xyz"]
            values += [i["temperature"]] + [i["magnetometer_" + c] for c in "xyz"]
            print("aedat sample", i["t"], "%08x" % zlib.crc32(np.array(values, "<f4").tobytes()))
        for trigger in packet.get("triggers", ()):
            print("aedat trigger", trigger["t"], trigger["source"])


def write(events, width, height, target):
    table = np.fromfile(events, dtype="<i8").reshape(-1, 4)
    for name in ("NONE", "LZ4", "LZ4_HIGH", "ZSTD", "ZSTD_HIGH"):
        config = dv.io.MonoCameraWriter.Config("camera", getattr(dv.CompressionType, name))
        config.addEventStream((width, height))
        writer = dv.io.MonoCameraWriter(target + "-" + name + ".aedat4", config)
        store = dv.EventStore()
        for t, x, y, p in table.tolist():
            store.push_back(t, x, y, bool(p))
        writer.writeEvents(store)
        del writer


if sys.argv[1] == "read":
    read(sys.argv[2:])
elif sys.argv[1] == "readings":
    readings(sys.argv[2])
elif sys.argv[1] == "read-cut":
    read(sys.argv[2:], by_aedat_to_the_cut)
elif sys.argv[1] == "write":
    write(sys.argv[2], int(sys.argv[3]), int(sys.argv[4]), sys.argv[5])
