"""Subscribes to live results by libzmq: zeromq.py read ADDRESS TOPIC COUNT prints each message."""

import sys

import zmq

PATIENCE_MS = 60_000

if sys.argv[1] == "read":
    address, topic, count = sys.argv[2], sys.argv[3], int(sys.argv[4])
    with zmq.Context() as context, context.socket(zmq.SUB) as socket:
        socket.setsockopt(zmq.RCVTIMEO, PATIENCE_MS)
        socket.connect(address)
        socket.subscribe(topic)
        for _ in range(count):
            print(*(frame.decode().strip() for frame in socket.recv_multipart()))
