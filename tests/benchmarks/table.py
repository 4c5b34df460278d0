"""table.py JSON COMMIT: the medians of bench_steps as one Markdown table, beside targets, finite differences and the roofline."""
import json
import platform
import sys

# what is limited, the limit, and what it is counted in: nanoseconds per unit, or multiples of another benchmark
TARGETS = {
    "lattice_1d": (1.8, "ns"),
    "lattice_1d_monaghan": (2.3, "lattice_1d"),
    "lattice_2d": (4.5, "plain_fdtd_2d"),
    "lattice_2d_walls_corrected": (1.05, "lattice_2d_walls"),
    "lattice_3d": (5, "plain_fdtd_3d"),
    "frozen_2d_gradient": (2, "ns"),
    "frozen_2d_divergence": (2, "ns"),
    "frozen_2d_momentum_monaghan": (4, "ns"),
    "moving_2d_monaghan": (4.5, "ns"),
    "moving_3d_monaghan": (4.5, "ns"),
    "moving_2d_both_sides_monaghan": (4.5, "ns"),
    "moving_3d_both_sides_monaghan": (4.5, "ns"),
    "rebuilding_vortices_2d": (25, "% rebuilding"),
    "rebuilding_vortices_3d": (25, "% rebuilding"),
    "rebuilding_standing_wave_2d": (25, "% rebuilding"),
    "rebuilding_standing_wave_3d": (25, "% rebuilding"),
}
BY_PAIR = ("frozen", "moving", "rebuilding")
TRIADS = ("triad/3072", "triad/786432", "triad/25165824")


def processor():
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as lines:
            return next(line.split(":", 1)[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.machine()


def medians(document):
    rows = [b for b in document["benchmarks"] if b.get("aggregate_name") == "median"]
    return {row["run_name"]: row for row in sorted(rows, key=lambda row: row["family_index"] * 1000 + row["per_family_instance_index"])}


def cost(name, row):
    """Nanoseconds and the unit that they are for."""
    units = [key[3:] for key in row if key.startswith("ns/")]
    unit = "pair" if name.startswith(BY_PAIR) and "pair" in units else next(u for u in units if u != "pair" or len(units) == 1)
    return row["ns/" + unit], unit


def roofline(row, rows):
    """The share of the time that arithmetic or memory traffic alone would take, whichever is longer."""
    if "bytes" not in row or TRIADS[0] not in rows or "fused_multiply_add" not in rows:
        return None
    level = TRIADS[0] if row["footprint"] < 5e4 else TRIADS[1] if row["footprint"] < 2e7 else TRIADS[2]
    return max(row["bytes"] * rows[level]["ns/byte"], row["flops"] * rows["fused_multiply_add"]["ns/flop"])


def target(name, ns, rows):
    """Measured in the target's own terms, and the target."""
    plain = name.split("/iterations")[0]
    if plain not in TARGETS:
        return "", ""
    limit, of = TARGETS[plain]
    if of == "ns":
        return f"{ns / limit:.2f}", f"{limit} ns"
    if of == "% rebuilding":
        share, narrowing = 100 * rows[name]["rebuilding"], 100 * rows[name]["narrowing"]
        return f"{share / limit:.2f}", f"{limit} % rebuilding ({share:.0f} %, and {narrowing:.0f} % narrowing lists down)"
    if of not in rows:
        return "", f"{limit} x {of}"
    return f"{ns / cost(of, rows[of])[0] / limit:.2f}", f"{limit} x {of}"


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        document = json.load(file)
    rows = medians(document)
    print(f"{processor()}, commit {sys.argv[2]}, one thread, double precision\n")
    print("| benchmark | ns | per | times plain FDTD | share of roofline | predicted / measured | target | measured / target |")
    print("|---|---|---|---|---|---|---|---|")
    for name, row in rows.items():
        ns, unit = cost(name, row)
        dimension = next((d for d in ("1d", "2d", "3d") if "_" + d in name), None)
        fdtd = rows.get(f"plain_fdtd_{dimension}")
        times = f"{ns / cost('', fdtd)[0]:.2f}" if fdtd and unit == "particle-step" else ""
        floor = roofline(row, rows)
        share = f"{floor / ns:.2f}" if floor else ""
        predicted = f"{row['predicted'] / row['ns/particle-step']:.2f}" if "predicted" in row else ""
        ratio, limit = target(name, ns, rows)
        print(f"| {name} | {ns:.3g} | {unit} | {times} | {share} | {predicted} | {limit} | {ratio} |")


main()
