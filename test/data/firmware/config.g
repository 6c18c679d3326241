; Configuration of a workshop's delta
G21                                 ; millimetres
G90
M83
M550 P"Workshop; delta"             ; its name
M569 P0 S1
M569 P1 S1
M569 P2 S1
M208 Z-0.5 S1                       ; lowest Z
M208 X140 Y140 S0

; what a calibration found
M665 L269.000:268.800:269.100 R130.246 H305.470 B110.0 X-0.105 Y0.161 Z0.000
M666 X-0.748 Y-0.006 Z0.755 A0.11 B-0.08
M92 X200 Y200 Z200
