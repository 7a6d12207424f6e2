#!/usr/bin/env python3
"""Turns the results of `haltere batch` into NWB files.

Usage:
    batch_to_nwb.py BATCH OUT [--recordings FOLDER] [--haltere PROGRAM] [--session-start ISO-TIME] [--overwrite]

BATCH is the results folder of `haltere batch --out`, with tables in CSV or Parquet. One NWB file for each recording is
written to OUT; existing ones are refused unless --overwrite is given. Requires pynwb 4, and pyarrow for tables in
Parquet.

Content of a file:
- Each table is a processing module named after its stage and outlet. Each numeric column is a TimeSeries with its
  unit, one for each object, edge, side or lane that the table has: `left-leading angle_rad`.
- With --recordings (the input folder of the batch), the camera's events are an EventsTable `camera_events` with the
  columns timestamp, x, y and on; `haltere convert` reads them.
- Chain, program, source checksum and the offset of the clock are in the file's notes.

Times in NWB count from the start of the session, which is the first time in the results (or events) of a recording. Its
date is --session-start; by default that of the recording's clock if it counts from 1970, else the modification time of
the recording.

pynwb's validator checks each file; the exit status is 1 if one is invalid.
"""

import argparse
import csv
import datetime
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy
import pynwb
from pynwb.event import EventsTable

TIMES = ("t_us", "time_us")
KEYS = ("id", "edge", "side", "lane", "object", "camera")
UNITS = (  # by the ending of a column name, the longest first
    ("_rad2_per_s2", "radians^2/second^2"), ("_rad2_per_s", "radians^2/second"), ("_rad2", "radians^2"),
    ("_rad_s", "radians/second"), ("_rad", "radians"), ("_px_s", "pixels/second"), ("_px", "pixels"),
    ("_m_s", "meters/second"), ("_km_h", "kilometers/hour"), ("_m", "meters"), ("_hz", "hertz"),
    ("_us", "microseconds"), ("_deg_s", "degrees/second"), ("_g", "g"), ("_c", "degrees Celsius"), ("_s", "seconds"),
)
YEAR_2001_US = 978_307_200_000_000


def read_table(path):
    """Columns of a table by name, in order: numbers as float64 with NaN for empty fields, times as int64, texts."""
    if path.suffix == ".parquet":
        import pyarrow.parquet

        columns = pyarrow.parquet.read_table(path).to_pydict()
    else:
        with open(path, newline="", encoding="utf-8") as file:
            rows = list(csv.reader(file))
        columns = {name: [row[i] for row in rows[1:]] for i, name in enumerate(rows[0])}
    return {name: column(name, values) for name, values in columns.items()}


def column(name, values):
    if name in TIMES:
        return numpy.array([int(value) for value in values], dtype=numpy.int64)
    try:
        return numpy.array([numpy.nan if value in ("", None) else float(value) for value in values])
    except ValueError:
        if set(values) <= {"true", "false"}:
            return numpy.array([float(value == "true") for value in values])
        return numpy.array([str(value) for value in values], dtype=object)


def unit(name):
    return next((unit for ending, unit in UNITS if name.endswith(ending)), "1")


def groups(columns):
    """Names and row indices of each key, such as an edge of a wing."""
    key = next((name for name in KEYS if name in columns), None)
    if key is None:
        return [("", slice(None))]
    values = columns[key]
    label = (lambda value: f"{value:g}") if values.dtype.kind == "f" else str
    return [(f"{key} {label(value)} " if values.dtype.kind == "f" else f"{value} ", numpy.flatnonzero(values == value))
            for value in dict.fromkeys(values)]


def add_table(nwb, path, columns, offset_us):
    time = next(name for name in TIMES if name in columns)
    name = path.name.rsplit(".", 1)[0]
    module = nwb.create_processing_module(name=name, description=f"Table {path.name} of haltere batch.")
    for label, rows in groups(columns):
        seconds = (columns[time][rows] - offset_us) * 1e-6
        for column_name, values in columns.items():
            if column_name == time or column_name in KEYS or values.dtype.kind != "f":
                continue
            module.add(pynwb.TimeSeries(
                name=f"{label}{column_name}", data=values[rows], timestamps=seconds, unit=unit(column_name),
                description=f"Column {column_name} of {path.name}."))


def read_events(recording, haltere):
    with tempfile.TemporaryDirectory() as folder:
        npz = pathlib.Path(folder, "events.npz")
        subprocess.run([haltere, "convert", str(recording), str(npz), "--quiet"], check=True)
        with numpy.load(npz) as events:
            return {name: events[name] for name in ("t", "x", "y", "p")}


def add_events(nwb, events, offset_us):
    table = EventsTable(
        name="camera_events", description="Events of the event camera.",
        source_description="Event camera, read by haltere convert.",
        columns=[
            pynwb.event.TimestampVectorData(
                name="timestamp", description="Time of the event.",
                data=(events["t"].astype(numpy.int64) - offset_us) * 1e-6, resolution=1e-6),
            pynwb.core.VectorData(name="x", description="Column of the pixel.", data=events["x"]),
            pynwb.core.VectorData(name="y", description="Row of the pixel, as the recording counts.", data=events["y"]),
            pynwb.core.VectorData(
                name="on", description="True if the light at the pixel rose.", data=events["p"].astype(bool)),
        ])
    nwb.add_events_table(table)


def session_start(given, offset_us, done):
    if given is not None:
        return given
    if offset_us > YEAR_2001_US:
        return datetime.datetime.fromtimestamp(offset_us * 1e-6, datetime.timezone.utc)
    changed = done["recordingChanged"][:19]  # whole seconds
    return datetime.datetime.fromisoformat(changed).replace(tzinfo=datetime.timezone.utc)


def convert(folder, out, recordings, haltere, given_start):
    """Writes the NWB file of one recording."""
    done = json.loads((folder / "done.json").read_text(encoding="utf-8"))
    tables = [(folder / output["file"], read_table(folder / output["file"])) for output in done["outputs"]]
    tables = [(path, columns) for path, columns in tables if any(len(columns.get(name, ())) for name in TIMES)]
    events = None if recordings is None else read_events(recordings / done["recording"], haltere)
    times = [columns[name] for _, columns in tables for name in TIMES if name in columns]
    if events is not None:
        times.append(events["t"])
    offset_us = min((int(values.min()) for values in times if len(values)), default=0)
    nwb = pynwb.NWBFile(
        session_description=f"Recording {done['recording']} of an event camera ({done['sensor']} pixels).",
        identifier=done["key"],
        session_start_time=session_start(given_start, offset_us, done),
        notes=json.dumps({
            "program": done["program"], "chain": done["chain"], "recording": done["recording"],
            "recordingSha256": done["recordingSha256"], "clockOffsetUs": offset_us, "warnings": done["warnings"]}),
    )
    for path, columns in tables:
        add_table(nwb, path, columns, offset_us)
    if events is not None:
        add_events(nwb, events, offset_us)
    out.parent.mkdir(parents=True, exist_ok=True)
    with pynwb.NWBHDF5IO(str(out), "w") as io:
        io.write(nwb)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("batch", type=pathlib.Path, help="results folder of haltere batch")
    parser.add_argument("out", type=pathlib.Path, help="folder of the NWB files")
    parser.add_argument("--recordings", type=pathlib.Path, help="input folder of the batch, for the events")
    parser.add_argument("--haltere", default="haltere", help="the program, for the events")
    parser.add_argument("--session-start", type=datetime.datetime.fromisoformat, help="such as 2026-11-23T12:00:00+00:00")
    parser.add_argument("--overwrite", action="store_true", help="replace existing NWB files")
    options = parser.parse_args()
    results = sorted(done.parent for done in options.batch.rglob("done.json"))
    if not results:
        sys.exit(f"{options.batch}: there is no result of haltere batch (no done.json)")
    names = [folder.relative_to(options.batch) for folder in results]
    files = [options.out / name.with_name(name.name + ".nwb") for name in names]
    for out in files:
        if out.exists() and not options.overwrite:
            sys.exit(f"{out}: exists already; give --overwrite to replace it")
    status = 0
    for folder, out in zip(results, files):
        convert(folder, out, options.recordings, options.haltere, options.session_start)
        errors = pynwb.validate(path=str(out))
        for error in errors:
            print(f"{out}: {error}", file=sys.stderr)
            status = 1
        print(f"wrote {out}" + ("" if errors else " (valid)"))
    return status


if __name__ == "__main__":
    sys.exit(main())
