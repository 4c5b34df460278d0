# Sourced by errors.sh: what steps cost on this machine.
echo "--- calibrate"
sphonic check case.json --json
[[ $code == 0 && $out == *"costs of the reference machine"* ]] && ok "check names the reference machine" || failed "check names the reference machine" "$code" "$err" "$out"
timeout 300 "$driver" calibrate --json >costs.json 2>err </dev/null
units=$(grep -c per_neighbour_ns costs.json)
[[ $units == 37 && -s $XDG_CACHE_HOME/sphonic/costs.json ]] && ok "calibrate measures every tier and keeps it" || failed "calibrate measures every tier and keeps it" "$units" "$(<err)"
sphonic check case.json --json
[[ $code == 0 && $out == *"calibrated costs of this machine"* ]] && ok "check takes calibrated costs" || failed "check takes calibrated costs" "$code" "$err" "$out"
echo "{" >"$XDG_CACHE_HOME/sphonic/costs.json"
sphonic check case.json --json
[[ $code == 0 && $out == *"costs of the reference machine"* ]] && ok "a damaged file of costs is passed over" || failed "a damaged file of costs is passed over" "$code" "$err" "$out"
rm -rf "$XDG_CACHE_HOME"
