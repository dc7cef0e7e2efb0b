# SPDX-License-Identifier: MIT
"""wheel_of_package.py LIBRARY VERSION FOLDER: writes the wheel of the package, with the library inside, into FOLDER.

The libraries that LIBRARY loads lie beside it in the wheel, with their copyright notices where Debian's packages have
them. Left out are glibc, libstdc++, libgcc_s and zlib, which the manylinux policy expects of every system and which Python has
loaded already. pip calls this file as well (PEP 517); setuptools would compile nothing here and require three more packages.
"""
import base64
import hashlib
import re
import shutil
import subprocess
import sys
import sysconfig
import zipfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
OF_EVERY_SYSTEM = re.compile(r"(libc|libm|libpthread|libdl|librt|libstdc\+\+|libgcc_s|libz|ld-linux[\w-]*)\.so")
METADATA = """Metadata-Version: 2.1
Name: bezierbench
Version: {version}
Summary: Bezier evaluators by name, the exact reference, errors and bounds
License: MIT
Requires-Python: >=3.9
Requires-Dist: numpy
"""
WHEEL = """Wheel-Version: 1.0
Generator: bezierbench
Root-Is-Purelib: false
Tag: {tag}
"""


def loaded_by(library):
    """{name: path} of the shared libraries that a library loads and that a system may lack."""
    found = subprocess.run(["ldd", library], check=True, capture_output=True, text=True).stdout
    return {name: Path(path) for name, path in re.findall(r"^\s+(\S+) => (/\S+)", found, re.MULTILINE)
            if not OF_EVERY_SYSTEM.match(name)}


def notices_of(libraries):
    """{name: path} of the copyright notices of the Debian packages that libraries come from."""
    if not shutil.which("dpkg-query"):
        return {}
    named = subprocess.run(["dpkg-query", "--search", *(f"*/{path.resolve().name}" for path in libraries)], check=False,
                           capture_output=True, text=True).stdout
    packages = set(re.findall(r"^([^:\s]+)[:\w]*: /", named, re.MULTILINE))
    return {f"{package}.txt": Path("/usr/share/doc") / package / "copyright" for package in packages}


def write_wheel(library, version, folder):
    """The path of the wheel, which replaces any other one in the folder."""
    tag = "py3-none-" + re.sub(r"[-.]", "_", sysconfig.get_platform())
    about = f"bezierbench-{version}.dist-info"
    others = loaded_by(library)
    contents = {f"bezierbench/{path.name}": path.read_bytes() for path in (HERE / "bezierbench").iterdir() if path.is_file()}
    contents |= {f"bezierbench/{name}": path.read_bytes() for name, path in {"libbezierbench.so.1": library, **others}.items()}
    contents |= {f"{about}/licenses/{name}": path.read_bytes()
                 for name, path in {"LICENSE": ROOT / "LICENSE", **notices_of(others.values())}.items()}
    contents[f"{about}/METADATA"] = METADATA.format(version=version).encode()
    contents[f"{about}/WHEEL"] = WHEEL.format(tag=tag).encode()
    record = [f"{name},sha256={base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b'=').decode()},{len(data)}\n"
              for name, data in sorted(contents.items())]
    contents[f"{about}/RECORD"] = "".join([*record, f"{about}/RECORD,,\n"]).encode()
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    wheel = folder / f"bezierbench-{version}-{tag}.whl"
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as file:
        for name, data in contents.items():
            file.writestr(zipfile.ZipInfo(name), data, zipfile.ZIP_DEFLATED)  # without the time, so that a wheel can be repeated
    return wheel


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """What pip calls. Returns the name of the wheel in wheel_directory."""
    subprocess.run([ROOT / "scripts/build", "wheel"], check=True, stdout=sys.stderr)
    (wheel,) = (ROOT / "build/release/wheel").glob("*.whl")
    return Path(shutil.copy(wheel, wheel_directory)).name


if __name__ == "__main__":
    print(write_wheel(Path(sys.argv[1]), sys.argv[2], Path(sys.argv[3])))
