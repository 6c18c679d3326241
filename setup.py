# SPDX-License-Identifier: BSD-3-Clause
"""Used by catkin_python_setup() only."""

from distutils.core import setup

from catkin_pkg.python_setup import generate_distutils_setup

setup(**generate_distutils_setup(packages=["pkm_workspace", "pkm_workspace.report", "pkm_workspace.study"],
                                 package_dir={"": "python"}, package_data={"pkm_workspace": ["*.pyi", "py.typed"]}))
