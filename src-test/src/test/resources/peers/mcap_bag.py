"""Other programs' view of MCAP files, for McapPeersTest.

peers/mcap_bag.py check         exits with 0 if the packages are there
peers/mcap_bag.py read FILE     a line per program: events and CRC-32 of int64 t,x,y,p rows; checksums of the file are checked
"""
import sys
import zlib

import numpy as np
from mcap.reader import make_reader
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

TYPE = "dvs_msgs/msg/EventArray"
ROW = np.dtype({"names": ["x", "y", "s", "ns", "p"], "formats": ["<u2", "<u2", "<i4", "<u4", "u1"],
                "offsets": [1, 3, 7, 11, 15], "itemsize": 16})


def crc(t, x, y, p):
    table = np.empty((len(t), 4), dtype="<i8")
    table[:, 0], table[:, 1], table[:, 2], table[:, 3] = t, x, y, p
    return "%d %08x" % (len(t), zlib.crc32(table.tobytes()))


def by_mcap(messages):
    """The layout as CDR has it: header, height, width, count; the first event has no byte before it."""
    parts = []
    for data in messages:
        start = 4 + (8 + 4 + int.from_bytes(data[12:16], "little") + 3 & ~3) + 12
        body = b"\0" + data[start:start + 4] + b"\0\0" + data[start + 4:start + 13] + data[start + 13:]
        parts.append(np.frombuffer(body, ROW))
    e = np.concatenate(parts)
    return crc(e["s"].astype("<i8") * 10**6 + e["ns"] // 1000, e["x"], e["y"], e["p"])


def by_rosbags(messages, definition):
    store = get_typestore(Stores.ROS2_HUMBLE)
    store.register(get_types_from_msg(definition, TYPE))
    events = [e for data in messages for e in store.deserialize_cdr(data, TYPE).events]
    return crc([e.ts.sec * 10**6 + e.ts.nanosec // 1000 for e in events], [e.x for e in events],
               [e.y for e in events], [e.polarity for e in events])


if sys.argv[1] == "read":
    with open(sys.argv[2], "rb") as file:
        reader = make_reader(file, validate_crcs=True)
        summary = reader.get_summary()
        found = list(reader.iter_messages())
        assert summary.statistics.message_count == len(found)
        assert summary.statistics.chunk_count == len(summary.chunk_indexes)
        messages = [message.data for _, _, message in found]
        print("mcap", by_mcap(messages))
        print("rosbags", by_rosbags(messages, found[0][0].data.decode()))
