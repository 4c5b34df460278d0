# Sourced by errors.sh: the atlas of failures.
# shellcheck shell=bash disable=SC2154,SC2015,SC2016  # of errors.sh; ok and failed always succeed; JSON in quotes

echo "--- atlas"
misused 2 'nowhere/studies/atlas.json: there is no such file. Check the path' atlas nowhere
misused 2 '--row: there is no row "checkerbord" in *. Did you mean "checkerboard"?' atlas "$repository/cases/failures" --row checkerbord --out parent/out
mkdir -p wrong/studies
told() { printf '{ "title": "t", "rows": [ { "name": "n", "title": "t", "failure": "f", "cure": "c", "case": "../../case.json", "fails": "errs", %s, "failures": [ { "name": "as it stands" } ], "cures": [ { "name": "as it stands" } ] } ] }' "$1" >wrong/studies/atlas.json; }
told '"bad": 1'
misused 2 'wrong/studies/atlas.json: /rows/0/good: *' atlas wrong --out parent/out
told '"bad": 0.5, "good": 0.1, "picture": "portrait"'
misused 2 'wrong/studies/atlas.json: /rows/0/picture: *' atlas wrong --out parent/out
told '"bad": 0.5, "good": 0.5, "picture": "profile"'
sphonic atlas wrong --out atlas
[[ $code == 3 && $err == 'wrong/studies/atlas.json: row n did not come out as it is told' && $out == *'NOT AS TOLD'* && -s atlas/atlas.html && -s atlas/n.png ]] &&
    ok "an atlas whose failure does not show ends with exit code 3" || failed "an atlas whose failure does not show ends with exit code 3" "$code" "$err" "$out"
sphonic atlas "$repository/cases/failures" --row checkerboard --out atlas --force --json
[[ $code == 0 && -z $err && $out == *'"as_told": true'* && $(<atlas/atlas.html) == *'<svg'* && $(<atlas/atlas.html) != *'href="http'* ]] &&
    ok "an atlas is one page" || failed "an atlas is one page" "$code" "$err" "$out"
