# SPDX-License-Identifier: BSD-3-Clause
"""What the commands that Python does have in common."""

import argparse
import sys


class Parser(argparse.ArgumentParser):
    """Refuses as all commands of pkm do."""

    def error(self, message):
        print(f"pkm: {message}\npkm: see {self.prog} --help", file=sys.stderr)
        sys.exit(2)
