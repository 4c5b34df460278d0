# Sourced by errors.sh: cases that check and run must both refuse.
# shellcheck shell=bash disable=SC2154,SC2016  # JSON in quotes

echo "--- names"
refused 2 'case.json: /kernel/typ: unknown key "typ". Did you mean "type"?' --set /kernel/typ=gaussian
refused 2 'case.json: /kernel/typ: unknown key "typ". Did you mean "type"?' --set '/kernel={"typ":"cubic_spline","h":0.04}'
refused 2 'case.json: /methd: unknown key "methd". Did you mean "method"?' --set '/methd={"type":"fdtd"}'
refused 2 'case.json: /reference/regoin: unknown key "regoin". Did you mean "region"?' --set '/reference={"type":"plane_wave_front","regoin":"x > 0"}'
refused 2 'case.json: /kernel/type: there is no kernel named "cubic_splin". Did you mean "cubic_spline"?' --set /kernel/type=cubic_splin
refused_like 2 'case.json: /kernel/type: there is no kernel named "sponge". Known: *cubic_spline, gaussian, *quintic_spline*' --set /kernel/type=sponge
refused_like 2 'case.json: /equations: there are no equations named "linear_acustics". *linear_acoustics*' --set /equations=linear_acustics
refused 2 'case.json: /particles/motion: "frozn" is not one of auto, frozen, lagrangian. Did you mean "frozen"?' --set /particles/motion=frozn

refused_like 2 'case.json: /threads: unknown key "threads". Known here: *boundaries, dimension, *' --set /threads=3
refused 2 'case.json: /sources/0/omga: unknown key "omga". Did you mean "omega"?' --set "$(source_is '{"type":"plane_wave","omga":3,"region":"x < 0"}')"
refused 2 'case.json: /kernel/hh: unknown key "hh". Did you mean "h"?' --set '/kernel={"type":"cubic_spline","hh":0.04}'
refused 2 'case.json: /kernels: "" is no name of a kernel. Give it one that terms can refer to' --set '/kernels={"":{"type":"cubic_spline","h":0.04}}'
refused 2 'case.json: /particles/velocity: "v" is no vector of the equations. Name the variable that moves the particles, or leave it out' --set /particles/velocity=v
refused 2 'case.json: /particles/velocity: "p" is no vector of the equations. Name the variable that moves the particles, or set "motion": "frozen"' --set /particles/velocity=p --set /particles/motion=lagrangian
refused 2 'case.json: /$schema: 3 is not a string. Give a string' --set '/$schema=3'

echo "--- methods"
refused_like 2 '*case.json: /method: method kspace: the box must repeat or absorb, and its face x_min does neither: *' --set '/method={"type":"kspace"}'
refused_like 2 '*case.json: /method: method fdtd: the boundary of x_max is made for one layer of points, and order 4 needs two: *' \
    --set '/method={"type":"fdtd","order":4}' --set '/boundaries=[{"type":"absorbing_mur","face":"x_max"}]'

refused_like 2 '*case.json: /method: method fdtd: the boundary of x_max gives way, *' --set '/method={"type":"fdtd"}' --set '/boundaries=[{"type":"impedance","face":"x_max","impedance":400}]'

echo "--- what is still to be planned"
for key in method equations kernel integrator integrator/type integrator/courant particles/dx; do
    refused 2 "case.json: /$key: \"auto\" is still to be planned. Give the case an \"accuracy\", such as { \"target\": 0.01 }, or use plan and then the case that it writes" --set "/$key=auto"
done
refused_like 2 'case.json: /boundaries/0/attenuation: "auto" is still to be planned. *' --set '/boundaries=[{"type":"absorbing_layer","face":"x_max","thickness":1,"attenuation":"auto"}]'

echo "--- types"
for key in viscosity dissipation kernel kernels reference initial output particles integrator method; do
    refused 2 "case.json: /$key: [] is not an object. Write { ... } here" --set "/$key=[]"
    refused 2 "case.json: /$key: null is not an object. Write { ... } here" --set "/$key=null"
done
refused 2 'case.json: /medium: null is not an object. Write { ... } here' --set /medium=null
refused 2 'case.json: /medium: the list is empty. Give { "c0": sound speed [m/s], "rho0": density [kg/m^3] }' --set '/medium=[]'
refused 2 'case.json: /medium/1/region: is missing. Give a condition on x, y, z, r: the first medium fills the box, the others their regions' --set '/medium=[{"c0":340,"rho0":1},{"c0":340,"rho0":1}]'
refused 2 'case.json: /medium/0/region: unknown key "region". Known here: c0, rho0' --set '/medium=[{"c0":340,"rho0":1,"region":"x > 0"}]'
refused 2 'case.json: /equations: [] is not an object. Write { ... } here' --set '/equations=[]'
refused 2 'case.json: /provenance: 3 is not an object. Leave it out' --set /provenance=3
refused 2 'case.json: /sources: {} is not a list. Write [ { "type": ... } ]' --set '/sources={}'
refused 2 'case.json: /sources/0: "plane_wave" is not an object. Write { ... } here' --set '/sources=["plane_wave"]'
refused 2 'case.json: /boundaries: {} is not a list. Write [ { "type": ..., "face": ... } ]' --set '/boundaries={}'
refused 2 'case.json: /output/probes: {} is not a list. Write [[x, y], ...]' --set '/output/probes={}'
refused 2 'case.json: /output/probes/0: 2.0 does not fit dimension 1. Give a list of 1 number' --set '/output/probes=[2.0]'
refused 2 'case.json: /output/probes/1/0: "a" is not a number. Give a number' --set '/output/probes=[[2.0],["a"]]'
refused 2 'case.json: /particles/lower/0: true is not a number. Give a number' --set '/particles/lower=[true]'
refused 2 'case.json: /sources/0/direction/0: "a" is not a number. Give a number' --set '/sources/0/direction=["a"]'
refused 2 'case.json: /sources/0/direction: [] is not a list of one to three numbers. Give one number per dimension' --set '/sources/0/direction=[]'
refused 2 'case.json: /kernel/type: 3 is not a string. Name a kernel' --set /kernel/type=3
refused 2 'case.json: /until: "" is not a number. Give a number' --set /until=
refused 2 'case.json: /until: [1] is not a number. Give a number' --set '/until=[1]'
refused 2 'case.json: /title: the text is empty. Give a title, or leave it out: it is then the file'"'"'s name' --set /title=
refused 2 'case.json: /dimension: 1.5 is not a dimension. Give 1, 2 or 3' --set /dimension=1.5
refused 2 'case.json: /particles/seed: 1.5 is not an integer. Give an integer' --set /particles/seed=1.5
refused 2 'case.json: /particles/seed: 1e+300 is not an integer. Give an integer' --set /particles/seed=1e300
refused 2 'case.json: /initial/u: "0" does not fit this variable. Give a list of 1 expressions' --set '/initial={"u":"0"}'
refused 2 'case.json: /initial/p: 3 does not fit this variable. Give an expression' --set '/initial={"p":3}'
refused 2 'case.json: /initial/q: unknown key "q". Known here: p, u' --set '/initial={"q":"0"}'

echo "--- values"
lattice=(--set '/particles/motion="frozen"' --set /precision=single)
refused 2 'case.json: /precision: "half" is not one of double, single' --set /precision=half
refused 2 'case.json: /precision: method fdtd works in double precision. Choose "double"' "${lattice[@]}" --set '/method={"type":"fdtd"}'
refused 2 'case.json: /precision: single precision is of linear lattices, and these neighbours are not found by their place on a lattice. Choose "double"' "${lattice[@]}" --set /particles/jitter=0.1
refused 2 'case.json: /precision: single precision is of linear lattices, and viscosity works in double precision. Choose "double"' "${lattice[@]}" --set '/viscosity={"type":"monaghan"}'
refused 2 'case.json: /kernel/h: -1 is out of range. h [m] must be greater than 0' --set /kernel/h=-1
refused 2 'case.json: /kernel: h and h_over_dx are both given. Give one of h [m] and h_over_dx' --set /kernel/h_over_dx=1
refused 2 'case.json: /kernel: the smoothing length is missing. Give one of h [m] and h_over_dx' --set '/kernel={"type":"cubic_spline"}'
refused 2 'case.json: /kernel/h: the support of 0.02 m reaches no neighbour. Choose h so that support * h > dx' --set /kernel/h=0.01
refused 2 'case.json: /medium/rho0: is missing. rho0 [kg/m^3] must be greater than 0' --set '/medium={"c0":340}'
refused 2 'case.json: /medium/c0: "fast" is not a number. Give a number' --set /medium/c0=fast
refused 2 'case.json: /title: 3 is not a string. Give a string' --set /title=3
refused 2 'case.json: /dimension: 4 is not a dimension. Give 1, 2 or 3' --set /dimension=4
refused 2 'case.json: /dimension: 4294967297 is not a dimension. Give 1, 2 or 3' --set /dimension=4294967297
refused 2 'case.json: /particles/lower: [-1,0] does not fit dimension 1. Give a list of 1 number' --set /particles/lower=[-1,0]
refused 2 'case.json: /particles/upper: upper is not above lower along axis x. Give upper > lower' --set /particles/upper=[-2]
refused_like 2 'case.json: /particles/dx: the box holds * particles, which need at least * GB; * GB are free. Choose a larger dx or a smaller box' --set /particles/dx=1e-15
refused_like 2 'case.json: /particles/dx: the periodic axis x is 71.42* spacings long. Choose dx or upper so that (upper - lower)/dx is an integer' --set '/boundaries=[{"type":"periodic","face":"x"}]' --set /particles/dx=0.07
refused 2 'case.json: /boundaries: only one face of the axis x is periodic. Give the axis as face: "x"' --set '/boundaries=[{"type":"periodic","face":"x_min"}]'
refused 2 'case.json: /boundaries/1/face: this face has a boundary already. Give each face one boundary' --set '/boundaries=[{"type":"free","face":"x"},{"type":"free","face":"x_min"}]'
refused 2 'case.json: /boundaries/0/face: "y" is no face in dimension 1. Give x_min, x_max, ... of an axis that exists, an axis such as "x", or "all"' --set '/boundaries=[{"type":"free","face":"y"}]'
refused 2 'case.json: /boundaries/0/face: is missing. Give x_min, x_max, ..., an axis such as "x", or "all"' --set '/boundaries=[{"type":"free"}]'
leaks='[{"type":"impedance","face":"x_max","impedance":400}]'
refused 2 'case.json: /boundaries/0/impedance: is missing. impedance [Pa s/m] must be greater than 0 and at most 1e+30' --set '/boundaries=[{"type":"impedance","face":"x_max"}]'
refused 2 'case.json: /boundaries/0: it gives way on regular sets that keep their places, and this is another one. Use a frozen lattice without jitter, or a layer that damps before a wall' --set "/boundaries=$leaks" --set /particles/jitter=0.1
refused 2 'case.json: /integrator/type: "rk4" works in stages, and the boundary of x_max acts once per step. Use leapfrog, or another boundary such as absorbing_layer' --set "/boundaries=$leaks" --set /integrator/type=rk4
refused 2 'case.json: /integrator/courant: dt and courant are both given. Give one of dt, courant and safety' --set /integrator/dt=1e-5
refused 2 'case.json: /integrator/safety: courant and safety are both given. Give one of dt, courant and safety' --set /integrator/safety=0.5
refused 2 'case.json: /particles/dx: is missing. dx [m] must be greater than 0' --set '/particles={"type":"lattice","lower":[-1],"upper":[4]}'
refused 2 'case.json: /particles/lower: is missing. Give a list of 1 number' --set '/particles={"type":"lattice","dx":0.04,"upper":[4]}'
refused 2 'case.json: /particles/seed: -1 is out of range. seed must be at least 0 and at most 2147483647' --set /particles/seed=-1
refused 2 'case.json: /particles/seed: 18446744073709551615 is out of range. seed must be at least 0 and at most 2147483647' --set /particles/seed=18446744073709551615
refused 2 'case.json: /particles/jitter: 0.7 is out of range. jitter [dx] must be at least 0 and at most 0.5' --set /particles/jitter=0.7
refused 2 'case.json: /particles/dx: 5e-324 is out of range. dx [m] must be greater than 0' --set /particles/dx=5e-324
refused 2 'case.json: /particles/dx: there are fewer than two particles along axis x. Choose a smaller dx' --set /particles/dx=10
refused 2 'case.json: /particles/upper: upper is not above lower along axis x. Give upper > lower' --set /particles/upper=[-1]
refused_like 2 'case.json: /particles/dx: the box holds 1000000000001 particles, which need at least 100000 GB; * GB are free. Choose a larger dx or a smaller box' --set /particles/dx=5e-12
refused 2 'case.json: /particles/dx: the box is more spacings long than a number can count. Choose a larger dx or a smaller box' --set '/particles/lower=[-1e308]' --set '/particles/upper=[1e308]'
refused 2 'case.json: /kernel/h: the support of 2e+300 m is wider than the box. Choose a smaller h or a larger box' --set /kernel/h=1e300
refused 2 'case.json: /kernel/h: 1e-320 is out of range. h [m] must be greater than 0' --set /kernel/h=1e-320
refused 2 'case.json: /output/every: -1 is out of range. every [s] must be at least 0' --set /output/every=-1
refused 2 'case.json: /output/probes/1: [4.1] lies outside the box. Choose a point with -1 <= x <= 4' --set '/output/probes=[[4],[4.1]]'
refused 2 'case.json: /integrator/dt: the run would take 5e+297 steps. Choose a larger step or a shorter run' --set '/integrator={"type":"rk4","dt":1e-300}'
refused 2 'case.json: /integrator/dt: the step 0.0025 s (c0 dt/dx = 21.25) is beyond the stable limit 0.0003328 s (c0 dt/dx = 2.828). Choose a smaller step, or set "unstable": "allow" to study the failure' --set '/integrator={"type":"rk4","dt":0.0025}'
for step in '' ',"dt":1e-9' ',"courant":1e-6'; do
    refused 2 'case.json: /integrator/type: "forward_euler" is unstable at every step. Choose another integrator, or set "unstable": "allow" to study the failure' --set '/integrator={"type":"forward_euler"'"$step"'}'
done
refused_like 2 'case.json: /integrator/courant: the step * s (c0 dt/dx = 2.*) is beyond the stable limit * s (c0 dt/dx = *). Choose a smaller step, or set "unstable": "allow" to study the failure' --set /integrator/courant=3

echo "--- two dimensions"
flat=(--set /dimension=2 --set '/particles/lower=[-1,0]' --set '/particles/upper=[4,0.4]' --set '/sources/0/direction=[1,0]' --set '/output/probes=[[2,0]]')
refused 2 'case.json: /particles/lower: [-1] does not fit dimension 2. Give a list of 2 numbers' --set /dimension=2
refused 2 'case.json: /particles/upper: [4] does not fit dimension 2. Give a list of 2 numbers' "${flat[@]}" --set '/particles/upper=[4]'
refused 2 'case.json: /output/probes/0: [2] does not fit dimension 2. Give a list of 2 numbers' "${flat[@]}" --set '/output/probes=[[2]]'
refused 2 'case.json: /output/probes/0: [2.0,0.5] lies outside the box. Choose a point with 0 <= y <= 0.4' "${flat[@]}" --set '/output/probes=[[2,0.5]]'
refused 2 'case.json: /sources/0/direction: [1] does not fit dimension 2. Give a list of 2 numbers' "${flat[@]}" --set '/sources/0/direction=[1]'
refused 2 'case.json: /sources/0/phase_origin: [0,0,0] does not fit dimension 2. Give a list of 2 numbers' "${flat[@]}" --set '/sources/0/phase_origin=[0,0,0]'
refused 2 'case.json: /reference/wave_number: [1,2] does not fit dimension 1. Give a list of 1 number' --set '/reference={"type":"travelling_wave","wave_number":[1,2]}'
refused 2 'case.json: /initial/u: ["0"] does not fit this variable. Give a list of 2 expressions' "${flat[@]}" --set '/initial={"u":["0"]}'
refused 2 'case.json: /particles/dx: the periodic axis y is 10.5 spacings long. Choose dx or upper so that (upper - lower)/dx is an integer' "${flat[@]}" --set '/particles/upper=[4,0.42]' --set '/boundaries=[{"type":"periodic","face":"y"}]'

echo "--- sources"
refused 2 'case.json: /sources/0/region: is missing. Say which particles it acts on, such as "x < 0"' --set "$(source_is '{"type":"plane_wave","omega":500}')"
refused 2 'case.json: /sources/0/direction: [1,0] does not fit dimension 1. Give a list of 1 number' --set '/sources/0/direction=[1,0]'
refused 2 'case.json: /sources/0: direction has no length: give a vector other than zero' --set '/sources/0/direction=[0]'
refused_bare 'bare.json: /sources/0: there is no reference to take the field from: add a reference to the case' --set "$(source_is '{"type":"exact","region":"x < 0"}')"
refused 2 'case.json: /sources/0/region: is missing. Say which particles it acts on, such as "x < 0"' --set "$(source_is '{"type":"exact"}')" --set '/reference={"type":"travelling_wave","wave_number":[1]}'
refused 2 'case.json: /reference: there is no wave to follow: add a plane_wave source, or remove the reference' --set '/sources=[]'
point() { refused_bare "bare.json: /sources/0$1" --set "$(source_is '{"type":"point",'"$2}")"; }
point ': signal "sine" needs omega, greater than 0' '"position":[2]'
point ': signal "gaussian" needs duration, greater than 0' '"signal":"gaussian"'
point ': signal "gaussian" does not use omega: leave it out' '"signal":"gaussian","omega":3,"duration":0.001'
point ': signal "sine" does not use duration and delay: leave it out' '"omega":100,"delay":1'
point '/signal: "sin" is not one of sine, gaussian, ricker. Did you mean "sine"?' '"signal":"sin","omega":100'
point '/position: [1,2] does not fit dimension 1. Give a list of 1 number' '"omega":100,"position":[1,2]'
point ': it reaches no particle. Put it inside the box' '"omega":100,"position":[50]'
point '/region: no particle that the source reaches lies in "x > 2". Choose a region around the source' '"omega":100,"region":"x > 2"'
point ': its wavelength is 0.00214 m long on this set, too short for a footprint of radius 0.112 m (width_over_dx 2.8): choose a smaller dx or a longer wavelength' '"omega":1e6'
point ': its pulse is 0.00034 m long on this set, too short for a footprint of radius 0.112 m (width_over_dx 2.8): choose a smaller dx or a longer pulse' '"signal":"gaussian","duration":1e-6'

echo "--- regions and equations"
refused 2 'case.json: /sources/0/region: no particle lies in "x < -100". Choose a region inside the box' --set '/sources/0/region=x < -100'
refused 2 'case.json: /reference/region: no particle lies in "x > 100". Choose a region inside the box' --set '/reference/region=x > 100'
refused 2 'case.json: /sources/0/region: "x <": something is missing at the end. Complete it' --set '/sources/0/region=x <'
refused 2 'case.json: /sources/0/region: "y < 0": "y" does not exist in 1-D. Use x or r' --set '/sources/0/region=y < 0'
refused 2 'case.json: /sources/0/region: "0 <= x > -1": "<=" and ">" do not chain. Join two comparisons with and' --set '/sources/0/region=0 <= x > -1'
refused 2 'case.json: /sources/0/region: "": there is no text. Write an expression' --set '/sources/0/region='
refused 2 'case.json: /sources/0/region: "x < 1 < ": something is missing at the end. Complete it' --set '/sources/0/region=x < 1 < '
refused 2 'case.json: /sources/0/region: 3 is not a string. Give a string' --set '/sources/0/region=3'
refused 2 'case.json: /initial/p: "1/x" is not finite at x = 0.000000. Choose an expression that is finite in the whole box' --set '/initial={"p":"1/x"}'
refused 2 'case.json: /initial/p: "log(0)" is not finite at x = -1.000000. Choose an expression that is finite in the whole box' --set '/initial={"p":"log(0)"}'
refused 2 'case.json: /sources/0/region: "x": this is a number, not a condition. Compare it with a number' --set '/sources/0/region=x'
refused 2 'case.json: /equations/p/0/divergence: there is no variable "v". The equations have p, rho, u' --set "$(terms '{"divergence":"v","form":"difference"}')"
refused 2 'case.json: /equations/p/0: the term has no operator. Give exactly one of divergence, gradient, viscosity, dissipation' --set "$(terms '{"form":"difference"}')"
refused 2 'case.json: /dissipation: dissipation is given here and in /equations. Remove one of the two' --set '/dissipation={"type":"fourth_order","alpha":0.1}' --set '/equations={"p":[{"divergence":"u","form":"sum"}],"u":[{"gradient":"p","form":"sum"},{"dissipation":"fourth_order"}]}'
refused 2 'case.json: /equations/q/0/dissipation: dissipation acts on sound, and "q" is not part of it. Put the term under u or p' --set "$(also '"q":[{"dissipation":"fourth_order","alpha":0.1}]')"
refused 2 'case.json: /dissipation/type: there is no dissipation named "forth_order". Did you mean "fourth_order"?' --set '/dissipation={"type":"forth_order"}'
refused 2 'case.json: /dissipation/alpha: -0.1 is out of range. alpha must be at least 0 and at most 10' --set '/dissipation={"type":"fourth_order","alpha":-0.1}'
refused 2 'case.json: /dissipation/alpha: is missing, and the set is too small to work it out. Give the strength, such as 0.2' --set '/dissipation={"type":"fourth_order"}' --set '/particles/jitter=0.1' --set '/kernel={"type":"cubic_spline","h":1.5}'
refused 2 'case.json: /particles/neighbours: "lattice" is a stencil, which does not do dissipation. Remove the dissipation, which lattices do not need, or use "auto"' --set '/dissipation={"type":"fourth_order","alpha":0.1}' --set /particles/neighbours=lattice
refused 2 'case.json: /boundaries/0: its layers of virtual particles continue a stencil, which does not do dissipation. Remove the dissipation, which lattices do not need, or absorb by absorbing_layer' --set '/dissipation={"type":"fourth_order","alpha":0.1}' --set '/boundaries=[{"type":"absorbing_mur","face":"x_max"}]'
refused 2 'case.json: /equations/p/0/form: this form'"'"'s weights are made for a lattice, which needs no dissipation. Use another form, or remove the dissipation' --set '/dissipation={"type":"fourth_order","alpha":0.1}' --set /equations=band_fitted_acoustics
refused 2 'case.json: /equations/p/0/form: there is no form named "diference". Did you mean "difference"?' --set "$(terms '{"divergence":"u","form":"diference"}')"
refused 2 'case.json: /equations/p/0/times: "rho1": "rho1" is unknown. Did you mean "rho0"?' --set "$(times '-rho1*c0^2')"
refused 2 'case.json: /equations/p/0/times: "1-2*c0^2" is not a product. Write factors joined by * and /' --set "$(times '1-2*c0^2')"
refused 2 'case.json: /equations/p/0/times: "rho^" is not an integer power. Powers of variables are integers' --set "$(times '-rho^')"
refused 2 'case.json: /equations/p/0/times: "rho^99999999999" is not an integer power. Powers of variables are integers' --set "$(times '-rho^99999999999')"
refused 2 'case.json: /equations/p/0/times: "0" is zero and divides. Choose constants whose product is finite' --set "$(times '-c0^2/0')"
refused 2 'case.json: /equations/p/0/times: the product is not finite at "1e200". Choose constants whose product is finite' --set "$(times '1e200*1e200')"
refused 2 'case.json: /equations/p/0/times: the product is not finite at "sqrt(-1)". Choose constants whose product is finite' --set "$(times 'sqrt(-1)')"
refused 2 'case.json: /equations/c0: "c0" means something else in expressions. Choose another name than x, y, z, r, pi, c0, rho0, K, dx, h' --set "$(also '"c0":[{"divergence":"u","form":"sum"}]')"
refused 2 'case.json: /equations/a b: "a b" is no name of a variable. Use letters, digits and _, a letter first' --set "$(also '"a b":[{"divergence":"u","form":"sum"}]')"
refused 2 'case.json: /equations/order: "x" is not an evolved variable, or stands twice. Write lists of evolved variables, each once, such as [["u"], ["p", "x"]]' --set "$(also '"order":[["u","x"],["p","x"]]')"
refused 2 'case.json: /equations/order: [] is not a list with entries. Write lists of evolved variables, each once, such as [["u"], ["p", "x"]]' --set "$(also '"order":[[],["u","p"]]')"
refused 2 'case.json: /equations/u: there is no rate term. Give at least one, or remove the variable' --set '/equations={"p":[{"divergence":"u","form":"difference"}],"u":[]}'
refused_like 2 'case.json: /equations/p/0/times: "x": "x" is a coordinate*' --set "$(times '-c0^2*x')"
refused_like 2 'case.json: /equations/p/0/times: "r": "r" is a coordinate*' --set "$(times '-c0^2*r')"
refused_like 2 'case.json: /equations/p/0/times: *2 3*' --set "$(times '-2 3*c0^2')"
refused_like 2 'case.json: /equations/p/of: *' --set '/equations={"p":{"state":"acoustic","of":"p"},"u":[{"gradient":"p","form":"sum"}]}'

echo "--- text"
refused_text 'text.json:1:1: the text is empty. Write a JSON value' ''
refused_text 'text.json:1:1: "hello" is not JSON. Correct the JSON there' 'hello'
refused_text 'text.json:1:1: the text begins with a byte-order mark. Save it as UTF-8 without one' '\xef\xbb\xbf{}'
refused_text 'text.json: /: [] is not an object. Write { ... } here' '[]'
refused_text 'text.json: /dimension: is missing. Give 1, 2 or 3' '{}'
refused_edit 'edited.json: /until: the key "until" is given twice. Remove one of them' 's/"until": 0.005/&, "until": 0.5/'
refused_edit 'edited.json:10:12: "NaN" is not JSON. Write a finite number' 's/"until": 0.005/"until": NaN/'
refused_edit 'edited.json: /until: the number 1e999 is too large for a double. Write a smaller number' 's/"until": 0.005/"until": 1e999/'
refused_edit 'edited.json: /title: the text has a NUL character. Remove it' 's/A short wave/A\\u0000/'
refused_edit 'edited.json:4:26: "rho0" is not JSON. Correct the JSON there' 's/"rho0"/rho0/'
printf '[%.0s' {1..100000} >deep.json
both like 2 'deep.json: /0/0/*/0: more than 64 values are nested. Nest less deeply' deep.json
printf '{"a":%.0s' {1..100000} >deep.json
both like 2 'deep.json: /a/a/*/a: more than 64 values are nested. Nest less deeply' deep.json
refused_edit "edited.json:13:1: unexpected end of input, expected '}'. Correct the JSON there" '$d'

