"""The Python package: python/quadmatch, and its extension module built by CMake. Settings stand in pyproject.toml.

CMAKE_ARGS in the environment is handed to CMake. All that is built lies under build/.
"""
import os
import pathlib
import re
import shlex
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent


class BuildByCMake(build_ext):
    def build_extension(self, extension):
        folder = pathlib.Path(self.build_temp).resolve()
        destination = pathlib.Path(self.get_ext_fullpath(extension.name)).resolve().parent
        configure = ["cmake", "-S", str(ROOT), "-B", str(folder), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                     "-DQUADMATCH_PYTHON=ON", "-DQUADMATCH_FRONT_ENDS=OFF", f"-DPython_EXECUTABLE={sys.executable}"]
        subprocess.run(configure + shlex.split(os.environ.get("CMAKE_ARGS", "")), check=True)
        subprocess.run(["cmake", "--build", str(folder), "--target", "quadmatch_python"], check=True)
        subprocess.run(["cmake", "--install", str(folder), "--component", "python", "--prefix", str(destination)],
                       check=True)


def version():
    return re.search(r"project\(quadmatch VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]


setup(version=version(), ext_modules=[Extension("quadmatch._core", sources=[])],
      cmdclass={"build_ext": BuildByCMake})
