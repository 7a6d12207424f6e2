"""Other programs' side of the comparison: one program, one file, some runs.

tools.py read PROGRAM FORMAT FILE RUNS    a line "run EVENTS SECONDS" for each, then "peak KIB"
tools.py write PROGRAM FORMAT FROM TO RUNS   the events of FROM (.npz of ours) from memory
tools.py make PROGRAM FROM TO             an input that the program is the one to write

Each program is used in the fastest way that its documentation names. FORMAT is that of compare.py.
"""
import os
import resource
import sys
import time


def faery_read(kind, path):
    import faery

    return sum(len(events) for events in faery.events_stream_from_file(path))


def evutils_read(kind, path):
    from evutils.io import EventReader

    # Windows of 10 ms are the fastest for its native decoders of raw files, where the clock does not go back.
    cut = {"delta_t": 10_000} if kind in ("evt2", "evt3-dense", "evt3-sparse") else {"n_events": 1_000_000}
    count = 0
    with EventReader(path, max_time=10**15, **cut) as reader:
        for batch in reader:
            count += len(batch[0] if isinstance(batch, tuple) else batch)
    return count


def expelliarmus_read(kind, path):
    from expelliarmus import Wizard

    return len(Wizard(encoding=kind.split("-")[0]).read(path))


def evt3_read(kind, path):
    import evt3

    events = evt3.decode_file(path)
    return len(events)


def eventstream_read(kind, path):
    import event_stream

    with event_stream.Decoder(path) as decoder:
        return sum(len(packet) for packet in decoder)


def aedat_read(kind, path):
    import aedat

    return sum(len(packet["events"]) for packet in aedat.Decoder(path) if "events" in packet)


def dv_read(kind, path, arrays=True):
    import dv_processing as dv

    reader = dv.io.MonoCameraRecording(path)
    count = 0
    while True:
        batch = reader.getNextEventBatch()
        if batch is None:
            return count
        count += len(batch.numpy()) if arrays else batch.size()


def eventcv_read(kind, path):
    import eventcv

    return len(eventcv.load(path))


def tonic_read(kind, path):
    import tonic.io

    if kind == "nmnist":
        return len(tonic.io.read_mnist_file(path, dtype=tonic.datasets.NMNIST.dtype))
    # What read_dvs_128 does, which fails on what its own first step returns.
    version, start = tonic.io.read_aedat_header_from_file(path)[:2]
    events = tonic.io.get_aer_events_from_file(path, version, start)
    address = events["address"]
    x, y, p = address >> 8 & 127, address >> 1 & 127, address & 1
    return len(tonic.io.make_structured_array(x, y, events["timeStamp"], p))


READ = {
    "faery": faery_read,
    "evutils": evutils_read,
    "expelliarmus": expelliarmus_read,
    "evt3": evt3_read,
    "event-stream": eventstream_read,
    "aedat": aedat_read,
    "dv-processing": dv_read,
    "dv-stores": lambda kind, path: dv_read(kind, path, arrays=False),
    "eventcv": eventcv_read,
    "tonic": tonic_read,
}


def load(path):
    import numpy as np

    arrays = np.load(path)
    return arrays["t"], arrays["x"], arrays["y"], arrays["p"], int(arrays["width"]), int(arrays["height"])


def dv_write(kind, events, path):
    import dv_processing as dv
    import numpy as np

    t, x, y, p, width, height = events
    compression = getattr(dv.CompressionType, kind.split("-")[1].upper())
    stores = []
    for start in range(0, len(t), 8192):
        part = slice(start, start + 8192)
        store = dv.EventStore()
        for row in zip(t[part].tolist(), x[part].tolist(), y[part].tolist(), p[part].tolist()):
            store.push_back(row[0], row[1], row[2], bool(row[3]))
        stores.append(store)

    def run():
        config = dv.io.MonoCameraWriter.Config("camera", compression)
        config.addEventStream((width, height))
        writer = dv.io.MonoCameraWriter(path, config)
        for store in stores:
            writer.writeEvents(store)
        del writer

    return run


def evutils_write(kind, events, path):
    from evutils.io import EventWriter
    from evutils.types import EventArray

    t, x, y, p, width, height = events
    array = EventArray(t, x, y, p)

    def run():
        with EventWriter(path, width=width, height=height) as writer:
            for start in range(0, len(array), 1_000_000):
                writer.write(array[start : start + 1_000_000])

    return run


def faery_write(kind, events, path):
    import faery
    import numpy as np

    t, x, y, p, width, height = events
    array = np.empty(len(t), dtype=faery.EVENTS_DTYPE)
    array["t"], array["x"], array["y"], array["on"] = t - t[0], x, y, p
    options = {}
    if kind.startswith("aedat4"):
        name = kind.split("-")[1]
        options["compression"] = None if name == "none" else (name, 1)
    if kind in ("evt2", "evt3"):
        options["version"] = kind

    def run():
        faery.events_stream_from_array(array, (width, height)).to_file(path, **options)

    return run


def eventstream_write(kind, events, path):
    import event_stream
    import numpy as np

    t, x, y, p, width, height = events
    array = np.empty(len(t), dtype=event_stream.dvs_dtype)
    array["t"], array["x"], array["y"], array["on"] = t - t[0], x, y, p

    def run():
        with event_stream.Encoder(path, "dvs", width, height) as encoder:
            for start in range(0, len(array), 100_000):
                encoder.write(array[start : start + 100_000])

    return run


def eventcv_write(kind, events, path):
    import eventcv
    import numpy as np

    t, x, y, p, width, height = events
    table = np.stack([x.astype("i8"), y.astype("i8"), t, p.astype("i8")], axis=1)
    stream = eventcv.from_numpy(table, sensor_size=(width, height), time_unit="us")
    # A .raw file is EVT2 unless it is told otherwise.
    encoding = kind if kind in ("evt2", "evt3") else None
    return lambda: eventcv.save(stream, path, format=encoding)


WRITE = {
    "dv-processing": dv_write,
    "evutils": evutils_write,
    "faery": faery_write,
    "event-stream": eventstream_write,
    "eventcv": eventcv_write,
}


def timed(run, runs, count=None):
    for _ in range(runs):
        start = time.perf_counter()
        events = run()
        seconds = time.perf_counter() - start
        print("run", count if events is None else events, "%.6f" % seconds, flush=True)


def main():
    command, program, kind = sys.argv[1:4]
    if command == "read":
        path = sys.argv[4]
        timed(lambda: READ[program](kind, path), int(sys.argv[5]))
    elif command == "write":
        events = load(sys.argv[4])
        run = WRITE[program](kind, events, sys.argv[5])

        def fresh():
            if os.path.exists(sys.argv[5]):
                os.remove(sys.argv[5])
            run()

        timed(fresh, int(sys.argv[6]), len(events[0]))
    elif command == "make":
        WRITE[program](os.path.splitext(sys.argv[4])[1], load(kind), sys.argv[4])()
    print("peak", resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)


if __name__ == "__main__":
    main()
