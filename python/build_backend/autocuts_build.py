"""Builds the wheel for pip (PEP 517) by CMake: the module, and the library beside it.

pip install . --config-settings build-dir=DIR takes what is built in DIR already.
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

ROOT = pathlib.Path(__file__).resolve().parents[2]


def _version():
    return re.search(r"project\(Autocuts VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)


def _built(folder):
    """Builds the module in a folder without the studio."""
    python = [f"-DPython_EXECUTABLE={os.path.realpath(sys.executable)}", "-DAUTOCUTS_STUDIO=OFF", "-DBUILD_TESTING=OFF"]
    subprocess.run(["cmake", "-S", ROOT, "-B", folder, "-DCMAKE_BUILD_TYPE=Release", *python], check=True)
    subprocess.run(["cmake", "--build", folder, "--parallel", str(os.cpu_count() or 1)], check=True)


def _files(build, prefix):
    """What is installed: names in the wheel and paths."""
    for component in ("runtime", "python"):
        subprocess.run(["cmake", "--install", build, "--prefix", prefix, "--component", component], check=True)
    found = {}
    for path in sorted(pathlib.Path(prefix).rglob("*")):
        if path.parent.name == "autocuts" and path.is_file():
            found[f"autocuts/{path.name}"] = path
        elif re.fullmatch(r"libautocuts\.so\.\d+\.\d+", path.name):
            found[f"autocuts.libs/{path.name}"] = path.resolve()
    return found


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    version = _version()
    tag = f"cp{sysconfig.get_python_version().replace('.', '')}"
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    info = f"autocuts-{version}.dist-info"
    name = f"autocuts-{version}-{tag}-{tag}-{platform}.whl"
    with tempfile.TemporaryDirectory() as folder:
        build = (config_settings or {}).get("build-dir")
        if build is None:
            build = os.path.join(folder, "build")
            _built(build)
        contents = {name: path.read_bytes() for name, path in _files(build, os.path.join(folder, "prefix")).items()}
    contents[f"{info}/METADATA"] = (
        f"Metadata-Version: 2.1\nName: autocuts\nVersion: {version}\nRequires-Dist: numpy\nLicense: GPL-3.0-or-later\n"
    ).encode()
    contents[f"{info}/WHEEL"] = (
        f"Wheel-Version: 1.0\nGenerator: autocuts_build\nRoot-Is-Purelib: false\nTag: {tag}-{tag}-{platform}\n"
    ).encode()
    record = [
        f"{file},sha256={base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b'=').decode()},{len(data)}"
        for file, data in contents.items()
    ]
    contents[f"{info}/RECORD"] = "\n".join([*record, f"{info}/RECORD,,", ""]).encode()
    with zipfile.ZipFile(os.path.join(wheel_directory, name), "w", zipfile.ZIP_DEFLATED) as wheel:
        for file, data in contents.items():
            wheel.writestr(file, data)
    return name


def build_sdist(sdist_directory, config_settings=None):
    raise NotImplementedError("use the source tree, or its archive")
