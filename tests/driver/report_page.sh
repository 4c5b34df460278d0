#!/usr/bin/env bash
# The report of a study in a real browser. Ends with 77, which skips the test, where Chromium, Node.js or the page's scripts are not installed.
#
#   report_page.sh DRIVER REPOSITORY
set -euo pipefail

driver=$(readlink -f -- "$1")
repository=$(readlink -f -- "$2")
chromium=$(command -v chromium || command -v chromium-browser) || { echo "skipped: there is no Chromium"; exit 77; }
command -v node >/dev/null || { echo "skipped: there is no Node.js"; exit 77; }
[[ -d $repository/apps/report/node_modules/playwright-core ]] || { echo "skipped: npm ci was not run in apps/report"; exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
cd -- "$scratch"
unset SPHONIC_PLUGIN_PATH

cp "$repository/cases/li2015/propagation.json" case.json
cat >study.json <<'JSON'
{ "title": "A page </script><b>that is shown</b>", "case": "case.json", "measure": ["errors.l2", "errors.max"], "vary": [
  { "name": "form", "values": [ { "label": "plain </script><script>wrong = 1</script>", "family": "fine", "set": { "/viscosity/alpha": 0 } },
                                { "label": "thick", "family": "<i>coarse</i>", "set": { "/particles/dx": 0.16, "/kernel/h": 0.52 } } ] },
  { "name": "C", "values": [ { "label": 0.2, "set": { "/until": 0.004, "/integrator": { "type": "symplectic_euler", "courant": 0.2 } } },
                             { "label": 0.02, "set": { "/until": 0.004, "/integrator": { "type": "symplectic_euler", "courant": 0.02 } } } ] } ],
  "charts": [ { "type": "cost", "name": "cost" } ] }
JSON
"$driver" study study.json --out studied --report >/dev/null
node "$repository/tests/driver/report_page.cjs" "$chromium" "$repository/apps/report" "$scratch/studied/report.html"
