# SPDX-License-Identifier: BSD-3-Clause
"""Who computes the rows: processes of this machine, or of a cluster by Dask's scheduler."""

import collections
import os
import pickle
import queue
import subprocess
import sys
import threading

from pkm_workspace.errors import PkmError
from pkm_workspace.study.evaluate import DEATHS, rows_of

MOST = 50  # designs in one batch


def batches_of(designs, workers):
    """Several for each worker, so that they end together."""
    size = max(1, min(MOST, len(designs) // (8 * workers)))
    return [designs[k:k + size] for k in range(0, len(designs), size)]


class Worker:
    """A process that answers batches; one that has died is replaced."""

    def __init__(self, task):
        self.task = task
        self.process = None

    def start(self):
        path = os.pathsep.join(filter(None, sys.path))
        self.process = subprocess.Popen([sys.executable, "-m", "pkm_workspace.study.worker"], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, env={**os.environ, "PYTHONPATH": path},
                                        start_new_session=True)  # Ctrl-C is the study's
        self.send(self.task)

    def send(self, data):
        self.process.stdin.write(len(data).to_bytes(8, "little") + data)
        self.process.stdin.flush()

    def answer(self, batch):
        """The rows, or nothing where the worker has died."""
        try:
            if self.process is None:
                self.start()
            self.send(pickle.dumps(batch))
            return pickle.load(self.process.stdout)
        except (OSError, EOFError, pickle.UnpicklingError):
            self.end()
            return None

    def kill(self):
        """Thread-safe: whoever waits for an answer gets none."""
        process = self.process
        if process is not None:
            process.kill()

    def end(self):
        self.kill()
        if self.process is not None:
            self.process.wait()
            self.process.stdin.close()
            self.process.stdout.close()
        self.process = None


class Local:
    """So many workers, each with a thread here that brings it batches."""

    def __init__(self, family, question, count):
        self.task = pickle.dumps((family, question))
        self.question = question
        self.count = count
        self.stop = threading.Event()

    def serve(self, worker, todo, done):
        while not self.stop.is_set():
            try:
                batch, deaths = todo.popleft()
            except IndexError:
                break
            rows = worker.answer(batch)
            if rows is not None:
                done.put(rows)
            elif self.stop.is_set():
                break
            elif len(batch) > 1:
                todo.extend(([design], deaths) for design in batch)  # to find the one that kills
            elif deaths + 1 < DEATHS:
                todo.append((batch, deaths + 1))
            else:
                done.put([(number, self.question.lost()) for number, _ in batch])
        worker.end()
        done.put(None)

    def rows(self, designs):
        """Lists of rows, as they come."""
        todo = collections.deque((batch, 0) for batch in batches_of(designs, self.count))
        done = queue.SimpleQueue()
        crew = [Worker(self.task) for _ in range(self.count)]
        threads = [threading.Thread(target=self.serve, args=(worker, todo, done), daemon=True) for worker in crew]
        for thread in threads:
            thread.start()
        ended = 0
        try:
            while ended < len(threads):
                rows = done.get()
                ended += rows is None
                if rows is not None:
                    yield rows
        finally:
            self.stop.set()
            for worker in crew:
                worker.kill()
            for thread in threads:
                thread.join()


class Dask:
    """Workers of a scheduler that runs already, which replaces those that die."""

    def __init__(self, family, question, address):
        try:
            from distributed import Client
        except ImportError:
            raise PkmError("a scheduler needs Dask's distributed (Debian: python3-distributed)") from None
        try:
            self.client = Client(address, timeout=20)
        except (OSError, ValueError) as reason:
            raise PkmError(f"no scheduler answers at {address}: {reason}; start dask-scheduler there") from None
        self.task, self.question = (family, question), question

    def rows(self, designs):
        from distributed import as_completed
        from distributed.scheduler import KilledWorker
        workers = max(1, len(self.client.scheduler_info()["workers"]))
        batches = {self.submit(batch): batch for batch in batches_of(designs, workers)}
        running = as_completed(list(batches))
        try:
            for future in running:
                batch = batches.pop(future)
                try:
                    yield future.result()  # computed again where it was lost with its worker
                except KilledWorker:
                    if len(batch) == 1:
                        yield [(batch[0][0], self.question.lost())]
                        continue
                    again = {self.submit([design]): [design] for design in batch}  # to find the one that kills
                    batches.update(again)
                    running.update(again)
        finally:
            self.client.close()

    def submit(self, batch):
        return self.client.submit(rows_of, *self.task, batch, pure=False)
