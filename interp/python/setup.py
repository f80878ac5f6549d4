"""Builds the extension module by CMake; what else there is to say is in pyproject.toml."""

import importlib.util
import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parents[2]


def version() -> str:
    header = (ROOT / "interp/displayfile.h").read_text()
    return ".".join(re.findall(r"#define DISPLAYFILE_VERSION_\w+ ([0-9]+)", header))


def licence_of(folder: Path) -> str:
    """Of the package in a folder: the module that combines solids, by CGAL, is under the GPL."""
    has_module = any(folder.glob("displayfile-solids.so.*"))
    return "MIT AND GPL-3.0-or-later" if has_module else "MIT"


def require_packages() -> None:
    """Says what is missing where pip was called with --no-build-isolation: setuptools would say
    "invalid command 'bdist_wheel'", and CMake that there is no pybind11."""
    needed = ["pybind11"]
    try:
        import setuptools.command.bdist_wheel  # noqa: F401  # since setuptools 70.1
    except ImportError:
        needed.append("wheel")
    if os.environ.get("DISPLAYFILE_PYTHON_BUILT"):
        needed.remove("pybind11")
    missing = [name for name in needed if importlib.util.find_spec(name) is None]
    if missing:
        sys.exit(
            f"displayfile: {sys.executable} has no {' and no '.join(missing)}, which a build needs: "
            "expected pip without --no-build-isolation, which fetches it, or an environment of the "
            "system's Python with its packages: /usr/bin/python3 -m venv --system-site-packages"
        )


def pybind11_of_this_python() -> "dict[str, str]":
    """Where that of this Python is: CMake would look for the system's, which may be for another."""
    if importlib.util.find_spec("pybind11") is None:
        return {}
    import pybind11

    return {"pybind11_DIR": pybind11.get_cmake_dir()}


class CMakeBuild(build_ext):
    """Builds the extension and what it starts, and puts them where setuptools wants them.

    Where CMake has built them already (the target displayfile_python), the environment variable
    DISPLAYFILE_PYTHON_BUILT may name the folder: they are taken from there. The package's metadata
    have the licences of what is in it. CMAKE_ARGS, as for other builds of extension modules, are
    more options for CMake.
    """

    def build_extension(self, ext: Extension) -> None:
        folder = Path(self.get_ext_fullpath(ext.name)).resolve().parent
        built = os.environ.get("DISPLAYFILE_PYTHON_BUILT")
        if built:
            folder.mkdir(parents=True, exist_ok=True)
            for old in folder.glob("displayfile-*"):  # of an earlier build
                old.unlink()
            for file in Path(built).iterdir():
                if file.name.startswith(("_displayfile.", "displayfile-")):
                    shutil.copy2(file, folder)
            self.distribution.metadata.license = licence_of(folder)
            return
        build = Path(self.build_temp).resolve()
        build.mkdir(parents=True, exist_ok=True)
        options = {
            "CMAKE_BUILD_TYPE": "Release",
            "CMAKE_UNITY_BUILD": "ON",
            "CMAKE_UNITY_BUILD_BATCH_SIZE": "12",
            "DISPLAYFILE_PRECOMPILED_HEADERS": "ON",
            "DISPLAYFILE_PYTHON": "ON",
            "DISPLAYFILE_PYTHON_FOLDER": str(folder),
            "DISPLAYFILE_TESTS": "OFF",
            "Python_EXECUTABLE": sys.executable,
            **pybind11_of_this_python(),
        }
        definitions = [f"-D{name}={value}" for name, value in options.items()]
        given = shlex.split(os.environ.get("CMAKE_ARGS", ""))
        subprocess.check_call(["cmake", "-G", "Ninja", *definitions, *given, str(ROOT)], cwd=build)
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", str(os.cpu_count() or 1))
        subprocess.check_call(
            ["cmake", "--build", ".", "--target", "displayfile_python", "--parallel", jobs],
            cwd=build,
        )
        self.distribution.metadata.license = licence_of(folder)


require_packages()
setup(
    version=version(),
    license="MIT",  # of the source
    ext_modules=[Extension("displayfile._displayfile", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
)
