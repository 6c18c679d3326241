# SPDX-License-Identifier: BSD-3-Clause
"""The table of a study in files for others: CSV, HDF5, Parquet."""

import csv
import pathlib

from pkm_workspace.errors import PkmError
from pkm_workspace.study.table import read


def export(table, path):
    """Writes the table of a study into a file, by its ending: .csv, .h5 (PyTables), .parquet (pyarrow)."""
    writers = {".csv": write_csv, ".h5": write_hdf5, ".hdf5": write_hdf5, ".parquet": write_parquet}
    ending = pathlib.Path(path).suffix
    if ending not in writers:
        raise PkmError(f"{path}: the ending {ending or '(none)'} is not known; allowed: {', '.join(writers)}")
    names, rows = read(table)
    writers[ending](path, names, rows)
    return len(rows)


def write_csv(path, names, rows):
    """Numbers with all their digits; nothing where there is none."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(names)
        writer.writerows([repr(value) if isinstance(value, float) else value for value in row] for row in rows)


def arrays(names, rows):
    """Of each column: text where one value is, else numbers; NaN where there is none."""
    import numpy as np
    for name, column in zip(names, zip(*rows) if rows else [()] * len(names)):
        if any(isinstance(value, str) for value in column):
            yield name, np.array(["" if value is None else str(value) for value in column])
        elif name == "design":
            yield name, np.array(column, dtype=np.int64)
        else:
            yield name, np.array([np.nan if value is None else value for value in column], dtype=np.float64)


def write_hdf5(path, names, rows):
    try:
        import tables
    except ImportError:
        raise PkmError(f"{path}: HDF5 needs PyTables (Debian: python3-tables); .csv needs nothing") from None
    import numpy as np
    columns = [(name, np.char.encode(column, "utf-8") if column.dtype.kind == "U" else column)
               for name, column in arrays(names, rows)]
    records = np.zeros(len(rows), dtype=[(name, column.dtype) for name, column in columns])
    for name, column in columns:
        records[name] = column
    with tables.open_file(str(path), "w") as file:
        file.create_table("/", "study", obj=records, title="pkm_workspace")


def write_parquet(path, names, rows):
    try:
        import pyarrow
        import pyarrow.parquet
    except ImportError:
        raise PkmError(f"{path}: Parquet needs pyarrow, which Debian 12 does not have; .h5 and .csv do without") from None
    pyarrow.parquet.write_table(pyarrow.table(dict(arrays(names, rows))), path)
