"""suite.py [--driver FILE] [--out FOLDER] [SCENE ...]: what the planner's choice costs beside the best of an exhaustive study, for every scene of cases/suite.

Runs the studies of cases/suite/studies into FOLDER (default runs/suite; finished points are kept), plans each scene to 1 % and 0.1 %, runs
the planned case in turn with the study's best one, and prints a Markdown table of medians. Ends with 1 where there is no plan, a target is missed or
the ratio of the CPU times is over 1.5. A study sees one moment of a scene: where a wave is late by whole periods its best may be luck,
which the planner, who looks at a second moment too, does not chase.
"""
import argparse
import json
import pathlib
import statistics
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENES = ["propagation_1d", "standing_wave_2d", "air_water", "circle_scattering_2d", "jittered_box", "pulse_3d_absorbed"]
TARGETS = [0.01, 0.001]
MOST = 1.5       # planned over best CPU time
TURNS = 5


def call(driver, *words, limit=None):
    """Runs the driver; its exit code, stdout and last line of stderr."""
    done = subprocess.run([driver, *map(str, words)], cwd=ROOT, capture_output=True, text=True, timeout=limit, check=False)
    return done.returncode, done.stdout, (done.stderr.strip().splitlines() or [""])[-1]


def points_of(driver, scene, folder):
    """The points of the scene's exhaustive study."""
    code, _, why = call(driver, "study", f"cases/suite/studies/{scene}.json", "--out", folder / scene)
    if code:
        sys.exit(f"{scene}: {why}")
    return [json.loads(line) for line in (folder / scene / "points.jsonl").read_text().splitlines()]


def set_at(document, pointer, value):
    *path, last = [part.replace("~1", "/").replace("~0", "~") for part in pointer.split("/")[1:]]
    for part in path:
        document = document[int(part)] if isinstance(document, list) else document.setdefault(part, {})
    if isinstance(document, list):
        document[int(last)] = value
    else:
        document[last] = value


def case_of(point):
    """The whole case of a study's point."""
    document = json.loads((ROOT / point["case"]).read_text())
    for pointer in point["remove"]:
        *path, last = pointer.split("/")[1:]
        holder = document
        for part in path:
            holder = holder[int(part)] if isinstance(holder, list) else holder.get(part, {})
        holder.pop(last, None)
    for pointer, value in point["set"].items():
        set_at(document, pointer, value)
    return document


def run(driver, case, out):
    """L2 error and CPU time of stepping."""
    code, text, why = call(driver, "run", case, "--out", out, "--force", "--threads", 1, "--json")
    if code:
        sys.exit(f"{case}: {why}")
    summary = json.loads(text)
    return summary["errors"]["l2"], summary["cpu_s"]


def compared(driver, files, folder):
    """The files' errors and median CPU times, run in turn."""
    runs = [[run(driver, file, folder / "run") for file in files] for _ in range(TURNS)]
    return [(turns[0][0], statistics.median(cpu for _, cpu in turns)) for turns in zip(*runs)]


def row_of(driver, scene, target, points, folder):
    """One line of the table, and whether it keeps what was promised."""
    met = [p for p in points if p["status"] == "done" and p["errors"]["l2"] <= target]
    best = min(met, key=lambda p: p["cpu_s"], default=None)
    planned, chosen = folder / f"{scene}-{target:g}-planned.json", folder / f"{scene}-{target:g}-best.json"
    name = f'{best["family"]}, {", ".join(map(str, best["labels"].values()))}' if best else "none meets it"
    try:
        code, _, why = call(driver, "plan", f"cases/suite/{scene}.json", "--free", "--target", target, "--out", planned, "--force", limit=600)
    except subprocess.TimeoutExpired:
        code, why = 1, "no plan within ten minutes"
    if code:
        return [scene, f"{100 * target:g} %", "", "", name, f'{best["cpu_s"]:.3g}' if best else "", f"no plan: {why.split('target: ')[-1]}"], False
    if best:
        chosen.write_text(json.dumps(case_of(best)))
    (error, cost), *others = compared(driver, [planned, chosen] if best else [planned], folder)
    ratio = cost / others[0][1] if best else 0
    return [scene, f"{100 * target:g} %", f"{error:.2e}", f"{cost:.3g}", name, f"{others[0][1]:.3g}" if best else "", f"{ratio:.2f}" if best else ""], \
        error <= target and ratio <= MOST


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--driver", type=pathlib.Path, default=ROOT / "build/release/bin/sphonic")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "runs/suite", metavar="FOLDER")
    parser.add_argument("scenes", nargs="*", default=SCENES, metavar="SCENE")
    given = parser.parse_args()
    driver, folder = str(given.driver.resolve()), given.out.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    print("| scene | target | L2 of the plan | CPU of the plan [s] | cheapest of the study | its CPU [s] | ratio |")
    print("|---|---|---:|---:|---|---:|---:|")
    kept = True
    for scene in given.scenes:
        points = points_of(driver, scene, folder)
        for target in TARGETS:
            row, good = row_of(driver, scene, target, points, folder)
            kept = kept and good
            print("| " + " | ".join(row) + " |", flush=True)
    return 0 if kept else 1


if __name__ == "__main__":
    sys.exit(main())
