"""The Python package quadmatch, which lies in the add-on's folder vendor/, or why it does not work here."""
import importlib
import importlib.machinery
import pathlib
import platform
import sys

VENDOR = pathlib.Path(__file__).parent / "vendor"

_tried = False
_module = None
_reason = ""


def load():
    """The package, or None; reason() says why. Tried once."""
    global _tried, _module, _reason
    if not _tried:
        _tried = True
        _module, _reason = _import()
    return _module


def reason():
    """A sentence, empty where the package is there."""
    load()
    return _reason


def _import():
    sys.path.insert(0, str(VENDOR))
    try:
        return importlib.import_module("quadmatch"), ""
    except ImportError as error:
        for name in [name for name in sys.modules if name == "quadmatch" or name.startswith("quadmatch.")]:
            del sys.modules[name]  # half of it
        return None, _explain(error)
    finally:
        sys.path.remove(str(VENDOR))


def _explain(error):
    modules = (path.name for path in VENDOR.glob("quadmatch/_core.*") if path.suffix in (".so", ".pyd"))
    built = sorted(name.partition(".")[2].rpartition(".")[0] for name in modules)
    ours = f"Python {platform.python_version()} on {platform.system()} {platform.machine()}"
    if not built:
        return f"this add-on comes without the extension module; build the zip with scripts/build_blender.sh ({error})"
    if any(f".{tag}." in f"{suffix}." for tag in built for suffix in importlib.machinery.EXTENSION_SUFFIXES):
        return f"the add-on's extension module does not load: {error}"
    return (f"the add-on's extension module was built for {', '.join(built)}, but this Blender runs {ours}; "
            "install the zip that was built for it")
