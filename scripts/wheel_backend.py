# SPDX-License-Identifier: BSD-3-Clause
"""Makes a wheel of the core in Python and of the command with CMake, for pip: PEP 517 without another package.

pip install . --no-build-isolation --no-deps [--config-settings build=FOLDER]: a folder where the source was configured
before is used as it is; without it, the source is configured and built without ROS in build/wheel/.
"""

import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

SOURCE = pathlib.Path(__file__).resolve().parent.parent
OPTIONS = ["-DPKM_WORKSPACE_ROS=OFF", "-DBUILD_SHARED_LIBS=OFF", "-DCMAKE_POSITION_INDEPENDENT_CODE=ON",
           "-DCMAKE_BUILD_TYPE=Release"]


def version():
    text = (SOURCE / "package.xml").read_text(encoding="utf-8")
    return re.search(r"<version>(.*)</version>", text).group(1)


def tag():
    """Of this interpreter and this system."""
    python = "cp" + sysconfig.get_config_var("py_version_nodot")
    return f"{python}-{python}-" + sysconfig.get_platform().replace("-", "_").replace(".", "_")


def built(settings):
    """The folder of the build, in which the module and the command are up to date."""
    given = (settings or {}).get("build")
    folder = pathlib.Path(given).resolve() if given else SOURCE / "build/wheel"
    if not given:
        options = [f"-DPython3_EXECUTABLE={sys.executable}", *OPTIONS]
        subprocess.run(["cmake", "-S", SOURCE, "-B", folder, *options], check=True)
    subprocess.run(["cmake", "--build", folder, "-j", str(os.cpu_count()), "--target", "pkm_workspace_python", "pkm"],
                   check=True)
    return folder


def files_of(stage):
    """Name in the wheel and file of all that is installed."""
    package = SOURCE / "python/pkm_workspace"
    for file in sorted([*package.rglob("*.py"), *package.rglob("*.pyi"), package / "py.typed"]):
        yield str(file.relative_to(package.parent)), file
    for file in sorted(stage.rglob("_core*")):
        yield f"pkm_workspace/{file.name}", file
    for file in sorted(stage.rglob("pkm")):
        if file.is_file():
            yield f"pkm_workspace-{version()}.data/scripts/pkm", file


def write(archive, record, name, content, mode=0o644):
    info = zipfile.ZipInfo(name)
    info.external_attr = (0o100000 | mode) << 16
    archive.writestr(info, content, zipfile.ZIP_DEFLATED)
    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
    record.append(f"{name},sha256={digest},{len(content)}")


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    folder = built(config_settings)
    name = f"pkm_workspace-{version()}"
    wheel = f"{name}-{tag()}.whl"
    record = []
    with tempfile.TemporaryDirectory() as stage, zipfile.ZipFile(pathlib.Path(wheel_directory) / wheel, "w") as archive:
        for component in ("python", "command"):
            subprocess.run(["cmake", "--install", folder, "--component", component, "--prefix", stage], check=True)
        for target, file in files_of(pathlib.Path(stage)):
            write(archive, record, target, file.read_bytes(), file.stat().st_mode & 0o777)
        write(archive, record, f"{name}.dist-info/LICENSE", (SOURCE / "LICENSE").read_bytes())
        about = {"METADATA": "Metadata-Version: 2.1\nName: pkm_workspace\nVersion: {0}\nRequires-Dist: numpy\n"
                             "Requires-Python: >=3.8\nLicense: BSD-3-Clause\n".format(version()),
                 "WHEEL": f"Wheel-Version: 1.0\nGenerator: wheel_backend\nRoot-Is-Purelib: false\nTag: {tag()}\n"}
        for member, text in about.items():
            write(archive, record, f"{name}.dist-info/{member}", text.encode())
        record.append(f"{name}.dist-info/RECORD,,\n")
        archive.writestr(f"{name}.dist-info/RECORD", "\n".join(record))
    return wheel


def build_sdist(sdist_directory, config_settings=None):
    raise NotImplementedError("install from the source tree: pip install . --no-build-isolation --no-deps")
