(for trunnion_ac- proving signs)
G21 G17 G40 G80 G90
G54
G61
(tool and length offset as the operator has set them)
(no tool call)
M5
M9
G94
(nothing above Z 0 - stop 0 - jog the tool high above the start - rotary axes at 0 - then go on)
M0
G1 X30.0000 Y20.0000 Z40.0000 A0.0000 C0.0000 F200.0000
(stop 1 - start)
M0
G1 Z20.0000
(stop 2 - the mark)
M0
G1 Z40.0000
G1 X50.0000
(stop 3 - X alone - +20 mm)
M0
G1 X30.0000
G1 Y40.0000
(stop 4 - Y alone - +20 mm)
M0
G1 Y20.0000
G1 Z60.0000
(stop 5 - Z alone - +20 mm)
M0
G1 Z40.0000
G1 C10.0000
(stop 6 - C alone - +10 deg)
M0
G1 C0.0000
G1 A10.0000
(stop 7 - A alone - +10 deg)
M0
G1 A0.0000
G1 A10.0000 C20.0000 F223.0000
G1 X35.0312 Y17.0860 Z27.7586 F221.0000
(stop 8 - both rotary axes turned - tip over the mark)
M0
G1 X30.0000 Y20.0000 Z40.0000
G1 A0.0000 C0.0000 F223.0000
M5
M9
G94
M2
