"""suite.py [--driver FILE] [--out FOLDER] [SCENE ...]: what the planner's choice costs beside the best of an exhaustive study, for every scene of cases/suite.

Runs the studies of cases/suite/studies into FOLDER (default runs/suite; finished points are kept), plans each scene to 1 % and 0.1 %, runs
the planned case in turn with the study's best one, and prints a Markdown table of medians. Ends with 1 where there is no plan, a target is missed or
the ratio of the CPU times is over 1.5. A second table has predicted over measured CPU times of all points of the studies.

A study sees one moment of a scene. There a wave that is late by whole periods looks right, and a standing wave at its height hardly shows that it
is late. So the study's points that meet the target run in the order of their cost until 0.93 of the time as well, and the cheapest that
meets the target at both, over the sound of the louder, is the best; the planned case is held to both, too, and its error is the larger one.
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
OTHER_END = 0.93


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
    """The run's summary."""
    code, text, why = call(driver, "run", case, "--out", out, "--force", "--threads", 1, "--json")
    if code:
        sys.exit(f"{case}: {why}")
    return json.loads(text)


def compared(driver, files, folder):
    """The files' median CPU times, run in turn."""
    runs = [[run(driver, file, folder / "run") for file in files] for _ in range(TURNS)]
    return [statistics.median(one["cpu_s"] for one in turns) for turns in zip(*runs)]


def worst(driver, document, target, folder, scene):
    """The larger L2 error of a case's run and of one of fewer such steps, both over the louder moment's sound; of the first alone if it is over the target."""
    file = folder / f"{scene}-moment.json"
    document = {**document, "reference": {**document["reference"], "scale": 1}}
    file.write_text(json.dumps(document))
    summary = run(driver, file, folder / "run")
    late, dt = summary["errors"], summary["dt"]
    if not late["l2"] <= target:
        return late["l2"]
    step = {"type": document["integrator"]["type"], "dt": dt}
    file.write_text(json.dumps({**document, "integrator": step, "until": round(OTHER_END * summary["steps"]) * dt}))
    early = run(driver, file, folder / "run")["errors"]
    loud = max(one["rms"] / one["l2"] for one in (late, early))
    return max(late["l2"], early["rms"] / loud)


def row_of(driver, scene, target, points, folder):
    """One line of the table, and whether it keeps what was promised."""
    met = sorted((p for p in points if p["status"] == "done" and p["errors"]["l2"] <= target), key=lambda p: p["cpu_s"])
    best = next((p for p in met if worst(driver, case_of(p), target, folder, scene) <= target), None)
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
    error = worst(driver, json.loads(planned.read_text()), target, folder, scene)
    cost, *others = compared(driver, [planned, chosen] if best else [planned], folder)
    ratio = cost / others[0] if best else 0
    return [scene, f"{100 * target:g} %", f"{error:.2e}", f"{cost:.3g}", name, f"{others[0]:.3g}" if best else "", f"{ratio:.2f}" if best else ""], \
        error <= target and ratio <= MOST


def foretold(scene, points):
    """A line of quartiles of predicted over measured CPU time, and of the share that is within 30 %."""
    ratios = sorted(p["predicted"]["cpu_s"] / p["cpu_s"] for p in points if p["status"] == "done" and p["predicted"] and p["predicted"]["cpu_s"])
    low, middle, high = statistics.quantiles(ratios, n=4)
    near = sum(1 / 1.3 < ratio < 1.3 for ratio in ratios) / len(ratios)
    return f"| {scene} | {len(ratios)} | {low:.2f} | {middle:.2f} | {high:.2f} | {100 * near:.0f} % |"


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
    kept, predictions = True, []
    for scene in given.scenes:
        points = points_of(driver, scene, folder)
        predictions.append(foretold(scene, points))
        for target in TARGETS:
            row, good = row_of(driver, scene, target, points, folder)
            kept = kept and good
            print("| " + " | ".join(row) + " |", flush=True)
    print("\n| scene | points | predicted / measured CPU time: lower quartile | median | upper quartile | within 30 % |\n|---|---:|---:|---:|---:|---:|")
    print("\n".join(predictions))
    return 0 if kept else 1


if __name__ == "__main__":
    sys.exit(main())
