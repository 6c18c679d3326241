#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Studies that are killed, whose workers die, that others compute: the table is the same."""

import os
import random
import signal
import subprocess
import sys
import unittest

from study_support import StudyTest, count_of, untimed

SEED = 1910
MOMENTS = 10


class Deaths(StudyTest):
    def test_a_worker_that_dies_is_replaced(self):
        self.finished(self.study("dies_once"))
        self.assertTrue((self.folder / "marker").exists())
        self.assertEqual(untimed(self.table)[1], self.expected())

    def test_a_design_that_kills_workers_is_given_up(self):
        self.finished(self.study("dies"))
        rows = untimed(self.table)[1]
        self.assertEqual(rows[:-1], self.expected()[:-1])
        self.assertEqual(rows[-1][2:4], ("lost", "3 workers died of it"))

    def test_killed_at_any_moment_it_goes_on(self):
        moments, file, count = random.Random(SEED), self.study("tells", count=1000), 0
        for moment in sorted(moments.randrange(1000) for _ in range(MOMENTS)):
            program = self.begin(file)
            self.wait_for_designs(program, moment - count)
            program.kill()
            program.communicate()
            self.assertGreaterEqual(count_of(self.table), count)
            count = count_of(self.table)
        self.assertIn(f"{1000 - count} of 1000 designs evaluated", self.finished(file))
        self.assertEqual(untimed(self.table)[1], self.expected(1000))

    def test_interrupted_it_goes_on(self):
        file = self.study("tells", count=1000)
        program = self.begin(file)
        self.wait_for_designs(program, 100)
        program.send_signal(signal.SIGINT)
        self.assertIn("goes on from here", program.communicate()[1])
        self.assertEqual(program.returncode, 130)
        self.finished(file)
        self.assertEqual(untimed(self.table)[1], self.expected(1000))

    def test_a_design_that_kills_the_workers_of_a_scheduler(self):
        try:
            import distributed  # noqa: F401
        except ImportError:
            self.skipTest("distributed is missing")
        with Cluster(self.folder, 1, "--nanny") as cluster:
            self.finished(self.study("dies", count=8), "--scheduler", cluster.address)
        rows = untimed(self.table)[1]
        self.assertEqual(rows[:-1], self.expected(8)[:-1])
        self.assertEqual(rows[-1][2], "lost")

    def test_a_scheduler_whose_worker_is_killed(self):
        try:
            import distributed  # noqa: F401
        except ImportError:
            self.skipTest("distributed is missing")
        self.finished(self.study(count=400, table="local.sqlite"))
        with Cluster(self.folder, 2) as cluster:
            program = self.begin(self.study("tells", count=400), "--scheduler", cluster.address)
            self.wait_for_designs(program, 200)
            self.assertIsNone(program.poll())
            cluster.workers[0].kill()
            said, reason = program.communicate()
            self.assertEqual(program.returncode, 0, said + reason)
        self.assertEqual(untimed(self.table), untimed(self.folder / "local.sqlite"))


class Cluster:
    """Dask's scheduler and workers."""

    def __init__(self, folder, count, nanny="--no-nanny"):
        self.folder, self.count, self.nanny = folder, count, nanny
        self.workers = []

    def start(self, module, *words):
        return subprocess.Popen([sys.executable, "-m", f"distributed.cli.{module}", *words], cwd=self.folder,
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                env={**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))})

    def __enter__(self):
        file = self.folder / "scheduler.json"
        self.scheduler = self.start("dask_scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard",
                                    "--scheduler-file", str(file))
        from distributed import Client
        with Client(scheduler_file=str(file)) as client:  # waits for the file
            self.address = client.scheduler.address
            self.workers = [self.start("dask_worker", self.address, "--nthreads", "1", self.nanny, "--no-dashboard")
                            for _ in range(self.count)]
            client.wait_for_workers(self.count)
        return self

    def __exit__(self, *_):
        for process in [*self.workers, self.scheduler]:
            process.send_signal(signal.SIGKILL)
            process.wait()


if __name__ == "__main__":
    unittest.main()
