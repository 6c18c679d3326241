# SPDX-License-Identifier: BSD-3-Clause
"""Writes files whole or not at all."""

import contextlib
import os
import pathlib
import tempfile


@contextlib.contextmanager
def whole_file(path):
    """Gives the path of a draft beside the file. At the end it takes the file's place; after an error it is removed."""
    path = pathlib.Path(path).resolve()
    draft = tempfile.NamedTemporaryFile(dir=path.parent, prefix=path.stem + ".", suffix=path.suffix, delete=False)
    draft.close()
    try:
        yield pathlib.Path(draft.name)
        mask = os.umask(0)
        os.umask(mask)
        os.chmod(draft.name, path.stat().st_mode & 0o7777 if path.exists() else 0o666 & ~mask)
        with open(draft.name, "rb") as content:
            os.fsync(content.fileno())
        os.replace(draft.name, path)
    except BaseException:
        os.unlink(draft.name)
        raise
