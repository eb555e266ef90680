"""What all parts share: running programs, raw figures, tables, bars."""
import argparse
import dataclasses
import json
import os
import pathlib
import platform
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


@dataclasses.dataclass
class Options:
    build: pathlib.Path   # the folder of a release build
    meshes: pathlib.Path  # the collection of real meshes
    tools: pathlib.Path   # edits, scoring and the independent verifier
    docs: pathlib.Path    # results.md goes here, raw figures to results/ in it
    jobs: int             # pairs at a time, where no time is measured
    quick: bool           # two meshes, one seed: to try a part

    @property
    def program(self):
        return self.build / "quadmatch"

    @property
    def collection(self):
        return self.meshes.is_dir() and self.tools.is_dir()


def parse(arguments, usage, parts, docs):
    """Which of the parts are asked for, and the options that all programs here take. Pages go to `docs` unless told."""
    parser = argparse.ArgumentParser(description=usage, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", default=",".join(parts))
    parser.add_argument("--meshes", type=pathlib.Path, default=ROOT.parent / "shared" / "meshes")
    parser.add_argument("--tools", type=pathlib.Path, default=ROOT.parent / "shared" / "tools")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release")
    parser.add_argument("--docs", type=pathlib.Path, default=docs)
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="pairs at a time where no time is measured")
    parser.add_argument("--quick", action="store_true", help="few meshes, few seeds")
    parsed = vars(parser.parse_args(arguments))
    chosen = [name for name in parsed.pop("only").split(",") if name]
    for name in chosen:
        if name not in parts:
            parser.error(f"no such part: {name}; there are {', '.join(parts)}")
    return chosen, Options(**parsed)


def run(command, statuses=(0,)):
    print("  $", " ".join(str(word) for word in command), flush=True)
    ended = subprocess.run([str(word) for word in command], text=True, capture_output=True, check=False)
    if ended.returncode not in statuses:
        raise SystemExit(f"{command[0]} ended with status {ended.returncode}: {ended.stderr.strip()[-400:]}")
    return ended.stdout


@dataclasses.dataclass
class Measured:
    milliseconds: float       # on the clock
    processor_seconds: float  # of all threads
    peak: int                 # bytes of resident memory
    output: str               # standard output


def measured_run(command, statuses=(0, 1), folder=None):
    """Run a program and say what it took."""
    words = [str(word) for word in command]
    with tempfile.NamedTemporaryFile() as file:
        ended = subprocess.run([sys.executable, "-I", "-S", ROOT / "bench" / "measured_run.py", file.name, *words], text=True,
                               stdout=subprocess.PIPE, cwd=folder, check=True)
        figures = json.load(file)
    status = figures.pop("status")
    if status not in statuses:
        raise SystemExit(f"{' '.join(words)} ended with status {status}")
    return Measured(output=ended.stdout, **figures)


def keep(options, name, value):
    folder = options.docs / "results"
    folder.mkdir(parents=True, exist_ok=True)
    (folder / name).write_text(json.dumps(value, indent=1) + "\n", encoding="utf-8")


def kept(options, name):
    path = options.docs / "results" / name
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else None


def conditions(options):
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        cpu = next((line.split(":", 1)[1].strip() for line in file if line.startswith("model name")), platform.machine())
    return {"cpu": cpu, "processors": os.cpu_count(), "system": f"{platform.system()} {platform.release()}",
            "compiler": run(["g++", "--version"]).splitlines()[0],
            "version": run([options.program, "--version"]).strip(),
            "commit": run(["git", "-C", ROOT, "rev-parse", "--short", "HEAD"]).strip()}


def table(header, rows):
    cells = [header, ["---"] + ["---:"] * (len(header) - 1)] + rows
    return "\n".join("| " + " | ".join(str(cell) for cell in row) + " |" for row in cells) + "\n"


@dataclasses.dataclass
class Bar:
    """What we ask of a figure: at least `bound`, or at most."""
    what: str
    value: float
    bound: float
    at_most: bool = False

    @property
    def missed_by(self):
        return max(0.0, self.value - self.bound if self.at_most else self.bound - self.value)

    def row(self):
        return [self.what, f"{'≤' if self.at_most else '≥'} {self.bound:g}", f"{self.value:.4g}",
                f"**missed by {self.missed_by:.2g}**" if self.missed_by else "met"]


def bar_table(bars):
    return table(["bar", "asked", "measured", ""], [bar.row() for bar in bars]) if bars else ""


def command_line(name):
    return f"`bench/run.py --only {name}`"
