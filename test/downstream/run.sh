#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs a build of pkm_workspace, then builds and runs this package against the install space.
# run.sh BUILD PREFIX WORK: the build folder, its install prefix, and the folder below which all is written
set -euo pipefail
build=$1
prefix=$3/root$2
work=$3
source=$(cd "$(dirname "$0")" && pwd)

export PATH=/usr/bin:$PATH ROS_HOME=$work # the Python of catkin; rospack keeps its cache in ROS_HOME
rm -rf "$work"
mkdir -p "$work"
DESTDIR=$work/root cmake --install "$build" >"$work/install.log"
for file in lib/libpkm_workspace.so include/pkm_workspace/region/largest_region.h share/pkm_workspace/package.xml \
  share/pkm_workspace/urdf/orthoglide.urdf share/pkm_workspace/launch/orthoglide.launch \
  share/pkm_workspace/rviz/pkm_workspace.rviz lib/pkm_workspace/open_rviz \
  lib/pkm_workspace/pkm lib/pkm_workspace/pkm_workspace_node; do
  [ -e "$prefix/$file" ] || { echo "not installed: $file" >&2; exit 1; }
done

set +u
source "$prefix/setup.bash"
set -u
cmake -S "$source" -B "$work/build" -DCATKIN_DEVEL_PREFIX="$work/devel" >"$work/configure.log"
cmake --build "$work/build"
program=$work/devel/lib/pkm_workspace_downstream/downstream
if ! ldd "$program" | grep -F "$prefix/lib/libpkm_workspace.so"; then
  echo "linked to another one:" >&2
  ldd "$program"
  exit 1
fi
"$program"

# The installed command, as rosrun finds it, with the installed machine
rosrun pkm_workspace pkm evaluate --urdf "$(rospack find pkm_workspace)/urdf/orthoglide.urdf" --point 0 0 0
