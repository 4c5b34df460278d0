# Sourced by errors.sh: steps beyond the limit, and sets that grow at any step.
# shellcheck shell=bash disable=SC2154,SC2015,SC2016  # of errors.sh; ok and failed always succeed; JSON in quotes

echo "--- steps"
# A step 1 % beyond the limit, and dt = 3 h/c0: refused with the limit, and stopped where the case allows it.
for too_large in '"courant": 2.02' '"dt": 3.529e-4'; do
    key=${too_large%%:*}
    refused_like 2 "case.json: /integrator/${key//\"/}: the step * s (c0 dt/dx = *) is beyond the stable limit 0.0002353 s (c0 dt/dx = 2). Choose a smaller step, *" \
        --set "/integrator={\"type\": \"symplectic_euler\", $too_large}" --set /until=0.5
    sphonic run case.json --out parent/out --set "/integrator={\"type\": \"symplectic_euler\", \"unstable\": \"allow\", $too_large}" --set /until=0.5
    [[ $code == 3 && $err == *'case.json: the run diverged at t = '* && $err == *'is beyond the stable limit'* ]] \
        && ok "where the case allows $too_large, the run is stopped" || failed "where the case allows $too_large, the run is stopped" "exit code: $code" "stderr: $err"
    rm -rf parent/out
done

# The other methods: a step beyond their limit, and the k-space method where it jumps from one medium to another, which bounds its step.
others=(--set '/boundaries=[{"type":"periodic","face":"x"}]' --set '/sources=[]' --set '/initial={"p":"exp(-9*x^2)"}' --set '/output={}' --set /until=0.5)
for method in fdtd kspace; do
    two=(); [[ $method == fdtd ]] || two=(--set '/medium=[{"c0":340,"rho0":1},{"c0":1000,"rho0":50,"region":"x > 1"}]')
    sed -e '/"reference"/d' case.json >other.json
    at=(other.json "${others[@]}" "${two[@]}" --set "/method={\"type\": \"$method\"}")
    sphonic check "${at[@]}" --set '/integrator={"type":"symplectic_euler","dt":3.529e-4}'
    [[ $code == 2 && $err == *'other.json: /integrator/dt: the step 0.0003529 s'*'is beyond the stable limit '* ]] \
        && ok "$method refuses a step beyond its limit" || failed "$method refuses a step beyond its limit" "exit code: $code" "stderr: $err"
    sphonic run "${at[@]}" --set '/integrator={"type":"symplectic_euler","dt":3.529e-4,"unstable":"allow"}' --out other --force
    [[ $code == 3 && $err == *'other.json: the run diverged at t = '*'growing by e^'*' a step'*' times the stable limit. Take '* ]] \
        && ok "$method is stopped where the case allows it" || failed "$method is stopped where the case allows it" "exit code: $code" "stderr: $err"
done

# What grows at any step: told where it grows a little, refused where much, with when and why.
uneven=(bare.json --set /dimension=2 --set '/particles/lower=[0,0]' --set '/particles/upper=[1.6,1.6]' --set /particles/jitter=0.2 --set '/sources=[]' --set '/output={}'
    --set '/boundaries=[{"type":"periodic","face":"all"}]' --set /equations=corrected_acoustics --set '/initial={"p":"exp(-20*((x-0.8)^2+(y-0.8)^2))"}')
sed -e '/"reference"/d' case.json >bare.json
sphonic check "${uneven[@]}" --set /until=0.004
[[ $code == 0 && $err == *'the forms of divergence and gradient are not adjoint on disordered particles: the worst motion grows by '*' per second at any step: e^'*' in this run, by e in '*' steps ('*' s); by '*' Add fourth_order dissipation, '* ]] \
    && [[ $out == *'no step is stable: the worst motion grows by e in '*' steps, e^'*' in this run; beyond '* && $out != *'stable to'* ]] \
    && ok "check warns of sets that grow at any step" || failed "check warns of sets that grow at any step" "$code" "$err" "$out"
sphonic check "${uneven[@]}" --set /until=0.05
[[ $code == 2 && $err == 'bare.json: /equations: the forms of divergence and gradient are not adjoint on disordered particles: '*'or set /integrator/unstable to "allow" to study the failure' ]] \
    && ok "and refuses where they grow much" || failed "and refuses where they grow much" "$code" "$err"
sphonic run "${uneven[@]}" --set /until=0.05 --set /integrator/unstable=allow --out uneven
[[ $code == 3 && $err == *'not adjoint on disordered particles, by theory by '*' per second. Add fourth_order dissipation'* && -s uneven/profile.csv ]] \
    && ok "which a run that may go on then says" || failed "which a run that may go on then says" "$code" "$err"
sphonic run "${uneven[@]}" --set /until=0.004 --out uneven --force
[[ $code == 0 && $out == *'no step is stable: the worst motion grows by e in '* ]] && ok "run tells so beside its step" || failed "run tells so beside its step" "$code" "$out"
sphonic stability "${uneven[@]}" --set /until=0.004
[[ $code == 0 && $out == *'predicted  no step is stable: at dt '*' the worst motion grows by e in '*' steps ('*' s); by '*'measured   every step grows, in '* ]] \
    && ok "stability tells so in the place of a limit" || failed "stability tells so in the place of a limit" "$code" "$out"
sphonic check bare.json --set '/integrator={"type":"forward_euler","courant":0.2,"unstable":"allow"}'
[[ $code == 0 && $out == *'no step is stable: the worst mode grows by e in '*' steps, e^'*' in this run'* ]] \
    && ok "and of an integrator that grows at any step" || failed "and of an integrator that grows at any step" "$code" "$out"

# The table of limits takes no case, all else does.
misused 2 'CASE is required*' stability --json
misused 2 '--table excludes CASE*' stability case.json --table
misused 5 'case.json: exists already. *' stability --table --out case.json
