# Sourced by errors.sh: what check warns of before waves that a set carries wrongly. `warned` is that of errors_at_obstacles.sh.
# shellcheck shell=bash disable=SC2016  # JSON in quotes

echo "--- warnings of sources"
# At h = 2 dx the highest frequency is that of 2 pi / max|F| dx = 12.1 points; at h = dx a wave of 15 is sin(k dx)/(k dx) too slow, but for the step.
coarse='/sources/0: its highest frequency, *'
warned "a tone beyond the top of the band" "*$coarse"'has 6 points per wavelength, and this set carries no waves of less than 12.1. Choose a smaller dx, *' --set /kernel/h=0.08 --set /sources/0/omega=8901
warned "a tone that travels too slowly" "*$coarse"'Hz, has 15 points per wavelength, and its waves travel 2.'*' % slower than long ones. Choose a smaller dx, *' --set /sources/0/omega=3560
for method in '{"type":"fdtd"}:5' '{"type":"kspace"}:1.9'; do
    points=${method##*:}
    walls=(--set '/boundaries=[{"type":"periodic","face":"x"}]' --set /integrator/dt=5e-5 --set "/method=${method%:*}" --set "/sources/0/omega=$(python3 -c "print(2*3.14159265*340/(.04*$points))")")
    sed -e '/"reference"/d' -e 's/, "courant": 0.5//' case.json >methods.json
    sphonic check methods.json "${walls[@]}"
    [[ $code == 0 && $err == *"/sources/0: its highest frequency, "*" has $points points per wavelength, and "*'. Choose a smaller dx' ]] \
        && ok "warned: ${method%:*}" || failed "warned: ${method%:*}" "exit code: $code" "stderr: $err"
done
pulse() { printf '/sources=[{"type":"point","position":[2],"flow":0.01,"width_over_dx":1.5,"signal":"%s","duration":%s}]' "$1" "$2"; }
sed -e '/"reference"/d' case.json >bare.json
# The duration at which the spectrum has fallen to a tenth at 10 points per wavelength, omega dx / c0 = 0.628.
for signal in gaussian:5.68e-4 ricker:8.28e-4; do
    sphonic check bare.json --set /kernel/h=0.08 --set "$(pulse "${signal%:*}" "${signal#*:}")"
    [[ $code == 0 && $err == *"/sources/0: its highest frequency, 850"*' Hz, has 10 points per wavelength, and this set carries no waves of less than 12.1'* ]] \
        && ok "warned: a ${signal%:*} of high frequencies" || failed "warned: a ${signal%:*} of high frequencies" "exit code: $code" "stderr: $err"
    sphonic check bare.json --set "$(pulse "${signal%:*}" 5e-3)"
    [[ $code == 0 && -z $err ]] && ok "a longer ${signal%:*} passes" || failed "a longer ${signal%:*} passes" "exit code: $code" "stderr: $err"
done
warned "an inflow of a reference's tone" "*$coarse"'has 6'*' points per wavelength, and this set carries no waves of less than 12.1*' --set /kernel/h=0.08 --set '/sources=[{"type":"exact","region":"x < 0"}]' \
    --set '/reference={"type":"travelling_wave","wave_number":[26.18]}'

# Fitted weights: another h/dx is no remedy.
fitted='"form":{"type":"band_fitted","points_per_wavelength":4,"support":2},"times"'
warned "a fit that is too wide" '*long waves run at the wrong speed by '*': refining dx at fixed points_per_wavelength will not converge. Give the form more points_per_wavelength or a wider support' \
    --set '/boundaries=[{"type":"rigid","face":"x"}]' --set "/equations={\"p\":[{\"divergence\":\"u\",$fitted:\"-rho0*c0^2\"}],\"u\":[{\"gradient\":\"p\",$fitted:\"-1/rho0\"}]}"
