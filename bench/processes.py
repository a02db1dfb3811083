#!/usr/bin/python3
"""What whole processes cost: from a document to a picture, against f3d and against the least that EGL needs.

    bench/processes.py --walkcycle build/walkcycle --bare build/bench/bench_bare_egl FILE.dae [--repeats 15]

Each round runs every competitor once, so that a busy moment hits all of them; best and median are printed, as JSON
with --json. CPU seconds and peak memory are the kernel's own (wait4). `warm`: Mesa's shader cache has seen these
shaders; `cold`: it is empty. f3d draws through an X server (Xvfb), whose time is not counted.
"""
import argparse
import json
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time


class Ran:
    def __init__(self, cpu, wall, peak_kib):
        self.cpu, self.wall, self.peak_kib = cpu, wall, peak_kib


def run(command, environment):
    """One process from start to end. Its output is thrown away; that it succeeds is part of the deal."""
    with open(os.devnull, "r+b") as nothing:
        started = time.monotonic()
        child = subprocess.Popen(command, env=environment, stdin=nothing, stdout=nothing, stderr=nothing)
        _, status, usage = os.wait4(child.pid, 0)
        wall = time.monotonic() - started
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        raise RuntimeError(f"{' '.join(command)}: exit code {child.returncode}")
    return Ran(usage.ru_utime + usage.ru_stime, wall, usage.ru_maxrss)


class Competitor:
    """A command, and the state of the shader cache that it finds."""

    def __init__(self, name, command, cache, display=None):
        self.name, self.command, self.cache, self.display = name, command, cache, display
        self.runs = []

    def environment(self, cache_folder):
        environment = dict(os.environ, MESA_SHADER_CACHE_DIR=cache_folder)
        environment.pop("DISPLAY", None)
        if self.display:
            environment["DISPLAY"] = self.display
        return environment

    def once(self, folder):
        if self.cache == "warm":
            return run(self.command, self.environment(os.path.join(folder, "warm-" + self.name)))
        with tempfile.TemporaryDirectory(dir=folder) as empty:
            return run(self.command, self.environment(empty))

    def summary(self):
        cpu, wall = [r.cpu for r in self.runs], [r.wall for r in self.runs]
        return {"cpu_best_ms": min(cpu) * 1e3, "cpu_median_ms": statistics.median(cpu) * 1e3,
                "wall_best_ms": min(wall) * 1e3, "wall_median_ms": statistics.median(wall) * 1e3,
                "peak_mib": max(r.peak_kib for r in self.runs) / 1024.0}


class Display:
    """An X server of our own for f3d; None where there is none to start."""

    def __enter__(self):
        self.server = None
        if not shutil.which("Xvfb"):
            return None
        number, write_end = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write_end), "-screen", "0", "1280x1024x24", "-nolisten", "tcp"],
            pass_fds=[write_end], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write_end)
        with os.fdopen(number) as told:
            display = told.readline().strip()
        return ":" + display if display else None

    def __exit__(self, *error):
        if self.server:
            self.server.terminate()
            self.server.wait()


def competitors(arguments, folder, display):
    picture = os.path.join(folder, "picture.png")
    render = [arguments.walkcycle, "render", arguments.file, "--resolution", "640,480", "-q", "-o", picture]
    f3d = ["f3d", arguments.file, "--resolution", "640,480", "--output", picture]
    found = [Competitor("info", [arguments.walkcycle, "info", arguments.file], "warm")]
    for cache in ("warm", "cold"):
        found.append(Competitor("render " + cache, render, cache))
        if arguments.bare and os.path.exists(arguments.bare):
            found.append(Competitor("bare EGL " + cache, [arguments.bare], cache))
        if display and shutil.which("f3d"):
            found.append(Competitor("f3d " + cache, f3d, cache, display))
    return found


GOALS = [("render warm", "f3d warm", 0.30), ("render cold", "f3d cold", 0.45), ("render warm", "bare EGL warm", 2.0)]


def ratios(summaries):
    found = []
    for ours, theirs, goal in GOALS:
        if ours not in summaries or theirs not in summaries:
            continue
        row = {"ours": ours, "theirs": theirs, "at_most": goal}
        for key in ("cpu_best", "cpu_median", "wall_best", "wall_median"):
            row[key] = summaries[ours][key + "_ms"] / summaries[theirs][key + "_ms"]
        found.append(row)
    return found


def measure(arguments):
    with tempfile.TemporaryDirectory() as folder, Display() as display:
        everyone = competitors(arguments, folder, display)
        for competitor in everyone:
            competitor.once(folder)  # fills the caches: the disk's, and Mesa's where it is to be warm
        for _ in range(arguments.repeats):
            for competitor in everyone:
                competitor.runs.append(competitor.once(folder))
    summaries = {competitor.name: competitor.summary() for competitor in everyone}
    return {"file": os.path.basename(arguments.file), "repeats": arguments.repeats, "load": os.getloadavg(),
            "processes": summaries, "ratios": ratios(summaries)}


def print_tables(result):
    print(f"Whole processes, {result['file']}, 640x480, {result['repeats']} rounds, "
          f"load {result['load'][0]:.1f} (milliseconds: best, median)")
    print(f"{'':16}{'CPU':>16}{'wall':>16}{'peak MiB':>10}")
    for name, s in result["processes"].items():
        print(f"{name:16}{s['cpu_best_ms']:8.1f}{s['cpu_median_ms']:8.1f}{s['wall_best_ms']:8.1f}"
              f"{s['wall_median_ms']:8.1f}{s['peak_mib']:10.1f}")
    for row in result["ratios"]:
        print(f"{row['ours']} / {row['theirs']}: CPU {row['cpu_best']:.2f} {row['cpu_median']:.2f}, "
              f"wall {row['wall_best']:.2f} {row['wall_median']:.2f} (at most {row['at_most']:.2f})")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file")
    parser.add_argument("--walkcycle", default="build/walkcycle")
    parser.add_argument("--bare", default="build/bench/bench_bare_egl")
    parser.add_argument("--repeats", type=int, default=15)
    parser.add_argument("--json", action="store_true")
    arguments = parser.parse_args()
    result = measure(arguments)
    if arguments.json:
        json.dump(result, sys.stdout, indent=1)
        print()
    else:
        print_tables(result)


if __name__ == "__main__":
    main()
