#!/bin/sh
# Makes ship-record.csv: sway, heave and roll of a ship in an irregular beam sea, from 40 waves.
#
# Waves: Bretschneider's spectrum, S = 5/16 H^2 w_p^4/w^5 exp(-5/4 (w_p/w)^4), significant height H = 3 m, peak period
# 11 s, from 0.3 to 1.3 rad/s in steps that grow by one part, so that it repeats nowhere within the record; phases by
# the golden ratio. Responses are assumed, of one degree of freedom each: sway and heave follow the wave where it is
# long, heave up to its natural period of 9 s, damped by 0.5; roll answers the wave's slope about one of 14 s, damped
# by 0.08.
set -eu
cd "$(dirname "$0")"
awk '
function response(w, wn, damping,   r) { r = w / wn; return 1 / sqrt((1 - r * r) ^ 2 + (2 * damping * r) ^ 2) }
function lag(w, wn, damping,   r) { r = w / wn; return atan2(2 * damping * r, 1 - r * r) }
BEGIN {
  pi = atan2(0, -1); g = 9.81; height = 3; peak = 2 * pi / 11; count = 40
  heave_natural = 2 * pi / 9; roll_natural = 2 * pi / 14
  ratio = exp(log(1.3 / 0.3) / count)
  for (k = 0; k < count; ++k) {
    low = 0.3 * ratio ^ k; w[k] = low * sqrt(ratio); width = low * (ratio - 1)
    spectrum = 5 / 16 * height ^ 2 * peak ^ 4 / w[k] ^ 5 * exp(-1.25 * (peak / w[k]) ^ 4)
    a[k] = sqrt(2 * spectrum * width); phase[k] = 2 * pi * ((k * 0.6180339887) % 1)
  }
  print "t [s],sway [m],heave [m],roll [deg]"
  for (i = 0; i <= 1200; ++i) {
    t = 0.25 * i; sway = heave = roll = 0
    for (k = 0; k < count; ++k) {
      wave = w[k] * t + phase[k]
      sway += a[k] * cos(wave + pi / 2)
      heave += a[k] * response(w[k], heave_natural, 0.5) * cos(wave - lag(w[k], heave_natural, 0.5))
      slope = a[k] * w[k] ^ 2 / g * 180 / pi
      roll += slope * response(w[k], roll_natural, 0.08) * cos(wave + pi / 2 - lag(w[k], roll_natural, 0.08))
    }
    printf "%.2f,%.6f,%.6f,%.6f\n", t, sway, heave, roll
  }
}' > ship-record.csv
