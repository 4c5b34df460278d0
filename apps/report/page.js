// The interactive chart of a study's report: error against CPU time.
// The page gives #study (JSON: {norms, floors, points}; what lies below a floor is drawn there) and the elements #norm, #families and #chart.
"use strict";

const study = JSON.parse(document.getElementById("study").textContent);
const colours = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#666666"];
const shapes = { "circle": "\u25cf", "square": "\u25a0", "triangle-up": "\u25b2", "diamond": "\u25c6", "triangle-down": "\u25bc", "cross": "\u271a", "triangle-left": "\u25c0", "triangle-right": "\u25b6" };
const families = [...new Set(study.points.map((point) => point.family))];
const hidden = new Set();
const norm = document.getElementById("norm");

// Whole configuration of a point, under the names that the pointer shows.
function configuration(point) {
    const told = { point: point.name, family: point.family, ...point.labels };
    for (const { key, name } of study.norms) told[name] = point[key] === null ? "" : point[key].toPrecision(4);
    told["CPU time [s]"] = point.cpu_s.toPrecision(3) + (point.spread ? ` (${point.spread})` : "") + (point.doubt ? `, in doubt: ${point.doubt}` : "");
    return { ...told, "steps": point.steps, "particles": point.particles, "tier": point.tier, "case": point.case, ...point.changes };
}

// Points that none of a list beats, by cost.
function front(points, cost = "cpu_s", error = "error") {
    let best = Infinity;
    return [...points].sort((a, b) => a[cost] - b[cost] || a[error] - b[error]).filter((point) => point[error] < best && ((best = point[error]), true));
}

// What is foreseen of the best of each family.
function foreseen(points) {
    const known = points.filter((point) => point.predicted_l2 > 0 && point.predicted_cpu_s > 0);
    return families.flatMap((family) => front(known.filter((point) => point.family === family), "predicted_cpu_s", "predicted_l2"));
}

function shown_points() {
    const floor = study.floors[norm.value] || 0;
    const shown = (point) => point.error > 0 && point.cpu_s > 0 && !hidden.has(point.family);
    return study.points.map((point) => ({ ...point, error: point[norm.value] && Math.max(point[norm.value], floor) })).filter(shown);
}

function shape(_, index) {
    return Object.keys(shapes)[index % Object.keys(shapes).length];
}

function specification(shown) {
    const points = shown.map((point) => ({ ...point, told: configuration(point) }));
    const predicted = norm.value === "errors.l2" ? foreseen(points) : [];
    const axis = (field, title) => ({ field, type: "quantitative", title, scale: { type: "log" }, axis: { format: "~e", tickCount: 6 } });
    const cost = (field) => axis(field, "CPU time of stepping [s]"), error = (field) => axis(field, study.norms.find(({ key }) => key === norm.value).name);
    const colour = { field: "family", type: "nominal", scale: { domain: families, range: families.map((_, i) => colours[i % colours.length]) }, legend: null };
    return {
        background: "white", width: "container", height: 480, autosize: { type: "fit", contains: "padding" },
        config: { font: "DejaVu Sans, Verdana, sans-serif", axis: { labelFontSize: 13, titleFontSize: 14, gridColor: "#e4e4e4" } },
        layer: [
            ...(predicted.length ? [{ data: { values: predicted }, mark: { type: "line", strokeDash: [6, 4] },
                                      encoding: { x: cost("predicted_cpu_s"), y: error("predicted_l2"), color: colour } }] : []),
            { data: { values: front(points) }, mark: { type: "line", interpolate: "step-after", color: "#555555", strokeWidth: 2.5 },
              encoding: { x: cost("cpu_s"), y: error("error") } },
            { data: { values: points }, mark: { type: "point", filled: true, size: 110, opacity: 1, tooltip: { content: "data" } },
              encoding: { x: cost("cpu_s"), y: error("error"), color: colour,
                          shape: { field: "family", type: "nominal", scale: { domain: families, range: families.map(shape) }, legend: null },
                          tooltip: { field: "told" }, description: { field: "name" } } },
        ],
    };
}

// What the pointer shows of a point; texts of the study are never taken for markup.
function tell(handler, event, item, value) {
    const box = document.getElementById("told");
    box.hidden = !value;
    if (!value) return;
    box.replaceChildren(...Object.entries(item.datum.told).map(([name, text]) => {
        const row = document.createElement("div"), key = document.createElement("b");
        key.textContent = name + ": ";
        row.append(key, typeof text === "object" ? JSON.stringify(text) : String(text));
        return row;
    }));
    box.style.left = Math.min(event.pageX + 14, document.documentElement.clientWidth - box.offsetWidth - 8) + "px";
    box.style.top = event.pageY + 14 + "px";
}

function draw() {
    const points = shown_points(), chart = document.getElementById("chart");
    if (points.length) vegaEmbed(chart, specification(points), { actions: false, renderer: "svg", tooltip: tell, mode: "vega-lite" });
    else chart.replaceChildren("No point is shown.");
}

function legend_entry(family, index) {
    const label = document.createElement("label"), box = document.createElement("input"), mark = document.createElement("span");
    box.type = "checkbox";
    box.checked = true;
    box.addEventListener("change", () => {
        if (box.checked) hidden.delete(family);
        else hidden.add(family);
        draw();
    });
    mark.className = "mark";
    mark.style.color = colours[index % colours.length];
    mark.textContent = shapes[shape(family, index)];
    label.append(box, mark, family || "all points");
    return label;
}

norm.append(...study.norms.map(({ key, name }) => new Option(name, key)));
norm.addEventListener("change", draw);
document.getElementById("families").append(...families.map(legend_entry));
draw();
