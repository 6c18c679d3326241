# SPDX-License-Identifier: BSD-3-Clause
"""The table of a study, in a file of SQLite: each row is written once, as it comes."""

import contextlib
import json
import sqlite3
import urllib.parse

from pkm_workspace.core import __version__
from pkm_workspace.errors import PkmError

FORMAT = 1


def quoted(name):
    return '"' + name.replace('"', '""') + '"'


def refuse_clashes(parameters, columns):
    """SQLite takes upper case for lower case."""
    before = {name.casefold(): "a column of the table" for name in (*columns, "design")}
    for name in parameters:
        if name.casefold() in before:
            raise PkmError(f"a parameter cannot be called {name}: so is {before[name.casefold()]}")
        before[name.casefold()] = "another parameter, but for upper and lower case"


class Table:
    """The designs, and the rows that are there. Opening a file again goes on with it: the study has to be the same."""

    def __init__(self, path, family, question, designs):
        self.path = str(path)
        self.designs = designs
        self.columns = question.columns()
        refuse_clashes(designs[0], self.columns)
        told = {"format": FORMAT, "version": __version__, "family": family.describe(designs),
                "question": question.describe(), "columns": self.columns}
        try:
            self.connection = sqlite3.connect(self.path, isolation_level=None)
            self.connection.execute("PRAGMA journal_mode=WAL")
            self.connection.execute("PRAGMA synchronous=NORMAL")
            self._open(json.dumps(told, sort_keys=True, default=str))
        except (sqlite3.Error, OverflowError) as reason:
            raise PkmError(f"{path}: cannot be used as the table of a study: {reason}") from reason

    def _open(self, told):
        with self._transaction():
            self.connection.execute("CREATE TABLE IF NOT EXISTS study (told TEXT)")
            before = self.connection.execute("SELECT told FROM study").fetchone()
            if before is None:
                self._create(told)
        if before is not None:
            self._compare(json.loads(before[0]), json.loads(told))

    def _transaction(self):
        return Transaction(self.connection)

    def _create(self, told):
        names = [*self.designs[0], *self.columns]
        run = self.connection.execute
        run(f"CREATE TABLE designs (design INTEGER PRIMARY KEY, {', '.join(map(quoted, self.designs[0]))})")
        run(f"CREATE TABLE results (design INTEGER PRIMARY KEY, {', '.join(map(quoted, self.columns))})")
        run("CREATE VIEW studied AS SELECT design, " + ", ".join(map(quoted, names))
            + " FROM designs JOIN results USING (design)")
        marks = ", ".join("?" * (1 + len(self.designs[0])))
        self.connection.executemany(f"INSERT INTO designs VALUES ({marks})",
                                    ([number, *design.values()] for number, design in enumerate(self.designs)))
        run("INSERT INTO study VALUES (?)", [told])

    def _compare(self, before, now):
        differ = [name for name in now if before.get(name) != now[name]]
        rows = self.connection.execute("SELECT * FROM designs ORDER BY design").fetchall()
        if rows != [(number, *design.values()) for number, design in enumerate(self.designs)]:
            differ.append("designs")
        if differ:
            raise PkmError(f"{self.path} is the table of another study: its {', '.join(differ)} differ; give another "
                           "file, or the same study to go on with it")

    def missing(self):
        """The designs without a row, with their numbers."""
        done = {number for number, in self.connection.execute("SELECT design FROM results")}
        return [(number, design) for number, design in enumerate(self.designs) if number not in done]

    def add(self, rows):
        """Writes rows, each (number of the design, values), all of them or none. @return how many were new"""
        marks = ", ".join("?" * (1 + len(self.columns)))
        with self._transaction():
            before = self.connection.total_changes
            self.connection.executemany(f"INSERT OR IGNORE INTO results VALUES ({marks})",
                                        ([number, *values] for number, values in rows))
            return self.connection.total_changes - before

    def close(self):
        self.connection.close()


class Transaction:
    """All or nothing, also where the process is killed."""

    def __init__(self, connection):
        self.connection = connection

    def __enter__(self):
        self.connection.execute("BEGIN IMMEDIATE")

    def __exit__(self, kind, *_):
        self.connection.execute("COMMIT" if kind is None else "ROLLBACK")


@contextlib.contextmanager
def reading(path):
    """A cursor on the file of a table. Raises PkmError where that is none."""
    try:
        with contextlib.closing(sqlite3.connect(f"file:{urllib.parse.quote(str(path))}?mode=ro", uri=True)) as connection:
            yield connection.cursor()
    except (sqlite3.DatabaseError, TypeError) as reason:
        raise PkmError(f"{path}: is not the table of a study: {reason}") from reason


def read(path):
    """Names of the columns, and the rows by the number of their design."""
    with reading(path) as cursor:
        cursor.execute("SELECT * FROM studied ORDER BY design")
        return [column[0] for column in cursor.description], cursor.fetchall()


def told_of(path):
    """What the study is about: family, question, columns, version."""
    with reading(path) as cursor:
        return json.loads(cursor.execute("SELECT told FROM study").fetchone()[0])


def count_of(path):
    """How many designs the study has."""
    with reading(path) as cursor:
        return cursor.execute("SELECT COUNT(*) FROM designs").fetchone()[0]
