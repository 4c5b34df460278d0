# Sourced by errors.sh: obstacles that check and run must both refuse, and what they only warn of.
# shellcheck shell=bash disable=SC2154,SC2016  # JSON in quotes

echo "--- obstacles"
# at_circle MEMBERS OPTIONS...: options of the flat case with a circle of these members besides.
at_circle() { circle=("${flat[@]}" --set '/particles/upper=[4,3]' --set '/obstacles=[{"type":"circle","centre":[2,1.5],"radius":0.5'"$1"'}]' "${@:2}"); }
refused 2 'case.json: /obstacles: {} is not a list. Write [ { "type": ... } ]' --set '/obstacles={}'
refused 2 'case.json: /obstacles/0: 3 is not an object. Write { ... } here' --set '/obstacles=[3]'
refused_like 2 'case.json: /obstacles/0/type: is missing. Name a shape: circle, expression, polygon' --set '/obstacles=[{}]'
refused 2 'case.json: /obstacles/0/type: there is no shape named "cirle". Did you mean "circle"?' --set '/obstacles=[{"type":"cirle"}]'
refused 2 'case.json: /obstacles/0: a circle needs two or three dimensions: in one, close the box by boundaries' --set '/obstacles=[{"type":"circle","radius":1}]'
refused 2 'case.json: /obstacles/0/radius: is missing. radius [m] must be greater than 0' "${flat[@]}" --set '/obstacles=[{"type":"circle"}]'
refused 2 'case.json: /obstacles/0/centre: [1] does not fit dimension 2. Give a list of 2 numbers' "${flat[@]}" --set '/obstacles=[{"type":"circle","radius":1,"centre":[1]}]'
at_circle ',"wall":"hard"'
refused 2 'case.json: /obstacles/0/wall: "hard" is not one of rigid, soft, free' "${circle[@]}"
at_circle ',"keep":"both"'
refused 2 'case.json: /obstacles/0/keep: "both" is not one of outside, inside' "${circle[@]}"
at_circle ',"wal":"soft"'
refused 2 'case.json: /obstacles/0/wal: unknown key "wal". Did you mean "wall"?' "${circle[@]}"
at_circle ''
refused 2 'case.json: /particles/motion: "lagrangian" particles would run into the obstacles. Use "auto", which keeps them where they are' "${circle[@]}" --set /particles/motion=lagrangian
refused 2 'case.json: /particles/neighbours: "lattice" needs a full lattice, and obstacles cut particles out of it. Use "auto"' "${circle[@]}" --set /particles/neighbours=lattice
refused 2 'case.json: /obstacles: method kspace knows no obstacles. Use method "particles", or "fdtd", which takes them as a staircase' "${circle[@]}" --set '/method={"type":"kspace"}'
refused 2 'case.json: /equations/p/0/form: this form'"'"'s weights are made for waves without obstacles. Use another form, such as "corrected"' "${circle[@]}" --set /equations=band_fitted_acoustics
refused_like 2 'case.json: /boundaries/0: it continues a frozen lattice by layers of virtual particles, and this set is another one. *' "${circle[@]}" --set '/boundaries=[{"type":"absorbing_mur","face":"x_max"}]'
refused 2 'case.json: /obstacles: they leave 0 of 9576 particles. Make the solid smaller, or keep the shape'"'"'s other side' "${circle[@]}" --set /obstacles/0/radius=9
refused 2 'case.json: /obstacles/0: surface is missing: give an expression that is zero on it and positive outside the body' "${circle[@]}" --set '/obstacles=[{"type":"expression"}]'
refused 2 'case.json: /obstacles/0: "x^2 +": something is missing at the end. Complete it' "${circle[@]}" --set '/obstacles=[{"type":"expression","surface":"x^2 +"}]'
refused 2 'case.json: /obstacles: surface: "log(x)" is not finite in the whole box: choose an expression that is' "${circle[@]}" --set '/obstacles=[{"type":"expression","surface":"log(x)"}]'
refused 2 'case.json: /obstacles/0: corners: "1" is no corner: give x and y, and commas between corners' "${circle[@]}" --set '/obstacles=[{"type":"polygon","corners":"1"}]'

# warned WHAT PATTERN OPTIONS...: check takes the case and says so.
warned() {
    sphonic check case.json "${@:3}"
    # shellcheck disable=SC2053  # a pattern
    [[ $code == 0 && $err == $2 ]] && ok "warned: $1" || failed "warned: $1" "exit code: $code" "stderr:   $err" "expected: $2"
}
at_circle ''
warned "a body that is not in the way" '*/obstacles/0: no particle lies in the solid, and it acts through those that it cuts out: it changes nothing*' "${circle[@]}" --set '/obstacles/0/centre=[9,9]'
warned "a thin body" '*/obstacles/0: it is thinner than twice the reach of the weights, 0.16 m: what is behind one side of it acts on the other too*' "${circle[@]}" --set /obstacles/0/radius=0.06
