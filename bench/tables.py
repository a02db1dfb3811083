#!/usr/bin/python3
"""Runs the benchmarks of build-bench/ and prints their tables; ./bench/run builds them and calls this.

Every competitor of a table runs in turns with the others (Google Benchmark's random interleaving, or rounds of whole
processes), so that a busy moment hits all of them. Times are of the processor unless said otherwise; of each the best
and the median of the repetitions are shown, and ratios are of the medians.
"""
import argparse
import json
import os
import platform
import re
import statistics
import subprocess
import sys
import tempfile

import processes

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
BUILD = os.path.join(ROOT, "build-bench")
PARTS = ["load", "large", "memory", "instructions", "pose", "skin", "draw", "picture"]
NANOSECONDS = {"ns": 1.0, "us": 1e3, "ms": 1e6, "s": 1e9}
KINDS = ["vertices", "quads", "skin", "keys", "curves", "meshes", "nodes", "instances"]


def program(name):
    path = os.path.join(BUILD, "bench", "bench_" + name)
    return path if os.path.exists(path) else None


class Measured:
    """The repetitions of one row: nanoseconds of the processor (or of the clock) per item, frame or load."""

    def __init__(self):
        self.times, self.real = [], []

    best = property(lambda self: min(self.times))
    median = property(lambda self: statistics.median(self.times))
    real_median = property(lambda self: statistics.median(self.real))


def benchmark(name, *arguments, repetitions=9, seconds=0.05):
    """Rows by name, of a Google Benchmark program."""
    command = [program(name), *arguments, "--benchmark_format=json", f"--benchmark_repetitions={repetitions}",
               "--benchmark_enable_random_interleaving=true", f"--benchmark_min_time={seconds}"]
    output = subprocess.run(command, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout
    rows = {}
    for run in json.loads(output)["benchmarks"]:
        if run.get("run_type") != "iteration" or run.get("error_occurred"):
            continue
        row = rows.setdefault(run["run_name"], Measured())
        row.times.append(run["cpu_time"] * NANOSECONDS[run["time_unit"]])
        row.real.append(run["real_time"] * NANOSECONDS[run["time_unit"]])
    return rows


def heading(text):
    print(f"\n{text}  (load {os.getloadavg()[0]:.1f})", flush=True)


def row(name, *columns):
    print(f"  {name:28}" + "".join(f"{column:>14}" for column in columns), flush=True)


def goal(what, value, at_most=None, at_least=None):
    reached = value <= at_most if at_most is not None else value >= at_least
    bound = f"at most {at_most:g}" if at_most is not None else f"at least {at_least:g}"
    print(f"  {what}: {value:.2f} ({bound}: {'reached' if reached else 'not reached'})", flush=True)


def load_tables(files):
    for file in files:
        size = os.path.getsize(file)
        heading(f"Loading {os.path.basename(file)}, {size:,} bytes")
        row("", "best ms", "median ms", "ns/byte")
        rows = {name.split("/")[1]: found for name, found in benchmark("load", file).items()}
        for name, found in rows.items():
            row(name, f"{found.best / 1e6:.2f}", f"{found.median / 1e6:.2f}", f"{found.median / size:.2f}")
        for peer, most in (("assimp-joined", 0.20), ("assimp", 0.75), ("opencollada", 0.85)):
            if peer in rows:
                goal(f"walkcycle / {peer}", rows["walkcycle"].median / rows[peer].median, at_most=most)


def large_table(megabytes):
    heading("Loading large documents: nanoseconds a byte, and peak memory as a multiple of the file")
    row("", *(f"{m} MB" for m in megabytes), *(f"{m} MB peak" for m in megabytes))
    with tempfile.TemporaryDirectory() as folder:
        for kind in KINDS:
            times, peaks = [], []
            for m in megabytes:
                file = os.path.join(folder, "large.dae")
                subprocess.run([sys.executable, os.path.join(ROOT, "tests/tools/large_document.py"), kind, str(m), file],
                               check=True)
                runs = [processes.run([program("once"), "walkcycle", file], os.environ) for _ in range(3)]
                size = os.path.getsize(file)
                times.append(f"{min(r.cpu for r in runs) * 1e9 / size:.1f}")
                peaks.append(f"{min(r.peak_kib for r in runs) * 1024 / size:.1f}x")
            row(kind, *times, *peaks)


def peak(*arguments):
    """Of a process, MiB; None where it fails."""
    try:
        return min(processes.run([program("once"), *arguments], os.environ).peak_kib for _ in range(3)) / 1024
    except RuntimeError:
        return None


def memory_table(files):
    heading("Peak memory of loading once, MiB beyond what the idle process has")
    importers = ["walkcycle", "assimp", "assimp-joined", "opencollada"]
    row("", *importers)
    idle = peak()
    for file in files:
        peaks = [found and found - idle for found in (peak(importer, file) for importer in importers)]
        row(os.path.basename(file), *("-" if found is None else f"{found:.1f}" for found in peaks))
        if peaks[2]:
            goal("walkcycle / assimp-joined", peaks[0] / peaks[2], at_most=0.5)


def instructions_table(files):
    heading("Instructions a byte, by callgrind, of loadCollada alone")
    for file in files:
        with tempfile.NamedTemporaryFile() as out:
            command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out.name}", "--collect-atstart=no",
                       "--toggle-collect=walkcycle::loadCollada*", program("once"), "walkcycle", file]
            told = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True).stderr
        found = re.search(r"Collected : (\d+)", told)
        if found:
            size = os.path.getsize(file)
            row(os.path.basename(file), f"{int(found[1]):,}", f"{int(found[1]) / size:.1f}")


def pose_table(file):
    heading(f"Posing: sample, hierarchy and palette, nanoseconds a character ({os.path.basename(file)})")
    row("", "best", "median")
    rows = benchmark("pose", file)
    crowd = {}  # by characters and threads
    for name, found in rows.items():
        count = int(re.search(r"/(\d+)", name + "/1")[1])
        row(name.removesuffix("/process_time/real_time"), f"{found.best / count:.0f}", f"{found.median / count:.0f}")
        if named := re.match(r"pose/crowd/(\d+)/(\d+)", name):
            crowd[named[1], named[2]] = found.median / count, found.real_median
    goal("crowd / series", crowd["1", "1"][0] / rows["pose/series"].median, at_most=0.1)
    goal("one of 10,000 / one", crowd["10000", "1"][0] / crowd["1", "1"][0], at_most=1.2)
    goal("2 threads, times one", crowd["10000", "1"][1] / crowd["10000", "2"][1], at_least=1.7)


def skin_table():
    heading("Skinning on the processor: nanoseconds a vertex, four influences, position and normal")
    row("", "best", "median", "/ copy")
    rows = benchmark("skin")
    copy = rows["skin/copy"].median
    for name, found in rows.items():
        row(name, f"{found.best / 2000:.2f}", f"{found.median / 2000:.2f}", f"{found.median / copy:.1f}")
    goal("with what this machine has / copy", min(found.median for name, found in rows.items() if name != "skin/copy") / copy, at_most=8)


def draw_table(file):
    heading(f"Drawing, milliseconds a frame ({os.path.basename(file)})")
    row("", "best", "median", "median of clock")
    rows = {name.replace("/process_time", ""): found for name, found in benchmark("draw", file, repetitions=5).items()}
    for name, found in rows.items():
        row(name, f"{found.best / 1e6:.2f}", f"{found.median / 1e6:.2f}", f"{found.real_median / 1e6:.2f}")
    for ours, theirs, most in (("frame/studio", "frame/bare", 1.15), ("walkers/crowd/100", "walkers/oneByOne/100", 0.75)):
        if ours in rows and theirs in rows:
            goal(f"{ours} / {theirs}", rows[ours].median / rows[theirs].median, at_most=most)


def picture_table(file):
    heading("From the document to a picture")
    processes.print_tables(processes.measure(argparse.Namespace(
        walkcycle=os.path.join(BUILD, "walkcycle"), bare=program("bare_egl") or "", file=file, repeats=11)))


def machine():
    with open("/proc/cpuinfo", encoding="utf-8") as text:
        model = re.search(r"model name\s*: (.*)", text.read())
    commit = subprocess.run(["git", "-C", ROOT, "rev-parse", "--short", "HEAD"], capture_output=True, text=True).stdout
    print(f"{model[1] if model else platform.machine()}, {os.cpu_count()} processors, commit {commit.strip() or '?'}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", nargs="*", metavar="PART|FILE", help="parts: " + " ".join(PARTS))
    parser.add_argument("--megabytes", type=int, nargs="+", default=[1, 15, 59], help="sizes of the large documents")
    arguments = parser.parse_args()
    parts = [what for what in arguments.what if what in PARTS] or PARTS
    files = [what for what in arguments.what if what not in PARTS] or [os.path.join(ROOT, "res/walker.dae")]
    for file in files:
        if not os.path.exists(file):
            parser.error(f"'{file}' is neither a file nor a part (parts: {' '.join(PARTS)})")
    machine()
    tables = {"load": lambda: load_tables(files), "large": lambda: large_table(arguments.megabytes),
              "memory": lambda: memory_table(files), "instructions": lambda: instructions_table(files),
              "pose": lambda: pose_table(files[0]), "skin": skin_table, "draw": lambda: draw_table(files[0]),
              "picture": lambda: picture_table(files[0])}
    needs = {"load": "load", "large": "once", "memory": "once", "instructions": "once"}
    for part in parts:
        if part != "picture" and not program(needs.get(part, part)):
            print(f"\n{part}: bench_{needs.get(part, part)} was not built")
            continue
        tables[part]()


if __name__ == "__main__":
    main()
