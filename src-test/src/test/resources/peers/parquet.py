"""pyarrow and DuckDB read tables in Parquet.

check          fails if one of them is not there
read FILE      for each: its name, types of the columns, then a line for each row
metadata FILE  names and values of the file's metadata that begin with haltere, one in a line
"""

import sys

import duckdb
import pyarrow.parquet


def text(value):
    return "null" if value is None else repr(value) if isinstance(value, float) else str(value)


def read(path):
    table = pyarrow.parquet.read_table(path)
    print("pyarrow", ",".join(f"{field.name}:{field.type}" for field in table.schema))
    for row in table.to_pylist():
        print(",".join(text(value) for value in row.values()))
    result = duckdb.connect().execute("SELECT * FROM read_parquet(?)", [path])
    print("duckdb", ",".join(f"{column[0]}:{column[1]}" for column in result.description))
    for row in result.fetchall():
        print(",".join(text(value) for value in row))


def metadata(path):
    found = pyarrow.parquet.read_metadata(path).metadata
    for name in sorted(found):
        if name.startswith(b"haltere"):
            print(name.decode(), found[name].decode().replace("\n", ""))


if sys.argv[1] == "read":
    read(sys.argv[2])
elif sys.argv[1] == "metadata":
    metadata(sys.argv[2])
