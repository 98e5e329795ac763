<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>A few words to each marker</source>
        <translation>Einige Worte zu jeder Markierung</translation>
    </message>
    <message>
        <source>A machine that comes with the workbench, or a machine file (.fcm)</source>
        <translation>Eine mitgelieferte Maschine oder eine Maschinendatei (.fcm)</translation>
    </message>
    <message>
        <source>Advice</source>
        <translation>Rat</translation>
    </message>
    <message>
        <source>Against</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>Allowed</source>
        <translation>Erlaubt</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Angle between the flank of a tapered cutter and its axis; other kinds have none</source>
        <translation>Winkel zwischen der Flanke eines konischen Fräsers und seiner Achse; andere Arten haben keinen</translation>
    </message>
    <message>
        <source>Angle of the passes to the X axis, counter-clockwise seen from above</source>
        <translation>Winkel der Bahnen zur X-Achse, von oben gesehen gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Angular Deflection</source>
        <translation>Winkelabweichung</translation>
    </message>
    <message>
        <source>Area that each marker stands for, as a side that no pass cuts, mm²; 0: none</source>
        <translation>Fläche, für die jede Marke steht, etwa eine Seite, die keine Bahn fräst, mm²; 0: keine</translation>
    </message>
    <message>
        <source>Areas</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Avoid</source>
        <translation>Aussparen</translation>
    </message>
    <message>
        <source>Avoid Allowance</source>
        <translation>Abstand zu ausgesparten Flächen</translation>
    </message>
    <message>
        <source>Avoided Runs</source>
        <translation>Ausgesparte Bereiche</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Axis Length</source>
        <translation>Länge der Werkzeugachsen</translation>
    </message>
    <message>
        <source>Axis Tolerance</source>
        <translation>Achstoleranz</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Basis</translation>
    </message>
    <message>
        <source>Below Table</source>
        <translation>Unter dem Tisch</translation>
    </message>
    <message>
        <source>Beyond Machine</source>
        <translation>Außerhalb der Maschine</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Verschleifen</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>NC-Sätze</translation>
    </message>
    <message>
        <source>Blocks near the pole, where a rotary axis turns far to lean the tool a little</source>
        <translation>NC-Sätze nahe am Pol, wo eine Rundachse weit dreht, um das Werkzeug ein wenig zu neigen</translation>
    </message>
    <message>
        <source>Blocks of the program</source>
        <translation>Sätze des NC-Programms</translation>
    </message>
    <message>
        <source>Blocks that leave the commanded segment by more than the tolerance</source>
        <translation>NC-Sätze, die um mehr als die Toleranz von der Sollstrecke abweichen</translation>
    </message>
    <message>
        <source>Blocks under RTCP: only their end points are verified, the controller moves the tip between them</source>
        <translation>NC-Sätze unter RTCP: nachgewiesen sind nur ihre Endpunkte, dazwischen führt die Steuerung die Spitze</translation>
    </message>
    <message>
        <source>Boundary</source>
        <translation>Begrenzung</translation>
    </message>
    <message>
        <source>Boundary Axis</source>
        <translation>Achse der Begrenzung</translation>
    </message>
    <message>
        <source>Boundary By</source>
        <translation>Begrenzung hält</translation>
    </message>
    <message>
        <source>Boundary Picked</source>
        <translation>Begrenzung gewählt</translation>
    </message>
    <message>
        <source>By so much the ball's radius is too large where the cutter itself is in the way</source>
        <translation>Um so viel ist der Kugelradius zu groß, wo schon der Fräser im Weg ist</translation>
    </message>
    <message>
        <source>CL file (.apt, .cl) or part (.stl) that the program is compared with</source>
        <translation>CL-Datei (.apt, .cl) oder Werkstück (.stl), womit das Programm verglichen wird</translation>
    </message>
    <message>
        <source>CSV file of closed curves at which the passes end: X,Y,Z in mm a line, in the frame of the work zero, a blank line between two (or the lines themselves, a ; between two)</source>
        <translation>CSV-Datei geschlossener Kurven, an denen die Bahnen enden: je Zeile X,Y,Z in mm, im Koordinatensystem des Werkstücknullpunkts, eine Leerzeile zwischen zwei (oder die Zeilen selbst, ein ; zwischen zweien)</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Certainty</source>
        <translation>Sicherheit</translation>
    </message>
    <message>
        <source>Checksum (sha256) of what was written</source>
        <translation>Prüfsumme (sha256) des Geschriebenen</translation>
    </message>
    <message>
        <source>Checksum of the base and the deflections that the mesh is made of</source>
        <translation>Prüfsumme der Grundlage und der Abweichungen, aus denen das Netz gemacht ist</translation>
    </message>
    <message>
        <source>Cl Tool</source>
        <translation>CL-Werkzeug</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Sicherheitsabstand</translation>
    </message>
    <message>
        <source>Closed passes round one another become one long pass, without links between them</source>
        <translation>Geschlossene Bahnen umeinander werden zu einer langen Bahn, ohne Verbindungen dazwischen</translation>
    </message>
    <message>
        <source>Coedge Tolerance</source>
        <translation>Kantentoleranz</translation>
    </message>
    <message>
        <source>Colour Axes</source>
        <translation>Farbe der Werkzeugachsen</translation>
    </message>
    <message>
        <source>Colour Bad</source>
        <translation>Farbe über der Toleranz</translation>
    </message>
    <message>
        <source>Colour Good</source>
        <translation>Farbe ohne Abweichung</translation>
    </message>
    <message>
        <source>Colour Singular</source>
        <translation>Farbe singulär</translation>
    </message>
    <message>
        <source>Colour between the least and the largest deviation</source>
        <translation>Farbe zwischen der kleinsten und der größten Abweichung</translation>
    </message>
    <message>
        <source>Colour of blocks over the tolerance</source>
        <translation>Farbe der NC-Sätze über der Toleranz</translation>
    </message>
    <message>
        <source>Colour of blocks within the tolerance</source>
        <translation>Farbe der NC-Sätze in der Toleranz</translation>
    </message>
    <message>
        <source>Colour of markers near the pole</source>
        <translation>Farbe der Markierungen nahe am Pol</translation>
    </message>
    <message>
        <source>Colour of places within the tolerance</source>
        <translation>Farbe der Orte in der Toleranz</translation>
    </message>
    <message>
        <source>Colour of the tool axes</source>
        <translation>Farbe der Werkzeugachsen</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>Constant distance of the passes, instead of a scallop height</source>
        <translation>Fester Abstand der Bahnen statt einer Kuppenhöhe</translation>
    </message>
    <message>
        <source>Constant scallop in each frame, or planes along the frame's axis and the direction of passes</source>
        <translation>Gleiche Kuppenhöhe in jeder Anstellung oder Ebenen entlang ihrer Achse und der Bahnrichtung</translation>
    </message>
    <message>
        <source>Control Point</source>
        <translation>Geführter Punkt</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>Controller that the NC file is written for</source>
        <translation>Steuerung, für die die NC-Datei geschrieben wird</translation>
    </message>
    <message>
        <source>Controller that the NC file is written for. machine's own: the one that the machine's file names</source>
        <translation>Steuerung, für die die NC-Datei geschrieben wird. machine's own: die, die in der Datei der Maschine steht</translation>
    </message>
    <message>
        <source>Coolant</source>
        <translation>Kühlmittel</translation>
    </message>
    <message>
        <source>Coolant on while the program runs</source>
        <translation>Kühlmittel ein, solange das Programm läuft</translation>
    </message>
    <message>
        <source>Corner radius of a bull nose, or radius of a barrel's tip; other kinds have none</source>
        <translation>Eckenradius eines Torusfräsers oder Radius der Spitze eines Tonnenfräsers; andere Arten haben keinen</translation>
    </message>
    <message>
        <source>Corner rounding: how far the controller may round corners, where it can; 0: exact path</source>
        <translation>Eckenverrundung: wie weit die Steuerung Ecken verrunden darf, wo sie es kann; 0: genauer Weg</translation>
    </message>
    <message>
        <source>Cut Length</source>
        <translation>Schnittweg</translation>
    </message>
    <message>
        <source>Cut pattern. zigzag: in both directions; one_way: in one direction only</source>
        <translation>Schnittfolge. zigzag: in beide Richtungen; one_way: nur in eine Richtung</translation>
    </message>
    <message>
        <source>Cutter Corner</source>
        <translation>Fräser-Eckenradius</translation>
    </message>
    <message>
        <source>Cutter Diameter</source>
        <translation>Fräserdurchmesser</translation>
    </message>
    <message>
        <source>Cutter Flank</source>
        <translation>Fräser-Flanke</translation>
    </message>
    <message>
        <source>Cutter From Program</source>
        <translation>Fräser aus dem Programm</translation>
    </message>
    <message>
        <source>Cutter Kind</source>
        <translation>Fräserart</translation>
    </message>
    <message>
        <source>Cutter Length</source>
        <translation>Schneidenlänge</translation>
    </message>
    <message>
        <source>Cutter Neck</source>
        <translation>Fräser-Hals</translation>
    </message>
    <message>
        <source>Cutter Taper</source>
        <translation>Fräser-Kegelwinkel</translation>
    </message>
    <message>
        <source>Cutter shape: ball, flat, bull nose, tapered ball or bull nose, lollipop, barrel</source>
        <translation>Form des Fräsers: Kugel, Schaftfräser, Torus, konische Kugel, konischer Torus, Lollipop, Tonne</translation>
    </message>
    <message>
        <source>Cylinders above the cutter, from below: diameter x length in mm, as 8x20,12x30</source>
        <translation>Zylinder über dem Fräser, von unten: Durchmesser x Länge in mm, etwa 8x20,12x30</translation>
    </message>
    <message>
        <source>Cylinders of the holder above cutter and shank, from below: diameter x length in mm, as 40x25,63x50</source>
        <translation>Zylinder des Halters über Fräser und Schaft, von unten: Durchmesser x Länge in mm, etwa 40x25,63x50</translation>
    </message>
    <message>
        <source>Decimal</source>
        <translation>Dezimalpunkt</translation>
    </message>
    <message>
        <source>Deepest that the cutter goes below the machined surface</source>
        <translation>So tief geht der Fräser höchstens unter die bearbeitete Fläche</translation>
    </message>
    <message>
        <source>Depths</source>
        <translation>Tiefen</translation>
    </message>
    <message>
        <source>Deviation After</source>
        <translation>Abweichung nachher</translation>
    </message>
    <message>
        <source>Deviation Before</source>
        <translation>Abweichung vorher</translation>
    </message>
    <message>
        <source>Deviations</source>
        <translation>Abweichungen</translation>
    </message>
    <message>
        <source>Diameter of a lollipop's neck, less than that of its ball; other kinds have none</source>
        <translation>Durchmesser des Halses eines Lollipop-Fräsers, kleiner als der seiner Kugel; andere Arten haben keinen</translation>
    </message>
    <message>
        <source>Diameter of the cutter; of a tapered one at its round end, of a barrel the largest</source>
        <translation>Durchmesser des Fräsers; eines konischen der seines runden Endes, eines Tonnenfräsers der größte</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Direction I, J, K across the planes of the passes; 0, 0, 0: upright planes along the direction</source>
        <translation>Richtung I, J, K quer zu den Ebenen der Bahnen; 0, 0, 0: senkrechte Ebenen längs der Richtung</translation>
    </message>
    <message>
        <source>Direction I, J, K along which the boundary is seen</source>
        <translation>Richtung I, J, K, entlang derer die Begrenzung gesehen wird</translation>
    </message>
    <message>
        <source>Direction I, J, K of the axis of radial and rotary passes; 0, 0, 0: Z; rotary: the machine's only rotary axis, else the part's longest side</source>
        <translation>Richtung I, J, K der Achse radialer und rotierender Bahnen; 0, 0, 0: Z; rotierend: die einzige Rundachse der Maschine, sonst die längste Seite des Werkstücks</translation>
    </message>
    <message>
        <source>Direction I, J, K of the fixed tool axis, from the tip to the holder</source>
        <translation>Richtung I, J, K der festen Werkzeugachse, von der Spitze zum Halter</translation>
    </message>
    <message>
        <source>Divide blocks that deviate by more than the tolerance, into as few as keep it</source>
        <translation>Sätze teilen, die um mehr als die Toleranz abweichen, in so wenige, wie sie einhalten</translation>
    </message>
    <message>
        <source>F words as inverse time (G93), or as feed per minute (G94)</source>
        <translation>F-Wörter zeitreziprok (G93) oder als Vorschub je Minute (G94)</translation>
    </message>
    <message>
        <source>Faces of the base that are left alone: they are not milled</source>
        <translation>Flächen der Basis, die ausgespart bleiben: sie werden nicht gefräst</translation>
    </message>
    <message>
        <source>Facet Runs</source>
        <translation>Facettenbereiche</translation>
    </message>
    <message>
        <source>Facets</source>
        <translation>Facetten</translation>
    </message>
    <message>
        <source>Facets of the mesh</source>
        <translation>Facetten des Netzes</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>Feed Mode</source>
        <translation>Vorschubart</translation>
    </message>
    <message>
        <source>Feed Per Minute</source>
        <translation>Vorschub pro Minute</translation>
    </message>
    <message>
        <source>Feed rate of the approach to the part</source>
        <translation>Vorschub beim Anfahren an das Werkstück</translation>
    </message>
    <message>
        <source>Feed rate of the approach to the part, in mm/min</source>
        <translation>Vorschub beim Anfahren an das Werkstück, in mm/min</translation>
    </message>
    <message>
        <source>Feed rate of the tip over the part</source>
        <translation>Vorschub der Spitze über das Werkstück</translation>
    </message>
    <message>
        <source>Feed rate of the tip over the part, in mm/min</source>
        <translation>Vorschub der Spitze über das Werkstück, in mm/min</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Find the rest material and the overcut on the machined surface</source>
        <translation>Restmaterial und zu tief Gefrästes auf der bearbeiteten Fläche ermitteln</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>Fingerprint</source>
        <translation>Fingerabdruck</translation>
    </message>
    <message>
        <source>Fixture</source>
        <translation>Spannmittel</translation>
    </message>
    <message>
        <source>Fixture Clearance</source>
        <translation>Abstand zu Spannmitteln</translation>
    </message>
    <message>
        <source>Fixture In The Way</source>
        <translation>Spannmittel im Weg</translation>
    </message>
    <message>
        <source>Fixtures</source>
        <translation>Spannmittel</translation>
    </message>
    <message>
        <source>Flank In The Way</source>
        <translation>Flanke im Weg</translation>
    </message>
    <message>
        <source>Fold Legend</source>
        <translation>Legende einklappen</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Anstellungen</translation>
    </message>
    <message>
        <source>From the spindle's gauge point to the tip; machines with a rotary head need it</source>
        <translation>Vom Bezugspunkt der Spindel bis zur Spitze; Maschinen mit Schwenkkopf brauchen sie</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Gouge</source>
        <translation>Eindringen</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>Guided Blocks</source>
        <translation>Geführte NC-Sätze</translation>
    </message>
    <message>
        <source>Height of the table's face in the machine's coordinates; empty: that of the machine's file</source>
        <translation>Höhe der Tischfläche in den Koordinaten der Maschine; leer: die der Maschinendatei</translation>
    </message>
    <message>
        <source>High Speed</source>
        <translation>Hochgeschwindigkeit</translation>
    </message>
    <message>
        <source>High-speed mode of the controller, with the tolerance given as corner rounding</source>
        <translation>Hochgeschwindigkeitsmodus der Steuerung, mit der Toleranz aus „Verschleifen“</translation>
    </message>
    <message>
        <source>Holder</source>
        <translation>Halter</translation>
    </message>
    <message>
        <source>Holder In The Way</source>
        <translation>Halter im Weg</translation>
    </message>
    <message>
        <source>Holder Places</source>
        <translation>Orte der Halter</translation>
    </message>
    <message>
        <source>How certain the offsets should be, and how near to those of the machine they are compared with</source>
        <translation>Wie sicher die Versätze sein sollen und wie nahe an denen der Maschine, mit der verglichen wird</translation>
    </message>
    <message>
        <source>How deep the tool enters the part at each marker, mm; 0: not at all</source>
        <translation>Wie tief das Werkzeug an jeder Markierung ins Werkstück eindringt, mm; 0: gar nicht</translation>
    </message>
    <message>
        <source>How far cutter, shank and holder keep off the faces that are left alone; 0: they may touch them</source>
        <translation>Wie weit Fräser, Schaft und Halter von den ausgesparten Flächen wegbleiben; 0: sie dürfen sie berühren</translation>
    </message>
    <message>
        <source>How far the controller may round corners, where it can; 0: exact path</source>
        <translation>Wie weit die Steuerung Ecken verschleifen darf, wo sie es kann; 0: genaue Bahn</translation>
    </message>
    <message>
        <source>How far the part should be turned about Z, counter-clockwise</source>
        <translation>Wie weit das Werkstück um Z gedreht werden sollte, gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>How far the tool axis may leave the surface normal, for the least deviation or to keep out of the part</source>
        <translation>Wie weit die Werkzeugachse von der Flächennormalen abweichen darf, für die kleinste Abweichung oder um nicht ins Werkstück einzudringen</translation>
    </message>
    <message>
        <source>How far the work zero may move to either side along X, Y, Z; 0: it stays</source>
        <translation>Wie weit der Werkstücknullpunkt längs X, Y, Z nach beiden Seiten wandern darf; 0: er bleibt</translation>
    </message>
    <message>
        <source>How many places along X, Y, Z the map shows</source>
        <translation>Wie viele Orte längs X, Y, Z die Karte zeigt</translation>
    </message>
    <message>
        <source>How many turns of the part about Z are tried, evenly over 360°; 1: as it stands</source>
        <translation>Wie viele Drehlagen des Werkstücks um Z versucht werden, gleichmäßig über 360°; 1: wie es steht</translation>
    </message>
    <message>
        <source>How much of the surface that is, in per cent</source>
        <translation>Wie viel der Fläche das ist, in Prozent</translation>
    </message>
    <message>
        <source>How much the tool reaches, in a plain sentence</source>
        <translation>Wie viel das Werkzeug erreicht, in einem Satz</translation>
    </message>
    <message>
        <source>How near the tool may come to fixtures and bodies of the machine before that is told</source>
        <translation>Wie nahe das Werkzeug Spannmitteln und Körpern der Maschine kommen darf, ehe das gemeldet wird</translation>
    </message>
    <message>
        <source>How the controller drives its axes in a rapid: all together, each at its own rate, or unknown; machine: as the machine file says</source>
        <translation>Wie die Steuerung ihre Achsen im Eilgang bewegt: alle gemeinsam, jede mit eigener Geschwindigkeit oder unbekannt; „die der Maschine“: wie es in der Maschinendatei steht</translation>
    </message>
    <message>
        <source>How the deviation from the line is computed: exactly, or by the model of So et al. 2008</source>
        <translation>Wie die Abweichung von der Geraden berechnet wird: genau oder nach dem Modell von So u. a. 2008</translation>
    </message>
    <message>
        <source>How the passes are laid over the part</source>
        <translation>Wie die Bahnen über das Teil gelegt werden</translation>
    </message>
    <message>
        <source>How the tool axis is found at each contact point</source>
        <translation>Wie die Werkzeugachse an jedem Berührpunkt bestimmt wird</translation>
    </message>
    <message>
        <source>How the tool axis is found at each contact point. facet_mean: surface normal; face_normal: normal to each face, turning at its edges; step_weighted: normal weighted by the step; minimax: least deviation; auto: free of the part; fixed: one axis everywhere; from_axis: square to the rotary axis and pointing at it</source>
        <translation>Wie die Werkzeugachse an jedem Berührpunkt bestimmt wird. facet_mean: Flächennormale; face_normal: senkrecht zu jeder Fläche, an ihren Kanten gedreht; step_weighted: nach Schrittlänge gewichtete Normale; minimax: kleinste Abweichung; auto: frei vom Werkstück; fixed: überall eine Achse; from_axis: senkrecht zur Rundachse und auf sie gerichtet</translation>
    </message>
    <message>
        <source>How the tool goes from one pass to the next: near the part where it is free, or over it</source>
        <translation>Weg des Werkzeugs von einer Bahn zur nächsten: nahe am Werkstück, wo er frei ist, oder darüber hinweg</translation>
    </message>
    <message>
        <source>How thick the jaws of a vise are of which is told how high they may reach</source>
        <translation>Wie dick die Schraubstockbacken sind, von denen gesagt wird, wie hoch sie reichen dürfen</translation>
    </message>
    <message>
        <source>In Closed Hollow</source>
        <translation>In geschlossenem Hohlraum</translation>
    </message>
    <message>
        <source>Jaw Thickness</source>
        <translation>Dicke der Backen</translation>
    </message>
    <message>
        <source>Kinds</source>
        <translation>Arten</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Beschriftungen</translation>
    </message>
    <message>
        <source>Largest Axis Angle</source>
        <translation>Größter Achswinkel</translation>
    </message>
    <message>
        <source>Largest Overcut</source>
        <translation>Größter Überschnitt</translation>
    </message>
    <message>
        <source>Largest Undercut</source>
        <translation>Größtes Restmaterial</translation>
    </message>
    <message>
        <source>Largest angle between neighbouring facets</source>
        <translation>Größter Winkel zwischen benachbarten Facetten</translation>
    </message>
    <message>
        <source>Largest angle between the tool axis and that of the CL file at the end of a block</source>
        <translation>Größter Winkel zwischen der Werkzeugachse und der der CL-Datei am Ende eines Satzes</translation>
    </message>
    <message>
        <source>Largest change of the tool axis where it is turned to pass the pole</source>
        <translation>Größte Änderung der Werkzeugachse, wo sie am Pol vorbeigedreht wird</translation>
    </message>
    <message>
        <source>Largest deviation in the recommended setup</source>
        <translation>Größte Abweichung in der empfohlenen Aufspannung</translation>
    </message>
    <message>
        <source>Largest deviation of the tip from the commanded segments</source>
        <translation>Größte Abweichung der Werkzeugspitze von den Sollstrecken</translation>
    </message>
    <message>
        <source>Largest deviation of the tip from the lines of the commanded segments</source>
        <translation>Größte Abweichung der Werkzeugspitze von den Geraden durch die Sollstrecken</translation>
    </message>
    <message>
        <source>Largest deviation of the tip from the programmed line</source>
        <translation>Größte Abweichung der Spitze von der programmierten Geraden</translation>
    </message>
    <message>
        <source>Largest deviation of what makes the surface, which the verdict goes by: a ball cutter's centre, or the tip</source>
        <translation>Größte Abweichung dessen, was die Fläche erzeugt und wonach das Urteil geht: die Mitte eines Kugelfräsers oder die Werkzeugspitze</translation>
    </message>
    <message>
        <source>Largest deviation where the work zero stood</source>
        <translation>Größte Abweichung dort, wo der Werkstücknullpunkt stand</translation>
    </message>
    <message>
        <source>Largest distance between cutter and a convex edge; beyond it the tool rolls around the edge in an arc</source>
        <translation>Größter Abstand zwischen Fräser und einer Außenkante; darüber rollt das Werkzeug in einem Bogen um die Kante</translation>
    </message>
    <message>
        <source>Largest distance of a facet from the surface</source>
        <translation>Größter Abstand einer Facette von der Fläche</translation>
    </message>
    <message>
        <source>Largest height of the ridges that stay between two passes</source>
        <translation>Größte Höhe der Grate, die zwischen zwei Bahnen stehen bleiben</translation>
    </message>
    <message>
        <source>Lead</source>
        <translation>Voreilwinkel</translation>
    </message>
    <message>
        <source>Lead In</source>
        <translation>Anfahrradius</translation>
    </message>
    <message>
        <source>Lead angle: how far the tool leans in the feed direction; above 0 its top goes ahead of its tip</source>
        <translation>Voreilwinkel: wie weit das Werkzeug in Vorschubrichtung geneigt ist; über 0 eilt sein oberes Ende der Spitze voraus</translation>
    </message>
    <message>
        <source>Least Interval</source>
        <translation>Kleinster Zeilensprung</translation>
    </message>
    <message>
        <source>Leave one line of the legend</source>
        <translation>Von der Legende nur eine Zeile zeigen</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Restmaterial</translation>
    </message>
    <message>
        <source>Length of the cutter's edge, from the tip upwards; of a lollipop with its neck</source>
        <translation>Länge der Schneide des Fräsers, von der Spitze aufwärts; beim Lollipop-Fräser mit dem Hals</translation>
    </message>
    <message>
        <source>Length of the tool axes; 0: as the part needs it</source>
        <translation>Länge der Werkzeugachsen; 0: dem Werkstück angemessen</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Ampel</translation>
    </message>
    <message>
        <source>Line Width</source>
        <translation>Linienbreite</translation>
    </message>
    <message>
        <source>Linear Deflection</source>
        <translation>Sehnenabweichung</translation>
    </message>
    <message>
        <source>Linearize</source>
        <translation>Linearisieren</translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Machine File</source>
        <translation>Maschinendatei</translation>
    </message>
    <message>
        <source>Machine In The Way</source>
        <translation>Maschine im Weg</translation>
    </message>
    <message>
        <source>Machined Area</source>
        <translation>Bearbeitete Fläche</translation>
    </message>
    <message>
        <source>Machined surface on which more is left than is allowed</source>
        <translation>Bearbeitete Fläche, auf der mehr stehen bleibt als erlaubt</translation>
    </message>
    <message>
        <source>Machined surface that is cut too deep by more than the tolerance</source>
        <translation>Bearbeitete Fläche, die um mehr als die Toleranz zu tief gefräst wird</translation>
    </message>
    <message>
        <source>Made Of</source>
        <translation>Gemacht aus</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>Marke</translation>
    </message>
    <message>
        <source>Mark From Machine</source>
        <translation>Marke von der Maschine</translation>
    </message>
    <message>
        <source>Marker Size</source>
        <translation>Markierungsgröße</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Markierungen</translation>
    </message>
    <message>
        <source>Max Axis Angle</source>
        <translation>Steilste Facette</translation>
    </message>
    <message>
        <source>Max Axis Change</source>
        <translation>Größte Achsänderung</translation>
    </message>
    <message>
        <source>Max Bound</source>
        <translation>Größte Schranke</translation>
    </message>
    <message>
        <source>Max Line Deviation</source>
        <translation>Größte Abweichung von der Geraden</translation>
    </message>
    <message>
        <source>Max Segment Deviation</source>
        <translation>Größte Abweichung von der Strecke</translation>
    </message>
    <message>
        <source>Max Surface Bound</source>
        <translation>Größte Schranke der Fläche</translation>
    </message>
    <message>
        <source>Max Surface Deviation</source>
        <translation>Größte Abweichung der Fläche</translation>
    </message>
    <message>
        <source>Max Tilt</source>
        <translation>Größte Neigung</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Most positions in which the rotary axes are locked while passes are cut, 1 to 12: as many as are worth it</source>
        <translation>Höchstzahl der Stellungen, in denen die Rundachsen geklemmt sind, während Bahnen geschnitten werden, 1 bis 12: so viele, wie sich lohnen</translation>
    </message>
    <message>
        <source>Most that is left on the machined surface</source>
        <translation>So viel bleibt auf der bearbeiteten Fläche höchstens stehen</translation>
    </message>
    <message>
        <source>NC file</source>
        <translation>NC-Datei</translation>
    </message>
    <message>
        <source>NC line of the block with the largest deviation; 0: none</source>
        <translation>NC-Zeile des Satzes mit der größten Abweichung; 0: keine</translation>
    </message>
    <message>
        <source>NCFile</source>
        <translation>NC-Datei</translation>
    </message>
    <message>
        <source>Number of the CL file's tool whose moves are meant; empty: all</source>
        <translation>Nummer des Werkzeugs der CL-Datei, dessen Bewegungen gemeint sind; leer: alle</translation>
    </message>
    <message>
        <source>Number of the tool; not given: the program calls no tool, the operator sets tool and length</source>
        <translation>Nummer des Werkzeugs; ohne Angabe ruft das Programm kein Werkzeug, der Bediener stellt Werkzeug und Länge ein</translation>
    </message>
    <message>
        <source>Of the mesh and the settings that the result is of</source>
        <translation>Des Netzes und der Einstellungen, zu denen das Ergebnis gehört</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Reihenfolge</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Nullpunkt auf der Maschine</translation>
    </message>
    <message>
        <source>Origin From Machine</source>
        <translation>Nullpunkt aus der Maschinendatei</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Ausgabe</translation>
    </message>
    <message>
        <source>Over Tolerance</source>
        <translation>Über der Toleranz</translation>
    </message>
    <message>
        <source>Overcut Area</source>
        <translation>Überschnittene Fläche</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Werkstück</translation>
    </message>
    <message>
        <source>Part Label</source>
        <translation>Name des Teils</translation>
    </message>
    <message>
        <source>Pass Axis</source>
        <translation>Bahnachse</translation>
    </message>
    <message>
        <source>Pass Axis Picked</source>
        <translation>Bahnachse gewählt</translation>
    </message>
    <message>
        <source>Pass Centre</source>
        <translation>Bahnmitte</translation>
    </message>
    <message>
        <source>Pass Centre Picked</source>
        <translation>Bahnmitte gewählt</translation>
    </message>
    <message>
        <source>Pass Strategy</source>
        <translation>Bahnstrategie</translation>
    </message>
    <message>
        <source>Pass strategy. planes: parallel planes; zlevel: level planes; scallop: constant scallop; morph: from one guide curve to another; radial: about an axis; rotary: around or along an axis about which the part turns; frames: constant scallop in few positions of locked rotary axes</source>
        <translation>Bahnstrategie. planes: parallele Ebenen; zlevel: Höhenebenen; scallop: gleiche Kuppenhöhe; morph: von einer Leitlinie zur anderen; radial: um eine Achse; rotary: um oder längs einer Achse, um die sich das Werkstück dreht; frames: gleiche Kuppenhöhe in wenigen Stellungen geklemmter Rundachsen</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Bahnen</translation>
    </message>
    <message>
        <source>Passes From</source>
        <translation>Bahnen ab</translation>
    </message>
    <message>
        <source>Passes From Picked</source>
        <translation>Bahnanfang gewählt</translation>
    </message>
    <message>
        <source>Passes To</source>
        <translation>Bahnen bis</translation>
    </message>
    <message>
        <source>Passes To Picked</source>
        <translation>Bahnende gewählt</translation>
    </message>
    <message>
        <source>Passes come no closer than this, also on steep walls</source>
        <translation>Enger liegen die Bahnen nicht, auch nicht an steilen Wänden</translation>
    </message>
    <message>
        <source>Passes over the part</source>
        <translation>Bahnen über das Werkstück</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Werkzeugweg</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>Orte</translation>
    </message>
    <message>
        <source>Plane Normal</source>
        <translation>Ebenennormale</translation>
    </message>
    <message>
        <source>Plunge Feed</source>
        <translation>Eintauchvorschub</translation>
    </message>
    <message>
        <source>Plunge Feed Per Minute</source>
        <translation>Eintauchvorschub pro Minute</translation>
    </message>
    <message>
        <source>Point of the axis that radial passes radiate from and rotary ones turn about: X,Y,Z, or middle (of what is cut; rotary: of the machine's only rotary axis, else of the part)</source>
        <translation>Punkt der Achse, von der radiale Bahnen ausgehen und um die rotierende laufen: X,Y,Z oder Mitte (middle) dessen, was bearbeitet wird ( rotierend: der einzigen Rundachse der Maschine, sonst des Werkstücks)</translation>
    </message>
    <message>
        <source>Point of the tool that the program moves: the tip, or the centre of the corner radius</source>
        <translation>Punkt des Werkzeugs, den das Programm bewegt: die Spitze oder die Mitte des Eckenradius</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Program Units</source>
        <translation>Programmeinheit</translation>
    </message>
    <message>
        <source>Proven</source>
        <translation>Bewiesen</translation>
    </message>
    <message>
        <source>Proven upper bound of the deviation of what makes the surface</source>
        <translation>Bewiesene obere Schranke der Abweichung dessen, was die Fläche erzeugt</translation>
    </message>
    <message>
        <source>Proven upper bound of the tip's deviation from the commanded segments</source>
        <translation>Bewiesene obere Schranke der Abweichung der Werkzeugspitze von den Sollstrecken</translation>
    </message>
    <message>
        <source>Radius Too Large</source>
        <translation>Radius zu groß um</translation>
    </message>
    <message>
        <source>Radius of a barrel's flank, more than half its diameter; other kinds have none</source>
        <translation>Radius der Flanke eines Tonnenfräsers, größer als sein halber Durchmesser; andere Arten haben keinen</translation>
    </message>
    <message>
        <source>Radius of the arc tangent to the surface on which the tool enters and leaves a pass; 0: along its axis</source>
        <translation>Radius des Bogens tangential zur Fläche, auf dem das Werkzeug in eine Bahn ein- und aus ihr ausfährt; 0: entlang seiner Achse</translation>
    </message>
    <message>
        <source>Rapid moves stay this far off the part's bounding box</source>
        <translation>So weit bleiben Eilgänge vom Hüllquader des Werkstücks weg</translation>
    </message>
    <message>
        <source>Rapids</source>
        <translation>Eilgänge</translation>
    </message>
    <message>
        <source>Reachable Area</source>
        <translation>Erreichte Fläche</translation>
    </message>
    <message>
        <source>Reachable Share</source>
        <translation>Erreichter Anteil</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Einlesen</translation>
    </message>
    <message>
        <source>Recommended</source>
        <translation>Empfohlen</translation>
    </message>
    <message>
        <source>Recommended Turn</source>
        <translation>Empfohlene Drehung</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Rings around the rotary axis, which spiral passes make one helix, or lines along it</source>
        <translation>Ringe um die Rundachse, aus denen Spiralbahnen eine Wendel machen, oder Linien längs der Achse</translation>
    </message>
    <message>
        <source>Rotary By</source>
        <translation>Bahnen um / längs der Rundachse</translation>
    </message>
    <message>
        <source>Rtcp</source>
        <translation>RTCP</translation>
    </message>
    <message>
        <source>Safety</source>
        <translation>Sicherheit</translation>
    </message>
    <message>
        <source>Scallop</source>
        <translation>Kuppenhöhe</translation>
    </message>
    <message>
        <source>Schema Version</source>
        <translation>Schemaversion</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchordner</translation>
    </message>
    <message>
        <source>Setup</source>
        <translation>Aufspannung</translation>
    </message>
    <message>
        <source>Shank</source>
        <translation>Schaft</translation>
    </message>
    <message>
        <source>Shank In The Way</source>
        <translation>Schaft im Weg</translation>
    </message>
    <message>
        <source>Shape and sizes of the cutter</source>
        <translation>Form und Maße des Fräsers</translation>
    </message>
    <message>
        <source>Show All Places</source>
        <translation>Alle Plätze zeigen</translation>
    </message>
    <message>
        <source>Show Axes</source>
        <translation>Werkzeugachsen zeigen</translation>
    </message>
    <message>
        <source>Show Curves</source>
        <translation>Kurven zeigen</translation>
    </message>
    <message>
        <source>Show Cuts</source>
        <translation>Schnitte zeigen</translation>
    </message>
    <message>
        <source>Show Label</source>
        <translation>Beschriftung zeigen</translation>
    </message>
    <message>
        <source>Show Legend</source>
        <translation>Legende zeigen</translation>
    </message>
    <message>
        <source>Show Links</source>
        <translation>Verbindungen zeigen</translation>
    </message>
    <message>
        <source>Show Markers</source>
        <translation>Markierungen zeigen</translation>
    </message>
    <message>
        <source>Show Rapids</source>
        <translation>Eilgänge zeigen</translation>
    </message>
    <message>
        <source>Show blocks over the tolerance and near the pole</source>
        <translation>NC-Sätze über der Toleranz und nahe am Pol zeigen</translation>
    </message>
    <message>
        <source>Show the places at all heights, not only those at the recommended one</source>
        <translation>Die Plätze in allen Höhen zeigen, nicht nur die in der empfohlenen</translation>
    </message>
    <message>
        <source>Show the rapids</source>
        <translation>Die Eilgänge zeigen</translation>
    </message>
    <message>
        <source>Show the real curve of the worst blocks beside the commanded line</source>
        <translation>Die wirkliche Kurve der schlimmsten NC-Sätze neben der Sollstrecke zeigen</translation>
    </message>
    <message>
        <source>Show the tool axis here and there on the path</source>
        <translation>Die Werkzeugachse hier und da auf dem Werkzeugweg zeigen</translation>
    </message>
    <message>
        <source>Show the tool axis with which each place is reached, as a short stroke</source>
        <translation>Die Werkzeugachse, mit der jede Stelle erreicht wird, als kurzen Strich zeigen</translation>
    </message>
    <message>
        <source>Show the value at the largest deviation</source>
        <translation>Den Wert an der größten Abweichung zeigen</translation>
    </message>
    <message>
        <source>Show the value at the recommended place</source>
        <translation>Den Wert am empfohlenen Ort zeigen</translation>
    </message>
    <message>
        <source>Show the values where most is left and where the cut is deepest</source>
        <translation>Die Werte zeigen, wo am meisten stehen bleibt und wo am tiefsten gefräst wird</translation>
    </message>
    <message>
        <source>Show the ways between passes at feed, and where the tool is lifted off the part</source>
        <translation>Die Wege zwischen den Bahnen im Vorschub zeigen, und wo das Werkzeug vom Werkstück abgehoben ist</translation>
    </message>
    <message>
        <source>Show what cuts, in the colours of its deviation</source>
        <translation>Zeigen, was schneidet, in den Farben seiner Abweichung</translation>
    </message>
    <message>
        <source>Show what the colours mean</source>
        <translation>Zeigen, was die Farben bedeuten</translation>
    </message>
    <message>
        <source>Singular Blocks</source>
        <translation>Singuläre NC-Sätze</translation>
    </message>
    <message>
        <source>Singularity</source>
        <translation>Singularität</translation>
    </message>
    <message>
        <source>Size of the markers in pixels</source>
        <translation>Größe der Markierungen in Bildpunkten</translation>
    </message>
    <message>
        <source>Slow Feed</source>
        <translation>Langsamer Vorschub</translation>
    </message>
    <message>
        <source>Slow Feed Per Minute</source>
        <translation>Langsamer Vorschub pro Minute</translation>
    </message>
    <message>
        <source>So far the tool may lean from the work frame's Z; 180°: as far as the machine turns</source>
        <translation>So weit darf sich das Werkzeug gegen Z des Werkstücks neigen; 180°: so weit die Maschine schwenkt</translation>
    </message>
    <message>
        <source>So much farther the tool should stick out where holder, fixture or machine are in the way</source>
        <translation>Um so viel sollte das Werkzeug weiter auskragen, wo Halter, Spannmittel oder Maschine im Weg sind</translation>
    </message>
    <message>
        <source>So much may be left: twice the scallop, and the tolerance</source>
        <translation>So viel darf stehen bleiben: die doppelte Kuppenhöhe und die Toleranz</translation>
    </message>
    <message>
        <source>Solids and meshes of the document that hold the part, as in the tool path, which takes a change</source>
        <translation>Körper und Netze des Dokuments, die das Teil halten: dieselben wie im Werkzeugweg, der eine Änderung übernimmt</translation>
    </message>
    <message>
        <source>Solids and meshes of the document that hold the part: the path goes around them</source>
        <translation>Körper und Netze des Dokuments, die das Teil halten: die Bahn führt darum herum</translation>
    </message>
    <message>
        <source>Solids and meshes of the document that hold the part: the tool is checked against them</source>
        <translation>Körper und Netze des Dokuments, die das Teil halten: das Werkzeug wird gegen sie geprüft</translation>
    </message>
    <message>
        <source>Solids and meshes of the document that hold the part: they are in the tool's way</source>
        <translation>Körper und Netze des Dokuments, die das Werkstück halten: sie sind dem Werkzeug im Weg</translation>
    </message>
    <message>
        <source>Spindle</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>Spindle speed, 1/min; not given (0): the program does not start the spindle</source>
        <translation>Spindeldrehzahl, 1/min; ohne Angabe (0): das Programm schaltet die Spindel nicht ein</translation>
    </message>
    <message>
        <source>Spiral</source>
        <translation>Spirale</translation>
    </message>
    <message>
        <source>Start and stop of the facets that are left alone</source>
        <translation>Anfang und Ende der Facetten, die ausgespart werden</translation>
    </message>
    <message>
        <source>Start and stop of the facets that are milled</source>
        <translation>Anfang und Ende der Facetten, die gefräst werden</translation>
    </message>
    <message>
        <source>Steep Shallow</source>
        <translation>Steil ab</translation>
    </message>
    <message>
        <source>Stepover</source>
        <translation>Zeilensprung</translation>
    </message>
    <message>
        <source>Stick Out</source>
        <translation>Auskragung</translation>
    </message>
    <message>
        <source>Stick Out Area</source>
        <translation>Fläche durch Auskragung</translation>
    </message>
    <message>
        <source>Surface for which no axis that was tried is within the machine's limits</source>
        <translation>Fläche, für die keine versuchte Achse in den Grenzen der Maschine liegt</translation>
    </message>
    <message>
        <source>Surface in hollows of the part that are closed all round: no tool gets in</source>
        <translation>Fläche in Hohlräumen des Werkstücks, die ringsum geschlossen sind: Kein Werkzeug kommt hinein</translation>
    </message>
    <message>
        <source>Surface that the tool reaches, with an axis that was tried</source>
        <translation>Fläche, die das Werkzeug mit einer versuchten Achse erreicht</translation>
    </message>
    <message>
        <source>Surface that the tool then reaches besides</source>
        <translation>Fläche, die das Werkzeug dann zusätzlich erreicht</translation>
    </message>
    <message>
        <source>Surface where a part of the tool would be below the table's face</source>
        <translation>Fläche, bei der ein Teil des Werkzeugs unter der Tischfläche läge</translation>
    </message>
    <message>
        <source>Surface where cutter and shank would be free, but not the holder</source>
        <translation>Fläche, bei der Fräser und Schaft frei wären, der Halter aber nicht</translation>
    </message>
    <message>
        <source>Surface where the cutter would be free, but not the shank</source>
        <translation>Fläche, bei der der Fräser frei wäre, der Schaft aber nicht</translation>
    </message>
    <message>
        <source>Surface where the cutter's end would be free, but not what of the cutter is above it</source>
        <translation>Fläche, bei der das Ende des Fräsers frei wäre, aber nicht, was vom Fräser darüber ist</translation>
    </message>
    <message>
        <source>Surface where the cutter's end would enter the part, however it leans</source>
        <translation>Fläche, bei der schon das Ende des Fräsers ins Werkstück dränge, wie auch immer er geneigt ist</translation>
    </message>
    <message>
        <source>Surface where the part would let the tool, but fixtures are in the way</source>
        <translation>Oberfläche, an der das Werkstück das Werkzeug ließe, aber Spannmittel im Weg sind</translation>
    </message>
    <message>
        <source>Surface where the tool would be free, but bodies of the machine are in the way</source>
        <translation>Oberfläche, an der das Werkzeug frei wäre, aber Körper der Maschine im Weg sind</translation>
    </message>
    <message>
        <source>Surfaces steeper than this are not machined; with auto no tool axis leans more. 0: 90 deg; with auto all that the machine reaches above its table</source>
        <translation>Steilere Flächen werden nicht bearbeitet; bei auto neigt sich keine Werkzeugachse weiter. 0: 90 Grad; bei auto alles, was die Maschine über ihrem Tisch erreicht</translation>
    </message>
    <message>
        <source>Table Height</source>
        <translation>Tischhöhe</translation>
    </message>
    <message>
        <source>Take the cutter that the program names, or the file to compare with</source>
        <translation>Den Fräser nehmen, den das Programm nennt oder die Datei, mit der verglichen wird</translation>
    </message>
    <message>
        <source>Take the work zero's place on the machine from the machine's file</source>
        <translation>Die Lage des Werkstücknullpunkts auf der Maschine der Maschinendatei entnehmen</translation>
    </message>
    <message>
        <source>Tessellation</source>
        <translation>Tessellierung</translation>
    </message>
    <message>
        <source>The NC file</source>
        <translation>Die NC-Datei</translation>
    </message>
    <message>
        <source>The NC file that is judged</source>
        <translation>Die NC-Datei, die geprüft wird</translation>
    </message>
    <message>
        <source>The cutters of the setup, one a line: number, shape with its sizes, name</source>
        <translation>Die Fräser der Aufspannung, einer je Zeile: Nummer, Form mit Maßen, Name</translation>
    </message>
    <message>
        <source>The edge or round face whose axis the radial passes have; empty: as typed</source>
        <translation>Die Kante oder runde Fläche, deren Achse die strahlenförmigen Bahnen haben; leer: wie eingegeben</translation>
    </message>
    <message>
        <source>The face, or the closed edges, at which the passes end; empty: as typed</source>
        <translation>Die Fläche oder die geschlossenen Kanten, an denen die Bahnen enden; leer: wie eingegeben</translation>
    </message>
    <message>
        <source>The file is what the toolpath makes now; if it is not, post-process again</source>
        <translation>Die Datei ist, was der Werkzeugweg jetzt ergibt; sonst die NC-Datei neu ausgeben</translation>
    </message>
    <message>
        <source>The largest deviation at each place, mm</source>
        <translation>Die größte Abweichung an jedem Ort, mm</translation>
    </message>
    <message>
        <source>The machined surface: what the map covers</source>
        <translation>Die bearbeitete Fläche: was die Karte umfasst</translation>
    </message>
    <message>
        <source>The map is of the part and the settings as they are now</source>
        <translation>Die Karte gilt für Werkstück und Einstellungen, wie sie jetzt sind</translation>
    </message>
    <message>
        <source>The map is of the toolpath as it is now</source>
        <translation>Die Karte gehört zum Werkzeugweg, wie er jetzt ist</translation>
    </message>
    <message>
        <source>The map is of the toolpath as it is now; if it is not, try the setups again</source>
        <translation>Die Karte gehört zum Werkzeugweg, wie er jetzt ist; sonst die Aufspannungen neu erproben</translation>
    </message>
    <message>
        <source>The name of the part that was chosen last: one that is deleted is missed</source>
        <translation>Der Name des zuletzt gewählten Teils: eines, das gelöscht ist, wird vermisst</translation>
    </message>
    <message>
        <source>The place of the work zero in the document</source>
        <translation>Die Lage des Werkstücknullpunkts im Dokument</translation>
    </message>
    <message>
        <source>The proven bound of every block is within the tolerance</source>
        <translation>Die bewiesene Schranke jedes NC-Satzes liegt in der Toleranz</translation>
    </message>
    <message>
        <source>The setup whose machine, controller and work zero the path takes; empty: its own</source>
        <translation>Die Aufspannung, deren Maschine, Steuerung und Nullpunkt der Weg übernimmt; leer: eigene</translation>
    </message>
    <message>
        <source>The solid or mesh of the document that the program is compared with</source>
        <translation>Der Körper oder das Netz des Dokuments, mit dem das Programm verglichen wird</translation>
    </message>
    <message>
        <source>The solid, body, compound or mesh, and the faces of it that are milled</source>
        <translation>Der Volumenkörper, Körper, Verbund oder das Netz, und seine Flächen, die gefräst werden</translation>
    </message>
    <message>
        <source>The surface that was looked at</source>
        <translation>Die betrachtete Fläche</translation>
    </message>
    <message>
        <source>The tessellation, or any mesh, that is milled</source>
        <translation>Die Tessellierung oder ein anderes Netz, das gefräst wird</translation>
    </message>
    <message>
        <source>The tessellation, or any mesh, that the tool is to reach</source>
        <translation>Die Tessellation oder irgendein Netz, die das Werkzeug erreichen soll</translation>
    </message>
    <message>
        <source>The toolpath or audit that is marked</source>
        <translation>Der Werkzeugweg oder die Prüfung, die markiert wird</translation>
    </message>
    <message>
        <source>The toolpath that is shown</source>
        <translation>Der Werkzeugweg, der gezeigt wird</translation>
    </message>
    <message>
        <source>The toolpath that the file is made from</source>
        <translation>Der Werkzeugweg, aus dem die Datei entsteht</translation>
    </message>
    <message>
        <source>The toolpath whose cutter leaves what the map shows</source>
        <translation>Der Werkzeugweg, dessen Fräser stehen lässt, was die Karte zeigt</translation>
    </message>
    <message>
        <source>The toolpath whose part is to be clamped</source>
        <translation>Der Werkzeugweg, dessen Werkstück aufgespannt werden soll</translation>
    </message>
    <message>
        <source>The verdict as a traffic light: red, amber or green</source>
        <translation>Das Urteil als Ampel: red (rot), amber (gelb) oder green (grün)</translation>
    </message>
    <message>
        <source>The vertex or edge where the passes begin; empty: as typed</source>
        <translation>Die Ecke oder Kante, an der die Bahnen beginnen; leer: wie eingegeben</translation>
    </message>
    <message>
        <source>The vertex or edge where the passes end; empty: as typed</source>
        <translation>Die Ecke oder Kante, an der die Bahnen enden; leer: wie eingegeben</translation>
    </message>
    <message>
        <source>The vertex, circle or sphere that is the centre of radial passes; empty: as typed</source>
        <translation>Die Ecke, der Kreis oder die Kugel als Mitte strahlenförmiger Bahnen; leer: wie eingegeben</translation>
    </message>
    <message>
        <source>The work zero in the machine frame about which setups were tried</source>
        <translation>Der Werkstücknullpunkt im Maschinensystem, um den herum Aufspannungen erprobt wurden</translation>
    </message>
    <message>
        <source>Tighter Than Cutter</source>
        <translation>Zu eng für den Fräser</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Seitwinkel</translation>
    </message>
    <message>
        <source>Tilt angle: how far the tool leans across the feed direction; above 0 its top stands to the right of the feed</source>
        <translation>Seitwinkel: wie weit das Werkzeug quer zur Vorschubrichtung geneigt ist; über 0 steht sein oberes Ende rechts vom Vorschub</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Time After</source>
        <translation>Zeit nachher</translation>
    </message>
    <message>
        <source>Time Before</source>
        <translation>Zeit vorher</translation>
    </message>
    <message>
        <source>Time of the program in the recommended setup</source>
        <translation>Zeit des Programms in der empfohlenen Aufspannung</translation>
    </message>
    <message>
        <source>Time of the program where the work zero stood</source>
        <translation>Zeit des Programms dort, wo der Werkstücknullpunkt stand</translation>
    </message>
    <message>
        <source>Time that the program takes</source>
        <translation>Laufzeit des Programms</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Tool Axis</source>
        <translation>Werkzeugachse</translation>
    </message>
    <message>
        <source>Tool Length</source>
        <translation>Werkzeuglänge</translation>
    </message>
    <message>
        <source>Tool centre point control (RTCP, TCPM, TRAORI): the controller guides the tip itself; off: the program gives the positions of all axes</source>
        <translation>Werkzeugspitzenführung (RTCP, TCPM, TRAORI): die Steuerung führt die Spitze selbst; aus: das Programm gibt die Stellungen aller Achsen</translation>
    </message>
    <message>
        <source>Toolpath</source>
        <translation>Werkzeugweg</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Travel</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Drehungen</translation>
    </message>
    <message>
        <source>Uncut Area</source>
        <translation>Ungefräste Fläche</translation>
    </message>
    <message>
        <source>Uncut Volume</source>
        <translation>Ungefrästes Volumen</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Einheiten</translation>
    </message>
    <message>
        <source>Units of a program that does not say them itself</source>
        <translation>Einheiten eines Programms, das sie nicht selbst nennt</translation>
    </message>
    <message>
        <source>Units of lengths and feeds in the NC file; machine: as the machine file says, else mm</source>
        <translation>Einheit der Längen und Vorschübe in der NC-Datei; „die der Maschine“: wie es in der Maschinendatei steht, sonst mm</translation>
    </message>
    <message>
        <source>Up To Date</source>
        <translation>Auf dem neuesten Stand</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Way of the tip along the part</source>
        <translation>Weg der Werkzeugspitze am Werkstück entlang</translation>
    </message>
    <message>
        <source>What F means. g93: inverse time; g94: feed per minute</source>
        <translation>Bedeutung von F. g93: zeitreziprok; g94: Vorschub je Minute</translation>
    </message>
    <message>
        <source>What a word without a decimal point counts: X100 is 100 mm, or 0.1 mm</source>
        <translation>Was ein Wort ohne Dezimalpunkt zählt: X100 sind 100 mm oder 0,1 mm</translation>
    </message>
    <message>
        <source>What each marker marks</source>
        <translation>Was jede Markierung bezeichnet</translation>
    </message>
    <message>
        <source>What each place is</source>
        <translation>Was jeder Ort ist</translation>
    </message>
    <message>
        <source>What is left beyond what is allowed</source>
        <translation>Was über das Erlaubte hinaus stehen bleibt</translation>
    </message>
    <message>
        <source>What is left, in a plain sentence</source>
        <translation>Was stehen bleibt, in einem einfachen Satz</translation>
    </message>
    <message>
        <source>What is recommended, in a plain sentence</source>
        <translation>Was empfohlen wird, in einem einfachen Satz</translation>
    </message>
    <message>
        <source>What stays inside the boundary: the contact, or the cutter's centre</source>
        <translation>Was innerhalb der Begrenzung bleibt: der Berührpunkt oder die Fräsermitte</translation>
    </message>
    <message>
        <source>What the result says about itself, in plain sentences</source>
        <translation>Was das Ergebnis über sich selbst sagt, in einfachen Sätzen</translation>
    </message>
    <message>
        <source>What to do near the pole, where a rotary axis turns far to lean the tool a little</source>
        <translation>Was nahe am Pol geschieht, wo eine Rundachse weit dreht, um das Werkzeug wenig zu neigen</translation>
    </message>
    <message>
        <source>What to do where cutter, shank or holder would enter the part</source>
        <translation>Was geschieht, wo Fräser, Schaft oder Halter in das Werkstück eindringen würde</translation>
    </message>
    <message>
        <source>What would help where holder, fixture, machine or cutter are in the way, in plain sentences</source>
        <translation>Was hülfe, wo Halter, Spannmittel, Maschine oder Fräser im Weg sind, in einfachen Sätzen</translation>
    </message>
    <message>
        <source>Where constant-scallop and morph passes begin: border (of the region), X,Y,Z of a point, or a CSV file with the points of a curve (or these, a ; between two)</source>
        <translation>Wo Bahnen gleicher Kuppenhöhe und Übergangsbahnen beginnen: Rand (border) des Bereichs, X,Y,Z eines Punktes oder eine CSV-Datei mit den Punkten einer Kurve (oder diese selbst, ein ; zwischen zweien)</translation>
    </message>
    <message>
        <source>Where morph passes end: border (of the region), X,Y,Z of a point, or a CSV file with the points of a curve (or these, a ; between two)</source>
        <translation>Wo Übergangsbahnen enden: Rand (border) des Bereichs, X,Y,Z eines Punktes oder eine CSV-Datei mit den Punkten einer Kurve (oder diese selbst, ein ; zwischen zweien)</translation>
    </message>
    <message>
        <source>Where something stays unfinished, try what would finish more, and name it</source>
        <translation>Wo etwas unfertig bleibt, versuchen, was mehr fertig bearbeiten würde, und es nennen</translation>
    </message>
    <message>
        <source>Where the markers stand in the document</source>
        <translation>Wo die Markierungen im Dokument stehen</translation>
    </message>
    <message>
        <source>Where the parts that hold the base and the mesh stood when the mesh was made</source>
        <translation>Wo die Teile standen, in denen Basis und Netz stecken, als das Netz gemacht wurde</translation>
    </message>
    <message>
        <source>Where the surface is steeper than this from the horizontal, level planes are cut instead of the passes chosen; 0: nowhere</source>
        <translation>Wo die Fläche steiler zur Waagrechten steht als so viel, werden waagrechte Ebenen gefräst statt der gewählten Bahnen; 0: nirgends</translation>
    </message>
    <message>
        <source>Where the work zero should stand, in the machine frame</source>
        <translation>Wo der Werkstücknullpunkt stehen sollte, im Maschinensystem</translation>
    </message>
    <message>
        <source>Where the work zero stands in the machine's coordinates</source>
        <translation>Wo der Werkstücknullpunkt in den Koordinaten der Maschine steht</translation>
    </message>
    <message>
        <source>Where the work zeros of the map lie in the document</source>
        <translation>Wo die Werkstücknullpunkte der Karte im Dokument liegen</translation>
    </message>
    <message>
        <source>Whether the program is safe to run, and why, in a plain sentence</source>
        <translation>Ob das Programm sicher ist und warum, in einem einfachen Satz</translation>
    </message>
    <message>
        <source>Whole Area</source>
        <translation>Ganze Fläche</translation>
    </message>
    <message>
        <source>Width of the path in pixels</source>
        <translation>Breite des Werkzeugwegs in Bildpunkten</translation>
    </message>
    <message>
        <source>Within Frames</source>
        <translation>In den Anstellungen</translation>
    </message>
    <message>
        <source>Work Offset</source>
        <translation>Nullpunktverschiebung</translation>
    </message>
    <message>
        <source>Work Zero</source>
        <translation>Werkstücknullpunkt</translation>
    </message>
    <message>
        <source>Work offset: G54 to G59; LinuxCNC also G59.1 to G59.3, Fanuc also G54.1 P1 to P300</source>
        <translation>Nullpunktverschiebung: G54 bis G59; LinuxCNC auch G59.1 bis G59.3, Fanuc auch G54.1 P1 bis P300</translation>
    </message>
    <message>
        <source>Worst Line</source>
        <translation>Schlimmste NC-Zeile</translation>
    </message>
    <message>
        <source>Written</source>
        <translation>Geschrieben</translation>
    </message>
    <message>
        <source>X,Y,Z over the work zero of a place to mark, as high as part and clamps reach</source>
        <translation>X,Y,Z über dem Werkstücknullpunkt: eine Stelle zum Anzeichnen, so hoch, wie Werkstück und Spannmittel reichen</translation>
    </message>
    <message>
        <source>Zigzag cuts in both directions, one way in one direction only</source>
        <translation>Zickzack fräst in beiden Richtungen, eine Richtung nur in einer</translation>
    </message>
    <message>
        <source>a folder with the programs that the program calls, beside its own; may be repeated</source>
        <translation>ein Ordner mit den Programmen, die das Programm aufruft, neben seinem eigenen; darf wiederholt werden</translation>
    </message>
    <message>
        <source>an STL file of a vise, clamp or other fixture, in the part's own place, or with the place of its zero behind it: FILE.stl@X,Y,Z in mm from the work zero, or FILE.stl@X,Y,Z,RX,RY,RZ with degrees, turned about X, then Y, then Z of the work zero; the tool is checked against it, and a path is laid around it; may be repeated</source>
        <translation>eine STL-Datei von Schraubstock, Spanneisen oder anderem Spannmittel, am Ort des Teils, oder mit dem Ort ihres Nullpunkts dahinter: DATEI.stl@X,Y,Z in mm vom Nullpunkt, oder DATEI.stl@X,Y,Z,RX,RY,RZ mit Grad, gedreht um X, dann Y, dann Z des Nullpunkts; das Werkzeug wird dagegen geprüft, und eine Bahn führt darum herum; mehrfach möglich</translation>
    </message>
    <message>
        <source>feed of all its moves, mm/min and deg/min</source>
        <translation>Vorschub aller Bewegungen, mm/min und Grad/min</translation>
    </message>
    <message>
        <source>the NC program that was posted from the CL path</source>
        <translation>das NC-Programm, das aus der CL-Bahn gemacht wurde</translation>
    </message>
    <message>
        <source>the machine file (.fcm) to write</source>
        <translation>die Maschinendatei (.fcm), die geschrieben wird</translation>
    </message>
    <message>
        <source>the tip stops so far above the mark, and never comes nearer</source>
        <translation>so weit über der Marke hält die Spitze an, und näher kommt sie nie</translation>
    </message>
    <message>
        <source>turn of each rotary axis</source>
        <translation>Drehung jeder Rundachse</translation>
    </message>
    <message>
        <source>way of each linear axis</source>
        <translation>Weg jeder Linearachse</translation>
    </message>
</context>
<context>
    <name>FiveAxis</name>
    <message>
        <source> 1/min</source>
        <translation> 1/min</translation>
    </message>
    <message>
        <source>1 pass, {length}, {time} of cutting at the feed, links not counted</source>
        <translation>1 Bahn, {length}, {time} Schnittzeit beim Vorschub, ohne Verbindungen</translation>
    </message>
    <message>
        <source>A controller with tool tip control (RTCP) guides the tip along the line itself.</source>
        <translation>Eine Steuerung mit Werkzeugspitzenführung (RTCP) führt die Spitze von sich aus auf der Geraden.</translation>
    </message>
    <message>
        <source>A line about it</source>
        <translation>Eine Zeile über sie</translation>
    </message>
    <message>
        <source>A longer tool, a slimmer holder, lead or tilt away from the wall; or leave such places out.</source>
        <translation>Ein längeres Werkzeug, ein schlankerer Halter, das Werkzeug von der Wand weg voreilen lassen oder zur Seite neigen; oder solche Stellen auslassen.</translation>
    </message>
    <message>
        <source>About how far facets may lie beside the solid; a clearance makes up for it</source>
        <translation>Etwa so weit dürfen Facetten neben dem Volumenkörper liegen; ein Abstand gleicht das aus</translation>
    </message>
    <message>
        <source>About {length}, {time} of cutting at the feed, links not counted; 1 in {one_in} passes is drawn</source>
        <translation>Etwa {length}, {time} Schnittzeit beim Vorschub, ohne Verbindungen; 1 von {one_in} Bahnen ist gezeichnet</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add a body</source>
        <translation>Einen Körper hinzufügen</translation>
    </message>
    <message>
        <source>Add an axis</source>
        <translation>Eine Achse hinzufügen</translation>
    </message>
    <message>
        <source>Add selected faces</source>
        <translation>Ausgewählte Flächen dazu</translation>
    </message>
    <message>
        <source>Advice</source>
        <translation>Rat</translation>
    </message>
    <message>
        <source>All axes to zero</source>
        <translation>Alle Achsen auf Null</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Allowance on faces to avoid</source>
        <translation>Abstand zu ausgesparten Flächen</translation>
    </message>
    <message>
        <source>Along or about which a positive word moves the tool relative to the work (ISO 841)</source>
        <translation>Entlang welcher oder um welche Richtung ein positives Wort das Werkzeug gegen das Werkstück bewegt (ISO 841)</translation>
    </message>
    <message>
        <source>An STL in mm, in machine coordinates with all axes at zero</source>
        <translation>Eine STL-Datei in mm, in Maschinenkoordinaten, alle Achsen auf Null</translation>
    </message>
    <message>
        <source>Annotate</source>
        <translation>Markieren</translation>
    </message>
    <message>
        <source>Another machine file (.fcm)…</source>
        <translation>Andere Maschinendatei (.fcm) …</translation>
    </message>
    <message>
        <source>Another task panel is open: close it first.</source>
        <translation>Ein anderer Aufgabendialog ist offen: ihn zuerst schließen.</translation>
    </message>
    <message>
        <source>Any point of the rotary axis's line in machine coordinates, with all axes at zero</source>
        <translation>Irgendein Punkt der Rundachse in Maschinenkoordinaten, alle Achsen auf Null</translation>
    </message>
    <message>
        <source>Applied: the largest deviation is now {deviation}.</source>
        <translation>Übernommen: die größte Abweichung ist jetzt {deviation}.</translation>
    </message>
    <message>
        <source>Applied: the largest deviation of the divided blocks is now {deviation}.</source>
        <translation>Übernommen: Die größte Abweichung der geteilten Sätze ist jetzt {deviation}.</translation>
    </message>
    <message>
        <source>Apply to the tool path</source>
        <translation>Für den Werkzeugweg übernehmen</translation>
    </message>
    <message>
        <source>Attach the selected solid</source>
        <translation>Gewählten Körper anhängen</translation>
    </message>
    <message>
        <source>Audit</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Axes, from the work to the tool</source>
        <translation>Achsen, vom Werkstück zum Werkzeug</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Axis of passes I, J, K</source>
        <translation>Achse der Bahnen I, J, K</translation>
    </message>
    <message>
        <source>Axis of the boundary I, J, K</source>
        <translation>Achse der Begrenzung I, J, K</translation>
    </message>
    <message>
        <source>Axis tolerance</source>
        <translation>Achstoleranz</translation>
    </message>
    <message>
        <source>Axis {letter}</source>
        <translation>Achse {letter}</translation>
    </message>
    <message>
        <source>Back to the first position</source>
        <translation>Zurück zur ersten Stellung</translation>
    </message>
    <message>
        <source>Before you start</source>
        <translation>Vor dem Start</translation>
    </message>
    <message>
        <source>Below the surface</source>
        <translation>Unter der Fläche</translation>
    </message>
    <message>
        <source>Below the table</source>
        <translation>Unter dem Tisch</translation>
    </message>
    <message>
        <source>Between two facets the axis turns evenly over the steps on either side (Lin and Ye).</source>
        <translation>Zwischen zwei Facetten dreht die Achse gleichmäßig über die Schritte auf beiden Seiten (Lin und Ye).</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>NC-Satz</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>NC-Sätze</translation>
    </message>
    <message>
        <source>Blocks near the pole are listed; the path stays as it is.</source>
        <translation>Sätze nahe am Pol werden aufgelistet; der Weg bleibt, wie er ist.</translation>
    </message>
    <message>
        <source>Blocks near the pole that are over tolerance are divided.</source>
        <translation>Sätze nahe am Pol, die über der Toleranz liegen, werden geteilt.</translation>
    </message>
    <message>
        <source>Blocks over tolerance</source>
        <translation>NC-Sätze über der Toleranz</translation>
    </message>
    <message>
        <source>Bodies</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Bodies that the tool must not hit</source>
        <translation>Körper, an die das Werkzeug nicht stoßen darf</translation>
    </message>
    <message>
        <source>Bodies, and what carries them: {}</source>
        <translation>Körper, und was sie trägt: {}</translation>
    </message>
    <message>
        <source>Boundary</source>
        <translation>Begrenzung</translation>
    </message>
    <message>
        <source>Boundary holds</source>
        <translation>Begrenzung hält</translation>
    </message>
    <message>
        <source>CL file</source>
        <translation>CL-Datei</translation>
    </message>
    <message>
        <source>CL files (*.apt *.cl *.cls *.ncl *.aptsource *.txt)</source>
        <translation>CL-Dateien (*.apt *.cl *.cls *.ncl *.aptsource *.txt)</translation>
    </message>
    <message>
        <source>Calculate</source>
        <translation>Berechnen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Carried by</source>
        <translation>Getragen von</translation>
    </message>
    <message>
        <source>Carries</source>
        <translation>Trägt</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Mittelpunkt</translation>
    </message>
    <message>
        <source>Centre of passes</source>
        <translation>Mitte der Bahnen</translation>
    </message>
    <message>
        <source>Centre off its segment</source>
        <translation>Kugelmitte neben Strecke</translation>
    </message>
    <message>
        <source>Certain within</source>
        <translation>Sicher auf</translation>
    </message>
    <message>
        <source>Choose a CSV file with the points of the curve</source>
        <translation>CSV-Datei mit den Punkten der Kurve wählen</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Datei wählen</translation>
    </message>
    <message>
        <source>Choose a machine file (.fcm)</source>
        <translation>Eine Maschinendatei (.fcm) wählen</translation>
    </message>
    <message>
        <source>Choose a tool file (.fctb)</source>
        <translation>Eine Werkzeugdatei (.fctb) wählen</translation>
    </message>
    <message>
        <source>Choose an NC file</source>
        <translation>Eine NC-Datei wählen</translation>
    </message>
    <message>
        <source>Choose the CL file (APT)</source>
        <translation>CL-Datei (APT) wählen</translation>
    </message>
    <message>
        <source>Choose the CL file that the program was made from.</source>
        <translation>Wählen Sie die CL-Datei, aus der das Programm gemacht wurde.</translation>
    </message>
    <message>
        <source>Choose the NC file that was made of it.</source>
        <translation>Wählen Sie die NC-Datei, die daraus gemacht wurde.</translation>
    </message>
    <message>
        <source>Choose the NC file to audit.</source>
        <translation>Die NC-Datei wählen, die geprüft werden soll.</translation>
    </message>
    <message>
        <source>Choose the file to import</source>
        <translation>Datei zum Übernehmen wählen</translation>
    </message>
    <message>
        <source>Choose the file to import.</source>
        <translation>Wählen Sie die Datei, die übernommen werden soll.</translation>
    </message>
    <message>
        <source>Choose the mesh of the body</source>
        <translation>Netz des Körpers wählen</translation>
    </message>
    <message>
        <source>Choose the vismach model</source>
        <translation>Vismach-Modell wählen</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Sicherheitsabstand</translation>
    </message>
    <message>
        <source>Clearance to fixtures</source>
        <translation>Abstand zu Spannmitteln</translation>
    </message>
    <message>
        <source>Click a point, or press Esc</source>
        <translation>Einen Punkt anklicken, oder Esc drücken</translation>
    </message>
    <message>
        <source>Click faces of the part in the 3D view first, several with Ctrl</source>
        <translation>Zuerst in der 3D-Ansicht Flächen des Werkstücks anklicken, mehrere mit Strg</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Collision between passes</source>
        <translation>Kollision zwischen Bahnen</translation>
    </message>
    <message>
        <source>Collision in a rapid</source>
        <translation>Kollision in einem Eilgang</translation>
    </message>
    <message>
        <source>Collision: {enters} in {entered}</source>
        <translation>Kollision: {enters} in {entered}</translation>
    </message>
    <message>
        <source>Collisions are not checked against it.</source>
        <translation>Kollisionen mit ihr werden nicht geprüft.</translation>
    </message>
    <message>
        <source>Comes from a position of the machine: the way to here is not known.</source>
        <translation>Kommt von einer Maschinenposition: der Weg hierher ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Compare machines</source>
        <translation>Maschinen vergleichen</translation>
    </message>
    <message>
        <source>Compare machines on {label}</source>
        <translation>Maschinen an {label} vergleichen</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>Vergleichen mit</translation>
    </message>
    <message>
        <source>Compare with a file</source>
        <translation>Mit einer Datei vergleichen</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>Coolant</source>
        <translation>Kühlmittel</translation>
    </message>
    <message>
        <source>Corner not reached</source>
        <translation>Ecke nicht erreicht</translation>
    </message>
    <message>
        <source>Corner radius</source>
        <translation>Eckenradius</translation>
    </message>
    <message>
        <source>Corner rounding</source>
        <translation>Verschleifen</translation>
    </message>
    <message>
        <source>Correction</source>
        <translation>Korrektur</translation>
    </message>
    <message>
        <source>Corrections</source>
        <translation>Korrekturen</translation>
    </message>
    <message>
        <source>Curves (*.csv)</source>
        <translation>Kurven (*.csv)</translation>
    </message>
    <message>
        <source>Cut pattern</source>
        <translation>Fräsmuster</translation>
    </message>
    <message>
        <source>Cut too deep</source>
        <translation>Zu tief gefräst</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <source>Cutter</source>
        <translation>Fräser</translation>
    </message>
    <message>
        <source>Cutter inside the part</source>
        <translation>Fräser im Werkstück</translation>
    </message>
    <message>
        <source>Cutting length</source>
        <translation>Schneidenlänge</translation>
    </message>
    <message>
        <source>Deepest below it: {depth}</source>
        <translation>Am tiefsten darunter: {depth}</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>Deviation of facets</source>
        <translation>Abweichung der Facetten</translation>
    </message>
    <message>
        <source>Deviation of the tip</source>
        <translation>Abweichung der Spitze</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Dips below the part</source>
        <translation>Taucht unter das Teil</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Direction of passes</source>
        <translation>Richtung der Bahnen</translation>
    </message>
    <message>
        <source>Distance of the ball's centre from the commanded line</source>
        <translation>Abstand der Kugelmitte von der Sollstrecke</translation>
    </message>
    <message>
        <source>Distance of the tip from the commanded line</source>
        <translation>Abstand der Werkzeugspitze von der Sollstrecke</translation>
    </message>
    <message>
        <source>Divide blocks</source>
        <translation>Sätze teilen</translation>
    </message>
    <message>
        <source>Do not save</source>
        <translation>Nicht speichern</translation>
    </message>
    <message>
        <source>Draw {label}</source>
        <translation>{label} zeichnen</translation>
    </message>
    <message>
        <source>Drive one group of axes after the other. Where the control interpolates rapids, set Rapids to interpolated, or say so in the machine file.</source>
        <translation>Eine Gruppe von Achsen nach der anderen fahren. Wo die Steuerung Eilgänge interpoliert, Eilgänge auf interpolated stellen, oder es in der Maschinendatei sagen.</translation>
    </message>
    <message>
        <source>Edge tolerance</source>
        <translation>Kantentoleranz</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Ändern</translation>
    </message>
    <message>
        <source>Edit a machine</source>
        <translation>Maschine bearbeiten</translation>
    </message>
    <message>
        <source>Edit setup {name}</source>
        <translation>Aufspannung {name} bearbeiten</translation>
    </message>
    <message>
        <source>Edit the setup: all its paths follow</source>
        <translation>Die Aufspannung ändern: alle ihre Wege folgen</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Faces to leave alone</source>
        <translation>Auszusparende Flächen</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>Feed mode</source>
        <translation>Vorschubart</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>File to import</source>
        <translation>Datei zum Übernehmen</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>Findings of {label}</source>
        <translation>Befunde zu {label}</translation>
    </message>
    <message>
        <source>First position: where the machine comes from is not known.</source>
        <translation>Erste Stellung: woher die Maschine kommt, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Five-axis</source>
        <translation>Fünfachsig</translation>
    </message>
    <message>
        <source>Fixed axis I, J, K</source>
        <translation>Feste Achse I, J, K</translation>
    </message>
    <message>
        <source>Fixture in a machine body</source>
        <translation>Spannmittel im Maschinenkörper</translation>
    </message>
    <message>
        <source>Fixture in the part</source>
        <translation>Spannmittel im Werkstück</translation>
    </message>
    <message>
        <source>Fixtures</source>
        <translation>Spannmittel</translation>
    </message>
    <message>
        <source>Flank radius</source>
        <translation>Flankenradius</translation>
    </message>
    <message>
        <source>Fold the legend</source>
        <translation>Legende einklappen</translation>
    </message>
    <message>
        <source>Folder of called programs</source>
        <translation>Ordner der aufgerufenen Programme</translation>
    </message>
    <message>
        <source>Follow the tip</source>
        <translation>Der Spitze folgen</translation>
    </message>
    <message>
        <source>Frames at most</source>
        <translation>Anstellungen höchstens</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>From a CAM Job…</source>
        <translation>Aus einem CAM-Auftrag …</translation>
    </message>
    <message>
        <source>From a document</source>
        <translation>Aus einem Dokument</translation>
    </message>
    <message>
        <source>From a tool file…</source>
        <translation>Aus einer Werkzeugdatei …</translation>
    </message>
    <message>
        <source>From setup {name}</source>
        <translation>Aus der Aufspannung {name}</translation>
    </message>
    <message>
        <source>From the gauge point to the tip: machines whose head turns need it</source>
        <translation>Vom Bezugspunkt bis zur Spitze: Maschinen mit drehendem Kopf brauchen sie</translation>
    </message>
    <message>
        <source>From the part's surface to the cutter</source>
        <translation>Von der Oberfläche des Werkstücks bis zum Fräser</translation>
    </message>
    <message>
        <source>From the setup…</source>
        <translation>Aus der Aufspannung …</translation>
    </message>
    <message>
        <source>Gap above the mark</source>
        <translation>Abstand über der Marke</translation>
    </message>
    <message>
        <source>Gauge point</source>
        <translation>Bezugspunkt der Spindel</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Gouge protection</source>
        <translation>Eindringschutz</translation>
    </message>
    <message>
        <source>Heel of the cutter in the part</source>
        <translation>Ferse des Fräsers im Werkstück</translation>
    </message>
    <message>
        <source>Height of the table</source>
        <translation>Höhe des Tisches</translation>
    </message>
    <message>
        <source>Height of the table's face</source>
        <translation>Höhe der Tischfläche</translation>
    </message>
    <message>
        <source>High end</source>
        <translation>Oberes Ende</translation>
    </message>
    <message>
        <source>High-speed mode</source>
        <translation>Hochgeschwindigkeitsmodus</translation>
    </message>
    <message>
        <source>Holder, Ø x length</source>
        <translation>Halter, Ø x Länge</translation>
    </message>
    <message>
        <source>How far the ball's centre, which makes the surface, is now from its commanded segment</source>
        <translation>Wie weit die Kugelmitte, die die Fläche erzeugt, jetzt von ihrer Sollstrecke entfernt ist</translation>
    </message>
    <message>
        <source>How far the mesh may leave the solid</source>
        <translation>Wie weit das Netz vom Volumenkörper abweichen darf</translation>
    </message>
    <message>
        <source>How far the tip is now from the segment that the block commands</source>
        <translation>Wie weit die Werkzeugspitze jetzt von der Sollstrecke des NC-Satzes entfernt ist</translation>
    </message>
    <message>
        <source>How far two neighbouring facets may lean apart</source>
        <translation>Wie weit zwei benachbarte Facetten gegeneinander geneigt sein dürfen</translation>
    </message>
    <message>
        <source>If the tool does not point at the cross, it is off by</source>
        <translation>Zeigt das Werkzeug nicht auf das Kreuz, so weicht es ab um</translation>
    </message>
    <message>
        <source>Import a machine</source>
        <translation>Maschine übernehmen</translation>
    </message>
    <message>
        <source>In a fixture</source>
        <translation>Im Spannmittel</translation>
    </message>
    <message>
        <source>In a rapid the tool goes {depth} into the part if its axes run independently.</source>
        <translation>In einem Eilgang dringt das Werkzeug {depth} in das Werkstück ein, wenn die Achsen unabhängig laufen.</translation>
    </message>
    <message>
        <source>In machine coordinates, with all axes at zero</source>
        <translation>In Maschinenkoordinaten, alle Achsen auf Null</translation>
    </message>
    <message>
        <source>In the folder that is proposed it stands in every list of machines from then on.</source>
        <translation>Im vorgeschlagenen Ordner steht sie von da an in jeder Maschinenliste.</translation>
    </message>
    <message>
        <source>In the machine</source>
        <translation>In der Maschine</translation>
    </message>
    <message>
        <source>In the tool path's panel a larger clearance; under the part let the tool be lifted, or leave such places out.</source>
        <translation>Im Fenster des Werkzeugwegs ein größerer Sicherheitsabstand; unter dem Werkstück das Werkzeug anheben lassen oder solche Stellen auslassen.</translation>
    </message>
    <message>
        <source>In the tool path's panel let the tool be lifted there, or leave such places out; or take a smaller cutter. The command What is left shows what then stays uncut. Where that is done already, the machine leaves the path between blocks: set Divide blocks to on.</source>
        <translation>Im Fenster des Werkzeugwegs das Werkzeug dort anheben oder solche Stellen auslassen; oder einen kleineren Fräser nehmen. Der Befehl „Restmaterial“ zeigt, was dann stehen bleibt. Ist das schon geschehen, so verlässt die Maschine den Weg zwischen den Sätzen: „Sätze teilen“ auf „ein“ stellen.</translation>
    </message>
    <message>
        <source>Its name must end in {endings}.</source>
        <translation>Der Name muss auf {endings} enden.</translation>
    </message>
    <message>
        <source>Keep anyway</source>
        <translation>Trotzdem behalten</translation>
    </message>
    <message>
        <source>Keep the tip of the tool in the middle of the view</source>
        <translation>Die Werkzeugspitze in der Mitte der Ansicht halten</translation>
    </message>
    <message>
        <source>Keep this path anyway?</source>
        <translation>Diese Bahn trotzdem behalten?</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Largest acceleration</source>
        <translation>Größte Beschleunigung</translation>
    </message>
    <message>
        <source>Largest axis angle</source>
        <translation>Größter Achswinkel</translation>
    </message>
    <message>
        <source>Largest axis change</source>
        <translation>Größte Achsänderung</translation>
    </message>
    <message>
        <source>Largest deviation</source>
        <translation>Größte Abweichung</translation>
    </message>
    <message>
        <source>Largest deviation with the work zero there</source>
        <translation>Größte Abweichung mit dem Werkstücknullpunkt dort</translation>
    </message>
    <message>
        <source>Largest deviation, blocks not yet divided</source>
        <translation>Größte Abweichung, Sätze noch nicht geteilt</translation>
    </message>
    <message>
        <source>Largest rate</source>
        <translation>Größte Geschwindigkeit</translation>
    </message>
    <message>
        <source>Largest residual of the rows used: {length}</source>
        <translation>Größter Rest der benutzten Zeilen: {length}</translation>
    </message>
    <message>
        <source>Largest: {largest}</source>
        <translation>Größte: {largest}</translation>
    </message>
    <message>
        <source>Lay the passes alone and draw them over the part: quick, before Calculate</source>
        <translation>Nur die Bahnen legen und über das Teil zeichnen: schnell, vor dem Berechnen</translation>
    </message>
    <message>
        <source>Lead</source>
        <translation>Voreilwinkel</translation>
    </message>
    <message>
        <source>Lead-in radius</source>
        <translation>Anfahrradius</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Ausgelassen</translation>
    </message>
    <message>
        <source>Let the tool path's panel turn the axis past the pole, lean the tool by a few degrees, or clamp the part tilted.</source>
        <translation>Im Fenster des Werkzeugwegs die Achse am Pol vorbeidrehen lassen, das Werkzeug um einige Grad neigen oder das Werkstück geneigt aufspannen.</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>Buchstabe</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Line deviation by</source>
        <translation>Abweichung von der Geraden</translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>LinuxCNC configurations, URDF and machine files (*.ini *.urdf *.fcm)</source>
        <translation>LinuxCNC-Konfigurationen, URDF- und Maschinendateien (*.ini *.urdf *.fcm)</translation>
    </message>
    <message>
        <source>LinuxCNC's .ini, a .urdf, or a .fcm of FreeCAD's Machine editor</source>
        <translation>LinuxCNCs .ini, eine .urdf oder eine .fcm des Maschineneditors von FreeCAD</translation>
    </message>
    <message>
        <source>Looks down</source>
        <translation>Zeigt nach unten</translation>
    </message>
    <message>
        <source>Low end</source>
        <translation>Unteres Ende</translation>
    </message>
    <message>
        <source>Lower limit</source>
        <translation>Untere Grenze</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Machine file to write</source>
        <translation>Zu schreibende Maschinendatei</translation>
    </message>
    <message>
        <source>Machine files (*.fcm)</source>
        <translation>Maschinendateien (*.fcm)</translation>
    </message>
    <message>
        <source>Machine to start from</source>
        <translation>Ausgangsmaschine</translation>
    </message>
    <message>
        <source>Machine's zero in the document</source>
        <translation>Maschinennullpunkt im Dokument</translation>
    </message>
    <message>
        <source>Machine, controller and work zero that several paths share</source>
        <translation>Maschine, Steuerung und Nullpunkt, die mehrere Wege teilen</translation>
    </message>
    <message>
        <source>Machines</source>
        <translation>Maschinen</translation>
    </message>
    <message>
        <source>Machines on {label}</source>
        <translation>Maschinen an {label}</translation>
    </message>
    <message>
        <source>Make a setup of these values, so that other paths take them too</source>
        <translation>Aus diesen Werten eine Aufspannung machen, damit andere Wege sie auch übernehmen</translation>
    </message>
    <message>
        <source>Many controls drive each axis of G0 at a rate of its own; the way is then no straight line.</source>
        <translation>Viele Steuerungen fahren in G0 jede Achse mit ihrer eigenen Geschwindigkeit; der Weg ist dann keine gerade Linie.</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>Marke</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Markierungen</translation>
    </message>
    <message>
        <source>Mesh angle</source>
        <translation>Winkelabweichung</translation>
    </message>
    <message>
        <source>Mesh deflection</source>
        <translation>Sehnenabweichung</translation>
    </message>
    <message>
        <source>Meshes (*.stl)</source>
        <translation>Netze (*.stl)</translation>
    </message>
    <message>
        <source>Model with bodies</source>
        <translation>Modell mit Körpern</translation>
    </message>
    <message>
        <source>More settings</source>
        <translation>Weitere Einstellungen</translation>
    </message>
    <message>
        <source>Most in block</source>
        <translation>Größte im Satz</translation>
    </message>
    <message>
        <source>Most that is left: {height}</source>
        <translation>Am meisten bleibt stehen: {height}</translation>
    </message>
    <message>
        <source>Move the axes</source>
        <translation>Achsen bewegen</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>Bewegungen</translation>
    </message>
    <message>
        <source>NC file</source>
        <translation>NC-Datei</translation>
    </message>
    <message>
        <source>NC file written</source>
        <translation>NC-Datei geschrieben</translation>
    </message>
    <message>
        <source>NC files (*.ngc *.nc *.tap *.cnc *.h *.mpf *.spf *.eia *.iso *.gcode *.txt)</source>
        <translation>NC-Dateien (*.ngc *.nc *.tap *.cnc *.h *.mpf *.spf *.eia *.iso *.gcode *.txt)</translation>
    </message>
    <message>
        <source>NC line</source>
        <translation>NC-Zeile</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name the NC file.</source>
        <translation>Die NC-Datei benennen.</translation>
    </message>
    <message>
        <source>Name the machine file.</source>
        <translation>Geben Sie der Maschinendatei einen Namen.</translation>
    </message>
    <message>
        <source>Near a fixture</source>
        <translation>Nahe einem Spannmittel</translation>
    </message>
    <message>
        <source>Near the machine</source>
        <translation>Nahe der Maschine</translation>
    </message>
    <message>
        <source>Near the pole</source>
        <translation>Nahe am Pol</translation>
    </message>
    <message>
        <source>Near the pole: {letter} turns far while the tool hardly leans.</source>
        <translation>Nahe am Pol: {letter} dreht weit, während sich das Werkzeug kaum neigt.</translation>
    </message>
    <message>
        <source>Near: {enters} within {distance} of {body}</source>
        <translation>Nah: {enters} näher als {distance} an {body}</translation>
    </message>
    <message>
        <source>Nearer to the tool, past its neighbour on the same side</source>
        <translation>Näher zum Werkzeug, an ihrer Nachbarin auf derselben Seite vorbei</translation>
    </message>
    <message>
        <source>Nearer to the work, past its neighbour on the same side</source>
        <translation>Näher zum Werkstück, an ihrer Nachbarin auf derselben Seite vorbei</translation>
    </message>
    <message>
        <source>Neck diameter</source>
        <translation>Halsdurchmesser</translation>
    </message>
    <message>
        <source>New setup</source>
        <translation>Neue Aufspannung</translation>
    </message>
    <message>
        <source>Next collision</source>
        <translation>Nächste Kollision</translation>
    </message>
    <message>
        <source>Next near miss</source>
        <translation>Nächste Annäherung</translation>
    </message>
    <message>
        <source>Next singular</source>
        <translation>Nächster singulärer</translation>
    </message>
    <message>
        <source>No document of yours is open: open the one that holds the solid, select it there, and press this again.</source>
        <translation>Keines Ihrer Dokumente ist offen: Öffnen Sie das mit dem Volumenkörper, wählen Sie ihn dort aus und drücken Sie dies noch einmal.</translation>
    </message>
    <message>
        <source>No spindle speed is given: the program leaves the spindle off, as for a dry run. Cancel, and type one.</source>
        <translation>Keine Spindeldrehzahl angegeben: das Programm lässt die Spindel aus, wie für einen Lauf ohne Schnitt. Abbrechen und eine eingeben.</translation>
    </message>
    <message>
        <source>Normal of the planes I, J, K</source>
        <translation>Normale der Ebenen I, J, K</translation>
    </message>
    <message>
        <source>Not drawn, as you stopped it: recompute to draw it</source>
        <translation>Nicht gezeichnet, weil abgebrochen: neu berechnen, um es zu zeichnen</translation>
    </message>
    <message>
        <source>Not machined</source>
        <translation>Nicht bearbeitet</translation>
    </message>
    <message>
        <source>Not proven</source>
        <translation>Nicht bewiesen</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Nothing enters the part</source>
        <translation>Nichts dringt ins Werkstück ein</translation>
    </message>
    <message>
        <source>Nothing is checked: the tool may enter the part.</source>
        <translation>Nichts wird geprüft: das Werkzeug kann in das Werkstück eindringen.</translation>
    </message>
    <message>
        <source>Nothing is selected: select solids, meshes, parts or links of “{}” in the tree or a view, then press this again.</source>
        <translation>Nichts ist ausgewählt: Wählen Sie Volumenkörper, Netze, Parts oder Links von „{}“ im Baum oder in einer Ansicht aus und drücken Sie dies dann noch einmal.</translation>
    </message>
    <message>
        <source>Nothing is wrong with this machine.</source>
        <translation>An dieser Maschine ist nichts falsch.</translation>
    </message>
    <message>
        <source>Nothing to report: all blocks are as they should be.</source>
        <translation>Nichts zu melden: alle NC-Sätze sind, wie sie sein sollen.</translation>
    </message>
    <message>
        <source>On each machine the work zero stands where its file says. The document stays as it is.</source>
        <translation>Auf jeder Maschine steht der Werkstücknullpunkt dort, wo ihre Datei es sagt. Das Dokument bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>On its way between passes the cutter goes {depth} into the part.</source>
        <translation>Auf dem Weg zwischen Bahnen dringt der Fräser {depth} ins Werkstück ein.</translation>
    </message>
    <message>
        <source>On the machine</source>
        <translation>Auf der Maschine</translation>
    </message>
    <message>
        <source>On {area} of the machined surface more is left than the passes are meant to leave.</source>
        <translation>Auf {area} der bearbeiteten Fläche bleibt mehr stehen, als die Bahnen stehen lassen sollen.</translation>
    </message>
    <message>
        <source>One axis everywhere: three-axis milling, or 3 + 2 with a tilted axis.</source>
        <translation>Überall eine Achse: dreiachsiges Fräsen, oder 3 + 2 mit geneigter Achse.</translation>
    </message>
    <message>
        <source>One block back</source>
        <translation>Einen NC-Satz zurück</translation>
    </message>
    <message>
        <source>One block on</source>
        <translation>Einen NC-Satz weiter</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open a document first: there is nothing to pick from.</source>
        <translation>Öffnen Sie zuerst ein Dokument: es gibt nichts zum Anklicken.</translation>
    </message>
    <message>
        <source>Open the sheet</source>
        <translation>Blatt öffnen</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Ausgabe</translation>
    </message>
    <message>
        <source>Over the tolerance</source>
        <translation>Über der Toleranz</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Werkstück</translation>
    </message>
    <message>
        <source>Part in a machine body</source>
        <translation>Werkstück im Maschinenkörper</translation>
    </message>
    <message>
        <source>Part in the document</source>
        <translation>Teil im Dokument</translation>
    </message>
    <message>
        <source>Pass strategy</source>
        <translation>Bahnstrategie</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Bahnen</translation>
    </message>
    <message>
        <source>Passes begin at</source>
        <translation>Bahnen beginnen bei</translation>
    </message>
    <message>
        <source>Passes end at</source>
        <translation>Bahnen enden bei</translation>
    </message>
    <message>
        <source>Passes in each frame</source>
        <translation>Bahnen je Anstellung</translation>
    </message>
    <message>
        <source>Peak of 1st rotary</source>
        <translation>Spitze der 1. Rundachse</translation>
    </message>
    <message>
        <source>Peak of 2nd rotary</source>
        <translation>Spitze der 2. Rundachse</translation>
    </message>
    <message>
        <source>Peak of X, Y, Z</source>
        <translation>Spitze von X, Y, Z</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Wählen</translation>
    </message>
    <message>
        <source>Pick in the 3D view</source>
        <translation>In der 3D-Ansicht wählen</translation>
    </message>
    <message>
        <source>Places on the map</source>
        <translation>Orte auf der Karte</translation>
    </message>
    <message>
        <source>Places where the tool enters the part are listed; the path stays as it is.</source>
        <translation>Stellen, an denen das Werkzeug ins Werkstück eindringt, werden aufgelistet; der Weg bleibt, wie er ist.</translation>
    </message>
    <message>
        <source>Places where the tool would enter the part are not machined.</source>
        <translation>Stellen, an denen das Werkzeug ins Werkstück eindringen würde, werden nicht bearbeitet.</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Play and pause</source>
        <translation>Abspielen und anhalten</translation>
    </message>
    <message>
        <source>Play {path}</source>
        <translation>{path} abspielen</translation>
    </message>
    <message>
        <source>Plunge feed</source>
        <translation>Eintauchvorschub</translation>
    </message>
    <message>
        <source>Point of the axis</source>
        <translation>Punkt der Achse</translation>
    </message>
    <message>
        <source>Post-process</source>
        <translation>NC-Datei ausgeben</translation>
    </message>
    <message>
        <source>Post-process {}</source>
        <translation>{} als NC-Datei ausgeben</translation>
    </message>
    <message>
        <source>Press Calculate to see what is found. OK writes it.</source>
        <translation>„Berechnen“ zeigt, was gefunden wird. OK schreibt es.</translation>
    </message>
    <message>
        <source>Press Calculate to see what these settings come to.</source>
        <translation>„Berechnen“ zeigt, was diese Einstellungen ergeben.</translation>
    </message>
    <message>
        <source>Preview for CAM</source>
        <translation>Vorschau für CAM</translation>
    </message>
    <message>
        <source>Preview passes</source>
        <translation>Bahnen vorab</translation>
    </message>
    <message>
        <source>Programmed point</source>
        <translation>Programmierter Punkt</translation>
    </message>
    <message>
        <source>Prove the signs</source>
        <translation>Vorzeichen nachweisen</translation>
    </message>
    <message>
        <source>Prove the signs…</source>
        <translation>Vorzeichen nachweisen…</translation>
    </message>
    <message>
        <source>Proven below</source>
        <translation>Bewiesen unter</translation>
    </message>
    <message>
        <source>Proven bound</source>
        <translation>Bewiesene Schranke</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Radius at the high end</source>
        <translation>Radius am oberen Ende</translation>
    </message>
    <message>
        <source>Radius at the low end</source>
        <translation>Radius am unteren Ende</translation>
    </message>
    <message>
        <source>Rapids</source>
        <translation>Eilgänge</translation>
    </message>
    <message>
        <source>Reach map</source>
        <translation>Erreichbarkeit</translation>
    </message>
    <message>
        <source>Recompute</source>
        <translation>Neu berechnen</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Zurückgewinnen</translation>
    </message>
    <message>
        <source>Recover a machine</source>
        <translation>Maschine zurückgewinnen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the chosen axis</source>
        <translation>Die gewählte Achse entfernen</translation>
    </message>
    <message>
        <source>Remove the chosen body</source>
        <translation>Den gewählten Körper entfernen</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Report as a web page (.html)</source>
        <translation>Bericht als Webseite (.html)</translation>
    </message>
    <message>
        <source>Report for programs (.json)</source>
        <translation>Bericht für Programme (.json)</translation>
    </message>
    <message>
        <source>Rest material</source>
        <translation>Restmaterial</translation>
    </message>
    <message>
        <source>Retract below the part</source>
        <translation>Rückzug unter dem Werkstück</translation>
    </message>
    <message>
        <source>Reverse the direction</source>
        <translation>Richtung umkehren</translation>
    </message>
    <message>
        <source>Room for the work zero</source>
        <translation>Spielraum des Nullpunkts</translation>
    </message>
    <message>
        <source>Rotary passes</source>
        <translation>Rotierende Bahnen</translation>
    </message>
    <message>
        <source>STL file</source>
        <translation>STL-Datei</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save as a web page…</source>
        <translation>Als Webseite speichern …</translation>
    </message>
    <message>
        <source>Save the report…</source>
        <translation>Bericht speichern…</translation>
    </message>
    <message>
        <source>Save the table and its pictures</source>
        <translation>Die Tabelle und ihre Bilder speichern</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern …</translation>
    </message>
    <message>
        <source>Scallop height</source>
        <translation>Kuppenhöhe</translation>
    </message>
    <message>
        <source>Select solids, meshes, parts or links in any document. Its coordinates are taken for the machine's, with all axes at zero. Saving writes them as STL files beside the machine's file.</source>
        <translation>Wählen Sie in einem beliebigen Dokument Volumenkörper, Netze, Parts oder Links aus. Seine Koordinaten gelten als die der Maschine, alle Achsen auf null. Beim Speichern werden daraus STL-Dateien neben der Maschinendatei.</translation>
    </message>
    <message>
        <source>Set the tool path's work zero on the machine to the recommended one, and compute it.</source>
        <translation>Den Werkstücknullpunkt des Werkzeugwegs auf der Maschine auf den empfohlenen setzen und den Werkzeugweg berechnen.</translation>
    </message>
    <message>
        <source>Setup</source>
        <translation>Aufspannung</translation>
    </message>
    <message>
        <source>Setup map</source>
        <translation>Aufspannkarte</translation>
    </message>
    <message>
        <source>Shank or holder collides</source>
        <translation>Schaft oder Halter kollidiert</translation>
    </message>
    <message>
        <source>Shank or holder not freed</source>
        <translation>Schaft oder Halter nicht frei</translation>
    </message>
    <message>
        <source>Shank, Ø x length</source>
        <translation>Schaft, Ø x Länge</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Teilen</translation>
    </message>
    <message>
        <source>Sheet to print</source>
        <translation>Blatt zum Drucken</translation>
    </message>
    <message>
        <source>Shorter blocks help: half the length leaves about a quarter of the deviation. Divide blocks, in the group Safety of the tool path's panel, makes as many of them as are needed.</source>
        <translation>Kürzere Sätze helfen: die halbe Länge lässt etwa ein Viertel der Abweichung. „Sätze teilen“ in der Gruppe „Sicherheit“ des Werkzeugwegs macht so viele daraus, wie nötig sind.</translation>
    </message>
    <message>
        <source>Show findings</source>
        <translation>Befunde zeigen</translation>
    </message>
    <message>
        <source>Show folder</source>
        <translation>Ordner zeigen</translation>
    </message>
    <message>
        <source>Show the tool axes</source>
        <translation>Werkzeugachsen zeigen</translation>
    </message>
    <message>
        <source>Shown in the view</source>
        <translation>In der Ansicht</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Singular blocks</source>
        <translation>Singuläre NC-Sätze</translation>
    </message>
    <message>
        <source>Slow feed</source>
        <translation>Langsamer Vorschub</translation>
    </message>
    <message>
        <source>Smallest stepover</source>
        <translation>Kleinster Zeilenabstand</translation>
    </message>
    <message>
        <source>Solids and meshes of the document that hold the part: each program is proven against them</source>
        <translation>Körper und Netze des Dokuments, die das Werkstück halten: jedes Programm wird gegen sie geprüft</translation>
    </message>
    <message>
        <source>Spacing by</source>
        <translation>Abstand nach</translation>
    </message>
    <message>
        <source>Speed, in times of real time</source>
        <translation>Geschwindigkeit, in Vielfachen der wirklichen</translation>
    </message>
    <message>
        <source>Spindle speed</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>Spindle speed not given: the program will not start the spindle.</source>
        <translation>Drehzahl fehlt: das Programm schaltet die Spindel nicht ein.</translation>
    </message>
    <message>
        <source>Spiral passes</source>
        <translation>Spiralbahnen</translation>
    </message>
    <message>
        <source>Square to the rotary axis and pointing at it, as the part turns.</source>
        <translation>Senkrecht zur Rundachse und auf sie gerichtet, während sich das Werkstück dreht.</translation>
    </message>
    <message>
        <source>Start from</source>
        <translation>Ausgehen von</translation>
    </message>
    <message>
        <source>Start through the part</source>
        <translation>Start durch das Werkstück</translation>
    </message>
    <message>
        <source>Steep from</source>
        <translation>Steil ab</translation>
    </message>
    <message>
        <source>Steepest surface</source>
        <translation>Steilste Fläche</translation>
    </message>
    <message>
        <source>Stepover</source>
        <translation>Zeilensprung</translation>
    </message>
    <message>
        <source>Stop {number}, NC line {line}: {title}</source>
        <translation>Halt {number}, NC-Zeile {line}: {title}</translation>
    </message>
    <message>
        <source>Stopped; nothing was written.</source>
        <translation>Abgebrochen; nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>Stopped; the document is as it was.</source>
        <translation>Abgebrochen; das Dokument ist, wie es war.</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>Halte</translation>
    </message>
    <message>
        <source>Summary</source>
        <translation>Zusammenfassung</translation>
    </message>
    <message>
        <source>Table and head move as they really will; otherwise the part stands still</source>
        <translation>Tisch und Kopf bewegen sich, wie sie es wirklich tun werden; sonst steht das Werkstück still</translation>
    </message>
    <message>
        <source>Taper, each side</source>
        <translation>Kegel, je Seite</translation>
    </message>
    <message>
        <source>Tessellate</source>
        <translation>Tessellieren</translation>
    </message>
    <message>
        <source>The CL file (APT) that the program was made from</source>
        <translation>Die CL-Datei (APT), aus der das Programm gemacht wurde</translation>
    </message>
    <message>
        <source>The NC file to write</source>
        <translation>Die NC-Datei, die geschrieben wird</translation>
    </message>
    <message>
        <source>The axis of the table that it moves with, or the spindle</source>
        <translation>Die Achse des Tisches, mit der er sich bewegt, oder die Spindel</translation>
    </message>
    <message>
        <source>The axis that keeps cutter, shank and holder out of the part and turns smoothly over the surface.</source>
        <translation>Die Achse, die Fräser, Schaft und Halter vom Teil freihält und sich gleichmäßig über die Fläche dreht.</translation>
    </message>
    <message>
        <source>The axis that makes the deviation of this machine smallest, within the largest axis angle; takes long.</source>
        <translation>Die Achse mit der kleinsten Abweichung auf dieser Maschine, innerhalb des größten Achswinkels; dauert lange.</translation>
    </message>
    <message>
        <source>The axis that moves what is attached, or the spindle</source>
        <translation>Die Achse, die das Angehängte bewegt, oder die Spindel</translation>
    </message>
    <message>
        <source>The axis's own limit, as its machine coordinates count; empty: none</source>
        <translation>Die Grenze der Achse selbst, in Maschinenkoordinaten; leer: keine</translation>
    </message>
    <message>
        <source>The ball's centre leaves its commanded straight line by {deviation}, within the {tolerance} allowed.</source>
        <translation>Die Kugelmitte weicht um {deviation} von ihrer Sollstrecke ab, innerhalb der erlaubten {tolerance}.</translation>
    </message>
    <message>
        <source>The ball's centre leaves its commanded straight line by {deviation}; allowed are {tolerance}.</source>
        <translation>Die Kugelmitte weicht um {deviation} von ihrer Sollstrecke ab; erlaubt sind {tolerance}.</translation>
    </message>
    <message>
        <source>The ball's centre leaves its segment by more than the {tolerance} that are allowed.</source>
        <translation>Die Kugelmitte weicht um mehr als die erlaubten {tolerance} von ihrer Sollstrecke ab.</translation>
    </message>
    <message>
        <source>The ball's centre was seen to leave the line by {deviation}; proven is only that it is no more than {bound}.</source>
        <translation>Gesehen wurde, dass die Kugelmitte um {deviation} von der Strecke abweicht; bewiesen ist nur, dass es nicht mehr als {bound} ist.</translation>
    </message>
    <message>
        <source>The block is so near to the tolerance of {tolerance} that the proof does not reach.</source>
        <translation>Der NC-Satz liegt so nahe an der Toleranz von {tolerance}, dass der Nachweis nicht reicht.</translation>
    </message>
    <message>
        <source>The block lies near the pole: the tool stands almost along the {first} axis, and there {first} must turn far to lean the tool a little.</source>
        <translation>Der NC-Satz liegt nahe am Pol: das Werkzeug steht fast in Richtung der Achse {first}, und dort muss {first} weit drehen, um das Werkzeug ein wenig zu neigen.</translation>
    </message>
    <message>
        <source>The command What is left shows where. Cut these places with a smaller cutter, or with another tool axis.</source>
        <translation>Der Befehl „Restmaterial“ zeigt, wo. Diese Stellen mit einem kleineren Fräser oder mit anderer Werkzeugachse fräsen.</translation>
    </message>
    <message>
        <source>The controller guides the tip (RTCP); shown is the tip on its straight way while the rotary axes turn evenly.</source>
        <translation>Die Steuerung führt die Spitze (RTCP); gezeigt ist die Spitze auf ihrem geraden Weg, während die Rundachsen gleichmäßig drehen.</translation>
    </message>
    <message>
        <source>The controller guides the tip; the program gives the rotary axes.</source>
        <translation>Die Steuerung führt die Spitze; das Programm gibt die Rundachsen.</translation>
    </message>
    <message>
        <source>The controller guides the tip; the program gives the tool axis as a vector.</source>
        <translation>Die Steuerung führt die Spitze; das Programm gibt die Werkzeugachse als Vektor.</translation>
    </message>
    <message>
        <source>The controller that its programs are for</source>
        <translation>Die Steuerung, für die ihre Programme sind</translation>
    </message>
    <message>
        <source>The cutter does not fit there, or it was lifted or kept away so that nothing enters the part.</source>
        <translation>Der Fräser passt dort nicht hinein, oder er wurde angehoben oder ferngehalten, damit nichts ins Werkstück eindringt.</translation>
    </message>
    <message>
        <source>The cutter goes {depth} too deep into the part.</source>
        <translation>Der Fräser geht {depth} zu tief ins Werkstück.</translation>
    </message>
    <message>
        <source>The faces of a mesh have no names: choose a solid, or {option} on the command line.</source>
        <translation>Die Flächen eines Netzes haben keine Namen: einen Volumenkörper wählen, oder {option} auf der Kommandozeile.</translation>
    </message>
    <message>
        <source>The head of a machine that is ticked turns: give the tool length.</source>
        <translation>Der Kopf einer angehakten Maschine dreht: die Werkzeuglänge angeben.</translation>
    </message>
    <message>
        <source>The largest distance in this block</source>
        <translation>Der größte Abstand in diesem NC-Satz</translation>
    </message>
    <message>
        <source>The largest rate that the drive reaches</source>
        <translation>Die größte Geschwindigkeit, die der Antrieb erreicht</translation>
    </message>
    <message>
        <source>The machine file to write</source>
        <translation>Die zu schreibende Maschinendatei</translation>
    </message>
    <message>
        <source>The machine is a sketch from its axes: not to scale.</source>
        <translation>Die Maschine ist eine Skizze aus ihren Achsen: nicht maßstäblich.</translation>
    </message>
    <message>
        <source>The machine whose values are changed; it stays as it is</source>
        <translation>Die Maschine, deren Werte geändert werden; sie selbst bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>The machine's bodies are those of its file.</source>
        <translation>Die Körper der Maschine sind die ihrer Datei.</translation>
    </message>
    <message>
        <source>The next block where a rotary axis turns far to lean the tool a little</source>
        <translation>Der nächste NC-Satz, in dem eine Rundachse weit dreht, um das Werkzeug ein wenig zu neigen</translation>
    </message>
    <message>
        <source>The part is in inches: scale it by 25.4</source>
        <translation>Das Teil ist in Zoll: mit 25,4 skalieren</translation>
    </message>
    <message>
        <source>The part is in metres: scale it by 1000</source>
        <translation>Das Teil ist in Metern: mit 1000 skalieren</translation>
    </message>
    <message>
        <source>The part was deleted meanwhile: press Cancel, and select another one.</source>
        <translation>Das Werkstück wurde inzwischen gelöscht: „Abbrechen“ drücken und ein anderes auswählen.</translation>
    </message>
    <message>
        <source>The point of the document that is the machine's zero</source>
        <translation>Der Punkt des Dokuments, der der Maschinennullpunkt ist</translation>
    </message>
    <message>
        <source>The point of the part that is the program's zero</source>
        <translation>Der Punkt des Werkstücks, der Nullpunkt des Programms ist</translation>
    </message>
    <message>
        <source>The program gives the positions of all axes; any controller can run it.</source>
        <translation>Das Programm gibt die Stellungen aller Achsen; jede Steuerung kann es fahren.</translation>
    </message>
    <message>
        <source>The program is in inches ({word}), whatever this document shows.</source>
        <translation>Das Programm ist in Zoll ({word}), was immer dieses Dokument zeigt.</translation>
    </message>
    <message>
        <source>The program is in millimetres ({word}), whatever this document shows.</source>
        <translation>Das Programm ist in Millimetern ({word}), was immer dieses Dokument zeigt.</translation>
    </message>
    <message>
        <source>The program that was made of the CL file, without tool centre point control</source>
        <translation>Das Programm, das aus der CL-Datei gemacht wurde, ohne TCP-Führung (RTCP)</translation>
    </message>
    <message>
        <source>The program: slow feed moves, with a stop after each</source>
        <translation>Das Programm: langsame Vorschubbewegungen, nach jeder ein Halt</translation>
    </message>
    <message>
        <source>The shank or the holder goes {depth} into the part.</source>
        <translation>Der Schaft oder der Halter dringt {depth} ins Werkstück ein.</translation>
    </message>
    <message>
        <source>The sheet to write</source>
        <translation>Das zu schreibende Blatt</translation>
    </message>
    <message>
        <source>The surface curls tighter than the cutter there, or another wall stands nearer than it is wide.</source>
        <translation>Die Fläche ist dort enger gekrümmt als der Fräser, oder eine andere Wand steht näher, als er breit ist.</translation>
    </message>
    <message>
        <source>The tip leaves its segment by more than the {tolerance} that are allowed.</source>
        <translation>Die Werkzeugspitze weicht um mehr als die erlaubten {tolerance} von ihrer Sollstrecke ab.</translation>
    </message>
    <message>
        <source>The tip leaves the commanded straight line by {deviation}, within the {tolerance} allowed.</source>
        <translation>Die Werkzeugspitze weicht um {deviation} von der Sollstrecke ab, innerhalb der erlaubten {tolerance}.</translation>
    </message>
    <message>
        <source>The tip leaves the commanded straight line by {deviation}; allowed are {tolerance}.</source>
        <translation>Die Werkzeugspitze weicht um {deviation} von der Sollstrecke ab; erlaubt sind {tolerance}.</translation>
    </message>
    <message>
        <source>The tip was seen to leave the line by {deviation}; proven is only that it is no more than {bound}.</source>
        <translation>Gesehen wurde, dass die Werkzeugspitze um {deviation} von der Strecke abweicht; bewiesen ist nur, dass es nicht mehr als {bound} ist.</translation>
    </message>
    <message>
        <source>The tool axis is turned by a few degrees, so that it passes beside the pole.</source>
        <translation>Die Werkzeugachse wird um einige Grad gedreht, sodass sie am Pol vorbeigeht.</translation>
    </message>
    <message>
        <source>The tool is lifted along its axis until nothing enters the part.</source>
        <translation>Das Werkzeug wird längs seiner Achse gehoben, bis nichts mehr ins Werkstück eindringt.</translation>
    </message>
    <message>
        <source>The tool is short, or leans towards a wall beside what is cut. Walls that are not selected count too.</source>
        <translation>Das Werkzeug ist kurz oder neigt sich zu einer Wand neben dem, was gefräst wird. Auch Wände, die nicht ausgewählt sind, zählen.</translation>
    </message>
    <message>
        <source>The tool is tilted until shank and holder are free; where the cutter still enters, it is lifted.</source>
        <translation>Das Werkzeug wird geneigt, bis Schaft und Halter frei sind; wo der Fräser noch eindringt, wird es gehoben.</translation>
    </message>
    <message>
        <source>The tool path was changed since: double-click the map to try again</source>
        <translation>Der Werkzeugweg wurde seither geändert: Doppelklick auf die Karte erprobt neu</translation>
    </message>
    <message>
        <source>The tool path was deleted meanwhile: close this panel.</source>
        <translation>Der Werkzeugweg wurde inzwischen gelöscht: dieses Fenster schließen.</translation>
    </message>
    <message>
        <source>The tool stands normal to each face up to its edges and turns over a sharp edge on the spot: a level bottom finishes plane faces.</source>
        <translation>Das Werkzeug steht bis an die Kanten senkrecht auf jeder Fläche und dreht sich an einer scharfen Kante auf der Stelle: Ein flacher Boden schlichtet ebene Flächen fertig.</translation>
    </message>
    <message>
        <source>The tool stands normal to the surface, leaned by lead and tilt.</source>
        <translation>Das Werkzeug steht senkrecht zur Fläche, geneigt um Voreil- und Seitwinkel.</translation>
    </message>
    <message>
        <source>Then click a face, or an edge of a closed wire, in the 3D view; Esc stops it</source>
        <translation>Danach in der 3D-Ansicht eine Fläche oder eine Kante eines geschlossenen Kantenzugs anklicken; Esc bricht ab</translation>
    </message>
    <message>
        <source>Then click a straight or circular edge, or a cylindrical or conical face, in the 3D view; Esc stops it</source>
        <translation>Danach in der 3D-Ansicht eine gerade oder kreisförmige Kante oder eine Zylinder- oder Kegelfläche anklicken; Esc bricht ab</translation>
    </message>
    <message>
        <source>Then click a vertex or an edge in the 3D view; Esc stops it</source>
        <translation>Danach in der 3D-Ansicht eine Ecke oder Kante anklicken; Esc bricht ab</translation>
    </message>
    <message>
        <source>Then click a vertex, a circle or a sphere in the 3D view; Esc stops it</source>
        <translation>Danach in der 3D-Ansicht eine Ecke, einen Kreis oder eine Kugel anklicken; Esc bricht ab</translation>
    </message>
    <message>
        <source>There are several paths: select the one to mark.</source>
        <translation>Es gibt mehrere Werkzeugwege: den auswählen, der markiert werden soll.</translation>
    </message>
    <message>
        <source>There are several paths: select the one to play.</source>
        <translation>Es gibt mehrere Werkzeugwege: den auswählen, der abgespielt werden soll.</translation>
    </message>
    <message>
        <source>There are several tool paths: select the one to compare machines on.</source>
        <translation>Es gibt mehrere Werkzeugwege: den auswählen, an dem Maschinen verglichen werden sollen.</translation>
    </message>
    <message>
        <source>There are several tool paths: select the one to map.</source>
        <translation>Es gibt mehrere Werkzeugwege: den auswählen, dessen Restmaterial gezeigt werden soll.</translation>
    </message>
    <message>
        <source>There are several tool paths: select the one to write.</source>
        <translation>Es gibt mehrere Werkzeugwege: den auswählen, der ausgegeben werden soll.</translation>
    </message>
    <message>
        <source>There is no other solid in the document.</source>
        <translation>Im Dokument ist kein anderer Körper.</translation>
    </message>
    <message>
        <source>These files are there already. Replace them?</source>
        <translation>Diese Dateien gibt es schon. Ersetzen?</translation>
    </message>
    <message>
        <source>Thickness of the jaws</source>
        <translation>Dicke der Backen</translation>
    </message>
    <message>
        <source>This file is there already: choose another name.</source>
        <translation>Diese Datei gibt es schon: wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>This machine is not saved. Leave it, and lose what was changed?</source>
        <translation>Diese Maschine ist nicht gespeichert. Verlassen und die Änderungen verlieren?</translation>
    </message>
    <message>
        <source>This machine's head turns: give the length from the gauge point to the tip.</source>
        <translation>Der Kopf dieser Maschine schwenkt: die Länge vom Bezugspunkt der Spindel bis zur Werkzeugspitze angeben.</translation>
    </message>
    <message>
        <source>This should not have happened: {error}. The details are in the report view.</source>
        <translation>Das hätte nicht geschehen dürfen: {error}. Einzelheiten stehen in der Ausgabeansicht.</translation>
    </message>
    <message>
        <source>Tick at least one machine and one correction.</source>
        <translation>Mindestens eine Maschine und eine Korrektur ankreuzen.</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Seitwinkel</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Tip guided (RTCP)</source>
        <translation>Spitze geführt (RTCP)</translation>
    </message>
    <message>
        <source>Tip guided (RTCP): {count} blocks,</source>
        <translation>Spitze geführt (RTCP): {count} NC-Sätze,</translation>
    </message>
    <message>
        <source>Tip off its segment</source>
        <translation>Spitze neben Strecke</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>To be carried by</source>
        <translation>Soll getragen werden von</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Tool axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Tool axis</source>
        <translation>Werkzeugachse</translation>
    </message>
    <message>
        <source>Tool files (*.fctb)</source>
        <translation>Werkzeugdateien (*.fctb)</translation>
    </message>
    <message>
        <source>Tool length</source>
        <translation>Werkzeuglänge</translation>
    </message>
    <message>
        <source>Tool lifted</source>
        <translation>Werkzeug angehoben</translation>
    </message>
    <message>
        <source>Tool number</source>
        <translation>Werkzeugnummer</translation>
    </message>
    <message>
        <source>Tool of the CL file</source>
        <translation>Werkzeug der CL-Datei</translation>
    </message>
    <message>
        <source>Tool path</source>
        <translation>Werkzeugweg</translation>
    </message>
    <message>
        <source>Try other passes, free tool axes and smaller balls on this part; takes as long as some paths</source>
        <translation>Andere Bahnen, freie Werkzeugachsen und kleinere Kugeln an diesem Teil versuchen; dauert so lange wie einige Bahnen</translation>
    </message>
    <message>
        <source>Turn about Z</source>
        <translation>Drehung um Z</translation>
    </message>
    <message>
        <source>Turn of each axis</source>
        <translation>Drehung jeder Achse</translation>
    </message>
    <message>
        <source>Turn the solid first, as the recommendation says, then try one turn only.</source>
        <translation>Zuerst den Volumenkörper drehen, wie empfohlen, dann nur eine Drehung erproben.</translation>
    </message>
    <message>
        <source>Turns at the pole</source>
        <translation>Dreht am Pol</translation>
    </message>
    <message>
        <source>Turns of the part</source>
        <translation>Drehungen des Werkstücks</translation>
    </message>
    <message>
        <source>Uncut</source>
        <translation>Ungefräst</translation>
    </message>
    <message>
        <source>Uncut: {area} of {whole}</source>
        <translation>Ungefräst: {area} von {whole}</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Einheiten</translation>
    </message>
    <message>
        <source>Units of STL files</source>
        <translation>Einheit von STL-Dateien</translation>
    </message>
    <message>
        <source>Units of the program</source>
        <translation>Einheit des Programms</translation>
    </message>
    <message>
        <source>Upper limit</source>
        <translation>Obere Grenze</translation>
    </message>
    <message>
        <source>Use these settings</source>
        <translation>Diese Einstellungen übernehmen</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Vismach models (*.py)</source>
        <translation>Vismach-Modelle (*.py)</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Warnungen</translation>
    </message>
    <message>
        <source>Way of X, Y, Z</source>
        <translation>Weg von X, Y, Z</translation>
    </message>
    <message>
        <source>Web page (*.html)</source>
        <translation>Webseite (*.html)</translation>
    </message>
    <message>
        <source>Web page (*.html);;For programs (*.json);;Text (*.txt)</source>
        <translation>Webseite (*.html);;Für Programme (*.json);;Text (*.txt)</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>What comes nearer to it than this is told; 0: nothing</source>
        <translation>Was ihm näher kommt, wird gemeldet; 0: nichts</translation>
    </message>
    <message>
        <source>What findings call the body</source>
        <translation>Wie Befunde den Körper nennen</translation>
    </message>
    <message>
        <source>What happens</source>
        <translation>Was geschieht</translation>
    </message>
    <message>
        <source>What helps</source>
        <translation>Was hilft</translation>
    </message>
    <message>
        <source>What is left</source>
        <translation>Restmaterial</translation>
    </message>
    <message>
        <source>What must be seen at each stop, to print; empty: no sheet</source>
        <translation>Was an jedem Halt zu sehen sein muss, zum Drucken; leer: kein Blatt</translation>
    </message>
    <message>
        <source>What stands beside them is a sketch: not to scale, not checked.</source>
        <translation>Was daneben steht, ist eine Skizze: nicht maßstäblich, nicht geprüft.</translation>
    </message>
    <message>
        <source>What the axis moves</source>
        <translation>Was die Achse bewegt</translation>
    </message>
    <message>
        <source>What the distance is proven to stay below, all through this block</source>
        <translation>Worunter der Abstand im ganzen NC-Satz bewiesenermaßen bleibt</translation>
    </message>
    <message>
        <source>What the drive reaches; it is kept in the file, nothing reckons with it</source>
        <translation>Was der Antrieb erreicht; es bleibt in der Datei, nichts rechnet damit</translation>
    </message>
    <message>
        <source>What the lists call the machine</source>
        <translation>Wie die Listen die Maschine nennen</translation>
    </message>
    <message>
        <source>What the verdict rests on</source>
        <translation>Worauf das Urteil beruht</translation>
    </message>
    <message>
        <source>What this panel changes was deleted or undone meanwhile: press Cancel.</source>
        <translation>Was dieser Dialog ändert, wurde inzwischen gelöscht oder rückgängig gemacht: Abbrechen drücken.</translation>
    </message>
    <message>
        <source>What would finish more?</source>
        <translation>Was würde mehr fertig bearbeiten?</translation>
    </message>
    <message>
        <source>Where the program's zero is drawn in the document</source>
        <translation>Wo der Nullpunkt des Programms im Dokument gezeichnet wird</translation>
    </message>
    <message>
        <source>Where the spindle's gauge point, from which tools are measured, is with all axes at zero</source>
        <translation>Wo der Bezugspunkt der Spindel, von dem aus Werkzeuge gemessen werden, liegt, alle Achsen auf Null</translation>
    </message>
    <message>
        <source>Where the tip is farthest from its commanded segment</source>
        <translation>Wo die Werkzeugspitze am weitesten von ihrer Sollstrecke entfernt ist</translation>
    </message>
    <message>
        <source>Where the work zero lies in the document</source>
        <translation>Wo der Werkstücknullpunkt im Dokument liegt</translation>
    </message>
    <message>
        <source>Where the work zero usually lies, in machine coordinates with all axes at zero</source>
        <translation>Wo der Werkstücknullpunkt gewöhnlich liegt, in Maschinenkoordinaten, alle Achsen auf Null</translation>
    </message>
    <message>
        <source>Where to clamp</source>
        <translation>Wohin spannen</translation>
    </message>
    <message>
        <source>Where tool or spindle go deepest into the next fixture or body of the machine, or come too near to it</source>
        <translation>Wo Werkzeug oder Spindel am tiefsten in das nächste Spannmittel oder den nächsten Körper der Maschine gehen oder ihm zu nahe kommen</translation>
    </message>
    <message>
        <source>While the rotary axes turn, the tip leaves the straight way over the part; or the part is over the tool.</source>
        <translation>Während die Rundachsen sich drehen, verlässt die Spitze den geraden Weg über dem Werkstück; oder das Werkstück ist über dem Werkzeug.</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Warum</translation>
    </message>
    <message>
        <source>Within a step of {step}, {first} turns {first_turn} and {second} {second_turn}. While rotary axes turn, even moves of the axes carry the ball's centre along a curve beside the straight line.</source>
        <translation>In einem Schritt von {step} dreht {first} um {first_turn} und {second} um {second_turn}. Während Rundachsen drehen, tragen gleichmäßige Bewegungen der Achsen die Kugelmitte auf einer Kurve neben der Geraden entlang.</translation>
    </message>
    <message>
        <source>Within a step of {step}, {first} turns {first_turn} and {second} {second_turn}. While rotary axes turn, even moves of the axes carry the tip along a curve beside the straight line.</source>
        <translation>In einem Schritt von {step} dreht {first} um {first_turn} und {second} um {second_turn}. Während Rundachsen drehen, tragen gleichmäßige Bewegungen der Achsen die Spitze auf einer Kurve neben der Geraden entlang.</translation>
    </message>
    <message>
        <source>Words without a decimal point</source>
        <translation>Wörter ohne Dezimalpunkt</translation>
    </message>
    <message>
        <source>Work offset</source>
        <translation>Nullpunktverschiebung</translation>
    </message>
    <message>
        <source>Work zero</source>
        <translation>Werkstücknullpunkt</translation>
    </message>
    <message>
        <source>Work zero on the machine</source>
        <translation>Werkstücknullpunkt auf der Maschine</translation>
    </message>
    <message>
        <source>Worst NC line</source>
        <translation>Schlimmste NC-Zeile</translation>
    </message>
    <message>
        <source>Worst block</source>
        <translation>Schlimmster NC-Satz</translation>
    </message>
    <message>
        <source>Write anyway</source>
        <translation>Trotzdem schreiben</translation>
    </message>
    <message>
        <source>Written: {}</source>
        <translation>Geschrieben: {}</translation>
    </message>
    <message>
        <source>Wrong: {text}</source>
        <translation>Falsch: {text}</translation>
    </message>
    <message>
        <source>X, Y and Z are linear, A, B and C rotary</source>
        <translation>X, Y und Z sind linear, A, B und C drehen</translation>
    </message>
    <message>
        <source>You see: {text}</source>
        <translation>Sie sehen: {text}</translation>
    </message>
    <message>
        <source>Z of the face that parts are clamped on, in machine coordinates with all axes at zero</source>
        <translation>Z der Fläche, auf der gespannt wird, in Maschinenkoordinaten, alle Achsen auf Null</translation>
    </message>
    <message>
        <source>along</source>
        <translation>entlang</translation>
    </message>
    <message>
        <source>along the axis</source>
        <translation>längs der Achse</translation>
    </message>
    <message>
        <source>always over the part</source>
        <translation>über das Werkstück</translation>
    </message>
    <message>
        <source>and {count} more</source>
        <translation>und {count} weitere</translation>
    </message>
    <message>
        <source>around an edge</source>
        <translation>um eine Kante</translation>
    </message>
    <message>
        <source>around the axis</source>
        <translation>um die Achse</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>wie die Datei sagt</translation>
    </message>
    <message>
        <source>as the machine file says</source>
        <translation>wie in der Maschinendatei</translation>
    </message>
    <message>
        <source>as they stand</source>
        <translation>wie sie dastehen</translation>
    </message>
    <message>
        <source>attached</source>
        <translation>angehängt</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>automatic (some seconds)</source>
        <translation>automatisch (Sekunden)</translation>
    </message>
    <message>
        <source>away from the rotary axis</source>
        <translation>von der Rundachse weg</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>ball end mill</source>
        <translation>Kugelfräser</translation>
    </message>
    <message>
        <source>barrel</source>
        <translation>Tonnenfräser</translation>
    </message>
    <message>
        <source>below the table</source>
        <translation>unter dem Tisch</translation>
    </message>
    <message>
        <source>beyond limits, below the table or in the machine: {count} places</source>
        <translation>außerhalb der Grenzen, unter dem Tisch oder in der Maschine: {count} Stellen</translation>
    </message>
    <message>
        <source>beyond the machine's limits</source>
        <translation>außerhalb der Maschinengrenzen</translation>
    </message>
    <message>
        <source>border</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>bull nose mill</source>
        <translation>Torusfräser</translation>
    </message>
    <message>
        <source>by rotary axes</source>
        <translation>durch Rundachsen</translation>
    </message>
    <message>
        <source>by the text itself</source>
        <translation>wie der Text zeigt</translation>
    </message>
    <message>
        <source>by tool vectors</source>
        <translation>durch Werkzeugvektoren</translation>
    </message>
    <message>
        <source>carries</source>
        <translation>trägt</translation>
    </message>
    <message>
        <source>centre of corner radius</source>
        <translation>Mitte des Eckenradius</translation>
    </message>
    <message>
        <source>certain within</source>
        <translation>sicher auf</translation>
    </message>
    <message>
        <source>closing gaps at edges</source>
        <translation>Lücken an Kanten schließen</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>collides</source>
        <translation>kollidiert</translation>
    </message>
    <message>
        <source>collision between passes: {count} places</source>
        <translation>Kollision zwischen Bahnen: {count} Stellen</translation>
    </message>
    <message>
        <source>collision in a rapid: {count} places</source>
        <translation>Kollision in einem Eilgang: {count} Stellen</translation>
    </message>
    <message>
        <source>commanded and real way of the ball's centre</source>
        <translation>Soll- und wirklicher Weg der Kugelmitte</translation>
    </message>
    <message>
        <source>commanded line beside the real curve</source>
        <translation>Sollstrecke neben der wirklichen Kurve</translation>
    </message>
    <message>
        <source>comparing axis changes</source>
        <translation>Achsänderungen vergleichen</translation>
    </message>
    <message>
        <source>comparing machines</source>
        <translation>Maschinen vergleichen</translation>
    </message>
    <message>
        <source>cone</source>
        <translation>Kegel</translation>
    </message>
    <message>
        <source>constant scallop</source>
        <translation>gleiche Kuppenhöhe</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>Berührpunkt</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>cut too deep</source>
        <translation>zu tief gefräst</translation>
    </message>
    <message>
        <source>cut too deep: {count} places</source>
        <translation>zu tief gefräst: {count} Stellen</translation>
    </message>
    <message>
        <source>cut, coloured by its deviation</source>
        <translation>Schnitt, nach Abweichung gefärbt</translation>
    </message>
    <message>
        <source>cutter too large</source>
        <translation>Fräser zu groß</translation>
    </message>
    <message>
        <source>cutter {depth} in the part between passes</source>
        <translation>Fräser zwischen Bahnen {depth} im Werkstück</translation>
    </message>
    <message>
        <source>cutter's flank in the way</source>
        <translation>Flanke des Fräsers im Weg</translation>
    </message>
    <message>
        <source>cutting the mesh</source>
        <translation>Netz schneiden</translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>deviation by So et al.</source>
        <translation>Abweichung nach So u. a.</translation>
    </message>
    <message>
        <source>divide blocks</source>
        <translation>NC-Sätze teilen</translation>
    </message>
    <message>
        <source>dividing blocks</source>
        <translation>NC-Sätze teilen</translation>
    </message>
    <message>
        <source>driving the turned axes</source>
        <translation>die gedrehten Achsen werden gefahren</translation>
    </message>
    <message>
        <source>each axis alone</source>
        <translation>jede Achse allein</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>genau</translation>
    </message>
    <message>
        <source>face normal, turning at edges</source>
        <translation>Flächennormale, an Kanten gedreht</translation>
    </message>
    <message>
        <source>fitting machines</source>
        <translation>Maschinen werden angepasst</translation>
    </message>
    <message>
        <source>fixed axis</source>
        <translation>feste Achse</translation>
    </message>
    <message>
        <source>fixture in the way</source>
        <translation>Spannmittel im Weg</translation>
    </message>
    <message>
        <source>flat end mill</source>
        <translation>Schaftfräser</translation>
    </message>
    <message>
        <source>found</source>
        <translation>gefunden</translation>
    </message>
    <message>
        <source>frames with locked rotary axes (3+2)</source>
        <translation>Anstellungen mit geklemmten Rundachsen (3+2)</translation>
    </message>
    <message>
        <source>free</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>free of the part (auto)</source>
        <translation>frei vom Teil (auto)</translation>
    </message>
    <message>
        <source>grbl with five axes</source>
        <translation>grbl mit fünf Achsen</translation>
    </message>
    <message>
        <source>head</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>holder in the way</source>
        <translation>Halter im Weg</translation>
    </message>
    <message>
        <source>impossible: {why}</source>
        <translation>unmöglich: {why}</translation>
    </message>
    <message>
        <source>in a closed hollow</source>
        <translation>in einem geschlossenen Hohlraum</translation>
    </message>
    <message>
        <source>in proportion</source>
        <translation>im Verhältnis</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>instead of {deviation} where it stood</source>
        <translation>statt {deviation}, wo er stand</translation>
    </message>
    <message>
        <source>inverse time (G93)</source>
        <translation>zeitreziprok (G93)</translation>
    </message>
    <message>
        <source>is left</source>
        <translation>bleibt stehen</translation>
    </message>
    <message>
        <source>joining facets</source>
        <translation>Facetten verbinden</translation>
    </message>
    <message>
        <source>larger deviation</source>
        <translation>größere Abweichung</translation>
    </message>
    <message>
        <source>least deviation (minimax)</source>
        <translation>kleinste Abw. (minimax)</translation>
    </message>
    <message>
        <source>least increment</source>
        <translation>kleinstes Inkrement</translation>
    </message>
    <message>
        <source>level planes</source>
        <translation>waagrechte Ebenen</translation>
    </message>
    <message>
        <source>lift the tool</source>
        <translation>Werkzeug abheben</translation>
    </message>
    <message>
        <source>lifting the tool out of the part</source>
        <translation>Werkzeug wird aus dem Teil gehoben</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>link between passes, or lifted: at feed</source>
        <translation>Verbindung oder abgehoben, im Vorschub</translation>
    </message>
    <message>
        <source>linking the passes</source>
        <translation>Bahnen verbinden</translation>
    </message>
    <message>
        <source>lollipop</source>
        <translation>Lollipop-Fräser</translation>
    </message>
    <message>
        <source>looking where the tool enters the part</source>
        <translation>Suche, wo das Werkzeug in das Teil eindringt</translation>
    </message>
    <message>
        <source>looking where the tool gets</source>
        <translation>prüft, wohin das Werkzeug kommt</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>machine in the way</source>
        <translation>Maschine im Weg</translation>
    </message>
    <message>
        <source>machines</source>
        <translation>Maschinen</translation>
    </message>
    <message>
        <source>measuring what is left</source>
        <translation>Messen, was stehen bleibt</translation>
    </message>
    <message>
        <source>meshing the solid</source>
        <translation>Volumenkörper vernetzen</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>model of So et al. 2008</source>
        <translation>Modell von So u. a. 2008</translation>
    </message>
    <message>
        <source>model of So et al. 2008 as printed</source>
        <translation>Modell von So u. a. 2008 wie gedruckt</translation>
    </message>
    <message>
        <source>morph between two curves</source>
        <translation>Übergang zwischen zwei Kurven</translation>
    </message>
    <message>
        <source>near the part where free</source>
        <translation>nahe am Werkstück</translation>
    </message>
    <message>
        <source>near the pole: {count} blocks</source>
        <translation>nahe am Pol: {count} NC-Sätze</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>no spindle speed</source>
        <translation>ohne Drehzahl</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>none, or a file</source>
        <translation>keines, oder eine Datei</translation>
    </message>
    <message>
        <source>normal weighted by step</source>
        <translation>Normale, nach Schritt gewichtet</translation>
    </message>
    <message>
        <source>not checked</source>
        <translation>nicht geprüft</translation>
    </message>
    <message>
        <source>not determined</source>
        <translation>nicht bestimmt</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>not proven between their ends</source>
        <translation>zwischen ihren Enden nicht nachgewiesen</translation>
    </message>
    <message>
        <source>nothing, it stands still</source>
        <translation>nichts, er steht still</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>of a LinuxCNC .ini: its vismach model, which is read, never run</source>
        <translation>zu einer .ini von LinuxCNC: ihr Vismach-Modell; es wird gelesen, nie ausgeführt</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>one way</source>
        <translation>in einer Richtung</translation>
    </message>
    <message>
        <source>only at block ends</source>
        <translation>nur an NC-Satzenden</translation>
    </message>
    <message>
        <source>only report</source>
        <translation>nur berichten</translation>
    </message>
    <message>
        <source>over by {length}</source>
        <translation>um {length} überschritten</translation>
    </message>
    <message>
        <source>over the tolerance: {count} blocks</source>
        <translation>über der Toleranz: {count} NC-Sätze</translation>
    </message>
    <message>
        <source>over tolerance</source>
        <translation>über der Toleranz</translation>
    </message>
    <message>
        <source>own values</source>
        <translation>eigene Werte</translation>
    </message>
    <message>
        <source>parallel planes</source>
        <translation>parallele Ebenen</translation>
    </message>
    <message>
        <source>per minute (G94)</source>
        <translation>je Minute (G94)</translation>
    </message>
    <message>
        <source>placing the passes</source>
        <translation>Bahnen legen</translation>
    </message>
    <message>
        <source>planning safe moves</source>
        <translation>sichere Bewegungen werden geplant</translation>
    </message>
    <message>
        <source>proving the deviation</source>
        <translation>Abweichung nachweisen</translation>
    </message>
    <message>
        <source>radial about an axis</source>
        <translation>strahlenförmig um eine Achse</translation>
    </message>
    <message>
        <source>rapid</source>
        <translation>Eilgang</translation>
    </message>
    <message>
        <source>rapid, dashed</source>
        <translation>Eilgang, gestrichelt</translation>
    </message>
    <message>
        <source>reached</source>
        <translation>erreicht</translation>
    </message>
    <message>
        <source>reading the CL file</source>
        <translation>die CL-Datei wird gelesen</translation>
    </message>
    <message>
        <source>reading the NC file</source>
        <translation>NC-Datei lesen</translation>
    </message>
    <message>
        <source>reading the mesh</source>
        <translation>Netz lesen</translation>
    </message>
    <message>
        <source>recommended</source>
        <translation>empfohlen</translation>
    </message>
    <message>
        <source>recommended: {deviation}</source>
        <translation>empfohlen: {deviation}</translation>
    </message>
    <message>
        <source>rotary: the part turns under the tool</source>
        <translation>rotierend: das Werkstück dreht sich unter dem Werkzeug</translation>
    </message>
    <message>
        <source>seeking axes that are free of the part</source>
        <translation>freie Werkzeugachsen werden gesucht</translation>
    </message>
    <message>
        <source>seeking the axes of least deviation</source>
        <translation>Achsen kleinster Abweichung suchen</translation>
    </message>
    <message>
        <source>setting feeds</source>
        <translation>Vorschübe bestimmen</translation>
    </message>
    <message>
        <source>setups</source>
        <translation>Aufspannungen</translation>
    </message>
    <message>
        <source>shank in the way</source>
        <translation>Schaft im Weg</translation>
    </message>
    <message>
        <source>shank or holder collides: {count} places</source>
        <translation>Schaft oder Halter kollidiert: {count} Stellen</translation>
    </message>
    <message>
        <source>shank or holder {depth} in the part</source>
        <translation>Schaft oder Halter {depth} im Werkstück</translation>
    </message>
    <message>
        <source>signs</source>
        <translation>Vorzeichen</translation>
    </message>
    <message>
        <source>skip these places</source>
        <translation>Stellen auslassen</translation>
    </message>
    <message>
        <source>smaller deviation</source>
        <translation>kleinere Abweichung</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>stopped by the user</source>
        <translation>vom Benutzer abgebrochen</translation>
    </message>
    <message>
        <source>surface normal</source>
        <translation>Flächennormale</translation>
    </message>
    <message>
        <source>table</source>
        <translation>Tisch</translation>
    </message>
    <message>
        <source>taken as 0</source>
        <translation>als 0 angenommen</translation>
    </message>
    <message>
        <source>tapered ball</source>
        <translation>konische Kugel</translation>
    </message>
    <message>
        <source>tapered bull nose</source>
        <translation>konischer Torus</translation>
    </message>
    <message>
        <source>the command line</source>
        <translation>die Kommandozeile</translation>
    </message>
    <message>
        <source>the head</source>
        <translation>den Kopf</translation>
    </message>
    <message>
        <source>the list of machines</source>
        <translation>die Liste der Maschinen</translation>
    </message>
    <message>
        <source>the machine's own</source>
        <translation>die der Maschine</translation>
    </message>
    <message>
        <source>the spindle</source>
        <translation>die Spindel</translation>
    </message>
    <message>
        <source>the table</source>
        <translation>den Tisch</translation>
    </message>
    <message>
        <source>the tool (head)</source>
        <translation>das Werkzeug (Kopf)</translation>
    </message>
    <message>
        <source>the work (table)</source>
        <translation>das Werkstück (Tisch)</translation>
    </message>
    <message>
        <source>through</source>
        <translation>durch</translation>
    </message>
    <message>
        <source>tilt the tool</source>
        <translation>Werkzeug neigen</translation>
    </message>
    <message>
        <source>tilting the tool out of the part</source>
        <translation>Werkzeug wird aus dem Teil geneigt</translation>
    </message>
    <message>
        <source>tip</source>
        <translation>Werkzeugspitze</translation>
    </message>
    <message>
        <source>tool {depth} in the part if axes run independently</source>
        <translation>Werkzeug {depth} im Werkstück, wenn Achsen unabhängig laufen</translation>
    </message>
    <message>
        <source>trying setups</source>
        <translation>Aufspannungen erproben</translation>
    </message>
    <message>
        <source>turn the axis past it</source>
        <translation>Achse vorbeidrehen</translation>
    </message>
    <message>
        <source>turn the axis past the pole</source>
        <translation>Achse am Pol vorbeidrehen</translation>
    </message>
    <message>
        <source>turning the axes</source>
        <translation>Rundachsen berechnen</translation>
    </message>
    <message>
        <source>turning the axis past the pole</source>
        <translation>die Achse wird am Pol vorbeigedreht</translation>
    </message>
    <message>
        <source>where the work zero stood</source>
        <translation>wo der Werkstücknullpunkt stand</translation>
    </message>
    <message>
        <source>wholly in {fixture}</source>
        <translation>ganz in {fixture}</translation>
    </message>
    <message>
        <source>within</source>
        <translation>eingehalten</translation>
    </message>
    <message>
        <source>within tolerance</source>
        <translation>in der Toleranz</translation>
    </message>
    <message>
        <source>within tolerance: {count} places</source>
        <translation>in der Toleranz: {count} Stellen</translation>
    </message>
    <message>
        <source>without {faces}</source>
        <translation>ohne {faces}</translation>
    </message>
    <message>
        <source>writing NC blocks</source>
        <translation>NC-Sätze schreiben</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>zigzag</source>
        <translation>Zickzack</translation>
    </message>
    <message>
        <source>{block} of {last}, {motion}</source>
        <translation>{block} von {last}, {motion}</translation>
    </message>
    <message>
        <source>{controller} does not guide the tip itself: divide blocks instead.</source>
        <translation>{controller} führt die Spitze nicht selbst: stattdessen Sätze teilen.</translation>
    </message>
    <message>
        <source>{controller} has no high-speed mode to switch.</source>
        <translation>{controller} hat keinen schaltbaren Hochgeschwindigkeitsmodus.</translation>
    </message>
    <message>
        <source>{controller} has no inverse time: F is in mm/min.</source>
        <translation>{controller} hat keine inverse Zeit: F ist in mm/min.</translation>
    </message>
    <message>
        <source>{controller} needs the number of the tool for it: give it in the group Tool.</source>
        <translation>{controller} braucht dafür die Nummer des Werkzeugs: in der Gruppe „Werkzeug“ angeben.</translation>
    </message>
    <message>
        <source>{count} passes, {length}, {time} of cutting at the feed, links not counted</source>
        <translation>{count} Bahnen, {length}, {time} Schnittzeit beim Vorschub, ohne Verbindungen</translation>
    </message>
    <message>
        <source>{count}, verified at their end points only</source>
        <translation>{count}, nur an ihren Endpunkten nachgewiesen</translation>
    </message>
    <message>
        <source>{depth} too deep</source>
        <translation>{depth} zu tief</translation>
    </message>
    <message>
        <source>{deviation}, NC line {line}: over {tolerance}</source>
        <translation>{deviation}, NC-Zeile {line}: über {tolerance}</translation>
    </message>
    <message>
        <source>{deviation}, NC line {line}: within {tolerance}</source>
        <translation>{deviation}, NC-Zeile {line}: innerhalb {tolerance}</translation>
    </message>
    <message>
        <source>{document} has no 3D view: open one and play {path} again.</source>
        <translation>{document} hat keine 3D-Ansicht: eine öffnen und {path} noch einmal abspielen.</translation>
    </message>
    <message>
        <source>{file}
{lines} lines, run time {time}</source>
        <translation>{file}
{lines} Zeilen, Laufzeit {time}</translation>
    </message>
    <message>
        <source>{finding}: {area}</source>
        <translation>{finding}: {area}</translation>
    </message>
    <message>
        <source>{finding}: {count} places</source>
        <translation>{finding}: {count} Stellen</translation>
    </message>
    <message>
        <source>{first} turns {first_turn} and {second} {second_turn} to lean the tool by {lean}. The axis may be too slow for the programmed feed: then the tool dwells and may leave a mark.</source>
        <translation>{first} dreht um {first_turn} und {second} um {second_turn}, um das Werkzeug um {lean} zu neigen. Die Achse kann für den programmierten Vorschub zu langsam sein: dann verweilt das Werkzeug und hinterlässt womöglich eine Marke.</translation>
    </message>
    <message>
        <source>{first} turns {first_turn} and {second} {second_turn} while the tool keeps its direction. The axis may be too slow for the programmed feed: then the tool dwells and may leave a mark.</source>
        <translation>{first} dreht um {first_turn} und {second} um {second_turn}, während das Werkzeug seine Richtung behält. Die Achse ist dafür vielleicht zu langsam: Dann verweilt das Werkzeug und hinterlässt womöglich eine Marke.</translation>
    </message>
    <message>
        <source>{height} left</source>
        <translation>{height} bleibt stehen</translation>
    </message>
    <message>
        <source>{length} (centre)</source>
        <translation>{length} (Mitte)</translation>
    </message>
    <message>
        <source>{length} deep</source>
        <translation>{length} tief</translation>
    </message>
    <message>
        <source>{length} from {fixture}</source>
        <translation>{length} vor {fixture}</translation>
    </message>
    <message>
        <source>{length} in {fixture}</source>
        <translation>{length} tief in {fixture}</translation>
    </message>
    <message>
        <source>{letter} line, {way}</source>
        <translation>Linie von {letter}, {way}</translation>
    </message>
    <message>
        <source>{letter} zero</source>
        <translation>Null von {letter}</translation>
    </message>
    <message>
        <source>{name} (0: the program leaves it off)</source>
        <translation>{name} (0: das Programm lässt sie aus)</translation>
    </message>
    <message>
        <source>{name}, other blocks</source>
        <translation>{name}, andere NC-Sätze</translation>
    </message>
    <message>
        <source>{now} of {whole}</source>
        <translation>{now} von {whole}</translation>
    </message>
    <message>
        <source>{over_tolerance} blocks are over the tolerance; this is the worst.</source>
        <translation>{over_tolerance} NC-Sätze liegen über der Toleranz; dieser ist der schlimmste.</translation>
    </message>
    <message>
        <source>{share} % reached</source>
        <translation>{share} % erreicht</translation>
    </message>
    <message>
        <source>{shown} of {count} places: those at the recommended height</source>
        <translation>{shown} von {count} Plätzen: die in der empfohlenen Höhe</translation>
    </message>
    <message>
        <source>{singular_blocks} blocks lie near the pole; this is the worst.</source>
        <translation>{singular_blocks} NC-Sätze liegen nahe am Pol; dieser ist der schlimmste.</translation>
    </message>
    <message>
        <source>{unproven} blocks are not proven; this is the worst.</source>
        <translation>{unproven} NC-Sätze sind nicht bewiesen; dieser ist der schlimmste.</translation>
    </message>
    <message>
        <source>{what}, NC line {line}</source>
        <translation>{what}, NC-Zeile {line}</translation>
    </message>
    <message>
        <source>{what}: all, the worst at</source>
        <translation>{what}: alle, der schlimmste bei</translation>
    </message>
    <message>
        <source>{} is the name of the report too: name the NC file otherwise.</source>
        <translation>{} heißt auch der Bericht: NC-Datei anders nennen.</translation>
    </message>
    <message>
        <source>{} is this document: name another file.</source>
        <translation>{} ist dieses Dokument: eine andere Datei nennen.</translation>
    </message>
    <message>
        <source>{} s</source>
        <translation>{} s</translation>
    </message>
    <message>
        <source>“Audit an NC file”</source>
        <translation>„NC-Datei prüfen“</translation>
    </message>
    <message>
        <source>“Post-process”</source>
        <translation>„NC-Datei ausgeben“</translation>
    </message>
    <message>
        <source>“Prove the signs”</source>
        <translation>„Vorzeichen nachweisen“</translation>
    </message>
    <message>
        <source>“Recover a machine from a program”</source>
        <translation>„Maschine aus einem Programm zurückgewinnen“</translation>
    </message>
    <message>
        <source>“Tool path”</source>
        <translation>„Werkzeugweg“</translation>
    </message>
    <message>
        <source>“Where to clamp”</source>
        <translation>„Wohin spannen“</translation>
    </message>
</context>
<context>
    <name>FiveAxisCore</name>
    <message>
        <source> (NC line {line})</source>
        <translation> (NC-Zeile {line})</translation>
    </message>
    <message>
        <source> (along the axis, which leans)</source>
        <translation> (entlang der Achse, die geneigt ist)</translation>
    </message>
    <message>
        <source> ({value})</source>
        <translation> ({value})</translation>
    </message>
    <message>
        <source> ({value}, NC line {line})</source>
        <translation> ({value}, NC-Zeile {line})</translation>
    </message>
    <message>
        <source> All differences together put the tip off by up to {miss} on that machine.</source>
        <translation> Alle Unterschiede zusammen bringen die Spitze auf jener Maschine um bis zu {miss} ab.</translation>
    </message>
    <message>
        <source> Beside it up to {height} is left between the passes.</source>
        <translation> Daneben bleibt zwischen den Bahnen bis {height} stehen.</translation>
    </message>
    <message>
        <source> The path goes straight on to the next GOTO: have curves written as points.</source>
        <translation> Der Werkzeugweg geht gerade weiter zum nächsten GOTO: Kurven als Punkte ausgeben lassen.</translation>
    </message>
    <message>
        <source> The tool only goes to its points: have cycles written as moves.</source>
        <translation> Das Werkzeug fährt nur zu seinen Punkten: Zyklen als Bewegungen ausgeben lassen.</translation>
    </message>
    <message>
        <source> This is the deepest of {blocks} blocks in {places} places.</source>
        <translation> Das ist der tiefste von {blocks} NC-Sätzen an {places} Stellen.</translation>
    </message>
    <message>
        <source> This is the deepest of {blocks} blocks there.</source>
        <translation> Das ist der tiefste von {blocks} NC-Sätzen dort.</translation>
    </message>
    <message>
        <source> and the part turned by {turn}</source>
        <translation> und das Werkstück um {turn} gedreht</translation>
    </message>
    <message>
        <source> at {count} place, {depth} deep</source>
        <translation> an {count} Stelle, {depth} tief</translation>
    </message>
    <message>
        <source> at {count} places, {depth} deep</source>
        <translation> an {count} Stellen, {depth} tief</translation>
    </message>
    <message>
        <source> in {count} blocks</source>
        <translation> in {count} NC-Sätzen</translation>
    </message>
    <message>
        <source> of {axes}</source>
        <translation> von {axes}</translation>
    </message>
    <message>
        <source> {name} is another machine.</source>
        <translation> {name} ist eine andere Maschine.</translation>
    </message>
    <message>
        <source> {name} is that machine.</source>
        <translation> {name} ist diese Maschine.</translation>
    </message>
    <message>
        <source>#0 takes no value</source>
        <translation>#0 nimmt keinen Wert an</translation>
    </message>
    <message>
        <source>#{key} is known only at the machine</source>
        <translation>#{key} kennt nur die Maschine</translation>
    </message>
    <message>
        <source>#{key} sets the machine</source>
        <translation>#{key} stellt die Maschine ein</translation>
    </message>
    <message>
        <source>- is no file, and nothing is written to the standard output; name a file</source>
        <translation>- ist keine Datei, und auf die Standardausgabe wird nichts geschrieben; eine Datei nennen</translation>
    </message>
    <message>
        <source>1 block feeds after a move to a machine position, before {axes} has a word again in a rapid move: it is taken from where the axis stood before. Give {axes} first.</source>
        <translation>1 Satz fährt nach einer Maschinenposition im Vorschub, bevor {axes} im Eilgang wieder ein Wort hat: Er ist von dort genommen, wo die Achse vorher stand. Zuerst {axes} angeben.</translation>
    </message>
    <message>
        <source>1 block has no F above 0 in force; most controllers stop there. Give F.</source>
        <translation>1 NC-Satz hat kein gültiges F über 0; die meisten Steuerungen halten dort an. F angeben.</translation>
    </message>
    <message>
        <source>1 block leads</source>
        <translation>1 NC-Satz führt</translation>
    </message>
    <message>
        <source>1 block under G93 has no F of its own; most controllers stop there. Give F in every block.</source>
        <translation>1 NC-Satz unter G93 hat kein eigenes F; die meisten Steuerungen halten dort an. F in jedem Satz angeben.</translation>
    </message>
    <message>
        <source>1 feed block</source>
        <translation>1 Vorschubsatz</translation>
    </message>
    <message>
        <source>1 feed block (NC line {first})</source>
        <translation>1 Vorschubsatz (NC-Zeile {first})</translation>
    </message>
    <message>
        <source>1 feed block asks</source>
        <translation>1 Vorschubsatz verlangt</translation>
    </message>
    <message>
        <source>1 feed block is</source>
        <translation>1 Vorschubsatz liegt</translation>
    </message>
    <message>
        <source>1 feed block leaves</source>
        <translation>1 Vorschubsatz verlässt</translation>
    </message>
    <message>
        <source>1 feed block lies</source>
        <translation>1 Vorschubsatz liegt</translation>
    </message>
    <message>
        <source>1 feed block: {count} of {all} feed blocks {what} Worst is NC line {line}, {off} off ({tolerance} allowed); first NC line {first}.</source>
        <translation>1 Vorschubsatz: {count} von {all} Vorschubsätzen {what} Am schlimmsten ist NC-Zeile {line}, {off} daneben ({tolerance} erlaubt); die erste ist NC-Zeile {first}.</translation>
    </message>
    <message>
        <source>1 of {all} ways holds {tolerance}; the quickest is {way}, {time}.</source>
        <translation>1 von {all} Wegen hält {tolerance} ein; der schnellste ist {way}, {time}.</translation>
    </message>
    <message>
        <source>1 setup that was tried is passed over, because the machine is hit there: with the work zero at {origin} the {name} by {depth}.</source>
        <translation>1 geprüfte Aufspannung ist übergangen, weil dort die Maschine getroffen wird: mit dem Werkstück-Nullpunkt bei {origin} wird {name} um {depth} getroffen.</translation>
    </message>
    <message>
        <source>: the tool cannot reach it ({why})</source>
        <translation>: Das Werkzeug kommt nicht hin ({why})</translation>
    </message>
    <message>
        <source>: {parts}</source>
        <translation>: {parts}</translation>
    </message>
    <message>
        <source>; did you mean {close}?</source>
        <translation> – ist {close} gemeint?</translation>
    </message>
    <message>
        <source>; do you mean {close}?</source>
        <translation> – ist {close} gemeint?</translation>
    </message>
    <message>
        <source>; what was there before is in {backups}</source>
        <translation>; was vorher dort stand, ist in {backups}</translation>
    </message>
    <message>
        <source>; {kept} were finished before</source>
        <translation>; {kept} waren schon fertig</translation>
    </message>
    <message>
        <source>; {key} is not known</source>
        <translation>; {key} ist nicht bekannt</translation>
    </message>
    <message>
        <source>; {option} is for {commands}; leave it out here</source>
        <translation>; {option} gehört zu {commands}; hier weglassen</translation>
    </message>
    <message>
        <source>; {word} stands there, do you mean {close}?</source>
        <translation>; dort steht {word} – ist {close} gemeint?</translation>
    </message>
    <message>
        <source>A controller with tool tip control (RTCP) guides the tip along the segment itself.</source>
        <translation>Eine Steuerung mit Werkzeugspitzenführung (RTCP) führt die Werkzeugspitze von sich aus auf der Strecke.</translation>
    </message>
    <message>
        <source>A display or pose that differs: work offset, tool length or zero positions are not set.</source>
        <translation>Eine andere Anzeige oder Stellung: Nullpunktverschiebung, Werkzeuglänge oder Nullstellungen sind nicht gesetzt.</translation>
    </message>
    <message>
        <source>A drilling cycle (line {line}) is not ended by CYCLE/OFF: it is taken to end at the next tool, operation or arc (line {end}), and the moves behind that drill no holes. Say CYCLE/OFF.</source>
        <translation>Ein Bohrzyklus (Zeile {line}) wird nicht durch CYCLE/OFF beendet: Er gilt als beendet beim nächsten Werkzeug, Arbeitsgang oder Bogen (Zeile {end}), und die Bewegungen danach bohren nicht. CYCLE/OFF angeben.</translation>
    </message>
    <message>
        <source>A drilling cycle dwells at the bottom (line {line}): the tool does not wait there in the program.</source>
        <translation>Ein Bohrzyklus verweilt am Grund (Zeile {line}): Im Programm wartet das Werkzeug dort nicht.</translation>
    </message>
    <message>
        <source>A drilling cycle with pecks says no STEP (line {line}): its holes are drilled in one go. Say the step, if the chips are to come out.</source>
        <translation>Ein Bohrzyklus mit Zustellungen nennt kein STEP (Zeile {line}): Seine Bohrungen werden in einem Zug gebohrt. Die Zustellung angeben, wenn die Späne herauskommen sollen.</translation>
    </message>
    <message>
        <source>A head's pivot was found as its distance from the tip, tool included. Give {tool_length} to have the gauge point's written; else use the file with tool length 0.</source>
        <translation>Der Drehpunkt eines Kopfes wurde als Abstand von der Werkzeugspitze gefunden, das Werkzeug eingeschlossen. {tool_length} angeben, damit der des Bezugspunkts geschrieben wird; sonst die Datei mit Werkzeuglänge 0 verwenden.</translation>
    </message>
    <message>
        <source>A positive word is taken for a positive value of its joint, which moves table or tool along or about its axis. Prove the signs before cutting.</source>
        <translation>Ein positives Wort gilt als positiver Wert seines Gelenks, das Tisch oder Werkzeug entlang seiner Achse oder um sie bewegt. Prüfen Sie die Vorzeichen, bevor Sie fräsen.</translation>
    </message>
    <message>
        <source>A shorter one may then do: to try it, run {task} with {options}; it says whether that is free.</source>
        <translation>Dann genügt vielleicht ein kürzeres: zum Versuch {task} mit {options} ausführen; dort steht, ob das frei ist.</translation>
    </message>
    <message>
        <source>A step or FROM stands within a drilling cycle (line {line}): no hole is drilled there. Say CYCLE/OFF before.</source>
        <translation>Ein Schritt oder FROM steht in einem Bohrzyklus (Zeile {line}): Dort wird nicht gebohrt. Vorher CYCLE/OFF angeben.</translation>
    </message>
    <message>
        <source>AND beside OR without a line of its own</source>
        <translation>AND neben OR ohne eigene Zeile</translation>
    </message>
    <message>
        <source>About {lost} of that cannot be reached because of the fixture {fixture}, which is in the way. {remedy}</source>
        <translation>Etwa {lost} davon sind wegen des Spannmittels {fixture}, das im Weg ist, nicht erreichbar. {remedy}</translation>
    </message>
    <message>
        <source>About {lost} of that cannot be reached because of the table: the tool would go below its face. {remedy}</source>
        <translation>Etwa {lost} davon sind wegen des Tisches nicht erreichbar: Das Werkzeug käme unter seine Fläche. {remedy}</translation>
    </message>
    <message>
        <source>All rotary words lie within {most}, and read as radians the tip goes {radians} instead of {degrees}: they seem to be radians, where controllers take degrees. Have the post write degrees.</source>
        <translation>Alle Drehworte liegen innerhalb von {most}, und als Bogenmaß gelesen legt die Spitze {radians} zurück statt {degrees}: Sie scheinen Bogenmaß zu sein, Steuerungen nehmen Grad. Den Postprozessor Grad schreiben lassen.</translation>
    </message>
    <message>
        <source>All that is to be milled of {label} is to be left alone too: take {names}, or some of them, out of {option}.</source>
        <translation>Alles, was von {label} gefräst werden soll, soll auch ausgespart bleiben: {names}, oder einige davon, aus „{option}“ herausnehmen.</translation>
    </message>
    <message>
        <source>All {count} facets looked inward and were turned outward; check the export if only some of them should.</source>
        <translation>Alle {count} Facetten zeigten nach innen und wurden nach außen gewendet; den Export prüfen, wenn es nur für einige gelten sollte.</translation>
    </message>
    <message>
        <source>An arc does not pass through the points before and after it (line {line}: off by {off}, radius {radius}); the path goes straight there. Has the CAM system left out a move, or are the units mixed?</source>
        <translation>Ein Kreisbogen geht nicht durch die Punkte vor und nach ihm (Zeile {line}: {off} daneben, Radius {radius}); der Weg ist dort gerade. Hat das CAM-System eine Bewegung ausgelassen, oder sind die Einheiten gemischt?</translation>
    </message>
    <message>
        <source>An arc lacks its start or its end (line {line}): it stands before the first move, after the last one, before another arc or a hole, or its direction points to its centre. The path goes straight there.</source>
        <translation>Einem Bogen fehlt Anfang oder Ende (Zeile {line}): Er steht vor der ersten Bewegung, nach der letzten, vor einem anderen Bogen oder einer Bohrung, oder seine Richtung zeigt auf seinen Mittelpunkt. Die Bahn geht dort gerade.</translation>
    </message>
    <message>
        <source>An arc runs back against the straight moves beside it (line {line}): does the CAM system mean its circles the other way round? Have curves written as points.</source>
        <translation>Ein Kreisbogen läuft den geraden Bewegungen neben ihm entgegen (Zeile {line}): Meint das CAM-System seine Kreise andersherum? Kurven als Punkte ausgeben lassen.</translation>
    </message>
    <message>
        <source>An arc turns back where a straight move meets it (line {line}), as in a corner beside an island; {on} others of the file run on as read.</source>
        <translation>Ein Bogen kehrt um, wo eine Gerade an ihn stößt (Zeile {line}), wie in einer Ecke neben einer Insel; {on} andere der Datei laufen weiter wie gelesen.</translation>
    </message>
    <message>
        <source>Approaches and blocks in which an axis is at its limit are rightly slower; look at the others.</source>
        <translation>Anfahrten und NC-Sätze, in denen eine Achse an ihrer Grenze ist, sind zu Recht langsamer; die anderen ansehen.</translation>
    </message>
    <message>
        <source>Are {cutter}, {origin} and the machine those of the program, and does the STL stand at the work zero? If they are, the part is spoilt.</source>
        <translation>Sind {cutter}, {origin} und die Maschine die des Programms, und steht die STL-Datei am Werkstücknullpunkt? Wenn ja, ist das Werkstück verdorben.</translation>
    </message>
    <message>
        <source>Assumed</source>
        <translation>Angenommen</translation>
    </message>
    <message>
        <source>At 1 place an inside corner is tighter than the cutter; {much}. Use a smaller cutter there.</source>
        <translation>An 1 Stelle ist eine Innenecke enger als der Fräser; {much}. Dort einen kleineren Fräser nehmen.</translation>
    </message>
    <message>
        <source>At 1 place the surface curls tighter than the cutter, which cuts into it; how deep is not known here. Have the path checked against the part ({report}), or lifted out of it ({lift}), or use a smaller cutter.</source>
        <translation>An 1 Stelle krümmt sich die Fläche enger als der Fräser, und er schneidet hinein; wie tief, ist hier nicht bekannt. Den Weg gegen das Werkstück prüfen ({report}) oder herausheben lassen ({lift}), oder einen kleineren Fräser nehmen.</translation>
    </message>
    <message>
        <source>At every stop compare what you see with this sheet, and stop for good if it differs. The tip stays at least {gap} above the level of the mark, even if a rotary axis turns the wrong way or the two are exchanged.</source>
        <translation>An jedem Halt mit diesem Blatt vergleichen, was zu sehen ist, und bei einem Unterschied endgültig anhalten. Die Werkzeugspitze bleibt mindestens {gap} über der Höhe der Marke, auch wenn eine Rundachse falsch herum dreht oder die beiden vertauscht sind.</translation>
    </message>
    <message>
        <source>At the end of {count} feed blocks the tool does not stand as the CL path says: worst NC line {line}, by {lean} ({tolerance} allowed); first NC line {first}. Are signs, order and zeros of the rotary axes those of the machine?</source>
        <translation>Am Ende von {count} Vorschubsätzen steht das Werkzeug nicht so, wie der CL-Weg es sagt: am schlimmsten NC-Zeile {line}, um {lean} ({tolerance} erlaubt); die erste ist NC-Zeile {first}. Sind Vorzeichen, Reihenfolge und Nullpunkte der Rundachsen die der Maschine?</translation>
    </message>
    <message>
        <source>At the others ({share} %) the part is: use a smaller cutter or holder, or a longer tool, or turn the part.</source>
        <translation>An den übrigen ({share} %) ist es das Teil: kleineren Fräser oder Halter oder längeres Werkzeug nehmen oder das Teil drehen.</translation>
    </message>
    <message>
        <source>At {count} of {all} contacts ({share} %), the first at {place}, no tool axis was found that the machine can take up and that keeps the tool off what stands about it; they are left out. In the way is {causes}. {remedy}</source>
        <translation>An {count} von {all} Berührpunkten ({share} %), der erste bei {place}, wurde keine Werkzeugachse gefunden, die die Maschine einnehmen kann und die das Werkzeug von dem fernhält, was um es steht; sie werden ausgelassen. Im Weg ist {causes}. {remedy}</translation>
    </message>
    <message>
        <source>At {count} of {all} contacts ({share} %), the first at {place}, no tool axis was found that the machine can take up and that keeps the tool out of the part; they are left out. Use a smaller cutter or holder, or a longer tool, or turn the part.</source>
        <translation>An {count} von {all} Berührpunkten ({share} %), der erste bei {place}, wurde keine Werkzeugachse gefunden, die die Maschine einnehmen kann und die das Werkzeug aus dem Teil hält; sie werden ausgelassen. Kleineren Fräser oder Halter oder längeres Werkzeug nehmen oder das Teil drehen.</translation>
    </message>
    <message>
        <source>At {count} of {all} contacts ({share} %), the first at {place}, the tool is not free with the axis of their frame; they are left out. Use a smaller cutter or holder, a longer tool, or other passes for the rest.</source>
        <translation>An {count} von {all} Berührpunkten ({share} %), der erste bei {place}, ist das Werkzeug mit der Achse ihrer Anstellung nicht frei; sie werden ausgelassen. Einen kleineren Fräser oder Halter, ein längeres Werkzeug oder für den Rest andere Bahnen nehmen.</translation>
    </message>
    <message>
        <source>At {count} places an inside corner is tighter than the cutter; {much}. Use a smaller cutter there.</source>
        <translation>An {count} Stellen ist eine Innenecke enger als der Fräser; {much}. Dort einen kleineren Fräser nehmen.</translation>
    </message>
    <message>
        <source>At {count} places the surface curls tighter than the cutter, which cuts into it; how deep is not known here. Have the path checked against the part ({report}), or lifted out of it ({lift}), or use a smaller cutter.</source>
        <translation>An {count} Stellen krümmt sich die Fläche enger als der Fräser, und er schneidet hinein; wie tief, ist hier nicht bekannt. Den Weg gegen das Werkstück prüfen ({report}) oder herausheben lassen ({lift}), oder einen kleineren Fräser nehmen.</translation>
    </message>
    <message>
        <source>Axis words stand under no G0 or G1; they are taken as G1. Give a motion code.</source>
        <translation>Achswörter stehen weder unter G0 noch G1; sie werden als G1 genommen. Einen Bewegungscode angeben.</translation>
    </message>
    <message>
        <source>Before it tilts the plane the control draws the tool back by a setting of the machine; that move is missing here.</source>
        <translation>Bevor die Steuerung die Ebene schwenkt, zieht sie das Werkzeug um einen Parameter der Maschine zurück; diese Bewegung fehlt hier.</translation>
    </message>
    <message>
        <source>Begin and end with an upright tool, or set the machine file's safe_start to none and begin by hand.</source>
        <translation>Mit senkrechtem Werkzeug beginnen und enden oder safe_start der Maschinendatei auf none setzen und von Hand beginnen.</translation>
    </message>
    <message>
        <source>Between pecks the tool stays {back} off the depth reached here; on this control a setting says how far. No other place hangs on it.</source>
        <translation>Zwischen den Zustellungen bleibt das Werkzeug hier {back} vor der erreichten Tiefe; an dieser Steuerung sagt das ein Parameter. Kein anderer Ort hängt davon ab.</translation>
    </message>
    <message>
        <source>C alone is parallel to the tool and never tilts it; leave C out for a machine of three axes</source>
        <translation>C allein ist parallel zum Werkzeug und neigt es nie; für eine dreiachsige Maschine C weglassen</translation>
    </message>
    <message>
        <source>CHECK</source>
        <translation>PRÜFEN</translation>
    </message>
    <message>
        <source>CL file, line {line}: {finding}</source>
        <translation>CL-Datei, Zeile {line}: {finding}</translation>
    </message>
    <message>
        <source>CL file: {finding}</source>
        <translation>CL-Datei: {finding}</translation>
    </message>
    <message>
        <source>CUTCOM asks for cutter compensation once (line {line}); the program has none: {taken}</source>
        <translation>CUTCOM verlangt einmal Radiuskorrektur (Zeile {line}); das Programm hat keine: {taken}</translation>
    </message>
    <message>
        <source>CUTCOM asks for cutter compensation {count} times (first line {line}); the program has none: {taken}</source>
        <translation>CUTCOM verlangt {count}-mal Radiuskorrektur (zuerst Zeile {line}); das Programm hat keine: {taken}</translation>
    </message>
    <message>
        <source>Clamp the part elsewhere or higher, use a longer tool, or lean it less.</source>
        <translation>Das Werkstück anderswo oder höher spannen, ein längeres Werkzeug nehmen oder es weniger neigen.</translation>
    </message>
    <message>
        <source>Clamp the part higher above the table.</source>
        <translation>Das Teil höher über dem Tisch aufspannen.</translation>
    </message>
    <message>
        <source>Clamp the part otherwise, so that the fixture stands elsewhere.</source>
        <translation>Das Teil anders spannen, so dass das Spannmittel anderswo steht.</translation>
    </message>
    <message>
        <source>Clamp the part otherwise, use a longer tool or a smaller holder, or machine fewer faces.</source>
        <translation>Spannen Sie das Teil anders, nehmen Sie ein längeres Werkzeug oder einen kleineren Halter, oder bearbeiten Sie weniger Flächen.</translation>
    </message>
    <message>
        <source>Closed passes begin where {letter} has room for them within its limits.</source>
        <translation>Geschlossene Bahnen beginnen dort, wo {letter} innerhalb seiner Grenzen Platz für sie hat.</translation>
    </message>
    <message>
        <source>Closed passes run by turns one way round and the other, so that {letter} goes to and fro within its limits.</source>
        <translation>Geschlossene Bahnen laufen abwechselnd in der einen und der anderen Richtung um, sodass {letter} innerhalb seiner Grenzen hin- und hergeht.</translation>
    </message>
    <message>
        <source>Cutter's flank in the way ({area}): its end fits, what is above it does not, as under an overhang; a smaller radius need not help, a lollipop or another setup may.</source>
        <translation>Flanke des Fräsers im Weg ({area}): Sein Ende passt, was darüber ist nicht, wie unter einem Überhang; ein kleinerer Radius hilft nicht unbedingt, vielleicht ein Lollipop-Fräser oder eine andere Aufspannung.</translation>
    </message>
    <message>
        <source>Drive one group of axes after the other, or, where the controller interpolates rapids, say so in the machine file or by {rapids}.</source>
        <translation>Die Achsgruppen nacheinander bewegen oder, wenn die Steuerung Eilgänge interpoliert, dies in der Maschinendatei oder mit {rapids} angeben.</translation>
    </message>
    <message>
        <source>EXISTS of a variable without a name</source>
        <translation>EXISTS einer Variablen ohne Namen</translation>
    </message>
    <message>
        <source>Every way leaves out at least {share} % of the surface: no free axis of the machine is there.</source>
        <translation>Jeder Weg lässt mindestens {share} % der Fläche aus: Dort ist keine Werkzeugachse der Maschine frei.</translation>
    </message>
    <message>
        <source>F exceeds the controller's largest</source>
        <translation>F übersteigt den größten Wert der Steuerung</translation>
    </message>
    <message>
        <source>F is larger than the controller takes</source>
        <translation>F ist größer, als die Steuerung annimmt</translation>
    </message>
    <message>
        <source>F lies below the controller's smallest step</source>
        <translation>F liegt unter der kleinsten Stufe der Steuerung</translation>
    </message>
    <message>
        <source>F says {speed}</source>
        <translation>F sagt {speed}</translation>
    </message>
    <message>
        <source>F under G70 counts in the control's basic system, mm or inches, which the program does not say; taken as inches. Give {option}, mm or inch, or post G700.</source>
        <translation>F unter G70 zählt im Grundsystem der Steuerung, mm oder Zoll, was das Programm nicht sagt; als Zoll genommen. {option} angeben, mm oder inch, oder mit G700 ausgeben.</translation>
    </message>
    <message>
        <source>FEDRAT needs one feed above 0</source>
        <translation>FEDRAT braucht einen Vorschub über 0</translation>
    </message>
    <message>
        <source>Feed override at its lowest, single block on, a hand on feed hold. The program waits (M0) after every line below.</source>
        <translation>Vorschub-Override ganz unten, Einzelsatz an, eine Hand am Vorschub-Halt. Das Programm wartet (M0) nach jeder Zeile unten.</translation>
    </message>
    <message>
        <source>For the post {letter} is the rotary axis nearer to the work, for {name} it is {own}.</source>
        <translation>Für den Postprozessor ist {letter} die Rundachse näher am Werkstück, für {name} ist es {own}.</translation>
    </message>
    <message>
        <source>For this cutter and these passes there is no other setting that is known to finish more, so none was tried.</source>
        <translation>Für diesen Fräser und diese Bahnen ist keine andere Einstellung bekannt, die mehr fertig bearbeitet; es wurde daher keine versucht.</translation>
    </message>
    <message>
        <source>FreeCAD could not mesh {label}: check its geometry, or choose other deflections.</source>
        <translation>FreeCAD konnte {label} nicht vernetzen: die Geometrie prüfen oder andere Abweichungen wählen.</translation>
    </message>
    <message>
        <source>FreeCAD's file does not say everything; taken: {lacking}. Correct them under fiveaxis.</source>
        <translation>FreeCADs Datei sagt nicht alles; angenommen: {lacking}. Unter fiveaxis berichtigen.</translation>
    </message>
    <message>
        <source>From NC line {line} on axes go home, and {function} is still on: the control may refuse that, or move X Y Z beside the rotary axes to keep the tip. Retract Z, then give {off} before that line.</source>
        <translation>Ab NC-Zeile {line} fahren Achsen heim, und {function} ist noch an: Die Steuerung kann das ablehnen, oder sie bewegt X Y Z neben den Rundachsen, um die Spitze zu halten. Z zurückziehen, dann vor dieser Zeile {off} angeben.</translation>
    </message>
    <message>
        <source>From and to, travel and the length of rapids count Z coming down from {plane} to the first block and rising to it from the last. Where the axes stand before is not known.</source>
        <translation>Von und bis, Verfahrweg und Länge der Eilgänge zählen mit, dass Z von {plane} zum ersten Satz herabfährt und vom letzten dorthin hinauf. Wo die Achsen davor stehen, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>G12.1 P0 is taken as the kinematics of the tip (M428), G12.1 P1 as that of the axes (M429), as LinuxCNC's trt modules and 5axiskins count them. If the machine's module counts otherwise, the path is another: look into its HAL file.</source>
        <translation>G12.1 P0 gilt als Kinematik der Spitze (M428), G12.1 P1 als die der Achsen (M429), wie LinuxCNCs trt-Module und 5axiskins zählen. Zählt das Modul der Maschine anders, ist es ein anderer Weg: in ihrer HAL-Datei nachsehen.</translation>
    </message>
    <message>
        <source>G43, G43.4, G43.5 and G234 take it by their H: give H there.</source>
        <translation>G43, G43.4, G43.5 und G234 nehmen sie mit ihrem H: dort H angeben.</translation>
    </message>
    <message>
        <source>G66 calls a program after each block</source>
        <translation>G66 ruft nach jedem Satz ein Programm auf</translation>
    </message>
    <message>
        <source>G76 is read without its shift: at the bottom the control leaves the wall by I J or Q before the tool rises, and comes back above.</source>
        <translation>G76 wird ohne seinen Versatz gelesen: Am Grund entfernt sich die Steuerung um I J oder Q von der Wand, bevor das Werkzeug steigt, und kommt oben zurück.</translation>
    </message>
    <message>
        <source>GODLTA stands before the first GOTO: from where is not known</source>
        <translation>GODLTA steht vor dem ersten GOTO: der Ausgangspunkt ist nicht bekannt</translation>
    </message>
    <message>
        <source>Give D1 after D0.</source>
        <translation>Nach D0 wieder D1 angeben.</translation>
    </message>
    <message>
        <source>Give G43 H after M6.</source>
        <translation>Nach M6 G43 H angeben.</translation>
    </message>
    <message>
        <source>Give TOOL CALL with the tool.</source>
        <translation>TOOL CALL mit dem Werkzeug angeben.</translation>
    </message>
    <message>
        <source>Give safe_start of the machine file a higher Z.</source>
        <translation>Geben Sie safe_start in der Maschinendatei ein höheres Z.</translation>
    </message>
    <message>
        <source>Give {options}.</source>
        <translation>Geben Sie {options} an.</translation>
    </message>
    <message>
        <source>If {text}, the tip is off by {size} only at the last stop, which is easily overlooked: rely on the stops</source>
        <translation>Wenn gilt: {text}, steht die Werkzeugspitze nur am letzten Halt um {size} daneben, was leicht übersehen wird: auf die Halte verlassen</translation>
    </message>
    <message>
        <source>In 1 of these the controller guides the tip: only the end points of blocks are verified there, the path between them is under RTCP.</source>
        <translation>Bei 1 davon führt die Steuerung die Spitze: Geprüft sind dort nur die Endpunkte der NC-Sätze, der Weg dazwischen liegt unter RTCP.</translation>
    </message>
    <message>
        <source>In 1 of these the controller would have to guide the tip, which {names} cannot.</source>
        <translation>Bei 1 davon müsste die Steuerung die Spitze führen, was {names} nicht kann.</translation>
    </message>
    <message>
        <source>In 1 of {all} ways it is not checked whether the tool goes into the part.</source>
        <translation>Bei 1 von {all} Wegen ist nicht geprüft, ob das Werkzeug ins Werkstück geht.</translation>
    </message>
    <message>
        <source>In 1 of {all} ways more of the surface is left out than in others.</source>
        <translation>Bei 1 von {all} Wegen bleibt mehr von der Fläche ausgelassen als bei anderen.</translation>
    </message>
    <message>
        <source>In 1 of {all} ways the tool goes into the part.</source>
        <translation>Bei 1 von {all} Wegen geht das Werkzeug ins Werkstück.</translation>
    </message>
    <message>
        <source>In 1 of {all} ways the tool hits a fixture.</source>
        <translation>Auf 1 von {all} Wegen trifft das Werkzeug ein Spannmittel.</translation>
    </message>
    <message>
        <source>In NC line {line} the program ends, and {function} is still on: the next one may begin with it. Give {off} before the end.</source>
        <translation>In NC-Zeile {line} endet das Programm, und {function} ist noch an: Das nächste kann damit beginnen. Vor dem Ende {off} angeben.</translation>
    </message>
    <message>
        <source>In all {count} setups that were tried the machine is hit, least with the work zero at {origin}: the {name} by {depth}. Move the region ({option}), clamp the part higher, or use a longer tool.</source>
        <translation>In allen {count} geprüften Aufspannungen wird die Maschine getroffen, am wenigsten mit dem Werkstück-Nullpunkt bei {origin}: {name} um {depth}. Den Bereich verschieben ({option}), das Werkstück höher spannen oder ein längeres Werkzeug nehmen.</translation>
    </message>
    <message>
        <source>In hollows along the passes the cutter's bottom stands in the part behind its contact or before it, over {count} rows; how deep is not known here. Give more lead, take a smaller cutter or a ball, or have the path checked against the part ({report}), or lifted out of it ({lift}).</source>
        <translation>In Mulden längs der Bahnen steht der Boden des Fräsers hinter oder vor dem Berührpunkt im Teil, über {count} Zeilen; wie tief, ist hier nicht bekannt. Mehr Voreilwinkel geben, einen kleineren Fräser oder eine Kugel nehmen, oder die Bahn gegen das Teil prüfen ({report}) oder aus ihm heben lassen ({lift}).</translation>
    </message>
    <message>
        <source>In the one setup that was tried the machine is hit, with the work zero at {origin}: the {name} by {depth}. Move the region ({option}), clamp the part higher, or use a longer tool.</source>
        <translation>In der einen geprüften Aufspannung wird die Maschine getroffen, mit dem Werkstück-Nullpunkt bei {origin}: {name} um {depth}. Den Bereich verschieben ({option}), das Werkstück höher spannen oder ein längeres Werkzeug nehmen.</translation>
    </message>
    <message>
        <source>In the present setup the axes leave their limits.</source>
        <translation>In der jetzigen Aufspannung verlassen die Achsen ihre Grenzen.</translation>
    </message>
    <message>
        <source>In the present setup the machine is hit.</source>
        <translation>In der jetzigen Aufspannung wird die Maschine getroffen.</translation>
    </message>
    <message>
        <source>In the present setup the part reaches below the table.</source>
        <translation>In der jetzigen Aufspannung reicht das Werkstück unter den Tisch.</translation>
    </message>
    <message>
        <source>In the present setup the part reaches below the table: its work zero must stand at Z {least} or higher. Give another {origin}.</source>
        <translation>In der jetzigen Aufspannung reicht das Werkstück unter den Tisch: sein Nullpunkt muss bei Z {least} oder höher stehen. {origin} anders angeben.</translation>
    </message>
    <message>
        <source>In this cut {letter} takes {whole} and has {width}, but begins where that does not fit: the part turned about {letter}, or limits that lie otherwise, avoid it.</source>
        <translation>In diesem Schnitt braucht {letter} {whole} und hat {width}, beginnt aber, wo das nicht passt: das Werkstück um {letter} gedreht oder anders liegende Grenzen vermeiden das.</translation>
    </message>
    <message>
        <source>In this cut {letter} takes {whole} and has {width}: wider limits or shorter passes avoid it.</source>
        <translation>In diesem Schnitt braucht {letter} {whole} und hat {width}: weitere Grenzen oder kürzere Bahnen vermeiden das.</translation>
    </message>
    <message>
        <source>In {count} blocks F would be below one step; they run faster than programmed. Use G93.</source>
        <translation>In {count} NC-Sätzen läge F unter einem Schritt; sie laufen schneller als programmiert. G93 verwenden.</translation>
    </message>
    <message>
        <source>In {count} blocks F would exceed the controller's largest; they run slower than programmed, half of them at less than {feed}. Use G94, or give a lower feed.</source>
        <translation>In {count} NC-Sätzen würde F das größte der Steuerung überschreiten; sie laufen langsamer als programmiert, die Hälfte davon mit weniger als {feed}. G94 verwenden oder einen kleineren Vorschub angeben.</translation>
    </message>
    <message>
        <source>In {count} blocks an axis would exceed its maximum rate; they run slower than programmed, half of them at less than {feed}. For an even feed give a lower one.</source>
        <translation>In {count} NC-Sätzen würde eine Achse ihre höchste Geschwindigkeit überschreiten; sie laufen langsamer als programmiert, die Hälfte davon mit weniger als {feed}. Für einen gleichmäßigen Vorschub einen kleineren angeben.</translation>
    </message>
    <message>
        <source>In {count} blocks it is not proven that the {part} stays out of the {name}, the first in NC line {line}. Drive one group of axes after the other, or place the part otherwise on the table.</source>
        <translation>Von {count} Sätzen ist nicht bewiesen, dass {part} und {name} einander nicht treffen, der erste steht in NC-Zeile {line}. Eine Achsgruppe nach der anderen fahren oder das Teil anders auf den Tisch setzen.</translation>
    </message>
    <message>
        <source>In {count} blocks of a tilted plane the tool stands up to {lean} off its normal: nothing has turned it there, and where the control leads it then is not known. Turn the axes first (G53.1, TURN, MOVE, or their words).</source>
        <translation>In {count} Sätzen einer geschwenkten Ebene steht das Werkzeug bis zu {lean} neben ihrer Normalen: Nichts hat es dorthin gedreht, und wohin die Steuerung es dann führt, ist nicht bekannt. Zuerst die Achsen drehen (G53.1, TURN, MOVE oder ihre Wörter).</translation>
    </message>
    <message>
        <source>In {count} blocks the controller guides the tip (RTCP): that it keeps to the segment is the controller's affair, and neither measured nor proven here. Limits and rates are those of the axes that this machine file needs for it.</source>
        <translation>In {count} NC-Sätzen führt die Steuerung die Werkzeugspitze (RTCP): Dass sie auf der Strecke bleibt, ist Sache der Steuerung und hier weder gemessen noch nachgewiesen. Grenzen und Geschwindigkeiten sind die der Achsen, die diese Maschinendatei dafür braucht.</translation>
    </message>
    <message>
        <source>In {count} blocks the tool points against the normal of the frame that is turned there, as if it cut from below. Compare the signs of the rotary words with those of the machine.</source>
        <translation>In {count} NC-Sätzen zeigt das Werkzeug gegen die Normale des dort gedrehten Frames, als schnitte es von unten. Die Vorzeichen der Rundachswörter mit denen der Maschine vergleichen.</translation>
    </message>
    <message>
        <source>In {count} blocks the whole cutter is inside the fixture {fixture}. Check the work zero and the units of the fixture.</source>
        <translation>In {count} Sätzen ist der ganze Fräser im Spannmittel {fixture}. Prüfen Sie den Werkstücknullpunkt und die Einheiten des Spannmittels.</translation>
    </message>
    <message>
        <source>In {count} blocks the whole cutter is inside the part, the first at {place}. Check the work zero and the units of the part.</source>
        <translation>In {count} NC-Sätzen ist der ganze Fräser im Werkstück, zuerst bei {place}. Werkstücknullpunkt und Einheiten des Werkstücks prüfen.</translation>
    </message>
    <message>
        <source>In {count} blocks the whole cutter is inside the {name}.</source>
        <translation>In {count} Sätzen steckt der ganze Fräser in: {name}.</translation>
    </message>
    <message>
        <source>In {count} blocks the whole spindle is inside the {name}.</source>
        <translation>In {count} Sätzen ist die ganze Spindel in {name}.</translation>
    </message>
    <message>
        <source>In {count} blocks whose tip the controller guides, the first in NC line {line}, the way of the axes is not bounded closely enough: the machine's bodies were looked at where these blocks end, not in between.</source>
        <translation>In {count} Sätzen, deren Spitze die Steuerung führt, der erste in NC-Zeile {line}, ist der Weg der Achsen nicht eng genug eingegrenzt: die Körper der Maschine wurden an den Enden dieser Sätze angesehen, nicht dazwischen.</translation>
    </message>
    <message>
        <source>In {count} divided blocks the rotary axes turn evenly, because the straight swing of the tool axis would need another branch or winding; its axis deviation stays as it was. Lead the tool round the pole to avoid it.</source>
        <translation>In {count} geteilten NC-Sätzen drehen die Rundachsen gleichmäßig, weil der gerade Schwenk der Werkzeugachse einen anderen Zweig oder eine andere Windung bräuchte; die Abweichung der Achse bleibt, wie sie war. Das Werkzeug um den Pol herumführen, um das zu vermeiden.</translation>
    </message>
    <message>
        <source>In {count} links or rewinds something hits the machine, and within its travel {letter} cannot go round it.</source>
        <translation>In {count} Verbindungen oder Rückdrehungen stößt etwas an die Maschine, und in seinem Verfahrweg kommt {letter} nicht daran vorbei.</translation>
    </message>
    <message>
        <source>In {count} of these the controller guides the tip: only the end points of blocks are verified there, the path between them is under RTCP.</source>
        <translation>Bei {count} davon führt die Steuerung die Spitze: Geprüft sind dort nur die Endpunkte der NC-Sätze, der Weg dazwischen liegt unter RTCP.</translation>
    </message>
    <message>
        <source>In {count} of these the controller would have to guide the tip, which {names} cannot.</source>
        <translation>Bei {count} davon müsste die Steuerung die Spitze führen, was {names} nicht kann.</translation>
    </message>
    <message>
        <source>In {count} of {all} feed blocks the ball of {diameter} enters the part by more than {tolerance}; deepest in NC line {line}, {depth}; first NC line {first}. Are {cutter}, {origin} and the machine those of the program, does the STL stand at the work zero? Else the part is spoilt.</source>
        <translation>In {count} von {all} Vorschubsätzen dringt die Kugel von {diameter} um mehr als {tolerance} ins Werkstück ein; am tiefsten in NC-Zeile {line}, {depth}; die erste ist NC-Zeile {first}. Sind {cutter}, {origin} und die Maschine die des Programms, steht das STL am Werkstücknullpunkt? Sonst ist das Werkstück verdorben.</translation>
    </message>
    <message>
        <source>In {count} of {all} ways it is not checked whether the tool goes into the part.</source>
        <translation>Bei {count} von {all} Wegen ist nicht geprüft, ob das Werkzeug ins Werkstück geht.</translation>
    </message>
    <message>
        <source>In {count} of {all} ways more of the surface is left out than in others.</source>
        <translation>Bei {count} von {all} Wegen bleibt mehr von der Fläche ausgelassen als bei anderen.</translation>
    </message>
    <message>
        <source>In {count} of {all} ways the tool goes into the part.</source>
        <translation>Bei {count} von {all} Wegen geht das Werkzeug ins Werkstück.</translation>
    </message>
    <message>
        <source>In {count} of {all} ways the tool hits a fixture.</source>
        <translation>Auf {count} von {all} Wegen trifft das Werkzeug ein Spannmittel.</translation>
    </message>
    <message>
        <source>In {count} rapids it is not proven that the tool keeps {allowance} off the faces to avoid on every way of independent axes, the first in NC line {line}. Drive one group of axes after the other.</source>
        <translation>In {count} Eilgängen ist nicht bewiesen, dass das Werkzeug auf jedem Weg unabhängiger Achsen {allowance} von den ausgesparten Flächen wegbleibt, zuerst in NC-Zeile {line}. Fahren Sie eine Gruppe von Achsen nach der anderen.</translation>
    </message>
    <message>
        <source>In {count} rapids it is not proven that the tool stays out of the fixture {fixture} on every way of independent axes, the first in NC line {line}; it enters by no more than {bound}. Drive one group of axes after the other.</source>
        <translation>In {count} Eilgängen ist nicht bewiesen, dass das Werkzeug auf jedem Weg unabhängiger Achsen aus dem Spannmittel {fixture} bleibt, zuerst in NC-Zeile {line}; es dringt höchstens {bound} ein. Fahren Sie eine Gruppe von Achsen nach der anderen.</translation>
    </message>
    <message>
        <source>In {count} rapids it is not proven that the tool stays out of the part on every way of independent axes, the first in NC line {line}; it enters by no more than {bound}.</source>
        <translation>In {count} Eilgängen ist nicht bewiesen, dass das Werkzeug auf jedem Weg unabhängiger Achsen außerhalb des Werkstücks bleibt, zuerst in NC-Zeile {line}; tiefer als {bound} dringt es nicht ein.</translation>
    </message>
    <message>
        <source>In {count} rapids it is not proven that tool and spindle stay out of the {name} on every way of independent axes, the first in NC line {line}; they enter by no more than {bound}. Drive one group of axes after the other.</source>
        <translation>In {count} Eilgängen ist nicht bewiesen, dass Werkzeug und Spindel auf jedem Weg unabhängiger Achsen draußen bleiben aus: {name}, der erste in NC-Zeile {line}; sie dringen höchstens {bound} ein. Eine Gruppe von Achsen nach der anderen fahren.</translation>
    </message>
    <message>
        <source>In {where} the tip moves over the part more than {factor} times faster or slower than meant: at worst {feed} in NC line {line}, where {meant}. </source>
        <translation>In {where} bewegt sich die Werkzeugspitze mehr als {factor}-mal schneller oder langsamer als gewollt über das Werkstück: am schlimmsten {feed} in NC-Zeile {line}, wo {meant}. </translation>
    </message>
    <message>
        <source>Inside corners are tighter than the cutter, but the map of what is left finds nowhere more in them than may stay: twice the scallop and the tolerance.</source>
        <translation>Innenecken sind enger als der Fräser, doch die Restmaterialkarte findet in ihnen nirgends mehr, als stehen bleiben darf: das Doppelte der Kuppenhöhe und die Toleranz.</translation>
    </message>
    <message>
        <source>It cannot be clamped shorter.</source>
        <translation>Kürzer lässt es sich nicht spannen.</translation>
    </message>
    <message>
        <source>It is not proven that the {part} stays out of {name}.</source>
        <translation>{part}: nicht bewiesen ist, dass nichts eindringt in {name}.</translation>
    </message>
    <message>
        <source>It lies</source>
        <translation>Er liegt</translation>
    </message>
    <message>
        <source>JSON text</source>
        <translation>ein JSON-Text</translation>
    </message>
    <message>
        <source>Jaws {thick} thick beside the part are free in the recommended setup up to these heights, from its work zero, where the tool sticks out {length}: {sides}.</source>
        <translation>Backen von {thick} Dicke neben dem Teil sind in der empfohlenen Aufspannung bis zu diesen Höhen frei, von ihrem Werkstücknullpunkt aus, bei einer Auskragung des Werkzeugs von {length}: {sides}.</translation>
    </message>
    <message>
        <source>Jog the tool high above the part, rotary axes at 0, before the first line.</source>
        <translation>Das Werkzeug vor der ersten Zeile von Hand hoch über das Werkstück fahren, Rundachsen auf 0.</translation>
    </message>
    <message>
        <source>LBL {label} stands in no line of this program</source>
        <translation>LBL {label} steht in keiner Zeile dieses Programms</translation>
    </message>
    <message>
        <source>Least deviation: {way}, {deviation} in {time}.</source>
        <translation>Geringste Abweichung: {way}, {deviation} in {time}.</translation>
    </message>
    <message>
        <source>Left out of {name} is what is not plain: {parts}</source>
        <translation>Aus {name} weggelassen ist, was nicht schlicht ist: {parts}</translation>
    </message>
    <message>
        <source>Let the tool axis be turned past the pole ({past}; where that is on, with a larger {change}), lean the tool by a few degrees ({lead}, {tilt}), or clamp the part tilted, so that the tool keeps off the pole.</source>
        <translation>Die Werkzeugachse am Pol vorbeidrehen lassen ({past}; wo das an ist, mit größerem Wert von {change}), das Werkzeug um einige Grad neigen ({lead}, {tilt}) oder das Werkstück geneigt aufspannen, damit das Werkzeug vom Pol wegbleibt.</translation>
    </message>
    <message>
        <source>Let the tool be lifted there or leave such places out ({lift}), or use a smaller cutter; where the machine leaves the path by as much, let blocks be divided ({divide}).</source>
        <translation>Das Werkzeug dort abheben lassen oder solche Stellen auslassen ({lift}), oder einen kleineren Fräser nehmen; wo die Maschine den Weg um so viel verlässt, NC-Sätze teilen lassen ({divide}).</translation>
    </message>
    <message>
        <source>Let the tool be tilted free or leave these places out ({tilt}), use a longer tool, or more lead or tilt.</source>
        <translation>Das Werkzeug freikippen oder diese Stellen auslassen ({tilt}), ein längeres Werkzeug oder mehr Vor- oder Seitwärtsneigung verwenden.</translation>
    </message>
    <message>
        <source>Let the tool stick out {step} farther and it reaches {area} more.</source>
        <translation>Kragt das Werkzeug {step} weiter aus, erreicht es {area} mehr.</translation>
    </message>
    <message>
        <source>Let the tool stick out {step} farther and it reaches {area} of the {held} where holder or machine are in the way.</source>
        <translation>Lassen Sie das Werkzeug {step} weiter auskragen, dann erreicht es {area} von den {held}, bei denen Halter oder Maschine im Weg sind.</translation>
    </message>
    <message>
        <source>Let the tool stick out {step} farther and it reaches {area} of the {held} where holder, fixture or machine are in the way.</source>
        <translation>Lassen Sie das Werkzeug {step} weiter auskragen, dann erreicht es {area} von den {held}, bei denen Halter, Spannmittel oder Maschine im Weg sind.</translation>
    </message>
    <message>
        <source>Let the tool stick out {step} farther and it reaches {area} of the {held} where the holder is in the way.</source>
        <translation>Lassen Sie das Werkzeug {step} weiter auskragen, dann erreicht es {area} von den {held}, bei denen der Halter im Weg ist.</translation>
    </message>
    <message>
        <source>Limits{of} are left open and maximum rates are assumed (10 m/min, 10 turns a minute): no row tells them. Correct them from the machine's data sheet.</source>
        <translation>Die Grenzen{of} bleiben offen, und größte Geschwindigkeiten sind angenommen (10 m/min, 10 Umdrehungen je Minute): keine Zeile sagt sie. Nach dem Datenblatt der Maschine berichtigen.</translation>
    </message>
    <message>
        <source>Lines {first} to {last} stand before the % that begins the program, and hold moves; they are not read, as controls do not read them. If they belong to the program, put them behind the %.</source>
        <translation>Die Zeilen {first} bis {last} stehen vor dem %, mit dem das Programm beginnt, und enthalten Bewegungen; sie werden nicht gelesen, wie auch Steuerungen sie nicht lesen. Gehören sie zum Programm, hinter das % setzen.</translation>
    </message>
    <message>
        <source>Lines {first} to {last} stand before the % that begins the program; they are not read, as controls do not read them.</source>
        <translation>Die Zeilen {first} bis {last} stehen vor dem %, mit dem das Programm beginnt; sie werden nicht gelesen, wie auch Steuerungen sie nicht lesen.</translation>
    </message>
    <message>
        <source>M70 to M73 keep and restore modes</source>
        <translation>M70 bis M73 merken und stellen Zustände wieder her</translation>
    </message>
    <message>
        <source>More or less room than {gap}: tool length, work offset or {mark} are wrong. Do not go on.</source>
        <translation>Mehr oder weniger Platz als {gap}: Werkzeuglänge, Nullpunktverschiebung oder {mark} sind falsch. Nicht weitermachen.</translation>
    </message>
    <message>
        <source>Most blocks keep that feed, whatever way their axes go; look at F in the others.</source>
        <translation>Die meisten Sätze halten diesen Vorschub, wie auch immer ihre Achsen fahren; F in den anderen ansehen.</translation>
    </message>
    <message>
        <source>Most of that is blocked by {name}.</source>
        <translation>Das meiste davon versperrt {name}.</translation>
    </message>
    <message>
        <source>NC line {line} has F{feed}, and {name} takes F{most} at most under {mode}: it refuses the line. Post the program with longer blocks, or with a lower F.</source>
        <translation>NC-Zeile {line} hat F{feed}, und {name} nimmt unter {mode} höchstens F{most}: sie wird abgelehnt. Das Programm mit längeren Sätzen oder kleinerem F ausgeben.</translation>
    </message>
    <message>
        <source>NC line {line} leaves the commanded segment by {deviation}, {tolerance} allowed: {turns} within a step of {step}.</source>
        <translation>NC-Zeile {line} verlässt die Sollstrecke um {deviation}, erlaubt sind {tolerance}: {turns} innerhalb eines Schritts von {step}.</translation>
    </message>
    <message>
        <source>NC line {line}: deviation {deviation}, proven bound {bound}, {tolerance} allowed. Split it.</source>
        <translation>NC-Zeile {line}: Abweichung {deviation}, bewiesene Schranke {bound}, erlaubt sind {tolerance}. Den Satz teilen.</translation>
    </message>
    <message>
        <source>NC line {line}: {turns}. Keep the tool off the pole.</source>
        <translation>NC-Zeile {line}: {turns}. Das Werkzeug vom Pol fernhalten.</translation>
    </message>
    <message>
        <source>NOT SAFE</source>
        <translation>NICHT SICHER</translation>
    </message>
    <message>
        <source>No HAL file sets {lacking} of {module}; LinuxCNC has the values in brackets then. Is that so?</source>
        <translation>Keine HAL-Datei setzt {lacking} von {module}; bei LinuxCNC gelten dann die Werte in Klammern. Stimmt das?</translation>
    </message>
    <message>
        <source>No HAL file sets {pins} of {name}; LinuxCNC has 0 there then. Is that so?</source>
        <translation>Keine HAL-Datei setzt {pins} von {name}; LinuxCNC hat dann 0. Ist das so?</translation>
    </message>
    <message>
        <source>No cutter is given; the CL file's is taken: {cutter}.</source>
        <translation>Kein Fräser ist angegeben; der der CL-Datei wird genommen: {cutter}.</translation>
    </message>
    <message>
        <source>No cutter is given; the one that the program names is taken: {cutter}.</source>
        <translation>Kein Fräser ist angegeben; der im Programm genannte gilt: {cutter}.</translation>
    </message>
    <message>
        <source>No height frees all of them: what hits there does so as it retracts or comes down.</source>
        <translation>Keine Höhe macht alle frei: Was dort anstößt, tut es beim Abheben oder beim Anfahren.</translation>
    </message>
    <message>
        <source>No link has a collision or visual shape: the machine has no bodies that the tool must not hit.</source>
        <translation>Kein Link hat eine Kollisions- oder sichtbare Form: Die Maschine hat keine Körper, die das Werkzeug nicht treffen darf.</translation>
    </message>
    <message>
        <source>No setup of the region keeps all axes within their limits and the part on the table.</source>
        <translation>Keine Aufspannung des Bereichs hält alle Achsen in ihren Grenzen und das Werkstück auf dem Tisch.</translation>
    </message>
    <message>
        <source>No tilt that was tried frees it there. Use a longer tool or a smaller holder, or leave these places out ({leave_out}); between cuts use a larger clearance.</source>
        <translation>Keine der versuchten Neigungen macht es dort frei. Ein längeres Werkzeug oder einen kleineren Halter verwenden oder diese Stellen auslassen ({leave_out}); zwischen Schnitten einen größeren Sicherheitsabstand verwenden.</translation>
    </message>
    <message>
        <source>No tool length is active in {count} feed block, NC line {line}: the control takes the tool for one of length 0 and drives it in by its length, if work zero was not set with this tool. {remedy}</source>
        <translation>In {count} Vorschubsatz, NC-Zeile {line}, ist keine Werkzeuglänge wirksam: Die Steuerung hält das Werkzeug für 0 lang und fährt es um seine Länge ins Teil, wenn der Nullpunkt nicht mit ihm gesetzt wurde. {remedy}</translation>
    </message>
    <message>
        <source>No tool length is active in {count} feed blocks, from NC line {line} on: the control takes the tool for one of length 0 and drives it in by its length, if work zero was not set with this tool. {remedy}</source>
        <translation>In {count} Vorschubsätzen, ab NC-Zeile {line}, ist keine Werkzeuglänge wirksam: Die Steuerung hält das Werkzeug für 0 lang und fährt es um seine Länge ins Teil, wenn der Nullpunkt nicht mit ihm gesetzt wurde. {remedy}</translation>
    </message>
    <message>
        <source>No work zero of the setup region keeps the linear axes within their limits: they are exceeded by {over} at least. Widen the region ({region}), begin with a work zero that brings the part near the rotary axes ({origin}), turn the part, or take a larger machine.</source>
        <translation>Kein Nullpunkt des Aufspannbereichs hält die Linearachsen in ihren Grenzen: Sie werden um mindestens {over} überschritten. Den Bereich erweitern ({region}), mit einem Nullpunkt beginnen, der das Werkstück nahe an die Drehachsen bringt ({origin}), das Werkstück drehen oder eine größere Maschine nehmen.</translation>
    </message>
    <message>
        <source>No work zero of the setup region puts the part on the table. Move the region up ({origin}), or widen it.</source>
        <translation>Kein Werkstücknullpunkt des Bereichs stellt das Werkstück auf den Tisch. Den Bereich nach oben versetzen ({origin}) oder erweitern.</translation>
    </message>
    <message>
        <source>None of the machines can drive this path.</source>
        <translation>Keine der Maschinen kann diesen Werkzeugweg fahren.</translation>
    </message>
    <message>
        <source>Not known</source>
        <translation>Nicht bekannt</translation>
    </message>
    <message>
        <source>Nothing here holds {tolerance} within the limits of its machine and stays out of the fixtures.</source>
        <translation>Nichts hält hier {tolerance} in den Grenzen seiner Maschine ein und bleibt aus den Spannmitteln.</translation>
    </message>
    <message>
        <source>Nothing here holds {tolerance} within the limits of its machine, stays out of the part and cuts as much as the others.</source>
        <translation>Nichts davon hält {tolerance} innerhalb der Grenzen seiner Maschine, bleibt aus dem Werkstück und fräst so viel wie die anderen.</translation>
    </message>
    <message>
        <source>Nothing here holds {tolerance} within the limits of its machine.</source>
        <translation>Nichts hier hält {tolerance} innerhalb der Grenzen seiner Maschine ein.</translation>
    </message>
    <message>
        <source>Nothing is selected: click faces of {label} in the 3D view, several with Ctrl.</source>
        <translation>Nichts ist ausgewählt: in der 3D-Ansicht Flächen von {label} anklicken, mehrere mit Strg.</translation>
    </message>
    <message>
        <source>Nothing is selected: {what}.</source>
        <translation>Nichts ist ausgewählt: {what}.</translation>
    </message>
    <message>
        <source>Nothing may stand above Z {z} of the work zero: remove the part, or give {mark} as high as part and clamps reach.</source>
        <translation>Über Z {z} vom Werkstücknullpunkt darf nichts stehen: das Werkstück entfernen oder {mark} so hoch angeben, wie Werkstück und Spannmittel reichen.</translation>
    </message>
    <message>
        <source>N{number} stands in no line of this program</source>
        <translation>N{number} steht in keiner Zeile dieses Programms</translation>
    </message>
    <message>
        <source>Of the file's tools ({listed}) the moves of tool {tool} are taken: {count} of {all}.</source>
        <translation>Von den Werkzeugen der Datei ({listed}) werden die Bewegungen von Werkzeug {tool} genommen: {count} von {all}.</translation>
    </message>
    <message>
        <source>Of what is reachable, {area} are the underside on which the part stands: mill cuts it only with {max_axis_angle}.</source>
        <translation>Vom Erreichbaren sind {area} die Unterseite, auf der das Werkstück steht: Gefräst wird sie nur mit {max_axis_angle}.</translation>
    </message>
    <message>
        <source>Of {whole} that are machined, all are cut: no more than {allowed} is left, nothing is cut too deep.</source>
        <translation>Von {whole} bearbeiteter Fläche ist alles gefräst: nicht mehr als {allowed} bleibt stehen, nichts ist zu tief.</translation>
    </message>
    <message>
        <source>Of {whole} that are machined, {parts}.</source>
        <translation>Von {whole} bearbeiteter Fläche: {parts}.</translation>
    </message>
    <message>
        <source>On about {area} of what is reachable the tool cannot be drawn out along any axis tried: mill leaves out passes that lead nowhere else.</source>
        <translation>Auf etwa {area} des Erreichbaren lässt sich das Werkzeug entlang keiner probierten Achse herausziehen: Bahnen, die von dort nicht weiterführen, werden beim Fräsen ausgelassen.</translation>
    </message>
    <message>
        <source>On steep walls passes stand no closer than the least interval, and between them alone up to {estimate} would stay. Other passes cut there: the map of what is left finds at most {height} anywhere.</source>
        <translation>An steilen Wänden stehen Bahnen nicht enger als der kleinste Abstand, und zwischen ihnen allein bliebe bis zu {estimate} stehen. Dort schneiden andere Bahnen: Die Karte des Restmaterials findet nirgends mehr als {height}.</translation>
    </message>
    <message>
        <source>On steep walls {count} of the passes stand no closer than {least}: material up to {height} high stays between them where scallops of {scallop} are asked. Give a smaller {option}, or turn the passes along the walls.</source>
        <translation>An steilen Wänden stehen {count} Bahnen nicht enger als {least}: zwischen ihnen bleibt Material bis {height} hoch stehen, wo Kuppen von {scallop} verlangt sind. {option} kleiner angeben oder die Bahnen längs der Wände drehen.</translation>
    </message>
    <message>
        <source>On steep walls {count} of the passes stand no closer than {least}: scallops up to {height} stay where {scallop} are asked. Give a smaller {option}, or turn the passes along the walls.</source>
        <translation>An steilen Wänden stehen {count} Bahnen nicht enger als {least}: Kuppen bis {height} bleiben stehen, wo {scallop} verlangt sind. {option} kleiner angeben oder die Bahnen längs der Wände drehen.</translation>
    </message>
    <message>
        <source>On {area} of the machined surface more than {above} is left, most at {place}: {height}; {volume} in all. Cut these places with a smaller cutter or another tool axis.</source>
        <translation>Auf {area} der bearbeiteten Fläche bleibt mehr als {above} Restmaterial stehen, am meisten bei {place}: {height}; insgesamt {volume}. Diese Stellen mit einem kleineren Fräser oder anderer Werkzeugachse fräsen.</translation>
    </message>
    <message>
        <source>On {area} of the machined surface more than {above} is left, most at {place}: {height}; {volume} in all. Most of that is what no pass touches: whatever the cutter, cut it with other passes.</source>
        <translation>Auf {area} der bearbeiteten Fläche bleibt mehr als {above} Restmaterial stehen, am meisten bei {place}: {height}; insgesamt {volume}. Das meiste davon berührt keine Bahn: mit anderen Bahnen fräsen, gleich mit welchem Fräser.</translation>
    </message>
    <message>
        <source>On {area} of the machined surface more than {tolerance} is cut too deep, most at {place}: {height}; {volume} in all. Let the tool be lifted there ({lift}), or use a smaller cutter.</source>
        <translation>Auf {area} der bearbeiteten Fläche wird um mehr als {tolerance} zu tief gefräst, am meisten bei {place}: {height}; insgesamt {volume}. Das Werkzeug dort abheben lassen ({lift}) oder einen kleineren Fräser nehmen.</translation>
    </message>
    <message>
        <source>On {length} of the passes, the first at {place}, the tool is free, but the part is over it, and it cannot get out along its axis; they are left out. Turn the part or, where it is the holder that is held, use a smaller holder.</source>
        <translation>Auf {length} der Bahnen, zuerst bei {place}, ist das Werkzeug frei, aber das Werkstück ist über ihm, und es kommt entlang seiner Achse nicht heraus; sie sind ausgelassen. Das Werkstück drehen oder, wo der Halter anstößt, einen kleineren Halter nehmen.</translation>
    </message>
    <message>
        <source>On {length} of the passes, the first at {place}, the tool is free, but the part is over it, and it cannot get out along its axis; they are left out. Turn the part, or cut this side in another setup.</source>
        <translation>Auf {length} der Bahnen, zuerst bei {place}, ist das Werkzeug frei, aber das Werkstück ist über ihm, und es kommt entlang seiner Achse nicht heraus; sie sind ausgelassen. Das Werkstück drehen oder diese Seite in einer anderen Aufspannung bearbeiten.</translation>
    </message>
    <message>
        <source>On {machine} with correction {cure} the path cannot be driven: {problem}</source>
        <translation>Auf {machine} mit Korrektur {cure} kann der Werkzeugweg nicht gefahren werden: {problem}</translation>
    </message>
    <message>
        <source>On {machine} with correction {cure}: {what}</source>
        <translation>Auf {machine} mit Korrektur {cure}: {what}</translation>
    </message>
    <message>
        <source>On {machine}: {what}</source>
        <translation>Auf {machine}: {what}</translation>
    </message>
    <message>
        <source>Once the tool retracts between two cuts and {letter} turns back above the part, within its limits: that takes time and leaves no mark.</source>
        <translation>Einmal hebt das Werkzeug zwischen zwei Schnitten ab, und {letter} dreht über dem Werkstück zurück, um in seinen Grenzen zu bleiben: Das kostet Zeit und hinterlässt keine Spur.</translation>
    </message>
    <message>
        <source>One shape of {name} moves with the tool's length; it is taken for the tool, not for a body.</source>
        <translation>Eine Form aus {name} bewegt sich mit der Werkzeuglänge; sie gilt als Werkzeug, nicht als Körper.</translation>
    </message>
    <message>
        <source>Only {letter} moves: the table goes {wrong} by {travel}; the tool, seen from the part, goes {right}.</source>
        <translation>Nur {letter} fährt: der Tisch geht {travel} {wrong}; das Werkzeug geht, vom Werkstück aus gesehen, {right}.</translation>
    </message>
    <message>
        <source>Only {letter} moves: the tool goes {right} by {travel}, the table rests.</source>
        <translation>Nur {letter} fährt: das Werkzeug geht {travel} {right}, der Tisch steht.</translation>
    </message>
    <message>
        <source>Only {letter} turns: the {what} turns {right} by {degrees}, seen {view}; {mark}.</source>
        <translation>Nur {letter} dreht: {what} dreht {right} um {degrees}, {view} gesehen; {mark}.</translation>
    </message>
    <message>
        <source>Over {length} of the passes no tilt of up to {most} keeps shank and holder out of the part, the deepest entry at {place}. Allow more tilt ({max_tilt}), use a longer tool, or leave these places out.</source>
        <translation>Auf {length} der Bahnen hält keine Neigung bis {most} Schaft und Halter aus dem Werkstück, am tiefsten bei {place}. Mehr Neigung erlauben ({max_tilt}), ein längeres Werkzeug nehmen oder diese Stellen auslassen.</translation>
    </message>
    <message>
        <source>Over {length} of the passes, the first at {place}, the barrel touches with the ball of {corner} at its tip, not with its flank, and scallops are as high as that ball leaves them. Let the axis lean by {begins} to {most} from the normal, as with {tilt} {middle}.</source>
        <translation>Auf {length} der Bahnen, zuerst bei {place}, berührt der Tonnenfräser mit der Kugel von {corner} an seiner Spitze, nicht mit seiner Flanke, und die Kuppen werden so hoch, wie diese Kugel sie lässt. Die Achse um {begins} bis {most} zur Flächennormalen neigen, etwa mit {tilt} {middle}.</translation>
    </message>
    <message>
        <source>P1 turns about more than one axis, and in which order is not known here</source>
        <translation>P1 dreht um mehr als eine Achse, und in welcher Reihenfolge, ist hier nicht bekannt</translation>
    </message>
    <message>
        <source>Passes are only {step} apart, because the cutter touches with its edge where the surface is aslant to its axis; a ball of its diameter would take {ball}. Use a ball or a bull nose cutter, or a tool axis that follows the surface.</source>
        <translation>Die Bahnen liegen nur {step} auseinander, weil der Fräser mit seiner Kante berührt, wo die Fläche schräg zu seiner Achse liegt; eine Kugel seines Durchmessers käme mit {ball} aus. Einen Kugel- oder Torusfräser nehmen oder eine Werkzeugachse, die der Fläche folgt.</translation>
    </message>
    <message>
        <source>Passes are {stepover} apart and the cutter is {width} wide: strips between them stay uncut. Give a smaller {option}, or the {scallop} that may stay.</source>
        <translation>Die Bahnen liegen {stepover} auseinander, der Fräser ist {width} breit: Die Streifen dazwischen bleiben stehen. Mit {option} einen kleineren Abstand angeben oder mit {scallop}, wie viel stehen bleiben darf.</translation>
    </message>
    <message>
        <source>Passes leave more than {scallop} where they turn in corners or end at edges: on at least {area}, {percent} % of what is cut, most at {place}: {height}. The map of what is left ({left}) measures the program itself. A smaller {option} leaves less there.</source>
        <translation>Wo Bahnen in Ecken umlenken oder an Kanten enden, lassen sie mehr als {scallop} stehen: auf mindestens {area}, {percent} % der zu fräsenden Fläche, am meisten bei {place}: {height}. Die Restmaterialkarte ({left}) misst das Programm selbst. Eine kleinere Angabe für {option} lässt dort weniger stehen.</translation>
    </message>
    <message>
        <source>Passes touch none of {count} facets of {area} that are to be cut: they lie along the passes or between two of them. Choose other passes, or a smaller stepover or scallop, for those.</source>
        <translation>Bahnen berühren keine der {count} Facetten von {area}, die zu fräsen sind: Sie liegen längs der Bahnen oder zwischen zweien. Für diese andere Bahnen wählen, oder einen kleineren Bahnabstand oder eine kleinere Rauhöhe.</translation>
    </message>
    <message>
        <source>Place the part otherwise on the table, or lean the tool less, so that the axes need not go there.</source>
        <translation>Das Teil anders auf den Tisch setzen oder das Werkzeug weniger neigen, damit die Achsen nicht dorthin müssen.</translation>
    </message>
    <message>
        <source>Positive {letter} words turn the tool, seen from the work, left-handed about {plus}, against ISO 841; the direction in the file is reversed accordingly.</source>
        <translation>Positive {letter}-Wörter drehen das Werkzeug, vom Werkstück aus gesehen, linksherum um {plus}, entgegen ISO 841; die Richtung in der Datei ist entsprechend umgekehrt.</translation>
    </message>
    <message>
        <source>Post it again for this machine</source>
        <translation>Für diese Maschine neu ausgeben</translation>
    </message>
    <message>
        <source>Proven</source>
        <translation>Bewiesen</translation>
    </message>
    <message>
        <source>RTP, RFP and its depth do not lie one below the other</source>
        <translation>RTP, RFP und seine Tiefe liegen nicht untereinander</translation>
    </message>
    <message>
        <source>Reachable is where the tool can stand; whether it gets there and away again is not asked.</source>
        <translation>Erreichbar ist, wo das Werkzeug stehen kann; ob es dorthin und wieder weg kommt, wird nicht gefragt.</translation>
    </message>
    <message>
        <source>Right is +X of the machine, back is +Y (away from you), up is +Z. If your machine's axes point elsewhere, stand so that they do.</source>
        <translation>Rechts ist +X der Maschine, hinten ist +Y (von Ihnen weg), oben ist +Z. Zeigen die Achsen Ihrer Maschine anders, so hinstellen, dass es stimmt.</translation>
    </message>
    <message>
        <source>SAFE</source>
        <translation>SICHER</translation>
    </message>
    <message>
        <source>SEQ asks for a way that lies beyond the limits</source>
        <translation>SEQ verlangt eine Stellung jenseits der Grenzen</translation>
    </message>
    <message>
        <source>STL file {path} cannot be read: {strerror}; check its name, its folder and your right to read it</source>
        <translation>STL-Datei {path} kann nicht gelesen werden: {strerror}; Namen, Ordner und Leserecht prüfen</translation>
    </message>
    <message>
        <source>Shorter blocks help: half the length leaves about a quarter of the deviation; {linearize} makes as many as are needed.</source>
        <translation>Kürzere Sätze helfen: halbe Länge lässt etwa ein Viertel der Abweichung; {linearize} macht so viele, wie nötig sind.</translation>
    </message>
    <message>
        <source>Shorter by {step}: {met}</source>
        <translation>Um {step} kürzer: {met}</translation>
    </message>
    <message>
        <source>Sliders of the screen set pins of {module}; taken is what they start with: {taken}. Is that so on your machine?</source>
        <translation>Schieberegler des Bildschirms setzen Pins von {module}; genommen sind ihre Anfangswerte: {taken}. Ist das an Ihrer Maschine so?</translation>
    </message>
    <message>
        <source>Spindle off and locked; no cutter that can hurt: a pointed rod of the tool's length.</source>
        <translation>Spindel aus und gesperrt; kein Fräser, der verletzen kann: ein spitzer Stab von der Länge des Werkzeugs.</translation>
    </message>
    <message>
        <source>Split it, or keep the tool off the pole.</source>
        <translation>Den Satz teilen oder das Werkzeug vom Pol fernhalten.</translation>
    </message>
    <message>
        <source>Split it.</source>
        <translation>Den Satz teilen.</translation>
    </message>
    <message>
        <source>Stand {place}: largest deviation {whose} {deviation} instead of {now}, {times} times less.</source>
        <translation>Aufstellen: {place}. Größte Abweichung {whose} {deviation} statt {now}, {times}-mal weniger.</translation>
    </message>
    <message>
        <source>Stand {place}: largest deviation {whose} {deviation}, as good as {now} in the present setup, which {why}.</source>
        <translation>Aufstellen: {place}. Größte Abweichung {whose} {deviation}, so gut wie {now} in der jetzigen Aufspannung, die {why}.</translation>
    </message>
    <message>
        <source>Stand {place}: largest deviation {whose} {deviation}.</source>
        <translation>Aufstellen: {place}. Größte Abweichung {whose} {deviation}.</translation>
    </message>
    <message>
        <source>Subprograms are not interpreted, because of this line: {reason}. Post one program without them.</source>
        <translation>Unterprogramme werden wegen dieser Zeile nicht ausgewertet: {reason}. Ein Programm ohne sie ausgeben.</translation>
    </message>
    <message>
        <source>Taken of {name}: the axes {letters}; the gauge point {gauge} mm, the origin of {tool}; the usual work zero {zero} mm, that of {table}. Neither controller nor height of the table's face is known. Correct what is otherwise in the machine file.</source>
        <translation>Angenommen von {name}: die Achsen {letters}; der Bezugspunkt der Werkzeuge {gauge} mm, der Ursprung von {tool}; der übliche Werkstücknullpunkt {zero} mm, der von {table}. Weder Steuerung noch Höhe der Tischfläche sind bekannt. Berichtigen Sie in der Maschinendatei, was anders ist.</translation>
    </message>
    <message>
        <source>The CL file does not say its unit; mm is taken, but line {line} says {statement}, as files in inches do. Give {option}, mm or inch.</source>
        <translation>Die CL-Datei nennt ihre Einheit nicht; mm wird angenommen, aber in Zeile {line} steht {statement}, wie in Dateien in Zoll. {option} angeben, mm oder inch.</translation>
    </message>
    <message>
        <source>The CL file is for a cutter of {diameter}, retracts are laid out for {given}; give {cutter}.</source>
        <translation>Die CL-Datei ist für einen Fräser von {diameter}, die Rückzüge sind für {given} ausgelegt; {cutter} angeben.</translation>
    </message>
    <message>
        <source>The CL file is for a {named}, retracts are laid out for a {given}; give {cutter}.</source>
        <translation>Die CL-Datei ist für {named}, die Rückzüge sind für {given} ausgelegt; {cutter} angeben.</translation>
    </message>
    <message>
        <source>The CL path starts with a feed move; the program reaches its first position in rapid. Start it above the part.</source>
        <translation>Der CL-Weg beginnt mit einer Vorschubbewegung; das Programm fährt seinen ersten Ort im Eilgang an. Über dem Werkstück beginnen.</translation>
    </message>
    <message>
        <source>The axes leave their limits by {over}.</source>
        <translation>Die Achsen verlassen ihre Grenzen um {over}.</translation>
    </message>
    <message>
        <source>The body {name} of the machine is {size} long: its file may be in metres ({metres}) or inches ({inches}), or scaled too often. Files of bodies are read in mm: export it so.</source>
        <translation>Der Körper {name} der Maschine ist {size} lang: Seine Datei ist vielleicht in Metern ({metres}) oder Zoll ({inches}), oder zu oft skaliert. Dateien von Körpern werden in mm gelesen: so exportieren.</translation>
    </message>
    <message>
        <source>The controller guides the tip (RTCP). Proven is that every block ends within {off} of the path's tip and {lean} of its tool axis, as the machine file describes the machine; how tip and axes go from end to end is the controller's affair, and not proven here.</source>
        <translation>Die Steuerung führt die Werkzeugspitze (RTCP). Nachgewiesen ist, dass jeder Satz innerhalb {off} an der Spitze des Werkzeugwegs und innerhalb {lean} an seiner Werkzeugachse endet, so wie die Maschinendatei die Maschine beschreibt; wie Spitze und Achsen von Ende zu Ende gehen, ist Sache der Steuerung und hier nicht nachgewiesen.</translation>
    </message>
    <message>
        <source>The cutter goes {depth} into the part at {at} on its way between passes. Use a larger clearance; where the part is over the tool, let it be lifted there or leave such places out ({lift}).</source>
        <translation>Der Fräser dringt auf dem Weg zwischen den Bahnen bei {at} {depth} ins Werkstück ein. Den Sicherheitsabstand vergrößern; wo das Werkstück über dem Werkzeug ist, es dort abheben lassen oder solche Stellen auslassen ({lift}).</translation>
    </message>
    <message>
        <source>The cutter goes {depth} into the part at {at}, not cutting.</source>
        <translation>Der Fräser dringt bei {at} {depth} ins Werkstück ein, ohne zu schneiden.</translation>
    </message>
    <message>
        <source>The cutter goes {depth} too deep into the part at {at}.</source>
        <translation>Der Fräser dringt bei {at} {depth} zu tief ins Werkstück ein.</translation>
    </message>
    <message>
        <source>The cycle G{code} is not written out, and its moves are missing: {reason}. Correct it, or post straight moves.</source>
        <translation>Der Zyklus G{code} wird nicht ausgeschrieben, seine Bewegungen fehlen: {reason}. Ihn berichtigen oder gerade Bewegungen ausgeben.</translation>
    </message>
    <message>
        <source>The cycle G{code} is not written out, and the moves of its {count} holes are missing: {reason}. Correct it, or post straight moves.</source>
        <translation>Der Zyklus G{code} wird nicht ausgeschrieben, und die Bewegungen seiner {count} Bohrungen fehlen: {reason}. Berichtigen oder gerade Bewegungen ausgeben.</translation>
    </message>
    <message>
        <source>The display shows {place}. The tool stands upright, the table level. Nothing is near the tool.</source>
        <translation>Die Anzeige zeigt {place}. Das Werkzeug steht senkrecht, der Tisch waagrecht. Nichts ist nahe am Werkzeug.</translation>
    </message>
    <message>
        <source>The ends of an arc are as near as the printed digits allow (line {line}): it may be a whole turn or next to nothing; {taken} is taken, as its direction says.</source>
        <translation>Die Enden eines Kreisbogens sind so nahe, wie die gedruckten Stellen es zulassen (Zeile {line}): Er kann ein voller Kreis oder fast nichts sein; {taken} wird genommen, wie seine Richtung sagt.</translation>
    </message>
    <message>
        <source>The ends of {count} arcs are as near as the printed digits allow (first line {line}): they may be whole turns or next to nothing; there {taken} is taken, as its direction says.</source>
        <translation>Die Enden von {count} Kreisbögen sind so nahe, wie die gedruckten Stellen es zulassen (zuerst Zeile {line}): Sie können volle Kreise oder fast nichts sein; dort wird {taken} genommen, wie die Richtung sagt.</translation>
    </message>
    <message>
        <source>The file changes tools ({listed}), the program does not: it cuts all of it with one. Write one file for each tool, or choose one: {option}.</source>
        <translation>Die Datei wechselt das Werkzeug ({listed}), das Programm nicht: Es fräst alles mit einem. Eine Datei je Werkzeug schreiben, oder eines wählen: {option}.</translation>
    </message>
    <message>
        <source>The file ends in control characters; they are passed over.</source>
        <translation>Die Datei endet mit Steuerzeichen; sie werden übergangen.</translation>
    </message>
    <message>
        <source>The file is of an older layout, which does not say what carries what; taken: X and Y move the table, Z the head. Limits are those beside each axis.</source>
        <translation>Die Datei hat eine ältere Form, die nicht sagt, was was trägt; angenommen: X und Y bewegen den Tisch, Z den Kopf. Grenzen sind die, die bei jeder Achse stehen.</translation>
    </message>
    <message>
        <source>The file's base frame is shifted or turned and is not used; write the axes in the machine's own frame.</source>
        <translation>Das Grundsystem der Datei ist verschoben oder gedreht und wird nicht verwendet; die Achsen im System der Maschine selbst angeben.</translation>
    </message>
    <message>
        <source>The first motion line does not say where {unknown} stand; they are taken as 0 there.</source>
        <translation>Die erste Bewegungszeile sagt nicht, wo {unknown} stehen; sie werden dort als 0 genommen.</translation>
    </message>
    <message>
        <source>The fixture {fixture} stands in the part, more than {depth} deep at {at}: check its place and its units first. What else is told of it is told of that place.</source>
        <translation>Das Spannmittel {fixture} steht im Werkstück, bei {at} mehr als {depth} tief: zuerst seinen Platz und seine Einheit prüfen. Was sonst von ihm gesagt wird, gilt für diesen Platz.</translation>
    </message>
    <message>
        <source>The fixture {fixture} stands in {body}, a body of the machine, at least {depth} deep at {at}. Check the work zero on the machine ({zero}), the fixture's place and its units, or mend the body.</source>
        <translation>Das Spannmittel {fixture} steckt in {body}, einem Körper der Maschine, mindestens {depth} tief bei {at}. Den Nullpunkt auf der Maschine ({zero}), den Ort des Spannmittels und seine Einheiten prüfen, oder den Körper berichtigen.</translation>
    </message>
    <message>
        <source>The fixture {name} is {size} long: its file may be in metres ({metres}) or inches ({inches}), or scaled too often. Export it in mm, or name the units of STL files: {option}.</source>
        <translation>Das Spannmittel {name} ist {size} lang: Seine Datei ist vielleicht in Metern ({metres}) oder Zoll ({inches}), oder zu oft skaliert. In mm exportieren oder die Einheit der STL-Dateien nennen: {option}.</translation>
    </message>
    <message>
        <source>The flank of the tapered cutter leans into the part over {length} of the passes, the first at {at}; they are left out. Choose another tool axis, lead or tilt, or a cutter of less taper.</source>
        <translation>Die Flanke des Kegelfräsers neigt sich auf {length} der Bahnen ins Werkstück, zuerst bei {at}; sie sind ausgelassen. Eine andere Werkzeugachse, Voreil- oder Seitwinkel oder einen Fräser mit weniger Kegel wählen.</translation>
    </message>
    <message>
        <source>The height of the table is not known: check that the part stands on it, or give {table_height}.</source>
        <translation>Die Höhe des Tisches ist nicht bekannt: prüfen, dass das Werkstück auf ihm steht, oder {table_height} angeben.</translation>
    </message>
    <message>
        <source>The height of the table is not known: check that the part stands on it.</source>
        <translation>Die Höhe des Tisches ist nicht bekannt: prüfen, dass das Werkstück auf ihm steht.</translation>
    </message>
    <message>
        <source>The joint axes are taken as the way the tool moves relative to the work (ISO 841). Prove the signs before cutting.</source>
        <translation>Die Achsen werden so genommen, wie sich das Werkzeug relativ zum Werkstück bewegt (ISO 841). Vor dem Fräsen die Vorzeichen prüfen.</translation>
    </message>
    <message>
        <source>The length of H{number} is active with tool T{tool} in {count} feed block, NC line {line}. Give G43 H{tool} after the M6, or see that row {number} of the table holds the length of T{tool}.</source>
        <translation>In {count} Vorschubsatz, NC-Zeile {line}, ist die Länge von H{number} mit Werkzeug T{tool} wirksam. Nach dem M6 G43 H{tool} angeben, oder prüfen, dass Zeile {number} der Tabelle die Länge von T{tool} enthält.</translation>
    </message>
    <message>
        <source>The length of H{number} is active with tool T{tool} in {count} feed blocks, from NC line {line} on. Give G43 H{tool} after the M6, or see that row {number} of the table holds the length of T{tool}.</source>
        <translation>In {count} Vorschubsätzen, ab NC-Zeile {line}, ist die Länge von H{number} mit Werkzeug T{tool} wirksam. Nach dem M6 G43 H{tool} angeben, oder prüfen, dass Zeile {number} der Tabelle die Länge von T{tool} enthält.</translation>
    </message>
    <message>
        <source>The lines after the end of the program in line {last} are not read.</source>
        <translation>Die Zeilen nach dem Programmende in Zeile {last} werden nicht gelesen.</translation>
    </message>
    <message>
        <source>The lines with variables, expressions or jumps are not interpreted, because of this one: {reason}. Their words are missing here; post without them.</source>
        <translation>Die Zeilen mit Variablen, Ausdrücken oder Sprüngen werden wegen dieser nicht ausgewertet: {reason}. Ihre Wörter fehlen hier; ohne sie ausgeben.</translation>
    </message>
    <message>
        <source>The machine cannot take the tool along the path.</source>
        <translation>Die Maschine kann das Werkzeug nicht die Bahn entlang führen.</translation>
    </message>
    <message>
        <source>The machine has no axis {letter}: its {count} words are left out. Choose the program's own machine.</source>
        <translation>Die Maschine hat keine Achse {letter}: deren {count} Wörter sind ausgelassen. Die Maschine des Programms wählen.</translation>
    </message>
    <message>
        <source>The machine that the post had in mind is {kind}, {name} is {own}.</source>
        <translation>Die Maschine, die der Postprozessor meinte, ist {kind}, {name} ist {own}.</translation>
    </message>
    <message>
        <source>The mesh of {label} was deleted: undo that, or choose another one in its property Mesh.</source>
        <translation>Das Netz von {label} wurde gelöscht: das rückgängig machen oder in der Eigenschaft Netz ein anderes wählen.</translation>
    </message>
    <message>
        <source>The model of So et al. finds no farthest point in {rootless} of {blocks} blocks and takes the middle there; use the exact line deviation.</source>
        <translation>Das Modell von So et al. findet in {rootless} von {blocks} NC-Sätzen keinen fernsten Punkt und nimmt dort die Mitte; die exakte Abweichung von der Geraden verwenden.</translation>
    </message>
    <message>
        <source>The part is cut in {count} frames, each with a tool axis of its own: {axes}.</source>
        <translation>Das Teil wird in {count} Anstellungen geschnitten, jede mit eigener Werkzeugachse: {axes}.</translation>
    </message>
    <message>
        <source>The part is not known here: watch that move.</source>
        <translation>Das Werkstück ist hier nicht bekannt: diese Bewegung beobachten.</translation>
    </message>
    <message>
        <source>The part reaches {depth} below the table of {machine}, so its place is not known and no tool axis leans below level. Give {origin} the place of the work zero, or {max_axis_angle} how far axes may lean.</source>
        <translation>Das Teil reicht {depth} unter den Tisch von {machine}; sein Ort ist also nicht bekannt, und keine Werkzeugachse neigt sich unter die Waagrechte. Mit {origin} den Ort des Nullpunkts angeben, oder mit {max_axis_angle}, wie weit sich Achsen neigen dürfen.</translation>
    </message>
    <message>
        <source>The part stands in {body}, a body of the machine, at least {depth} deep at {at}. Check the work zero on the machine ({zero}), or mend the body.</source>
        <translation>Das Werkstück steckt in {body}, einem Körper der Maschine, mindestens {depth} tief bei {at}. Den Nullpunkt auf der Maschine ({zero}) prüfen oder den Körper berichtigen.</translation>
    </message>
    <message>
        <source>The part that {label} was made of was deleted: undo that, or choose another one in its property Base</source>
        <translation>Das Werkstück, aus dem {label} entstand, wurde gelöscht: das rückgängig machen oder in der Eigenschaft Basis ein anderes wählen</translation>
    </message>
    <message>
        <source>The part was deleted: undo that, or choose another one in the property Base.</source>
        <translation>Das Werkstück wurde gelöscht: das rückgängig machen oder in der Eigenschaft Basis ein anderes wählen.</translation>
    </message>
    <message>
        <source>The part's lowest place is then {height} above the table.</source>
        <translation>Die tiefste Stelle des Werkstücks ist dann {height} über dem Tisch.</translation>
    </message>
    <message>
        <source>The part's lowest place would be {depth} below the table: the table is not looked at. Give the work zero with {origin}, or the table's height with {table_height}.</source>
        <translation>Die tiefste Stelle des Teils läge {depth} unter dem Tisch: Der Tisch wird nicht beachtet. Geben Sie den Werkstücknullpunkt mit {origin} an oder die Höhe des Tischs mit {table_height}.</translation>
    </message>
    <message>
        <source>The passes end at boundary {name}: {left} of {whole} lie inside.</source>
        <translation>Die Bahnen enden an der Begrenzung {name}: {left} von {whole} liegen innerhalb.</translation>
    </message>
    <message>
        <source>The path itself is free of the part there, but the machine leaves it between the ends of blocks: {way}.</source>
        <translation>Der Werkzeugweg selbst ist dort frei vom Werkstück, aber die Maschine verlässt ihn zwischen den Enden der NC-Sätze: {way}.</translation>
    </message>
    <message>
        <source>The path of {label} was deleted: choose another one in its property Path.</source>
        <translation>Der Werkzeugweg von {label} wurde gelöscht: in der Eigenschaft Werkzeugweg einen anderen wählen.</translation>
    </message>
    <message>
        <source>The plane above the part at which the rotary axes turn lies at Z {height}, beyond the limit {limit}, and the first or the last place of the path too: the program begins and ends at Z {reached}. Move the work zero ({origin}) so that Z reaches the part.</source>
        <translation>Die Ebene über dem Werkstück, auf der die Drehachsen drehen, liegt bei Z {height}, jenseits der Grenze {limit}, und die erste oder letzte Stelle der Bahn auch: Das Programm beginnt und endet bei Z {reached}. Den Nullpunkt so verschieben ({origin}), dass Z das Werkstück erreicht.</translation>
    </message>
    <message>
        <source>The plane above the part at which the rotary axes turn lies at Z {height}, beyond the limit {limit}: the program begins and ends at that limit. Watch the first moves, or set the machine file's safe_start to machine or reference.</source>
        <translation>Die Ebene über dem Werkstück, auf der die Rundachsen drehen, liegt bei Z {height}, jenseits der Grenze {limit}: das Programm beginnt und endet an dieser Grenze. Die ersten Bewegungen beobachten oder safe_start der Maschinendatei auf machine oder reference setzen.</translation>
    </message>
    <message>
        <source>The post had in mind: {layout}. It explains {count} of {all} rows within {worst}.</source>
        <translation>Der Postprozessor meinte: {layout}. Das erklärt {count} von {all} Zeilen auf {worst} genau.</translation>
    </message>
    <message>
        <source>The present setup is as good as any of the region: largest deviation {whose} {deviation}.</source>
        <translation>Die jetzige Aufspannung ist so gut wie jede des Bereichs: größte Abweichung {whose} {deviation}.</translation>
    </message>
    <message>
        <source>The program begins and ends at Z {height}. Only from Z {need} on are tool and spindle above what the axes carry, wherever these stand before: {names}.</source>
        <translation>Das Programm beginnt und endet auf Z {height}. Erst ab Z {need} sind Werkzeug und Spindel über dem, was die Achsen tragen, wo immer diese vorher stehen: {names}.</translation>
    </message>
    <message>
        <source>The program counts {name} from {value} (within {certainty}), not from the CL path's zero. A machine file cannot hold that: correct {what}, or the post.</source>
        <translation>Das Programm zählt {name} von {value} (auf {certainty} genau), nicht vom Nullpunkt des CL-Wegs. Eine Maschinendatei kann das nicht festhalten: {what} oder den Postprozessor berichtigen.</translation>
    </message>
    <message>
        <source>The program goes over {size} where {name} goes over {other}, {times} times: one of them is read in inches and means mm, or the other way round. Give {option} where the file does not say its unit, else set right what it says.</source>
        <translation>Das Programm reicht über {size}, {name} über {other}, {times}-fach: Eines von beiden wird in Zoll gelesen und meint mm, oder umgekehrt. {option} angeben, wo die Datei ihre Einheit nicht nennt, sonst richtigstellen, was sie nennt.</translation>
    </message>
    <message>
        <source>The program has no end: give {word} in its last line.</source>
        <translation>Das Programm hat kein Ende: in der letzten Zeile {word} angeben.</translation>
    </message>
    <message>
        <source>The program has rotary words {letters}, {name} has {own}.</source>
        <translation>Das Programm hat die Rundachsen {letters}, {name} hat {own}.</translation>
    </message>
    <message>
        <source>The program retracts to Z {position} of the machine, which by machine file, work zero and tool length is Z {height} of the program, below the place at Z {place} where it begins or ends: the retract goes down, in rapid. Give safe_start of the machine file a higher Z, or say where the part stands ({origin}).</source>
        <translation>Das Programm zieht auf Z {position} der Maschine zurück. Nach Maschinendatei, Nullpunkt und Werkzeuglänge ist das Z {height} des Programms, unter der Stelle bei Z {place}, wo es beginnt oder endet: Der Rückzug geht nach unten, im Eilgang. safe_start der Maschinendatei ein höheres Z geben oder sagen, wo das Werkstück steht ({origin}).</translation>
    </message>
    <message>
        <source>The program retracts to the machine position of safe_start, where Z would be {height}, beyond its limit {limit}. Give safe_start of the machine file another Z, or correct the limits of Z.</source>
        <translation>Das Programm fährt zur Maschinenposition von safe_start frei, wo Z auf {height} stünde, jenseits seiner Grenze {limit}. Geben Sie safe_start in der Maschinendatei ein anderes Z, oder berichtigen Sie die Grenzen von Z.</translation>
    </message>
    <message>
        <source>The program says inches, and by that {letter} goes over {goes}, where the machine has {has}: its numbers seem to be mm ({mm}). Set right what the program says of its unit.</source>
        <translation>Das Programm nennt Zoll, und danach geht {letter} über {goes}, wo die Maschine {has} hat: Seine Zahlen scheinen mm zu sein ({mm}). Richtigstellen, was das Programm zu seiner Einheit sagt.</translation>
    </message>
    <message>
        <source>The program says {units}; taken as mm, but its size ({size}) and F (up to {feed}) are rather those of inches. Give {option}, mm or inch.</source>
        <translation>Das Programm nennt {units}; es wird in mm gelesen, doch Größe ({size}) und F (bis {feed}) sprechen eher für Zoll. {option} angeben, mm oder inch.</translation>
    </message>
    <message>
        <source>The program says {units}; taken as mm: it then moves {size} mm at most, at F up to {feed}. Give {option}, mm or inch.</source>
        <translation>Das Programm nennt {units}; es wird in mm gelesen und fährt dann höchstens {size} mm, mit F bis {feed}. {option} angeben, mm oder inch.</translation>
    </message>
    <message>
        <source>The program says {units}; taken as mm: it then moves {size} mm at most. No F is per minute (G93 and G95 are not), so none tells which unit is meant. Give {option}, mm or inch.</source>
        <translation>Das Programm nennt {units}; es wird in mm gelesen und fährt dann höchstens {size} mm. Kein F gilt je Minute (unter G93 und G95 nicht), darum verrät keines die Einheit. {option} angeben, mm oder inch.</translation>
    </message>
    <message>
        <source>The program uses {count} work offsets: {names} (with their first lines). Their distance is not known, and the blocks between are not right. Audit each part on its own.</source>
        <translation>Das Programm verwendet {count} Nullpunktverschiebungen: {names} (mit ihren ersten Zeilen). Ihr Abstand ist nicht bekannt, und die Sätze dazwischen stimmen nicht. Jeden Teil für sich prüfen.</translation>
    </message>
    <message>
        <source>The programs {names} behind the closing % are called, and read. A control may stop at that %: load each by itself.</source>
        <translation>Die Programme {names} hinter dem schließenden % werden aufgerufen und sind gelesen. Eine Steuerung hält vielleicht an diesem %: jedes für sich laden.</translation>
    </message>
    <message>
        <source>The recommended setup lies on the edge of the region ({edges}); beyond it may be a better one.</source>
        <translation>Die empfohlene Aufspannung liegt am Rand des Bereichs ({edges}); dahinter mag eine bessere liegen.</translation>
    </message>
    <message>
        <source>The rotary axes cannot turn to the tilted plane: {reason}. Choose the program's own machine.</source>
        <translation>Die Rundachsen können nicht zur geschwenkten Ebene drehen: {reason}. Die Maschine des Programms wählen.</translation>
    </message>
    <message>
        <source>The rotary limits make the tool retract, turn back and re-engage inside cuts, {count} times.</source>
        <translation>Die Grenzen der Drehachsen zwingen das Werkzeug innerhalb von Schnitten {count}-mal, abzuheben, zurückzudrehen und neu anzusetzen.</translation>
    </message>
    <message>
        <source>The rows are off by up to {worst} and {lean} from the best machine, {scale} times what rounding explains. The program may come from another CL path, or its machine have directions or axes that are not tried here.</source>
        <translation>Die Zeilen liegen um bis zu {worst} und {lean} neben der besten Maschine, das {scale}-fache dessen, was Rundung erklärt. Das Programm kommt vielleicht von einem anderen CL-Weg, oder seine Maschine hat Richtungen oder Achsen, die hier nicht erprobt werden.</translation>
    </message>
    <message>
        <source>The rows do not determine {name}; it is written {kept}. Give rows in which the rotary axes turn farther.</source>
        <translation>Die Zeilen bestimmen {name} nicht; geschrieben ist {kept}. Zeilen angeben, in denen die Rundachsen weiter drehen.</translation>
    </message>
    <message>
        <source>The shape of {label} is invalid, so its mesh would have cracks: repair it (Part workbench: Check geometry shows where), or select another solid.</source>
        <translation>Die Form von {label} ist ungültig, ihr Netz hätte Risse: reparieren (Part: Geometrie prüfen zeigt, wo) oder einen anderen Volumenkörper wählen.</translation>
    </message>
    <message>
        <source>The spindle has no speed in {count} feed block, NC line {line}: it is started, but no S above 0 is in force there. Give S with M3.</source>
        <translation>Die Spindel hat in {count} Vorschubsatz, NC-Zeile {line}, keine Drehzahl: Sie ist eingeschaltet, aber kein S über 0 ist dort wirksam. S mit M3 angeben.</translation>
    </message>
    <message>
        <source>The spindle has no speed in {count} feed blocks, from NC line {line} on: it is started, but no S above 0 is in force there. Give S with M3.</source>
        <translation>Die Spindel hat in {count} Vorschubsätzen, ab NC-Zeile {line}, keine Drehzahl: Sie ist eingeschaltet, aber kein S über 0 ist dort wirksam. S mit M3 angeben.</translation>
    </message>
    <message>
        <source>The spindle stands still in {count} feed block, NC line {line}: M5 is in force there. Give M3 before it, or delete the M5.</source>
        <translation>Die Spindel steht in {count} Vorschubsatz, NC-Zeile {line}, still: Dort ist M5 wirksam. Davor M3 angeben oder das M5 löschen.</translation>
    </message>
    <message>
        <source>The spindle stands still in {count} feed blocks, from NC line {line} on: M5 is in force there. Give M3 before them, or delete the M5.</source>
        <translation>Die Spindel steht in {count} Vorschubsätzen, ab NC-Zeile {line}, still: Dort ist M5 wirksam. Davor M3 angeben oder das M5 löschen.</translation>
    </message>
    <message>
        <source>The spindle stays off, as asked: this program is for a dry run.</source>
        <translation>Die Spindel bleibt aus, wie verlangt: dieses Programm ist für einen Lauf ohne Schnitt.</translation>
    </message>
    <message>
        <source>The spindle stays off: give {spindle}.</source>
        <translation>Die Spindel bleibt aus: {spindle} angeben.</translation>
    </message>
    <message>
        <source>The spindle stays off: nothing before NC line {line}, the first that feeds, starts it. Give M3 with S before the tool gets to the part.</source>
        <translation>Die Spindel steht: nichts vor NC-Zeile {line}, der ersten mit Vorschub, schaltet sie ein. M3 mit S geben, bevor das Werkzeug an das Teil kommt.</translation>
    </message>
    <message>
        <source>The spindle still turns there.</source>
        <translation>Die Spindel dreht sich dort noch.</translation>
    </message>
    <message>
        <source>The spindle turns to the left (M4) in {count} feed block, NC line {line}. That is right for left-hand tools alone: give M3 for any other.</source>
        <translation>Die Spindel dreht in {count} Vorschubsatz, NC-Zeile {line}, links herum (M4). Das ist nur für linksschneidende Werkzeuge richtig: für andere M3 angeben.</translation>
    </message>
    <message>
        <source>The spindle turns to the left (M4) in {count} feed blocks, from NC line {line} on. That is right for left-hand tools alone: give M3 for any other.</source>
        <translation>Die Spindel dreht in {count} Vorschubsätzen, ab NC-Zeile {line}, links herum (M4). Das ist nur für linksschneidende Werkzeuge richtig: für andere M3 angeben.</translation>
    </message>
    <message>
        <source>The table goes {right}: {letter} has the wrong sign.</source>
        <translation>Der Tisch geht {right}: {letter} hat das falsche Vorzeichen.</translation>
    </message>
    <message>
        <source>The text after FINI is not read.</source>
        <translation>Der Text nach FINI wird nicht gelesen.</translation>
    </message>
    <message>
        <source>The text after the closing % is not read.</source>
        <translation>Der Text nach dem schließenden % wird nicht gelesen.</translation>
    </message>
    <message>
        <source>The text is {language}, and read as such; give its {option}, so that feeds are taken as it takes them.</source>
        <translation>Der Text ist {language} und wird so gelesen; {option} angeben, damit die Vorschübe genommen werden, wie sie es tut.</translation>
    </message>
    <message>
        <source>The text is {language}; it is read as a program of {controller}. If it is for another, give its {option}.</source>
        <translation>Der Text ist {language}; er wird als Programm von {controller} gelesen. Ist er für eine andere Steuerung, {option} angeben.</translation>
    </message>
    <message>
        <source>The tip stands {gap} over the highest place of part and clamps (a gauge block fits). Draw a cross on part or plate straight below the tip: this is the mark.</source>
        <translation>Die Werkzeugspitze steht {gap} über der höchsten Stelle von Werkstück und Spannmitteln (ein Endmaß passt dazwischen). Senkrecht unter der Spitze ein Kreuz auf Werkstück oder Platte zeichnen: das ist die Marke.</translation>
    </message>
    <message>
        <source>The tool axis is beyond the rotary limits over {length} of the passes, the first at {at}; they are left out. Use less lead or tilt, clamp the part in another position, or take another machine.</source>
        <translation>Die Werkzeugachse liegt auf {length} der Bahnen jenseits der Grenzen der Rundachsen, zuerst bei {at}; sie sind ausgelassen. Weniger Voreil- oder Seitwinkel geben, das Werkstück anders aufspannen oder eine andere Maschine nehmen.</translation>
    </message>
    <message>
        <source>The tool axis is given by vectors. What was looked at of the machine's bodies holds where the controller takes the same rotary words at the blocks' ends and turns them evenly in between; it may choose others, and where it turns the vector itself they go otherwise.</source>
        <translation>Die Werkzeugachse ist durch Vektoren gegeben. Was von den Körpern der Maschine angesehen wurde, gilt, wo die Steuerung an den Satzenden dieselben Drehachswörter nimmt und sie dazwischen gleichmäßig dreht; sie kann andere wählen, und wo sie den Vektor selbst dreht, gehen sie anders.</translation>
    </message>
    <message>
        <source>The tool axis of the CL path turns by {wanted}, the rotary words by {turned} in all: no degrees, but radians would do. Have the post write degrees.</source>
        <translation>Die Werkzeugachse des CL-Wegs dreht sich um {wanted}, die Drehworte zusammen um {turned}: Grad sind es nicht, Bogenmaß würde reichen. Den Postprozessor Grad schreiben lassen.</translation>
    </message>
    <message>
        <source>The tool axis was tilted in {count} rows, most by {angle} at {place}, so that the tool stays out of the part.</source>
        <translation>Die Werkzeugachse wurde in {count} Punkten geneigt, am meisten um {angle} bei {place}, damit das Werkzeug nicht ins Werkstück eindringt.</translation>
    </message>
    <message>
        <source>The tool dips up to {depth} below Z {height}, on which the part stands. Hold the part so that as much is free below its edges, or give what is there with {fixture}.</source>
        <translation>Das Werkzeug taucht bis {depth} unter Z {height} ein, worauf das Teil steht. Das Teil so spannen, dass unter seinen Kanten so viel frei ist, oder mit {fixture} angeben, was dort ist.</translation>
    </message>
    <message>
        <source>The tool gets everywhere: {area}.</source>
        <translation>Das Werkzeug kommt überall hin: {area}.</translation>
    </message>
    <message>
        <source>The tool gets to {share} % of the surface, {reached} of {area}; most of the rest is {reason}.</source>
        <translation>Das Werkzeug erreicht {share} % der Oberfläche, {reached} von {area}; der Rest ist meist: {reason}.</translation>
    </message>
    <message>
        <source>The tool goes up to {depth} below Z {height}, on which the part stands: farther than the end of the cutter needs beside a wall. Raise the part by as much, give what is there with {fixture}, or keep the tool from leaning so far with {max_axis_angle}.</source>
        <translation>Das Werkzeug geht bis {depth} unter Z {height}, worauf das Teil steht: weiter, als das Ende des Fräsers neben einer Wand braucht. Das Teil um so viel höher spannen, mit {fixture} angeben, was dort ist, oder mit {max_axis_angle} das Werkzeug weniger weit neigen.</translation>
    </message>
    <message>
        <source>The tool goes {wrong}: {letter} has the wrong sign.</source>
        <translation>Das Werkzeug geht {wrong}: {letter} hat das falsche Vorzeichen.</translation>
    </message>
    <message>
        <source>The tool leans into the part over {length} of the passes, the first at {at}; they are left out. Choose another tool axis, lead or tilt, or cut these places in another set-up.</source>
        <translation>Das Werkzeug neigt sich auf {length} der Bahnen ins Werkstück, zuerst bei {at}; sie sind ausgelassen. Eine andere Werkzeugachse, Voreil- oder Seitwinkel wählen oder diese Stellen in einer anderen Aufspannung fräsen.</translation>
    </message>
    <message>
        <source>The tool passes below the part once between two cuts, because it looks down there. Check that nothing holds the part from below, or choose a tool axis that looks up.</source>
        <translation>Das Werkzeug geht zwischen zwei Schnitten einmal unter dem Werkstück durch, weil es dort nach unten zeigt. Prüfen, dass nichts das Werkstück von unten hält, oder eine Werkzeugachse wählen, die nach oben zeigt.</translation>
    </message>
    <message>
        <source>The tool points elsewhere: see the table below for what that means. Signs seen right: pivot offsets are wrong.</source>
        <translation>Das Werkzeug zeigt woandershin: was das heißt, sagt die Tabelle unten. Sind die Vorzeichen richtig gesehen: die Drehpunktversätze sind falsch.</translation>
    </message>
    <message>
        <source>The tool was lifted over {length} of the passes, most at {place}: by {lift} along its axis. What no other pass cuts there stays. Cut these places with a smaller cutter or another tool axis.</source>
        <translation>Das Werkzeug wurde auf {length} der Bahnen abgehoben, am meisten bei {place}: um {lift} entlang seiner Achse. Was dort keine andere Bahn schneidet, bleibt stehen. Diese Stellen mit einem kleineren Fräser oder einer anderen Werkzeugachse fräsen.</translation>
    </message>
    <message>
        <source>The tool {what} along Z through {obstacle}, {why}.</source>
        <translation>Das Werkzeug {what} entlang Z durch {obstacle}, {why}.</translation>
    </message>
    <message>
        <source>The toolpath of {label} was deleted</source>
        <translation>Der Werkzeugweg von {label} wurde gelöscht</translation>
    </message>
    <message>
        <source>The toolpath of {label} was deleted: make the map of another one.</source>
        <translation>Der Werkzeugweg von {label} wurde gelöscht: die Karte eines anderen erstellen.</translation>
    </message>
    <message>
        <source>The underside at Z {height} is not machined: the part stands on these {area} ({share} %). Cut them in another setup; with the part held off the table, {max_axis_angle} has them cut in this one.</source>
        <translation>Die Unterseite bei Z {height} wird nicht bearbeitet: Darauf steht das Teil ({area}, {share} %). Fräsen Sie sie in einer anderen Aufspannung; ist das Teil über dem Tisch gehalten, wird sie mit {max_axis_angle} auch in dieser bearbeitet.</translation>
    </message>
    <message>
        <source>The underside at Z {height} is not machined: {area} ({share} % of the part) face away from the spindle. Turn the part over to cut it.</source>
        <translation>Die Unterseite bei Z {height} ist nicht bearbeitet: {area} ({share} % des Werkstücks) zeigen von der Spindel weg. Das Werkstück wenden, um sie zu fräsen.</translation>
    </message>
    <message>
        <source>The whole part is {size} long, less than the cutter's diameter of {diameter}: its file may be in metres ({metres}) or inches ({inches}). Export the part in mm, scale it, or name the units of STL files on the command line: {option}.</source>
        <translation>Das ganze Teil ist {size} lang, weniger als der Durchmesser {diameter} des Fräsers: seine Datei kann in Metern ({metres}) oder Zoll ({inches}) sein. Exportieren Sie das Teil in mm, skalieren Sie es, oder nennen Sie auf der Befehlszeile die Einheit von STL-Dateien: {option}.</translation>
    </message>
    <message>
        <source>The word {letter} in NC line {line} is not interpreted: what it does is missing here. Post without it, or see that it moves nothing and changes no feed.</source>
        <translation>Das Wort {letter} in NC-Zeile {line} wird nicht ausgewertet: Was es bewirkt, fehlt hier. Ohne es ausgeben oder nachsehen, dass es nichts bewegt und keinen Vorschub ändert.</translation>
    </message>
    <message>
        <source>The words of {letter} count their turns on, and {count} blocks turn by more than half a turn; the machine file says modulo, so the shorter way is taken. If the control counts turns, set wrap_strategy to unwound.</source>
        <translation>Die Wörter von {letter} zählen Umdrehungen weiter, und {count} NC-Sätze drehen um mehr als eine halbe Umdrehung; die Maschinendatei sagt modulo, also gilt der kürzere Weg. Zählt die Steuerung Umdrehungen, wrap_strategy auf unwound stellen.</translation>
    </message>
    <message>
        <source>The work zero is shifted: the program counts {axes} from {values} (within {certainty}), not from the CL path's zero. A machine file cannot hold that: correct the work offset, or the post.</source>
        <translation>Der Werkstücknullpunkt ist verschoben: das Programm zählt {axes} von {values} an (auf {certainty}), nicht vom Nullpunkt des CL-Wegs. Eine Maschinendatei kann das nicht festhalten: Nullpunktverschiebung oder Postprozessor berichtigen.</translation>
    </message>
    <message>
        <source>The zeros of {assumed} are taken as right: these rows could not tell them apart from the offsets. Give rows with larger turns to have them proven too.</source>
        <translation>Die Nullpunkte von {assumed} gelten als richtig: diese Zeilen konnten sie nicht von den Versätzen unterscheiden. Zeilen mit größeren Drehungen angeben, um auch sie nachzuweisen.</translation>
    </message>
    <message>
        <source>The {part} comes nearer than {distance} to the faces to avoid at {at}, nearest of {count} blocks; {allowance} are asked for. Let blocks be divided, or use a smaller cutter or holder.</source>
        <translation>{part} kommt den ausgesparten Flächen bei {at} näher als {distance}, am nächsten von {count} Sätzen; verlangt sind {allowance}. Lassen Sie Sätze teilen, oder nehmen Sie einen kleineren Fräser oder Halter.</translation>
    </message>
    <message>
        <source>The {part} comes nearer than {distance} to {name} at {at}, nearest of {count} blocks; {clearance} are asked for.</source>
        <translation>{part}: kommt {name} bei {at} näher als {distance}, der nächste von {count} Sätzen; verlangt sind {clearance}.</translation>
    </message>
    <message>
        <source>The {part} comes nearer to {name} than the clearance.</source>
        <translation>{part}: kommt näher als der Abstand an {name}.</translation>
    </message>
    <message>
        <source>The {part} goes at least {depth} below the table's face at {at}, deepest of {count} blocks. Clamp the part higher, use a longer tool, or lean it less ({max_axis_angle}).</source>
        <translation>{part}: mindestens {depth} unter der Tischfläche bei {at}, am tiefsten von {count} Sätzen. Das Teil höher spannen, ein längeres Werkzeug nehmen oder es weniger neigen ({max_axis_angle}).</translation>
    </message>
    <message>
        <source>The {part} goes at least {depth} into the fixture {fixture} at {at}, deepest of {count} blocks.</source>
        <translation>{part}: dringt bei {at} mindestens {depth} in das Spannmittel {fixture} ein, am tiefsten von {count} Sätzen.</translation>
    </message>
    <message>
        <source>The {part} goes at least {depth} into the part at {at} if the axes of this rapid run independently; it is clear if they are interpolated. Which of the two this controller does is not known.</source>
        <translation>{part}: dringt bei {at} mindestens {depth} ins Werkstück ein, wenn die Achsen in diesem Eilgang unabhängig laufen; werden sie interpoliert, ist der Weg frei. Welches von beidem diese Steuerung tut, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>The {part} goes at least {depth} into the part at {at} in a rapid whose axes run independently; it is clear only if they are interpolated.</source>
        <translation>{part}: dringt bei {at} mindestens {depth} ins Werkstück ein, in einem Eilgang, dessen Achsen unabhängig laufen; frei ist der Weg nur, wenn sie interpoliert werden.</translation>
    </message>
    <message>
        <source>The {part} goes at least {depth} into the {name}, at {at}, deepest of {count} blocks.</source>
        <translation>{part}: mindestens {depth} tief in {name}, bei {at}, der tiefste von {count} Sätzen.</translation>
    </message>
    <message>
        <source>The {part} goes at least {depth} into {name} at {at}.</source>
        <translation>{part}: dringt bei {at} mindestens {depth} ein in {name}.</translation>
    </message>
    <message>
        <source>The {part} goes at least {depth} into {name}.</source>
        <translation>{part}: dringt mindestens {depth} ein in {name}.</translation>
    </message>
    <message>
        <source>The {part} goes {depth} into the part at {at}.</source>
        <translation>{part}: dringt bei {at} {depth} ins Werkstück ein.</translation>
    </message>
    <message>
        <source>The {what} turns {wrong}, {opposite}: {letter} has the wrong sign. Another axis turns: it is not {letter} (if it is {other}, the two letters are exchanged).</source>
        <translation>{what} dreht {wrong}, {opposite}: {letter} hat das falsche Vorzeichen. Eine andere Achse dreht: es ist nicht {letter} (ist es {other}, sind die beiden Buchstaben vertauscht).</translation>
    </message>
    <message>
        <source>These are deviations of blocks that are not yet divided: the program's own keep its tolerance.</source>
        <translation>Das sind Abweichungen von Sätzen, die noch nicht geteilt sind: Die des Programms halten seine Toleranz ein.</translation>
    </message>
    <message>
        <source>These touch each other with all axes at zero and were not looked at against each other, for one is hollow or holds the other: {names}. Divide what is hollow into several bodies.</source>
        <translation>Diese berühren einander, wenn alle Achsen auf null stehen, und wurden nicht gegeneinander geprüft, denn einer ist hohl oder enthält den anderen: {names}. Hohle Körper in mehrere teilen.</translation>
    </message>
    <message>
        <source>These touch each other with all axes at zero, so they are taken for neighbours; they go nowhere deeper into each other than there: {names}.</source>
        <translation>Diese berühren einander, wenn alle Achsen auf null stehen, und gelten daher als Nachbarn; sie dringen nirgends tiefer ineinander ein als dort: {names}.</translation>
    </message>
    <message>
        <source>This is told of the path as it was made for {present}: by {axes_by} another tool is given another path.</source>
        <translation>Das gilt für die Bahn, wie sie für {present} gemacht wurde: durch {axes_by} bekommt ein anderes Werkzeug eine andere Bahn.</translation>
    </message>
    <message>
        <source>Tighter than the cutter ({area}): its end does not fit there; use a smaller radius.</source>
        <translation>Zu eng für den Fräser ({area}): Sein Ende passt dort nicht hinein; nehmen Sie einen kleineren Radius.</translation>
    </message>
    <message>
        <source>Tilted planes: of the ways to stand the one that {control} takes by its manual is taken, at first {first} {second}; a setting of the machine may choose another. Compare with the control.</source>
        <translation>Geschwenkte Ebenen: Von den möglichen Stellungen wird die genommen, die {control} nach seinem Handbuch nimmt, zuerst {first} {second}; ein Parameter der Maschine kann eine andere wählen. Mit der Steuerung vergleichen.</translation>
    </message>
    <message>
        <source>Tool stick-out: the {present} that are set are the least.</source>
        <translation>Auskragung des Werkzeugs: Die eingestellten {present} sind das Mindeste.</translation>
    </message>
    <message>
        <source>Tool stick-out: {enough} are enough, {present} are set.</source>
        <translation>Auskragung des Werkzeugs: {enough} genügen, {present} sind eingestellt.</translation>
    </message>
    <message>
        <source>Tool stick-out: {enough} are needed, {present} are set.</source>
        <translation>Auskragung des Werkzeugs: {enough} sind nötig, {present} sind eingestellt.</translation>
    </message>
    <message>
        <source>Tool stick-out: {present} are set, and no length from that up to {longest} keeps shank, holder and spindle free in the recommended setup.</source>
        <translation>Auskragung des Werkzeugs: {present} sind eingestellt, und keine Länge von da bis {longest} hält Schaft, Halter und Spindel in der empfohlenen Aufspannung frei.</translation>
    </message>
    <message>
        <source>Tool vectors</source>
        <translation>Werkzeugvektoren</translation>
    </message>
    <message>
        <source>Tried, and none finishes more: {tried}.</source>
        <translation>Versucht, und keines bearbeitet mehr fertig: {tried}.</translation>
    </message>
    <message>
        <source>Tried: {changes} would finish {gain} more, {finished} in all; the program then takes {time} instead of {before}.</source>
        <translation>Versucht: {changes} würde {gain} mehr fertig bearbeiten, {finished} im Ganzen; das Programm dauert dann {time} statt {before}.</translation>
    </message>
    <message>
        <source>Turn the part, or use another tool axis there.</source>
        <translation>Das Werkstück drehen oder dort eine andere Werkzeugachse nehmen.</translation>
    </message>
    <message>
        <source>Under {split} the program begins and ends at the reference point of Z, because before it no tool length is active. Set the machine file's safe_start to reference or machine.</source>
        <translation>Unter {split} beginnt und endet das Programm am Referenzpunkt von Z, weil vorher keine Werkzeuglänge gilt. safe_start der Maschinendatei auf reference oder machine setzen.</translation>
    </message>
    <message>
        <source>Use a longer tool or a smaller holder; between cuts use a larger clearance.</source>
        <translation>Ein längeres Werkzeug oder einen kleineren Halter verwenden; zwischen Schnitten einen größeren Sicherheitsabstand.</translation>
    </message>
    <message>
        <source>Use a smaller cutter or another tool axis there.</source>
        <translation>Dort einen kleineren Fräser oder eine andere Werkzeugachse nehmen.</translation>
    </message>
    <message>
        <source>Use a smaller holder, lean the tool otherwise, or clamp the part otherwise.</source>
        <translation>Nehmen Sie einen kleineren Halter, neigen Sie das Werkzeug anders, oder spannen Sie das Teil anders.</translation>
    </message>
    <message>
        <source>What an axis change buys on {part} passes that come within {change} of the pole (peak rate and travel of {letter}, blocks that would hold {tolerance}): {rows}.</source>
        <translation>Was eine Änderung der Achse auf {part} Zeilen bringt, die dem Pol näher als {change} kommen (größte Drehung je Weg und gesamte Drehung von {letter}, NC-Sätze, die {tolerance} einhielten): {rows}.</translation>
    </message>
    <message>
        <source>Where Z comes down to the first block, or rises from the last one:</source>
        <translation>Wo Z zum ersten Satz hinabfährt oder vom letzten aus steigt:</translation>
    </message>
    <message>
        <source>Where holder or machine are in the way, no tool that sticks out up to 80 mm farther helps.</source>
        <translation>Wo Halter oder Maschine im Weg sind, hilft kein Werkzeug, das bis zu 80 mm weiter auskragt.</translation>
    </message>
    <message>
        <source>Where holder, fixture or machine are in the way, no tool that sticks out up to 80 mm farther helps.</source>
        <translation>Wo Halter, Spannmittel oder Maschine im Weg sind, hilft kein Werkzeug, das bis zu 80 mm weiter auskragt.</translation>
    </message>
    <message>
        <source>Where the axes stand before the first known position is not known, nor where a retract to a machine position or a reference point begins: neither is counted.</source>
        <translation>Wo die Achsen vor der ersten bekannten Position stehen, ist nicht bekannt, auch nicht, wo ein Freifahren zu einer Maschinenposition oder einem Referenzpunkt beginnt: beides wird nicht mitgezählt.</translation>
    </message>
    <message>
        <source>Where the cutter is too large, a ball of {diameter}, its radius {more} smaller, fits on 90 % of that area.</source>
        <translation>Wo der Fräser zu groß ist, passt eine Kugel von {diameter}, deren Radius um {more} kleiner ist, auf 90 % dieser Fläche.</translation>
    </message>
    <message>
        <source>Where the cutter is too large, no ball down to a tenth of it fits on 90 % of that area.</source>
        <translation>Wo der Fräser zu groß ist, passt auch eine Kugel von einem Zehntel nicht auf 90 % dieser Fläche.</translation>
    </message>
    <message>
        <source>Where the holder is in the way, no tool that sticks out up to 80 mm farther helps.</source>
        <translation>Wo der Halter im Weg ist, hilft kein Werkzeug, das bis zu 80 mm weiter auskragt.</translation>
    </message>
    <message>
        <source>Where the spindle is over the tip is not known without the tool's length: {names} were not looked at. Give it ({option}).</source>
        <translation>Wo die Spindel über der Spitze steht, ist ohne die Werkzeuglänge nicht bekannt: nicht angesehen wurden {names}. Sie angeben ({option}).</translation>
    </message>
    <message>
        <source>While rotary axes turn, straight moves of the axes carry the ball's centre along a curve beside its straight segment, and the surface with it.</source>
        <translation>Während Rundachsen drehen, tragen gerade Bewegungen der Achsen die Kugelmitte auf einer Kurve neben ihrer Sollstrecke, und die Fläche mit ihr.</translation>
    </message>
    <message>
        <source>While rotary axes turn, straight moves of the axes carry the tip along a curve beside the straight segment.</source>
        <translation>Während Rundachsen drehen, tragen gerade Bewegungen der Achsen die Werkzeugspitze auf einer Kurve neben der Sollstrecke.</translation>
    </message>
    <message>
        <source>Wider limits or another setup avoid it.</source>
        <translation>Weitere Grenzen oder eine andere Aufspannung vermeiden das.</translation>
    </message>
    <message>
        <source>With a tool that sticks out {more} farther an axis is free on about {share} % of that.</source>
        <translation>Mit einem Werkzeug, das {more} weiter auskragt, ist auf etwa {share} % davon eine Achse frei.</translation>
    </message>
    <message>
        <source>With a tool that sticks out {more} farther there is a way.</source>
        <translation>Mit einem Werkzeug, das {more} weiter auskragt, gibt es einen Weg.</translation>
    </message>
    <message>
        <source>With all axes at zero they are {depth} in each other.</source>
        <translation>Mit allen Achsen auf null stecken sie {depth} ineinander.</translation>
    </message>
    <message>
        <source>With rotary axes turning, F means other things on other controls. This one has no inverse time: give each block an F for the way of its axes, as {post} does.</source>
        <translation>Wenn Rundachsen drehen, bedeutet F auf verschiedenen Steuerungen Verschiedenes. Diese hat keinen zeitreziproken Vorschub: jedem Satz ein F für den Weg seiner Achsen geben, wie es {post} tut.</translation>
    </message>
    <message>
        <source>With rotary axes turning, F under G94 means other things on other controls. Post with inverse time (G93).</source>
        <translation>Wenn Rundachsen drehen, bedeutet F unter G94 auf anderen Steuerungen anderes. Mit zeitreziprokem Vorschub (G93) ausgeben.</translation>
    </message>
    <message>
        <source>With the part turned by {angle} the rotary limits allow no way: {error}.</source>
        <translation>Mit dem um {angle} gedrehten Werkstück erlauben die Grenzen der Rundachsen keinen Weg: {error}.</translation>
    </message>
    <message>
        <source>With the tool as it is the machine is hit in every setup that was tried. With one that sticks out {enough} instead of {present}:</source>
        <translation>Mit dem Werkzeug, wie es ist, wird die Maschine in jeder erprobten Aufspannung getroffen. Mit einer Auskragung von {enough} statt {present}:</translation>
    </message>
    <message>
        <source>With {letter} at {first} and {other} at {second} the tool points at the cross: its tip is {distance} from it, measured along the tool.</source>
        <translation>Mit {letter} auf {first} und {other} auf {second} zeigt das Werkzeug auf das Kreuz: seine Spitze ist {distance} davon entfernt, entlang des Werkzeugs gemessen.</translation>
    </message>
    <message>
        <source>Without the fixture {fixture} the tool reaches about {area} more.</source>
        <translation>Ohne das Spannmittel {fixture} erreicht das Werkzeug etwa {area} mehr.</translation>
    </message>
    <message>
        <source>Words count from the work zero: is {origin} where it stood on the machine? Else move it ({setup} finds a place)</source>
        <translation>Die Wörter zählen vom Werkstücknullpunkt: Ist {origin} dort, wo er auf der Maschine stand? Sonst versetzen ({setup} findet einen Platz)</translation>
    </message>
    <message>
        <source>Work offset and tool length set as for the real program; tool centre point control off.</source>
        <translation>Nullpunktverschiebung und Werkzeuglänge wie für das echte Programm gesetzt; Werkzeugspitzenführung aus.</translation>
    </message>
    <message>
        <source>X Y Z are the tips of the CL path although the rotary axes turn: the program leaves the pivots to the controller (RTCP); post it without tool centre point control</source>
        <translation>X Y Z sind die Werkzeugspitzen des CL-Wegs, obwohl die Rundachsen drehen: das Programm überlässt die Drehpunkte der Steuerung (RTCP); ohne Werkzeugspitzenführung ausgeben</translation>
    </message>
    <message>
        <source>X and Y are not told before it</source>
        <translation>X und Y stehen nicht davor</translation>
    </message>
    <message>
        <source>X{x} Y{y} Z{z}</source>
        <translation>X{x} Y{y} Z{z}</translation>
    </message>
    <message>
        <source>Z goes no higher: before the start stand the rotary axes by hand where the first block wants them, use a shorter tool, or narrow the rotary limits in the machine file to what is really used.</source>
        <translation>Höher fährt Z nicht: Stellen Sie vor dem Start die Rundachsen von Hand dorthin, wo der erste Satz sie braucht, nehmen Sie ein kürzeres Werkzeug, oder begrenzen Sie die Rundachsen in der Maschinendatei auf das, was wirklich benutzt wird.</translation>
    </message>
    <message>
        <source>Z of this machine does not lift the tool: give its file another safe_start than clearance</source>
        <translation>Z dieser Maschine hebt das Werkzeug nicht: ihrer Datei ein anderes safe_start als clearance geben</translation>
    </message>
    <message>
        <source>a CAM job</source>
        <translation>einen CAM-Auftrag</translation>
    </message>
    <message>
        <source>a CL file (APT)</source>
        <translation>eine CL-Datei (APT)</translation>
    </message>
    <message>
        <source>a G65 beside another G code</source>
        <translation>ein G65 neben einem anderen G-Code</translation>
    </message>
    <message>
        <source>a HAL file was not read</source>
        <translation>eine HAL-Datei wurde nicht gelesen</translation>
    </message>
    <message>
        <source>a barrel cutter touches with the ball at its tip, not with its flank</source>
        <translation>ein Tonnenfräser berührt mit der Kugel an seiner Spitze, nicht mit seiner Flanke</translation>
    </message>
    <message>
        <source>a barrel leans {angle} from the surface, which machine {name} cannot follow with one rotary axis: choose {fixed} for upright walls, or a ball cutter</source>
        <translation>ein Tonnenfräser neigt sich um {angle} von der Oberfläche, und dem kann die Maschine {name} mit einer Rundachse nicht folgen: {fixed} für senkrechte Wände wählen, oder einen Kugelfräser</translation>
    </message>
    <message>
        <source>a block asks more of an axis than its maximum rate</source>
        <translation>ein Satz verlangt von einer Achse mehr als ihre größte Geschwindigkeit</translation>
    </message>
    <message>
        <source>a block leaves the commanded path</source>
        <translation>ein Satz verlässt die befohlene Bahn</translation>
    </message>
    <message>
        <source>a block lies near the machine's pole: rotary axes swing</source>
        <translation>ein Satz liegt nahe am Pol der Maschine, Rundachsen schwenken</translation>
    </message>
    <message>
        <source>a block of inverse time has no F of its own</source>
        <translation>ein Satz mit inverser Zeit hat kein eigenes F</translation>
    </message>
    <message>
        <source>a bracket without its partner</source>
        <translation>eine Klammer ohne Gegenstück</translation>
    </message>
    <message>
        <source>a call that does not say what by P alone</source>
        <translation>ein Aufruf, der nicht allein mit P sagt, was</translation>
    </message>
    <message>
        <source>a code that the reader does not know</source>
        <translation>ein Code ist unbekannt</translation>
    </message>
    <message>
        <source>a collision with the machine is not excluded</source>
        <translation>ein Zusammenstoß mit der Maschine ist nicht ausgeschlossen</translation>
    </message>
    <message>
        <source>a coordinate of {farthest} mm or rad is beyond any machine; correct it</source>
        <translation>eine Koordinate von {farthest} mm oder rad liegt jenseits jeder Maschine; berichtigen</translation>
    </message>
    <message>
        <source>a deviation of {enough} cannot be enough; give 0 or more</source>
        <translation>eine Abweichung von {enough} kann nicht genug sein; 0 oder mehr angeben</translation>
    </message>
    <message>
        <source>a deviation of {linear} is not above 0; give one as 0.1 mm</source>
        <translation>Eine Abweichung von {linear} ist nicht größer als 0; geben Sie eine wie 0,1 mm an</translation>
    </message>
    <message>
        <source>a dimension of the machine is certain within a range only</source>
        <translation>ein Maß der Maschine ist nur innerhalb eines Bereichs sicher</translation>
    </message>
    <message>
        <source>a divided block would leave the limits in its middle</source>
        <translation>ein geteilter Satz verließe in seiner Mitte die Grenzen</translation>
    </message>
    <message>
        <source>a document, as FreeCAD.ActiveDocument</source>
        <translation>ein Dokument, etwa FreeCAD.ActiveDocument</translation>
    </message>
    <message>
        <source>a facet names vertex {wrong}, but the rows run from 0 to {count}: correct the facets</source>
        <translation>eine Facette nennt die Ecke {wrong}, aber die Zeilen gehen von 0 bis {count}: die Facetten berichtigen</translation>
    </message>
    <message>
        <source>a feed begins where an axis stands at a machine position that is not known</source>
        <translation>ein Vorschub beginnt, wo eine Achse auf einer unbekannten Maschinenposition steht</translation>
    </message>
    <message>
        <source>a feed is given by a parameter or the tool</source>
        <translation>ein Vorschub steht in einem Parameter oder beim Werkzeug</translation>
    </message>
    <message>
        <source>a feed per turn needs the spindle speed; say SPINDL/ before, or give it per minute</source>
        <translation>ein Vorschub je Umdrehung braucht die Spindeldrehzahl; vorher SPINDL/ angeben oder Vorschub je Minute</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>eine endliche Zahl</translation>
    </message>
    <message>
        <source>a fixture is in the way</source>
        <translation>ein Spannmittel ist im Weg</translation>
    </message>
    <message>
        <source>a fixture stands in a body of the machine</source>
        <translation>ein Spannmittel steckt in einem Körper der Maschine</translation>
    </message>
    <message>
        <source>a fixture stands in the part</source>
        <translation>ein Spannmittel steht im Werkstück</translation>
    </message>
    <message>
        <source>a list of names</source>
        <translation>eine Liste von Namen</translation>
    </message>
    <message>
        <source>a lower feed for plunging, of which the times here know nothing; F is taken as it stands</source>
        <translation>ein geringerer Vorschub beim Eintauchen, den die Zeiten hier nicht berücksichtigen; F wird genommen, wie es dasteht</translation>
    </message>
    <message>
        <source>a machine on which the path cannot be driven</source>
        <translation>auf einer Maschine lässt sich die Bahn nicht fahren</translation>
    </message>
    <message>
        <source>a mirror image, rotation or scaling is on, and which comes first is not known; end it first</source>
        <translation>eine Spiegelung, Drehung oder Skalierung ist aktiv, und was zuerst kommt, ist nicht bekannt; sie zuerst beenden</translation>
    </message>
    <message>
        <source>a mirror image, rotation or scaling is on; end it first</source>
        <translation>eine Spiegelung, Drehung oder Skalierung ist aktiv; sie zuerst beenden</translation>
    </message>
    <message>
        <source>a number with an exponent; write it out</source>
        <translation>eine Zahl mit Exponent; ausschreiben</translation>
    </message>
    <message>
        <source>a part that is no STL needs FreeCAD, and {given} is no program here; install FreeCAD, name its freecadcmd in {variable}, or give the part as STL</source>
        <translation>ein Teil, das keine STL-Datei ist, braucht FreeCAD, und {given} ist hier kein Programm; installieren Sie FreeCAD, nennen Sie sein freecadcmd in {variable}, oder geben Sie das Teil als STL an</translation>
    </message>
    <message>
        <source>a pecking cycle without its step</source>
        <translation>ein Tieflochzyklus hat keine Zustelltiefe</translation>
    </message>
    <message>
        <source>a piece of the tool from height {low} to {high} has no volume</source>
        <translation>ein Stück des Werkzeugs von Höhe {low} bis {high} hat kein Volumen</translation>
    </message>
    <message>
        <source>a piece of the tool has sizes {sizes}; give radii of at least 0, up to {largest}</source>
        <translation>ein Stück des Werkzeugs hat die Maße {sizes}; Radien ab 0 bis {largest} angeben</translation>
    </message>
    <message>
        <source>a pin of the tool length is a constant</source>
        <translation>ein Pin der Werkzeuglänge ist eine Konstante</translation>
    </message>
    <message>
        <source>a pivot was found with the tool length in it</source>
        <translation>ein Drehpunkt wurde samt der Werkzeuglänge gefunden</translation>
    </message>
    <message>
        <source>a place or step beyond {farthest}; is it in another unit?</source>
        <translation>ein Ort oder Schritt jenseits von {farthest}; ist er in einer anderen Einheit?</translation>
    </message>
    <message>
        <source>a plane offset is {wrong}: give finite numbers</source>
        <translation>ein Ebenenabstand ist {wrong}: endliche Zahlen angeben</translation>
    </message>
    <message>
        <source>a process died, as when memory runs out; give fewer {workers}</source>
        <translation>ein Prozess ist gestorben, wie bei zu wenig Speicher; weniger {workers} angeben</translation>
    </message>
    <message>
        <source>a program's name where O takes a number</source>
        <translation>ein Programmname, wo O eine Nummer nimmt</translation>
    </message>
    <message>
        <source>a rapid may come too near to the faces to avoid</source>
        <translation>ein Eilgang kommt den zu meidenden Flächen vielleicht zu nahe</translation>
    </message>
    <message>
        <source>a rapid may enter the part on some way of the axes</source>
        <translation>ein Eilgang dringt auf einem Weg der Achsen vielleicht ins Teil ein</translation>
    </message>
    <message>
        <source>a rapid may hit a fixture on some way of the axes</source>
        <translation>ein Eilgang trifft auf einem Weg der Achsen vielleicht ein Spannmittel</translation>
    </message>
    <message>
        <source>a rapid whose axes run independently enters the part</source>
        <translation>ein Eilgang mit unabhängigen Achsen dringt ins Teil ein</translation>
    </message>
    <message>
        <source>a rapid with independent axes hits the part</source>
        <translation>ein Eilgang mit unabhängigen Achsen trifft das Werkstück</translation>
    </message>
    <message>
        <source>a rotary axis that wraps takes the shorter way</source>
        <translation>eine Rundachse nimmt den kürzeren Weg</translation>
    </message>
    <message>
        <source>a rotary axis turns against ISO 841</source>
        <translation>eine Rundachse dreht gegen ISO 841</translation>
    </message>
    <message>
        <source>a rotary axis turns back inside a cut</source>
        <translation>eine Rundachse dreht mitten in einem Schnitt zurück</translation>
    </message>
    <message>
        <source>a rotary axis turns back inside a cut, with the tool retracted</source>
        <translation>eine Rundachse dreht mitten im Schnitt zurück, bei abgehobenem Werkzeug</translation>
    </message>
    <message>
        <source>a rotary axis turns back inside cuts, {count} times</source>
        <translation>eine Rundachse dreht mitten im Schnitt zurück, {count}-mal</translation>
    </message>
    <message>
        <source>a rotary axis turns while the tool stands at the machine's pole</source>
        <translation>eine Rundachse dreht, während das Werkzeug am Pol der Maschine steht</translation>
    </message>
    <message>
        <source>a setup map</source>
        <translation>eine Aufspannkarte</translation>
    </message>
    <message>
        <source>a setup, as create_setup gives it</source>
        <translation>eine Aufspannung, wie create_setup sie gibt</translation>
    </message>
    <message>
        <source>a side is not machined ({area})</source>
        <translation>eine Seite ist nicht bearbeitet ({area})</translation>
    </message>
    <message>
        <source>a slash must follow the word, as in GOTO/1,2,3</source>
        <translation>dem Wort muss ein Schrägstrich folgen, wie in GOTO/1,2,3</translation>
    </message>
    <message>
        <source>a smaller least interval than {interval}</source>
        <translation>ein kleinster Abstand unter {interval}</translation>
    </message>
    <message>
        <source>a smaller stepover</source>
        <translation>ein kleinerer Zeilensprung</translation>
    </message>
    <message>
        <source>a statement within a drilling cycle drills no hole</source>
        <translation>eine Anweisung in einem Bohrzyklus bohrt kein Loch</translation>
    </message>
    <message>
        <source>a stick-out of {length} is not between {least} and {most}</source>
        <translation>eine Auskragung von {length} liegt nicht zwischen {least} und {most}</translation>
    </message>
    <message>
        <source>a strip beside the faces to avoid stays uncut</source>
        <translation>ein Streifen neben den zu meidenden Flächen bleibt stehen</translation>
    </message>
    <message>
        <source>a tilted plane ends with a shift in it, and moves follow; reset the shift first</source>
        <translation>eine geschwenkte Ebene endet mit einer Verschiebung darin, und Bewegungen folgen; zuerst die Verschiebung zurücksetzen</translation>
    </message>
    <message>
        <source>a tilted plane is on; end it first</source>
        <translation>eine geschwenkte Ebene ist aktiv; sie zuerst beenden</translation>
    </message>
    <message>
        <source>a tool unlike that of the control's table (DL, DR); the words are taken as they are, without the difference</source>
        <translation>ein Werkzeug anders als in der Tabelle der Steuerung (DL, DR); die Wörter werden ohne den Unterschied genommen, wie sie sind</translation>
    </message>
    <message>
        <source>a value beyond all words</source>
        <translation>ein Wert jenseits aller Wörter</translation>
    </message>
    <message>
        <source>a value that is no number</source>
        <translation>ein Wert, der keine Zahl ist</translation>
    </message>
    <message>
        <source>a variable of no whole number</source>
        <translation>eine Variable ohne ganze Zahl</translation>
    </message>
    <message>
        <source>a whole stretch of the surface stays uncut</source>
        <translation>ein ganzes Stück der Fläche bleibt ungefräst</translation>
    </message>
    <message>
        <source>a whole turn</source>
        <translation>ein voller Kreis</translation>
    </message>
    <message>
        <source>a word is a letter and one number</source>
        <translation>ein Wort ist ein Buchstabe und eine Zahl</translation>
    </message>
    <message>
        <source>a wrong sign would hardly be seen</source>
        <translation>ein falsches Vorzeichen sähe man kaum</translation>
    </message>
    <message>
        <source>a {kind} axis is called one of {letters}</source>
        <translation>eine Achse der Art {kind} heißt {letters}</translation>
    </message>
    <message>
        <source>a {side} axis cannot stand on the {other} axis {carrier}</source>
        <translation>eine Achse der Seite {side} kann nicht auf der Achse {carrier} der Seite {other} stehen</translation>
    </message>
    <message>
        <source>above {bound}</source>
        <translation>über {bound} sein</translation>
    </message>
    <message>
        <source>all moves stand in variables, expressions or jumps, which are not interpreted; line {line}: {text}</source>
        <translation>alle Bewegungen stehen in Variablen, Ausdrücken oder Sprüngen, die nicht ausgewertet werden; Zeile {line}: {text}</translation>
    </message>
    <message>
        <source>all that is to be machined lies on {name}; leave out {option}</source>
        <translation>alles zu Bearbeitende liegt auf {name}; {option} weglassen</translation>
    </message>
    <message>
        <source>allow more frames</source>
        <translation>mehr Anstellungen zulassen</translation>
    </message>
    <message>
        <source>an NC program</source>
        <translation>ein NC-Programm</translation>
    </message>
    <message>
        <source>an STL file</source>
        <translation>eine STL-Datei</translation>
    </message>
    <message>
        <source>an arc does not pass through the points beside it</source>
        <translation>ein Bogen geht nicht durch die Punkte daneben</translation>
    </message>
    <message>
        <source>an arc goes about a CC that stands before it; give CC again</source>
        <translation>ein Bogen läuft um einen CC, der davor steht; CC erneut angeben</translation>
    </message>
    <message>
        <source>an arc or a rounding lies in a plane whose axes have unlike factors</source>
        <translation>ein Bogen oder eine Rundung liegt in einer Ebene, deren Achsen ungleiche Faktoren haben</translation>
    </message>
    <message>
        <source>an axis is passed over: the machine file says that it moves nothing</source>
        <translation>eine Achse wird übergangen, sie bewegt laut Maschinendatei nichts</translation>
    </message>
    <message>
        <source>an axis leaves its limits</source>
        <translation>eine Achse verlässt ihre Grenzen</translation>
    </message>
    <message>
        <source>an axis that this machine does not have; its moves are missing here. Choose the program's own machine</source>
        <translation>eine Achse, die diese Maschine nicht hat; ihre Bewegungen fehlen hier. Die eigene Maschine des Programms wählen</translation>
    </message>
    <message>
        <source>an axis would exceed its rate; the block runs slower</source>
        <translation>eine Achse überschritte ihre Geschwindigkeit, der Satz läuft langsamer</translation>
    </message>
    <message>
        <source>an inside corner is tighter than the cutter</source>
        <translation>eine Innenecke ist enger als der Fräser</translation>
    </message>
    <message>
        <source>an offset is set that the kinematics do not use</source>
        <translation>ein Versatz ist gesetzt, den die Kinematik nicht benutzt</translation>
    </message>
    <message>
        <source>an offset is where a slider of the screen starts</source>
        <translation>ein Versatz steht da, wo ein Regler des Bildschirms beginnt</translation>
    </message>
    <message>
        <source>and {count} more</source>
        <translation>und {count} weitere</translation>
    </message>
    <message>
        <source>angle; write it as 10 deg</source>
        <translation>Winkel; als 10 deg schreiben</translation>
    </message>
    <message>
        <source>another cutter is used than the file names</source>
        <translation>es wird ein anderer Fräser benutzt, als die Datei nennt</translation>
    </message>
    <message>
        <source>another of them is on, and which comes first is not known; end that one first</source>
        <translation>eine andere ist aktiv, und welche zuerst kommt, ist nicht bekannt; diese zuerst beenden</translation>
    </message>
    <message>
        <source>another plane is on; end it first</source>
        <translation>eine andere Ebene ist aktiv; sie zuerst beenden</translation>
    </message>
    <message>
        <source>arcs of a form that is not known here, taken as straight to their end points; post straight moves</source>
        <translation>Kreisbögen einer hier unbekannten Form, als Geraden bis zum Endpunkt genommen; Geraden ausgeben</translation>
    </message>
    <message>
        <source>arcs that the reader cannot follow</source>
        <translation>Bögen werden nicht verstanden</translation>
    </message>
    <message>
        <source>are off the CL path, nearly all alike ({least} to {most} at their ends): the post had another machine, work zero or tool length in mind. See {origin} and {tool_length}; {recover} finds the machine that fits.</source>
        <translation>liegen neben dem CL-Weg, fast alle gleich ({least} bis {most} an ihren Enden): der Postprozessor meinte eine andere Maschine, einen anderen Werkstücknullpunkt oder eine andere Werkzeuglänge. {origin} und {tool_length} ansehen; {recover} findet die passende Maschine.</translation>
    </message>
    <message>
        <source>as 0</source>
        <translation>als 0</translation>
    </message>
    <message>
        <source>as given</source>
        <translation>wie gegeben</translation>
    </message>
    <message>
        <source>as in the machine given</source>
        <translation>wie in der gegebenen Maschine</translation>
    </message>
    <message>
        <source>ask for a smaller tolerance</source>
        <translation>eine kleinere Toleranz verlangen</translation>
    </message>
    <message>
        <source>at least {bound}</source>
        <translation>mindestens {bound} sein</translation>
    </message>
    <message>
        <source>at least {depth}</source>
        <translation>mindestens {depth}</translation>
    </message>
    <message>
        <source>at least {share} % of the surface to be milled stays unfinished</source>
        <translation>mindestens {share} % der zu fräsenden Fläche bleiben unbearbeitet</translation>
    </message>
    <message>
        <source>at most {bound}</source>
        <translation>höchstens {bound} sein</translation>
    </message>
    <message>
        <source>axis words under no motion code are taken as feed moves</source>
        <translation>Achsworte ohne Bewegungscode gelten als Vorschub</translation>
    </message>
    <message>
        <source>axis {about} has no direction; give three numbers, as 1,0,0</source>
        <translation>Achse {about} hat keine Richtung; geben Sie drei Zahlen an, etwa 1,0,0</translation>
    </message>
    <message>
        <source>axis {given} has no direction; give I,J,K of the fixed tool axis, as 0,0,1</source>
        <translation>die Achse {given} hat keine Richtung; I,J,K der festen Werkzeugachse angeben, wie 0,0,1</translation>
    </message>
    <message>
        <source>axis {letter} cannot stand at 0; programs begin with their rotary axes there</source>
        <translation>Achse {letter} kann nicht auf 0 stehen; Programme beginnen mit den Rundachsen dort</translation>
    </message>
    <message>
        <source>axis {letter} has no end; give its limits, or its travel is not checked</source>
        <translation>Achse {letter} hat kein Ende; Grenzen angeben, sonst wird ihr Weg nicht geprüft</translation>
    </message>
    <message>
        <source>axis {letter} has no maximum rate; give one, the machine file needs it</source>
        <translation>die Achse {letter} hat keine größte Geschwindigkeit; eine angeben, die Maschinendatei braucht sie</translation>
    </message>
    <message>
        <source>axis {letter} has no maximum rate; give what its drive reaches</source>
        <translation>Achse {letter} hat keine größte Geschwindigkeit; angeben, was ihr Antrieb erreicht</translation>
    </message>
    <message>
        <source>axis {letter} needs it there or under [AXIS_{letter}]</source>
        <translation>die Achse {letter} braucht ihn dort oder unter [AXIS_{letter}]</translation>
    </message>
    <message>
        <source>axis {letter}: joint axis</source>
        <translation>Achse {letter}: Richtung der Achse</translation>
    </message>
    <message>
        <source>axis {letter}: joint origin</source>
        <translation>Achse {letter}: Punkt der Achse</translation>
    </message>
    <message>
        <source>axis {letter}: {problem}</source>
        <translation>Achse {letter}: {problem}</translation>
    </message>
    <message>
        <source>back</source>
        <translation>zurück</translation>
    </message>
    <message>
        <source>ball ends, end mills, bull noses and tapered ball noses are of use here: choose one, or give the cutter by hand</source>
        <translation>brauchbar sind hier Kugel-, Schaft-, Torus- und kegelige Kugelfräser: einen davon wählen oder den Fräser von Hand angeben</translation>
    </message>
    <message>
        <source>because the tool axis points downwards there</source>
        <translation>weil die Werkzeugachse dort nach unten zeigt</translation>
    </message>
    <message>
        <source>below the table</source>
        <translation>unter dem Tisch</translation>
    </message>
    <message>
        <source>between table and tool {linear} run straight and {rotary} turn; it needs three and at most two, make others fixed</source>
        <translation>zwischen Tisch und Werkzeug laufen {linear} gerade und drehen {rotary}; es müssen drei und höchstens zwei sein, machen Sie andere fest (fixed)</translation>
    </message>
    <message>
        <source>beyond the machine's limits</source>
        <translation>außerhalb der Achsgrenzen der Maschine</translation>
    </message>
    <message>
        <source>beyond the machine's limits or the largest axis angle; turn the part over, or raise the angle</source>
        <translation>außerhalb der Grenzen der Maschine oder des größten Achswinkels; das Teil wenden oder den Winkel erhöhen</translation>
    </message>
    <message>
        <source>blend tolerance is {blend}; give 0 (exact path) to 999</source>
        <translation>die Eckenverrundung ist {blend}; 0 (exakter Weg) bis 999 angeben</translation>
    </message>
    <message>
        <source>blocks end off the path</source>
        <translation>Sätze enden neben der Bahn</translation>
    </message>
    <message>
        <source>blocks leave the path and come back to it: ways of the post's own</source>
        <translation>Sätze verlassen die Bahn und kehren zurück, auf Wegen des Postprozessors</translation>
    </message>
    <message>
        <source>blocks leave the path between their ends, which lie on it</source>
        <translation>Sätze verlassen die Bahn zwischen ihren Enden, die darauf liegen</translation>
    </message>
    <message>
        <source>blocks of the program that belong to no row of the path</source>
        <translation>Sätze des Programms gehören zu keiner Zeile der Bahn</translation>
    </message>
    <message>
        <source>blocks were divided to hold the tolerance</source>
        <translation>Sätze wurden geteilt, damit die Toleranz hält</translation>
    </message>
    <message>
        <source>bodies that touch at zero go no deeper into each other, or were not looked at</source>
        <translation>Körper, die sich in der Nullstellung berühren, dringen nicht tiefer ineinander ein oder wurden nicht geprüft</translation>
    </message>
    <message>
        <source>body {name}: {carrier} carries no body; name one of {known}</source>
        <translation>Körper {name}: {carrier} trägt keinen Körper; eines von {known} nennen</translation>
    </message>
    <message>
        <source>body {name}: {error}</source>
        <translation>Körper {name}: {error}</translation>
    </message>
    <message>
        <source>both rotary axes are parallel; tilt one of them</source>
        <translation>beide Rundachsen sind parallel; eine davon neigen</translation>
    </message>
    <message>
        <source>both rotary axes turned, tip over the mark</source>
        <translation>beide Rundachsen gedreht, Werkzeugspitze über der Marke</translation>
    </message>
    <message>
        <source>both stepover {stepover} and scallop {scallop}</source>
        <translation>sowohl Zeilensprung {stepover} als auch Kuppenhöhe {scallop}</translation>
    </message>
    <message>
        <source>boundary {name} crosses itself at {place}, seen along {axis}; give curves that do not</source>
        <translation>Begrenzung {name} kreuzt sich bei {place}, entlang {axis} gesehen; Kurven angeben, die das nicht tun</translation>
    </message>
    <message>
        <source>boundary {name} holds no closed curves: give X,Y,Z in mm on a line each, a blank line between two curves, at most {most} points, none beyond {farthest}</source>
        <translation>Begrenzung {name} enthält keine geschlossenen Kurven: je Zeile X,Y,Z in mm angeben, eine Leerzeile zwischen zwei Kurven, höchstens {most} Punkte, keiner jenseits von {farthest}</translation>
    </message>
    <message>
        <source>boundary {name} holds no closed curves: {cells} in curve {number} is no point; give X,Y,Z in mm on a line each, none beyond {farthest}</source>
        <translation>Begrenzung {name} enthält keine geschlossenen Kurven: {cells} in Kurve {number} ist kein Punkt; je Zeile X,Y,Z in mm angeben, keiner jenseits von {farthest}</translation>
    </message>
    <message>
        <source>by a setting of the machine its angles are spatial or those of the rotary axes, here two unlike planes</source>
        <translation>je nach Einstellung der Maschine sind seine Winkel Raumwinkel oder die der Rundachsen, hier zwei verschiedene Ebenen</translation>
    </message>
    <message>
        <source>calls of other programs, whose moves are missing</source>
        <translation>andere Programme werden aufgerufen, deren Bewegungen fehlen</translation>
    </message>
    <message>
        <source>calls, whose moves are missing here; post one program without them</source>
        <translation>Aufrufe, deren Bewegungen hier fehlen; ein Programm ohne sie ausgeben</translation>
    </message>
    <message>
        <source>character {shown} cannot be read ({hint})</source>
        <translation>das Zeichen {shown} ist nicht lesbar ({hint})</translation>
    </message>
    <message>
        <source>clearance {clearance} must be positive: rapids and rewinds need room about the part</source>
        <translation>der Sicherheitsabstand {clearance} muss über 0 sein: Eilgänge und Rückdrehungen brauchen Platz um das Werkstück</translation>
    </message>
    <message>
        <source>clockwise</source>
        <translation>im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>closed passes begin where a rotary axis has room</source>
        <translation>geschlossene Bahnen beginnen, wo eine Rundachse Platz hat</translation>
    </message>
    <message>
        <source>closed passes run by turns one way and the other, within a rotary axis' limits</source>
        <translation>geschlossene Bahnen laufen abwechselnd in beide Richtungen, innerhalb der Grenzen einer Drehachse</translation>
    </message>
    <message>
        <source>co-edge tolerance</source>
        <translation>die Kantentoleranz</translation>
    </message>
    <message>
        <source>comes down to its first place</source>
        <translation>kommt zu seinem ersten Ort herunter</translation>
    </message>
    <message>
        <source>contacts at which a cone's flank would enter are left out</source>
        <translation>Berührpunkte, an denen die Flanke eines Kegels eindränge, sind ausgelassen</translation>
    </message>
    <message>
        <source>contacts at which the tool would stand in the part are left out</source>
        <translation>Berührpunkte, an denen das Werkzeug im Teil stünde, sind ausgelassen</translation>
    </message>
    <message>
        <source>control_point is {control_point}; choose one of {known}</source>
        <translation>der geführte Punkt ist {control_point}; einen wählen von {known}</translation>
    </message>
    <message>
        <source>corners that lie next to each other were joined</source>
        <translation>nahe beieinander liegende Ecken wurden vereint</translation>
    </message>
    <message>
        <source>correct that place in a text editor, or {export}</source>
        <translation>diese Stelle in einem Texteditor berichtigen, oder {export}</translation>
    </message>
    <message>
        <source>counter-clockwise</source>
        <translation>gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>curve {number} of boundary {name} has no area when it is seen along {axis}; give another {option}</source>
        <translation>Kurve {number} der Begrenzung {name} hat entlang {axis} gesehen keine Fläche; {option} anders angeben</translation>
    </message>
    <message>
        <source>curve {number} of boundary {name} has {count} points; give three or more, and the first again at the end</source>
        <translation>Kurve {number} der Begrenzung {name} hat {count} Punkte; drei oder mehr angeben und den ersten am Ende noch einmal</translation>
    </message>
    <message>
        <source>curve {number} of boundary {name} is not closed: its ends are {gap} apart; repeat the first point at the end</source>
        <translation>Kurve {number} der Begrenzung {name} ist nicht geschlossen: ihre Enden liegen {gap} auseinander; den ersten Punkt am Ende wiederholen</translation>
    </message>
    <message>
        <source>cut that with other passes</source>
        <translation>das mit anderen Bahnen schneiden</translation>
    </message>
    <message>
        <source>cuts too deep</source>
        <translation>fräst zu tief</translation>
    </message>
    <message>
        <source>cutter</source>
        <translation>Fräser</translation>
    </message>
    <message>
        <source>cutter and holder stay</source>
        <translation>Fräser und Halter bleiben</translation>
    </message>
    <message>
        <source>cutter and shank stay</source>
        <translation>Fräser und Schaft bleiben</translation>
    </message>
    <message>
        <source>cutter compensation in the control</source>
        <translation>Radiuskorrektur in der Steuerung</translation>
    </message>
    <message>
        <source>cutter compensation; the words are taken as they are</source>
        <translation>Fräserradiuskorrektur; die Wörter werden genommen, wie sie sind</translation>
    </message>
    <message>
        <source>cutter corner radius is {corner}; a barrel has a ball of {least} or more at its tip, of less than {radius}, half the diameter</source>
        <translation>der Eckenradius des Fräsers ist {corner}; ein Tonnenfräser hat an der Spitze eine Kugel von mindestens {least} und weniger als {radius}, dem halben Durchmesser</translation>
    </message>
    <message>
        <source>cutter corner radius is {corner}; give 0 to {radius}, half the diameter</source>
        <translation>der Eckenradius des Fräsers ist {corner}; 0 bis {radius} angeben, den halben Durchmesser</translation>
    </message>
    <message>
        <source>cutter flank radius is {flank}; give more than {radius}, half the diameter, and at most {most}</source>
        <translation>der Flankenradius des Fräsers ist {flank}; mehr als {radius}, den halben Durchmesser, und höchstens {most} angeben</translation>
    </message>
    <message>
        <source>cutter flank radius: only a barrel has one, and it has no taper; leave one of them out</source>
        <translation>Flankenradius des Fräsers: nur ein Tonnenfräser hat einen, und der hat keinen Kegel; eines von beiden weglassen</translation>
    </message>
    <message>
        <source>cutter length is {length}, its flank ends {ends} above the tip; give a longer cutter or a smaller flank radius</source>
        <translation>die Länge des Fräsers ist {length}, seine Flanke endet {ends} über der Spitze; einen längeren Fräser oder einen kleineren Flankenradius angeben</translation>
    </message>
    <message>
        <source>cutter length is {length}, the neck begins {begins} above the tip; give a longer cutter</source>
        <translation>die Länge des Fräsers ist {length}, der Hals beginnt {begins} über der Spitze; einen längeren Fräser angeben</translation>
    </message>
    <message>
        <source>cutter length is {length}, the taper begins {begins} above the tip; give a longer cutter</source>
        <translation>die Länge des Fräsers ist {length}, der Kegel beginnt {begins} über der Spitze; einen längeren Fräser angeben</translation>
    </message>
    <message>
        <source>cutter neck is {neck}; give {least} or more, and less than {diameter}, the diameter of the ball</source>
        <translation>der Hals des Fräsers ist {neck}; {least} oder mehr angeben, und weniger als {diameter}, den Durchmesser der Kugel</translation>
    </message>
    <message>
        <source>cutter neck: only a ball without a taper has one; leave corner radius and taper out</source>
        <translation>Hals des Fräsers: nur eine Kugel ohne Kegel hat einen; Eckenradius und Kegelwinkel weglassen</translation>
    </message>
    <message>
        <source>cutter radius</source>
        <translation>der Fräserradius</translation>
    </message>
    <message>
        <source>cutter taper is {taper}; give 0 to {least}, from the axis to the flank</source>
        <translation>der Kegelwinkel des Fräsers ist {taper}; 0 bis {least} angeben, von der Achse zur Flanke</translation>
    </message>
    <message>
        <source>cutter taper {taper} makes it {width} wide; give a smaller taper or length</source>
        <translation>mit dem Kegelwinkel {taper} wird der Fräser {width} breit; einen kleineren Winkel oder eine kleinere Länge angeben</translation>
    </message>
    <message>
        <source>cutter {name} is {value}; give {least} to {most}</source>
        <translation>Fräser: {name} ist {value}; {least} bis {most} angeben</translation>
    </message>
    <message>
        <source>cutter {text} needs {sizes} or {sizes}:LENGTH, as {form} or {form}:60</source>
        <translation>der Fräser {text} braucht {sizes} oder {sizes}:LENGTH, wie {form} oder {form}:60</translation>
    </message>
    <message>
        <source>cutter {text}: only {kinds} cutters are on offer; write it as {form}</source>
        <translation>Fräser {text}: im Angebot sind nur {kinds}; schreiben wie {form}</translation>
    </message>
    <message>
        <source>cutter's flank in the way</source>
        <translation>Flanke des Fräsers im Weg</translation>
    </message>
    <message>
        <source>cutter, shank and holder stay</source>
        <translation>Fräser, Schaft und Halter bleiben</translation>
    </message>
    <message>
        <source>cutter, shank and holder, as far as they are given, keep {distance} off the faces to avoid</source>
        <translation>Fräser, Schaft und Halter, soweit angegeben, bleiben {distance} von den ausgesparten Flächen weg</translation>
    </message>
    <message>
        <source>cutter, shank and holder, as far as they are given, stay out of the fixtures: {names}</source>
        <translation>Fräser, Schaft und Halter, soweit angegeben, bleiben aus den Spannmitteln: {names}</translation>
    </message>
    <message>
        <source>cycle {number} with {name} above 0</source>
        <translation>Zyklus {number} mit {name} über 0</translation>
    </message>
    <message>
        <source>cycle {number} without {name}</source>
        <translation>Zyklus {number} ohne {name}</translation>
    </message>
    <message>
        <source>cycles, whose moves are missing</source>
        <translation>Zyklen, deren Bewegungen fehlen</translation>
    </message>
    <message>
        <source>cycles, whose moves are missing here; post straight moves</source>
        <translation>Zyklen, deren Bewegungen hier fehlen; Geraden ausgeben</translation>
    </message>
    <message>
        <source>direction {angle} is no angle; give a number of degrees</source>
        <translation>die Richtung {angle} ist kein Winkel; eine Zahl in Grad angeben</translation>
    </message>
    <message>
        <source>down</source>
        <translation>nach unten</translation>
    </message>
    <message>
        <source>dwells of drilling cycles are left out</source>
        <translation>Verweilzeiten von Bohrzyklen sind ausgelassen</translation>
    </message>
    <message>
        <source>dwells, whose time is not counted</source>
        <translation>Verweilzeiten, die nicht gezählt werden</translation>
    </message>
    <message>
        <source>dwells; their time is in no time that is told here</source>
        <translation>Verweilzeiten; sie sind in keiner der hier genannten Zeiten enthalten</translation>
    </message>
    <message>
        <source>each of its numbers must be {bounds}</source>
        <translation>jede der Zahlen muss {bounds}</translation>
    </message>
    <message>
        <source>enters the part</source>
        <translation>dringt ins Werkstück ein</translation>
    </message>
    <message>
        <source>export the machine from FreeCAD again</source>
        <translation>die Maschine noch einmal aus FreeCAD exportieren</translation>
    </message>
    <message>
        <source>export the part with a coarser tolerance, or free memory</source>
        <translation>das Werkstück gröber exportieren oder Speicher freimachen</translation>
    </message>
    <message>
        <source>faces need the part (.stl), {source} is none; leave faces out</source>
        <translation>Flächen brauchen das Werkstück (.stl), {source} ist keines; die Flächen weglassen</translation>
    </message>
    <message>
        <source>facet</source>
        <translation>Facette</translation>
    </message>
    <message>
        <source>facet {facet} is malformed: '{odd}' stands where {need} belongs; export the file again</source>
        <translation>die Facette {facet} ist fehlerhaft: „{odd}“ steht, wo {need} hingehört; die Datei neu exportieren</translation>
    </message>
    <message>
        <source>facets</source>
        <translation>Facetten</translation>
    </message>
    <message>
        <source>facets are given as {dtype} numbers: give integer rows of the vertex table</source>
        <translation>die Facetten sind als Zahlen {dtype} gegeben: ganzzahlige Zeilen der Eckentabelle angeben</translation>
    </message>
    <message>
        <source>facets at the ends of a rotary axis get no rotary passes</source>
        <translation>Facetten an den Enden einer Rundachse bekommen keine Drehbahnen</translation>
    </message>
    <message>
        <source>facets lean more than the largest axis angle</source>
        <translation>Facetten sind steiler als der größte Achswinkel</translation>
    </message>
    <message>
        <source>facets lie inside another solid of the part</source>
        <translation>Facetten liegen in einem anderen Volumenkörper des Teils</translation>
    </message>
    <message>
        <source>facets lie nearer to faces to avoid than the allowance</source>
        <translation>Facetten liegen den zu meidenden Flächen näher als das Aufmaß</translation>
    </message>
    <message>
        <source>facets need rotary positions beyond the limits</source>
        <translation>Facetten brauchen Drehstellungen jenseits der Grenzen</translation>
    </message>
    <message>
        <source>facets outside the boundary are left out</source>
        <translation>Facetten außerhalb der Begrenzung sind ausgelassen</translation>
    </message>
    <message>
        <source>facets that faced the other way than their neighbours were turned</source>
        <translation>Facetten, die zur anderen Seite als ihre Nachbarn zeigten, wurden umgedreht</translation>
    </message>
    <message>
        <source>facets that no allowed tool axis reaches from above, or that the part stands on</source>
        <translation>Facetten, die keine erlaubte Werkzeugachse von oben erreicht, oder auf denen das Teil steht</translation>
    </message>
    <message>
        <source>facets that were there twice; one of each was kept</source>
        <translation>Facetten waren doppelt, je eine blieb</translation>
    </message>
    <message>
        <source>facets were divided at corners that lie on their sides</source>
        <translation>Facetten wurden an Ecken geteilt, die auf ihren Seiten liegen</translation>
    </message>
    <message>
        <source>facets without an area were dropped</source>
        <translation>Facetten ohne Fläche wurden weggelassen</translation>
    </message>
    <message>
        <source>feed moves have no feed</source>
        <translation>Vorschubbewegungen haben keinen Vorschub</translation>
    </message>
    <message>
        <source>feeds are for each turn of the spindle, so no time is given</source>
        <translation>Vorschübe gelten je Umdrehung der Spindel, daher steht keine Zeit da</translation>
    </message>
    <message>
        <source>feeds per spindle turn; no time is given for these blocks</source>
        <translation>Vorschübe je Umdrehung; für diese NC-Sätze gibt es keine Zeit</translation>
    </message>
    <message>
        <source>feeds told by a parameter or the tool; F is not known there</source>
        <translation>Vorschübe aus einem Parameter oder vom Werkzeug; F ist dort nicht bekannt</translation>
    </message>
    <message>
        <source>file names with their contents as bytes</source>
        <translation>Dateinamen mit ihrem Inhalt als Bytes</translation>
    </message>
    <message>
        <source>fixed tool axis {fixed} has no direction; give three numbers, as 0,0,1</source>
        <translation>die feste Werkzeugachse {fixed} hat keine Richtung; drei Zahlen angeben, wie 0,0,1</translation>
    </message>
    <message>
        <source>fixture in the way</source>
        <translation>Spannmittel im Weg</translation>
    </message>
    <message>
        <source>fixtures that were not given, other bodies of the machine, and stock that is still there</source>
        <translation>nicht angegebene Spannmittel, andere Körper der Maschine und Rohmaterial, das noch da ist</translation>
    </message>
    <message>
        <source>fixtures, the machine's own bodies, and stock that is still there</source>
        <translation>Spannmittel, die Maschine selbst und Material, das noch steht</translation>
    </message>
    <message>
        <source>folder {folder} cannot be made: {strerror}; choose another one</source>
        <translation>der Ordner {folder} kann nicht angelegt werden: {strerror}; einen anderen wählen</translation>
    </message>
    <message>
        <source>folder {folder} cannot be written: {strerror}; choose another one</source>
        <translation>in den Ordner {folder} kann nicht geschrieben werden: {strerror}; einen anderen wählen</translation>
    </message>
    <message>
        <source>folder {folder} does not exist; make it first</source>
        <translation>den Ordner {folder} gibt es nicht; zuerst anlegen</translation>
    </message>
    <message>
        <source>from above</source>
        <translation>von oben</translation>
    </message>
    <message>
        <source>from line {line} on the controller guides the tip (G43.4, G43.5, G234, M128, M428, TRAORI or FUNCTION TCPM): X Y Z are tips and say nothing of pivots; post it again without tool centre point control</source>
        <translation>ab Zeile {line} führt die Steuerung die Spitze (G43.4, G43.5, G234, M128, M428, TRAORI oder FUNCTION TCPM): X Y Z sind Orte der Spitze und sagen nichts über Drehpunkte; ohne Werkzeugspitzenführung noch einmal ausgeben</translation>
    </message>
    <message>
        <source>from the first block to the last those of the machine's bodies that move against each other stay out of each other, and out of part and fixtures as far as these are known, but for neighbours that touch with all axes at zero: {names}</source>
        <translation>vom ersten bis zum letzten Satz bleiben die Körper der Maschine, die sich gegeneinander bewegen, einander fern, ebenso Werkstück und Spannmitteln, soweit diese bekannt sind, außer Nachbarn, die sich berühren, wenn alle Achsen auf null stehen: {names}</translation>
    </message>
    <message>
        <source>from the first block to the last tool and spindle, as far as they are given, stay out of the machine's bodies: {names}</source>
        <translation>vom ersten bis zum letzten Satz bleiben Werkzeug und Spindel, soweit angegeben, außerhalb der Körper der Maschine: {names}</translation>
    </message>
    <message>
        <source>from the front</source>
        <translation>von vorn</translation>
    </message>
    <message>
        <source>from the right</source>
        <translation>von rechts</translation>
    </message>
    <message>
        <source>from work to tool it has {model}, the kinematics {kinematics}; one of them can be right</source>
        <translation>vom Werkstück zum Werkzeug hat es {model}, die Kinematik {kinematics}; nur eines kann stimmen</translation>
    </message>
    <message>
        <source>front</source>
        <translation>vordere</translation>
    </message>
    <message>
        <source>give Z, a machine coordinate</source>
        <translation>Z angeben, eine Maschinenkoordinate</translation>
    </message>
    <message>
        <source>give a larger stepover or scallop, or check the units of the part</source>
        <translation>größeren Bahnabstand oder größere Kuppenhöhe angeben, oder die Einheiten des Werkstücks prüfen</translation>
    </message>
    <message>
        <source>give a smaller file, or free memory</source>
        <translation>eine kleinere Datei angeben oder Speicher freimachen</translation>
    </message>
    <message>
        <source>gouge, shank and holder need the part or a fixture: give its STL with {against} or {fixture}</source>
        <translation>Prüfung, Schaft und Halter brauchen das Teil oder ein Spannmittel: geben Sie dessen STL mit {against} oder {fixture} an</translation>
    </message>
    <message>
        <source>guide curve {source} needs two points or more, X,Y,Z in mm on a line each, at most {most}</source>
        <translation>die Leitkurve {source} braucht zwei Punkte oder mehr, X,Y,Z in mm je Zeile, höchstens {most}</translation>
    </message>
    <message>
        <source>head</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>hits the part between passes</source>
        <translation>trifft das Werkstück zwischen den Bahnen</translation>
    </message>
    <message>
        <source>holder</source>
        <translation>Halter</translation>
    </message>
    <message>
        <source>holder and {given} say the same; give holder</source>
        <translation>Halter und {given} sagen dasselbe; den Halter angeben</translation>
    </message>
    <message>
        <source>holder in the way</source>
        <translation>Halter im Weg</translation>
    </message>
    <message>
        <source>holder {sizes} is no cone; give z0, r0, z1, r1 in mm with 0 &lt;= z0 &lt; z1 and radii of at least 0</source>
        <translation>der Halter {sizes} ist kein Kegel; z0, r0, z1, r1 in mm angeben mit 0 &lt;= z0 &lt; z1 und Radien ab 0</translation>
    </message>
    <message>
        <source>how far a peck goes back is a setting of the control</source>
        <translation>wie weit der Bohrer zurückfährt, ist in der Steuerung eingestellt</translation>
    </message>
    <message>
        <source>how high part and clamps reach is not given</source>
        <translation>wie hoch Teil und Spannmittel reichen, ist nicht angegeben</translation>
    </message>
    <message>
        <source>how high the jaws of a vise may reach beside the part</source>
        <translation>wie hoch die Backen eines Schraubstocks neben dem Teil reichen dürfen</translation>
    </message>
    <message>
        <source>how many times a rotary axis turns back between cuts</source>
        <translation>wie oft eine Rundachse zwischen Schnitten zurückdreht</translation>
    </message>
    <message>
        <source>how many times a rotary axis turns back inside a cut</source>
        <translation>wie oft eine Rundachse mitten im Schnitt zurückdreht</translation>
    </message>
    <message>
        <source>how much stays is not known from the passes alone, but told by the map of what is left where that is asked for ({left})</source>
        <translation>wie viel stehen bleibt, ist aus den Bahnen allein nicht bekannt; die Karte des Restmaterials sagt es, wo sie verlangt ist ({left})</translation>
    </message>
    <message>
        <source>how the axes come to the first block, and where they go behind the last: where they stand before the program is not known, so nothing was looked at there</source>
        <translation>wie die Achsen zum ersten Satz kommen und wohin sie nach dem letzten fahren: Wo sie vor dem Programm stehen, ist nicht bekannt, also wurde dort nichts geprüft</translation>
    </message>
    <message>
        <source>in a closed hollow, where no tool gets in</source>
        <translation>in einem geschlossenen Hohlraum, in den kein Werkzeug kommt</translation>
    </message>
    <message>
        <source>in a feed block all axes run in proportion to each other</source>
        <translation>in einem Vorschubsatz laufen alle Achsen im Verhältnis zueinander</translation>
    </message>
    <message>
        <source>in a rapid all axes run in proportion to each other ({rapids})</source>
        <translation>auch im Eilgang laufen alle Achsen im Verhältnis zueinander ({rapids})</translation>
    </message>
    <message>
        <source>in all setups that were tried the machine is hit</source>
        <translation>in allen versuchten Aufspannungen wird die Maschine getroffen</translation>
    </message>
    <message>
        <source>in {count} of {all} feed blocks {point} stays within {tolerance} of the straight way between the block's ends</source>
        <translation>in {count} von {all} Vorschubsätzen bleibt {point} bis auf {tolerance} auf dem geraden Weg zwischen den Enden des Satzes</translation>
    </message>
    <message>
        <source>in {count} of {all} feed blocks {point} stays within {tolerance} of the straight way between the blocks' ends</source>
        <translation>in {count} von {all} Vorschubsätzen bleibt {point} bis auf {tolerance} auf dem geraden Weg zwischen den Enden der Sätze</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>ist leer</translation>
    </message>
    <message>
        <source>is not JSON ({error})</source>
        <translation>ist kein JSON ({error})</translation>
    </message>
    <message>
        <source>is turned farther</source>
        <translation>weiter gedreht ist</translation>
    </message>
    <message>
        <source>it calls more than {most} programs</source>
        <translation>es ruft mehr als {most} Programme auf</translation>
    </message>
    <message>
        <source>it changes a rotary axis, or one beside X, Y and Z</source>
        <translation>sie ändert eine Drehachse oder eine neben X, Y und Z</translation>
    </message>
    <message>
        <source>it defines entities of its own, which are not read; write it without &lt;!DOCTYPE</source>
        <translation>sie definiert eigene Entitäten, die nicht gelesen werden; schreiben Sie sie ohne &lt;!DOCTYPE</translation>
    </message>
    <message>
        <source>it gives more values than the program takes</source>
        <translation>er gibt mehr Werte, als das Programm nimmt</translation>
    </message>
    <message>
        <source>it goes on from a plane in which TRANS or ROT is on; end that first</source>
        <translation>es setzt auf einer Ebene auf, in der TRANS oder ROT wirkt; diese zuerst beenden</translation>
    </message>
    <message>
        <source>it has more than {most} shapes; give a model of fewer, larger ones</source>
        <translation>es hat mehr als {most} Formen; geben Sie ein Modell mit weniger, größeren an</translation>
    </message>
    <message>
        <source>it has more values than are known here</source>
        <translation>er hat mehr Werte, als hier bekannt sind</translation>
    </message>
    <message>
        <source>it has no Q above 0</source>
        <translation>er hat kein Q über 0</translation>
    </message>
    <message>
        <source>it has no R or no depth</source>
        <translation>er hat kein R oder keine Tiefe</translation>
    </message>
    <message>
        <source>it has no link; give the URDF of a machine</source>
        <translation>sie hat keinen Link; geben Sie die URDF-Datei einer Maschine an</translation>
    </message>
    <message>
        <source>it has no main(model, tool, work) that can be read; give the script of a vismach model</source>
        <translation>es hat kein main(model, tool, work), das sich lesen lässt; geben Sie das Skript eines Vismach-Modells an</translation>
    </message>
    <message>
        <source>it has no {name}</source>
        <translation>{name} fehlt</translation>
    </message>
    <message>
        <source>it has too many parts; give a simpler model</source>
        <translation>es hat zu viele Teile; geben Sie ein einfacheres Modell an</translation>
    </message>
    <message>
        <source>it is a closed hollow, where no tool gets in</source>
        <translation>es ist ein geschlossener Hohlraum, in den kein Werkzeug kommt</translation>
    </message>
    <message>
        <source>it is a xacro file; run xacro on it first, and give the URDF that it writes</source>
        <translation>sie ist eine Xacro-Datei; lassen Sie zuerst xacro darüber laufen und geben Sie die URDF-Datei an, die es schreibt</translation>
    </message>
    <message>
        <source>it is empty; write a text in quotes</source>
        <translation>er ist leer; einen Text in Anführungszeichen schreiben</translation>
    </message>
    <message>
        <source>it is flat</source>
        <translation>sie ist flach</translation>
    </message>
    <message>
        <source>it is nested too deep; give the script of a vismach model</source>
        <translation>es ist zu tief verschachtelt; geben Sie das Skript eines Vismach-Modells an</translation>
    </message>
    <message>
        <source>it is no XML that can be read ({error}); correct it</source>
        <translation>sie ist kein lesbares XML ({error}); berichtigen Sie sie</translation>
    </message>
    <message>
        <source>it is no script; give the script of a vismach model</source>
        <translation>es ist kein Skript; geben Sie das Skript eines Vismach-Modells an</translation>
    </message>
    <message>
        <source>it is not known in this form</source>
        <translation>sie ist in dieser Form nicht bekannt</translation>
    </message>
    <message>
        <source>it is too tight for the cutter; use a smaller one</source>
        <translation>für den Fräser ist es zu eng; einen kleineren nehmen</translation>
    </message>
    <message>
        <source>it makes too many pecks</source>
        <translation>er macht zu viele Zustellungen</translation>
    </message>
    <message>
        <source>it moves by {axes} as neither table nor tool do</source>
        <translation>sie bewegt sich mit {axes}, wie es weder Tisch noch Werkzeug tun</translation>
    </message>
    <message>
        <source>it must be {bounds}</source>
        <translation>es muss {bounds}</translation>
    </message>
    <message>
        <source>it needs one of {shapes}</source>
        <translation>er braucht eines von {shapes}</translation>
    </message>
    <message>
        <source>it needs {keys} and nothing else</source>
        <translation>er braucht {keys} und nichts sonst</translation>
    </message>
    <message>
        <source>it repeats lines with jumps or repeats</source>
        <translation>er wiederholt Zeilen mit Sprüngen oder Wiederholungen</translation>
    </message>
    <message>
        <source>it repeats more than {most} lines</source>
        <translation>er wiederholt mehr als {most} Zeilen</translation>
    </message>
    <message>
        <source>it says none of TURN, MOVE and STAY</source>
        <translation>sie nennt weder TURN noch MOVE noch STAY</translation>
    </message>
    <message>
        <source>it shifts a rotary axis</source>
        <translation>sie verschiebt eine Rundachse</translation>
    </message>
    <message>
        <source>it stands in a tilted plane</source>
        <translation>sie steht in einer geschwenkten Ebene</translation>
    </message>
    <message>
        <source>it stands under G91</source>
        <translation>es steht unter G91</translation>
    </message>
    <message>
        <source>it would run at a machine position</source>
        <translation>er würde an einer Maschinenposition laufen</translation>
    </message>
    <message>
        <source>its Q makes too many pecks</source>
        <translation>sein Q ergibt zu viele Zustellungen</translation>
    </message>
    <message>
        <source>its depth is not below 0, or its infeed is not above it</source>
        <translation>seine Tiefe ist nicht unter 0 oder seine Zustellung nicht darüber</translation>
    </message>
    <message>
        <source>its depth lies above R</source>
        <translation>seine Tiefe liegt über R</translation>
    </message>
    <message>
        <source>its factor is 0 or less, or more than 10</source>
        <translation>ihr Faktor ist höchstens 0 oder größer als 10</translation>
    </message>
    <message>
        <source>its feed is inverse time (G93)</source>
        <translation>sein Vorschub ist zeitreziprok (G93)</translation>
    </message>
    <message>
        <source>its first depth does not lie below RFP</source>
        <translation>seine erste Tiefe liegt nicht unter RFP</translation>
    </message>
    <message>
        <source>its pecks get smaller (I)</source>
        <translation>seine Zustellungen werden kleiner (I)</translation>
    </message>
    <message>
        <source>its pin is joined with several axes: {axes}</source>
        <translation>ihr Pin ist mit mehreren Achsen verbunden: {axes}</translation>
    </message>
    <message>
        <source>its process died, as when memory runs out; give fewer {workers}, or a coarser part</source>
        <translation>sein Prozess ist gestorben, wie bei zu wenig Speicher; weniger {workers} angeben oder ein gröberes Teil</translation>
    </message>
    <message>
        <source>its radius is that of the tool, which only the control knows; name it above TOOL CALL as ; DM=16</source>
        <translation>sein Radius ist der des Werkzeugs, den nur die Steuerung kennt; über TOOL CALL nennen als ; DM=16</translation>
    </message>
    <message>
        <source>its repeats are no whole number from 0 on</source>
        <translation>seine Wiederholungen sind keine ganze Zahl ab 0</translation>
    </message>
    <message>
        <source>its root is &lt;{tag}&gt;, not &lt;robot&gt;; give a URDF file</source>
        <translation>ihre Wurzel ist &lt;{tag}&gt;, nicht &lt;robot&gt;; geben Sie eine URDF-Datei an</translation>
    </message>
    <message>
        <source>its tool does not stand along Z with every joint at zero; turn the model so</source>
        <translation>sein Werkzeug steht nicht längs Z, wenn alle Gelenke auf null stehen; drehen Sie das Modell so</translation>
    </message>
    <message>
        <source>its values are no numbers</source>
        <translation>ihre Werte sind keine Zahlen</translation>
    </message>
    <message>
        <source>its vectors span no plane</source>
        <translation>ihre Vektoren spannen keine Ebene auf</translation>
    </message>
    <message>
        <source>its {edge} edge goes {way}, {size}</source>
        <translation>seine {edge} Kante geht {way}, {size}</translation>
    </message>
    <message>
        <source>its {edge} edge going {way}</source>
        <translation>seine {edge} Kante geht {way}</translation>
    </message>
    <message>
        <source>job file {path} is not JSON: {error}; correct that place, or name another file</source>
        <translation>Auftragsdatei {path} ist kein JSON: {error}; diese Stelle berichtigen oder eine andere Datei nennen</translation>
    </message>
    <message>
        <source>job file {path} needs "task" (one of {tasks}) and "source", the file to read</source>
        <translation>die Auftragsdatei {path} braucht „task“ (eines von {tasks}) und „source“, die zu lesende Datei</translation>
    </message>
    <message>
        <source>job file {path}: {error}</source>
        <translation>Auftragsdatei {path}: {error}</translation>
    </message>
    <message>
        <source>joint axis {place} has no direction; give a unit vector</source>
        <translation>die Achse {place} hat keine Richtung; einen Einheitsvektor angeben</translation>
    </message>
    <message>
        <source>joint {joint} has the axis 0 0 0; give its direction</source>
        <translation>Gelenk {joint} hat die Achse 0 0 0; geben Sie seine Richtung an</translation>
    </message>
    <message>
        <source>joint {joint} moves table and tool alike; make it fixed</source>
        <translation>Gelenk {joint} bewegt Tisch und Werkzeug zugleich; machen Sie es fest (fixed)</translation>
    </message>
    <message>
        <source>joint {joint} names the link {link}, which is not there; add it</source>
        <translation>Gelenk {joint} nennt den Link {link}, den es nicht gibt; ergänzen Sie ihn</translation>
    </message>
    <message>
        <source>joint {joint} runs along none of X, Y, Z; call it by its letter, as axis_{letter}</source>
        <translation>Gelenk {joint} läuft entlang keiner von X, Y, Z; nennen Sie es nach seinem Buchstaben, etwa axis_{letter}</translation>
    </message>
    <message>
        <source>joint {joint}, {error}</source>
        <translation>Gelenk {joint}, {error}</translation>
    </message>
    <message>
        <source>joint {name}</source>
        <translation>Gelenk {name}</translation>
    </message>
    <message>
        <source>keep has shape {shape}: give one value for each of the {count} facets</source>
        <translation>keep hat die Form {shape}: für jede der {count} Facetten einen Wert angeben</translation>
    </message>
    <message>
        <source>key {key} is not known; leave it out</source>
        <translation>Schlüssel {key} ist nicht bekannt; weglassen</translation>
    </message>
    <message>
        <source>key {key} stands twice in one object; remove one</source>
        <translation>der Schlüssel {key} steht zweimal in einem Objekt; einen entfernen</translation>
    </message>
    <message>
        <source>known are {dialects}</source>
        <translation>bekannt sind {dialects}</translation>
    </message>
    <message>
        <source>known are {modules}</source>
        <translation>bekannt sind {modules}</translation>
    </message>
    <message>
        <source>known: {names}, or give a {suffix} file</source>
        <translation>bekannt: {names}, oder eine {suffix}-Datei angeben</translation>
    </message>
    <message>
        <source>largest axis angle {angle} is out of range; give more than 0 and at most 180 deg</source>
        <translation>größter Achswinkel {angle} liegt außerhalb; mehr als 0 und höchstens 180° angeben</translation>
    </message>
    <message>
        <source>largest axis angle {angle} is out of range; it must be above 0 and at most 180</source>
        <translation>Größter Achswinkel {angle} liegt außerhalb des Bereichs; er muss über 0 und höchstens 180 sein</translation>
    </message>
    <message>
        <source>lead-in or lead-out arcs are smaller than asked, or none</source>
        <translation>Bögen zum An- oder Wegfahren sind kleiner als verlangt oder fehlen</translation>
    </message>
    <message>
        <source>leave Z out</source>
        <translation>Z weglassen</translation>
    </message>
    <message>
        <source>leave the CL path between their ends, which lie on it: the axes' even motion carries the tip off. Divide blocks ({linearize}).</source>
        <translation>verlassen den CL-Weg zwischen ihren Enden, die auf ihm liegen: die gleichmäßige Bewegung der Achsen trägt die Spitze hinaus. Sätze teilen ({linearize}).</translation>
    </message>
    <message>
        <source>leave the CL path out along the tool and come back to the same place: ways of the post's own, as to rewind.</source>
        <translation>verlassen den CL-Weg entlang des Werkzeugs und kommen an dieselbe Stelle zurück: eigene Wege des Postprozessors, etwa zum Zurückdrehen.</translation>
    </message>
    <message>
        <source>leave the CL path, and end off it: a word is wrong there, or they are moves of the post's own, as retracts.</source>
        <translation>verlassen den CL-Weg und enden neben ihm: dort ist ein Wort falsch, oder es sind eigene Bewegungen des Postprozessors, etwa Rückzüge.</translation>
    </message>
    <message>
        <source>length; write it as 6 mm or 0.25 in</source>
        <translation>Länge; als 6 mm oder 0.25 in schreiben</translation>
    </message>
    <message>
        <source>let blocks be divided ({divide})</source>
        <translation>NC-Sätze teilen lassen ({divide})</translation>
    </message>
    <message>
        <source>lies outside the region</source>
        <translation>außerhalb des Bereichs liegt</translation>
    </message>
    <message>
        <source>limits and rates are assumed: no row tells them</source>
        <translation>Grenzen und Geschwindigkeiten sind angenommen, keine Zeile nennt sie</translation>
    </message>
    <message>
        <source>limits min {low} is not below max {high}; swap or widen them</source>
        <translation>die Grenzen: das Minimum {low} liegt nicht unter dem Maximum {high}; tauschen oder erweitern</translation>
    </message>
    <message>
        <source>line 1, column 1: the CL file holds no GOTO statement</source>
        <translation>Zeile 1, Spalte 1: die CL-Datei enthält keine GOTO-Anweisung</translation>
    </message>
    <message>
        <source>line 1, column 1: the GOTO statements cannot be read</source>
        <translation>Zeile 1, Spalte 1: die GOTO-Anweisungen sind nicht lesbar</translation>
    </message>
    <message>
        <source>line {line} is no Python 3 ({what}); correct it</source>
        <translation>Zeile {line} ist kein Python 3 ({what}); berichtigen Sie sie</translation>
    </message>
    <message>
        <source>line {line}, column {at}: {reason}: {found}</source>
        <translation>Zeile {line}, Spalte {at}: {reason}: {found}</translation>
    </message>
    <message>
        <source>line {line}, column {column}: byte {control}: this is no NC text; give a plain text file</source>
        <translation>Zeile {line}, Spalte {column}: Byte {control}: das ist kein NC-Text; eine reine Textdatei angeben</translation>
    </message>
    <message>
        <source>line {line}, column {column}: {reason}</source>
        <translation>Zeile {line}, Spalte {column}: {reason}</translation>
    </message>
    <message>
        <source>line {line}: calls are nested deeper than {most}; does a subprogram call itself? Post the moves themselves</source>
        <translation>Zeile {line}: Aufrufe sind tiefer als {most} geschachtelt; ruft ein Unterprogramm sich selbst auf? Die Bewegungen selbst ausgeben</translation>
    </message>
    <message>
        <source>line {line}: digits stand right behind a call, and no letter before them: {found}</source>
        <translation>Zeile {line}: direkt hinter einem Aufruf stehen Ziffern, und vor ihnen kein Buchstabe: {found}</translation>
    </message>
    <message>
        <source>line {line}: the cycles make more than {most} moves; divide the program</source>
        <translation>Zeile {line}: die Zyklen ergeben mehr als {most} Bewegungen; das Programm teilen</translation>
    </message>
    <message>
        <source>line {line}: the loop does not end: {most} lines were run; correct its condition, or post the moves themselves</source>
        <translation>Zeile {line}: die Schleife endet nicht: {most} Zeilen wurden ausgeführt; ihre Bedingung berichtigen oder die Bewegungen selbst ausgeben</translation>
    </message>
    <message>
        <source>line {line}: {error}</source>
        <translation>Zeile {line}: {error}</translation>
    </message>
    <message>
        <source>line {line}: {file} is not found; put it beside the model</source>
        <translation>Zeile {line}: {file} ist nicht zu finden; legen Sie sie neben das Modell</translation>
    </message>
    <message>
        <source>line {line}: {text}</source>
        <translation>Zeile {line}: {text}</translation>
    </message>
    <message>
        <source>line {number}, column {column}: {reason}: {statement}</source>
        <translation>Zeile {number}, Spalte {column}: {reason}: {statement}</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linear</translation>
    </message>
    <message>
        <source>lines that a switch of the control skips</source>
        <translation>Zeilen, die ein Schalter der Steuerung überspringt</translation>
    </message>
    <message>
        <source>lines {line} and {other} both move tool or work by {letter}; one of them can be right</source>
        <translation>die Zeilen {line} und {other} bewegen beide Werkzeug oder Werkstück mit {letter}; nur eine kann stimmen</translation>
    </message>
    <message>
        <source>link {name}</source>
        <translation>Link {name}</translation>
    </message>
    <message>
        <source>links or rewinds go higher, round bodies of the machine</source>
        <translation>Verbindungen oder Rückdrehungen fahren höher, um Maschinenkörper herum</translation>
    </message>
    <message>
        <source>low and high are one point</source>
        <translation>low und high sind ein Punkt</translation>
    </message>
    <message>
        <source>low is not below high in each of X, Y, Z</source>
        <translation>low liegt nicht in jedem von X, Y, Z unter high</translation>
    </message>
    <message>
        <source>machine file {output} needs the ending .fcm</source>
        <translation>die Maschinendatei {output} braucht die Endung .fcm</translation>
    </message>
    <message>
        <source>machine in the way</source>
        <translation>Maschine im Weg</translation>
    </message>
    <message>
        <source>machine {name} has a rotary head: give {tool_length}, gauge point to tip</source>
        <translation>die Maschine {name} hat einen Schwenkkopf: {tool_length} angeben, vom Bezugspunkt bis zur Werkzeugspitze</translation>
    </message>
    <message>
        <source>machine {name} has fewer than two rotary axes, and only five axes are recovered: leave {machine} out</source>
        <translation>die Maschine {name} hat weniger als zwei Rundachsen, und nur fünf Achsen werden zurückgewonnen: {machine} weglassen</translation>
    </message>
    <message>
        <source>machine {name} has fewer than two rotary axes: the proof of signs turns two; jog each axis and compare with the machine file</source>
        <translation>die Maschine {name} hat weniger als zwei Rundachsen, der Nachweis der Vorzeichen dreht zwei: jede Achse von Hand fahren und mit der Maschinendatei vergleichen</translation>
    </message>
    <message>
        <source>machine {name} has no rotary axis and cannot lean the tool as {strategy} asks: choose {tool_axis}</source>
        <translation>die Maschine {name} hat keine Rundachse und kann das Werkzeug nicht neigen, wie {strategy} es verlangt: {tool_axis} wählen</translation>
    </message>
    <message>
        <source>machine {name} has no rotary axis and cannot lean the tool: choose {gouge}</source>
        <translation>die Maschine {name} hat keine Rundachse und kann das Werkzeug nicht neigen: {gouge} wählen</translation>
    </message>
    <message>
        <source>machine {name} has no rotary axis and cannot lean the tool: leave {option} out</source>
        <translation>die Maschine {name} hat keine Rundachse und kann das Werkzeug nicht neigen: {option} weglassen</translation>
    </message>
    <message>
        <source>machine {name} has no rotary axis: its tip leaves no line wherever the part is clamped; put it where the travel reaches</source>
        <translation>die Maschine {name} hat keine Rundachse: ihre Spitze verlässt die Gerade nicht, wo immer gespannt wird; dort spannen, wohin die Verfahrwege reichen</translation>
    </message>
    <message>
        <source>machine {name} has two axes of the same letter: {letters}</source>
        <translation>die Maschine {name} hat zwei Achsen mit demselben Buchstaben: {letters}</translation>
    </message>
    <message>
        <source>machine {name} has {count}; needs 3 and at most 2</source>
        <translation>die Maschine {name} hat {count}; gebraucht werden 3 und höchstens 2</translation>
    </message>
    <message>
        <source>machine {name}: its only rotary axis {letter} is parallel to the tool and never tilts it; leave it out of the file</source>
        <translation>Maschine {name}: ihre einzige Rundachse {letter} ist parallel zum Werkzeug und neigt es nie; in der Datei weglassen</translation>
    </message>
    <message>
        <source>machine {name}: singular_cone {cone} is not between 0 and 90</source>
        <translation>Maschine {name}: singular_cone {cone} liegt nicht zwischen 0 und 90</translation>
    </message>
    <message>
        <source>machine {name}: table {table} is beyond {farthest}</source>
        <translation>Maschine {name}: der Tisch {table} liegt jenseits von {farthest}</translation>
    </message>
    <message>
        <source>machine {name}: {letters} does not name the table's axes before the head's</source>
        <translation>Maschine {name}: {letters} nennt nicht die Achsen des Tisches vor denen des Kopfes</translation>
    </message>
    <message>
        <source>machine {name}: {problem}</source>
        <translation>Maschine {name}: {problem}</translation>
    </message>
    <message>
        <source>machines are compared on a toolpath: select a toolpath</source>
        <translation>Maschinen werden an einem Werkzeugweg verglichen: einen Werkzeugweg auswählen</translation>
    </message>
    <message>
        <source>maximum acceleration {max_acceleration} is not positive; give what the drive reaches</source>
        <translation>die größte Beschleunigung {max_acceleration} ist nicht positiv; geben Sie an, was der Antrieb erreicht</translation>
    </message>
    <message>
        <source>maximum rate {max_rate} is not positive; give what the drive reaches</source>
        <translation>die größte Geschwindigkeit {max_rate} ist nicht über 0; angeben, was der Antrieb erreicht</translation>
    </message>
    <message>
        <source>maxkins shows wrong positions where B and C are both off zero: its forward formula does not fit the one that moves the joints. The machine is that of the latter; home it with B or C at 0.</source>
        <translation>maxkins zeigt falsche Positionen, wo B und C beide nicht null sind: Seine Vorwärtsformel passt nicht zu der, welche die Gelenke bewegt. Die Maschine ist die der letzteren; referenzieren Sie mit B oder C auf 0.</translation>
    </message>
    <message>
        <source>maxkins turns the tool length with the head only where it is a W offset of the tool table; enter it there.</source>
        <translation>maxkins dreht die Werkzeuglänge nur dann mit dem Kopf, wenn sie in der Werkzeugtabelle als Versatz in W steht; tragen Sie sie dort ein.</translation>
    </message>
    <message>
        <source>more than scallops stays uncut on {value}</source>
        <translation>mehr als Kuppen bleibt auf {value} stehen</translation>
    </message>
    <message>
        <source>more than the scallop stays</source>
        <translation>mehr als die Kuppenhöhe bleibt stehen</translation>
    </message>
    <message>
        <source>more than the tolerance is missing on the surface</source>
        <translation>auf der Oberfläche fehlt mehr als die Toleranz</translation>
    </message>
    <message>
        <source>more than {most_planes} planes; give a larger {what} or check the units of the part</source>
        <translation>mehr als {most_planes} Ebenen; {what} vergrößern oder die Einheiten des Werkstücks prüfen</translation>
    </message>
    <message>
        <source>more than {most} brackets in brackets</source>
        <translation>mehr als {most} Klammern in Klammern</translation>
    </message>
    <message>
        <source>move the work zero ({origin}) or take a larger machine.</source>
        <translation>den Werkstücknullpunkt versetzen ({origin}) oder eine größere Maschine nehmen.</translation>
    </message>
    <message>
        <source>moves to machine positions unknown to the program; they and the ways back from there are not audited</source>
        <translation>Bewegungen zu Maschinenpositionen, die das Programm nicht kennt; sie und die Wege von dort zurück werden nicht geprüft</translation>
    </message>
    <message>
        <source>moves to positions of the machine, which are not known</source>
        <translation>es geht an Maschinenpositionen, die nicht bekannt sind</translation>
    </message>
    <message>
        <source>moves without an axis keep the last one, which leans</source>
        <translation>Bewegungen ohne Achse behalten die letzte, die geneigt ist</translation>
    </message>
    <message>
        <source>name another file</source>
        <translation>eine andere Datei nennen</translation>
    </message>
    <message>
        <source>name another file ({task} takes CL files)</source>
        <translation>eine andere Datei nennen ({task} nimmt CL-Dateien)</translation>
    </message>
    <message>
        <source>name another file ({task} takes NC programs)</source>
        <translation>eine andere Datei nennen ({task} nimmt NC-Programme)</translation>
    </message>
    <message>
        <source>name another file ({task} takes job files)</source>
        <translation>eine andere Datei nennen ({task} nimmt Auftragsdateien)</translation>
    </message>
    <message>
        <source>name another file ({task} takes parts)</source>
        <translation>eine andere Datei nennen ({task} nimmt Werkstücke)</translation>
    </message>
    <message>
        <source>neighbouring facets disagree about which side is outside</source>
        <translation>benachbarte Facetten sind uneins, welche Seite außen ist</translation>
    </message>
    <message>
        <source>neither</source>
        <translation>keines von beiden</translation>
    </message>
    <message>
        <source>neither G20 nor G21</source>
        <translation>weder G20 noch G21</translation>
    </message>
    <message>
        <source>neither G70 nor G71 (G700, G710)</source>
        <translation>weder G70 noch G71 (G700, G710)</translation>
    </message>
    <message>
        <source>neither MM nor INCH in BEGIN PGM</source>
        <translation>weder MM noch INCH in BEGIN PGM</translation>
    </message>
    <message>
        <source>neither mm nor inches are named</source>
        <translation>weder mm noch Zoll sind genannt</translation>
    </message>
    <message>
        <source>no HAL file sets an offset, so LinuxCNC's own value is taken</source>
        <translation>keine HAL-Datei setzt einen Versatz, daher gilt der Wert von LinuxCNC</translation>
    </message>
    <message>
        <source>no NC file named; give one with -o OUT.ngc</source>
        <translation>keine NC-Datei genannt; eine mit -o OUT.ngc angeben</translation>
    </message>
    <message>
        <source>no allowed tilt keeps shank and holder out of the part</source>
        <translation>keine erlaubte Neigung hält Schaft und Halter aus dem Teil</translation>
    </message>
    <message>
        <source>no batch.json of a batch is in {folder}; name a folder that one wrote</source>
        <translation>in {folder} ist keine batch.json einer Serie; einen Ordner nennen, den eine geschrieben hat</translation>
    </message>
    <message>
        <source>no block cuts, so nothing can be said of what is left</source>
        <translation>kein NC-Satz fräst, also lässt sich nichts über Restmaterial sagen</translation>
    </message>
    <message>
        <source>no circle fits the words of an arc</source>
        <translation>zu den Wörtern eines Bogens passt kein Kreis</translation>
    </message>
    <message>
        <source>no correction</source>
        <translation>ohne Korrektur</translation>
    </message>
    <message>
        <source>no dask scheduler answers at {address}: {error}; start one, or name another</source>
        <translation>kein Dask-Scheduler antwortet unter {address}: {error}; einen starten oder einen anderen nennen</translation>
    </message>
    <message>
        <source>no distance up to {raises} keeps a machine with wrong signs clear of the mark</source>
        <translation>kein Abstand bis {raises} hält eine Maschine mit falschen Vorzeichen von der Marke frei</translation>
    </message>
    <message>
        <source>no facet can be cut: at no contact of the passes a tool axis is free; use a smaller cutter or holder</source>
        <translation>keine Facette kann bearbeitet werden: an keinem Berührpunkt der Bahnen ist eine Werkzeugachse frei; kleineren Fräser oder Halter nehmen</translation>
    </message>
    <message>
        <source>no facet can be cut: no tool axis is free on any; {remedy}</source>
        <translation>keine Facette kann bearbeitet werden: auf keiner ist eine Werkzeugachse frei; {remedy}</translation>
    </message>
    <message>
        <source>no facet can be cut: over none of those chosen the tool axis may stand</source>
        <translation>keine Facette kann bearbeitet werden: über keiner der gewählten darf die Werkzeugachse stehen</translation>
    </message>
    <message>
        <source>no facet can be cut: the part stands on all that is to be cut; turn it over, or have it cut as it lies with {max_axis_angle}</source>
        <translation>keine Facette kann gefräst werden: Auf allem, was zu fräsen ist, steht das Teil; wenden Sie es, oder lassen Sie es mit {max_axis_angle} fräsen, wie es liegt</translation>
    </message>
    <message>
        <source>no facet can be cut: {across} % of the area lie across the axis of the passes or face it, {beyond} % need a tool axis beyond the machine's rotary limits; give the axis about which the part is turned, or take another machine</source>
        <translation>keine Facette kann bearbeitet werden: {across} % der Fläche liegen quer zur Achse der Bahnen oder sind ihr zugewandt, {beyond} % brauchen eine Werkzeugachse jenseits der Drehgrenzen der Maschine; geben Sie die Achse an, um die das Werkstück gedreht wird, oder nehmen Sie eine andere Maschine</translation>
    </message>
    <message>
        <source>no facet can be cut: {down} % look down, {steep} % lean more than {most}, {beyond} % lie beyond the machine's rotary limits of the area; turn the part, raise the largest axis angle or take another machine</source>
        <translation>keine Facette lässt sich fräsen: {down} % der Fläche zeigen nach unten, {steep} % neigen sich um mehr als {most}, {beyond} % liegen jenseits der Grenzen der Rundachsen; das Werkstück drehen, den größten Achswinkel erhöhen oder eine andere Maschine nehmen</translation>
    </message>
    <message>
        <source>no facet lies across planes at {angle}; turn the direction</source>
        <translation>keine Facette liegt quer zu Ebenen bei {angle}; die Richtung drehen</translation>
    </message>
    <message>
        <source>no facet lies across planes of the normal {given}; turn the normal</source>
        <translation>keine Facette liegt quer zu Ebenen der Normale {given}; die Normale drehen</translation>
    </message>
    <message>
        <source>no facet of the part lies on {name} within {tolerance}; export the faces in the part's own place and units, or raise the tolerance</source>
        <translation>keine Facette des Werkstücks liegt innerhalb {tolerance} auf {name}; die Flächen an ihrem Ort und in den Einheiten des Werkstücks exportieren oder die Toleranz erhöhen</translation>
    </message>
    <message>
        <source>no free axis</source>
        <translation>keine Werkzeugachse frei</translation>
    </message>
    <message>
        <source>no height up to {raises} keeps a machine with wrong signs clear; give a smaller {angle}</source>
        <translation>keine Höhe bis {raises} hält eine Maschine mit falschen Vorzeichen frei; {angle} verringern</translation>
    </message>
    <message>
        <source>no jobs given; name a folder of parts or a table (JSON)</source>
        <translation>keine Aufträge angegeben; nennen Sie einen Ordner mit Teilen oder eine Tabelle (JSON)</translation>
    </message>
    <message>
        <source>no joint moves {table} and {tool} against each other; they make no machine</source>
        <translation>kein Gelenk bewegt {table} und {tool} gegeneinander; das ist keine Maschine</translation>
    </message>
    <message>
        <source>no link is called {words}; name the one that is it</source>
        <translation>kein Link heißt {words}; nennen Sie den so, der es ist</translation>
    </message>
    <message>
        <source>no link within the travel goes round a body of the machine</source>
        <translation>keine Verbindung im Verfahrweg führt an einem Maschinenkörper vorbei</translation>
    </message>
    <message>
        <source>no machine file named; give one with -o OUT.fcm</source>
        <translation>keine Maschinendatei genannt; eine mit -o OUT.fcm angeben</translation>
    </message>
    <message>
        <source>no machine given; name one with {machine} ({list} shows them)</source>
        <translation>keine Maschine gegeben; eine mit {machine} nennen ({list} zeigt sie)</translation>
    </message>
    <message>
        <source>no machine is called {given}; {hint}{known}</source>
        <translation>keine Maschine heißt {given}; {hint}{known}</translation>
    </message>
    <message>
        <source>no machines given; name them with {machines} ({list} shows them)</source>
        <translation>keine Maschinen gegeben; mit {machines} nennen ({list} zeigt sie)</translation>
    </message>
    <message>
        <source>no number of blocks holds the tolerance there</source>
        <translation>dort hält keine Zahl von Sätzen die Toleranz</translation>
    </message>
    <message>
        <source>no part (STL, STEP, FCStd) is in the folder {folder}; name another</source>
        <translation>im Ordner {folder} ist kein Teil (STL, STEP, FCStd); nennen Sie einen anderen</translation>
    </message>
    <message>
        <source>no part of the surface that is to be machined lies inside boundary {name}, which reaches from {low} to {high}; its points are in mm, in the frame of the part</source>
        <translation>nichts von der zu bearbeitenden Oberfläche liegt innerhalb der Begrenzung {name}, die von {low} bis {high} reicht; ihre Punkte sind in mm, im Koordinatensystem des Werkstücks</translation>
    </message>
    <message>
        <source>no pass touches a side of the part</source>
        <translation>keine Bahn berührt eine Seite des Teils</translation>
    </message>
    <message>
        <source>no piece of the surface that is to be cut has both guides on it; give {from_} and {to} on one piece</source>
        <translation>Kein Stück der zu bearbeitenden Fläche trägt beide Leitlinien; {from_} und {to} auf einem Stück angeben</translation>
    </message>
    <message>
        <source>no position keeps the axes within their limits</source>
        <translation>keine Stellung hält die Achsen in ihren Grenzen</translation>
    </message>
    <message>
        <source>no position on the table is free</source>
        <translation>keine Stellung auf dem Tisch ist frei</translation>
    </message>
    <message>
        <source>no program given; name the NC file that was posted from the CL path</source>
        <translation>kein Programm gegeben; die NC-Datei nennen, die aus dem CL-Weg ausgegeben wurde</translation>
    </message>
    <message>
        <source>no stick-out of the tool within reason keeps the holder free</source>
        <translation>keine vernünftige Auskragung des Werkzeugs hält den Halter frei</translation>
    </message>
    <message>
        <source>no such key; did you mean {near}?</source>
        <translation>diesen Schlüssel gibt es nicht; ist {near} gemeint?</translation>
    </message>
    <message>
        <source>no tilted plane is on</source>
        <translation>keine geschwenkte Ebene ist aktiv</translation>
    </message>
    <message>
        <source>no tool</source>
        <translation>kein Werkzeug</translation>
    </message>
    <message>
        <source>no tool axis is free at these facets</source>
        <translation>an Facetten ist keine Werkzeugachse frei</translation>
    </message>
    <message>
        <source>no tool axis keeps the tool out of part, fixtures and table</source>
        <translation>keine Werkzeugachse hält das Werkzeug aus Teil, Spannmitteln und Tisch</translation>
    </message>
    <message>
        <source>no tool length is active where the program feeds</source>
        <translation>im Vorschub ist keine Werkzeuglänge wirksam</translation>
    </message>
    <message>
        <source>no tool {number}</source>
        <translation>kein Werkzeug {number}</translation>
    </message>
    <message>
        <source>no value: {rest}</source>
        <translation>kein Wert: {rest}</translation>
    </message>
    <message>
        <source>no way to stand lies within the limits of the rotary axes</source>
        <translation>keine Stellung liegt in den Grenzen der Rundachsen</translation>
    </message>
    <message>
        <source>no {option}</source>
        <translation>kein {option}</translation>
    </message>
    <message>
        <source>no_motion: {name} is no function that can be passed over; write one each as M202, G05 P10000, CYCL DEF 392 (300 to 399, 500 to 599) or FUNCTION NAME</source>
        <translation>no_motion: {name} ist keine Funktion, die übergangen werden kann; jede für sich schreiben wie M202, G05 P10000, CYCL DEF 392 (300 bis 399, 500 bis 599) oder FUNCTION NAME</translation>
    </message>
    <message>
        <source>no_motion: {name} moves the tool or ends a program; leave it out</source>
        <translation>no_motion: {name} bewegt das Werkzeug oder beendet ein Programm; weglassen</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>none asked for</source>
        <translation>keine verlangt</translation>
    </message>
    <message>
        <source>none of the {count} facets has an area: check the units and the export</source>
        <translation>keine der {count} Facetten hat eine Fläche: Einheiten und Export prüfen</translation>
    </message>
    <message>
        <source>not all its values are given, or others</source>
        <translation>nicht alle ihre Werte sind gegeben, oder andere</translation>
    </message>
    <message>
        <source>not checked against the part</source>
        <translation>nicht gegen das Werkstück geprüft</translation>
    </message>
    <message>
        <source>not known and not interpreted; what it does is missing here</source>
        <translation>nicht bekannt und nicht ausgewertet; was es tut, fehlt hier</translation>
    </message>
    <message>
        <source>not part of any word</source>
        <translation>gehört zu keinem Wort</translation>
    </message>
    <message>
        <source>nothing ends the program</source>
        <translation>nichts beendet das Programm</translation>
    </message>
    <message>
        <source>nothing in it moves tool or work by {letters}</source>
        <translation>nichts darin bewegt Werkzeug oder Werkstück mit {letters}</translation>
    </message>
    <message>
        <source>nothing is left to cut: {why}; use a smaller allowance or tool</source>
        <translation>nichts bleibt zu fräsen: {why}; nehmen Sie einen kleineren Abstand oder ein kleineres Werkzeug</translation>
    </message>
    <message>
        <source>nothing of what is to be machined can be cut {allowance} off the faces to avoid; give a smaller allowance or cutter</source>
        <translation>nichts von dem, was gefräst werden soll, lässt sich mit {allowance} Abstand zu den ausgesparten Flächen fräsen; geben Sie einen kleineren Abstand oder Fräser an</translation>
    </message>
    <message>
        <source>nothing says where {letters} stand and which carries which; copy the file of a shipped machine with these axes ({alike}) and write their lines, signs, limits and rates into it by hand (docs/adding.md)</source>
        <translation>nichts sagt, wo {letters} stehen und welche welche trägt; die Datei einer mitgelieferten Maschine mit diesen Achsen kopieren ({alike}) und ihre Linien, Vorzeichen, Grenzen und Geschwindigkeiten von Hand hineinschreiben (docs/adding.md)</translation>
    </message>
    <message>
        <source>nothing says where {letters} stand and which carries which; describe the machine by hand (docs/adding.md)</source>
        <translation>nichts sagt, wo {letters} stehen und welche welche trägt; beschreiben Sie die Maschine von Hand (docs/adding.md)</translation>
    </message>
    <message>
        <source>nothing that is to be cut faces away from the axis of the passes; give the axis about which the part is turned</source>
        <translation>nichts, was bearbeitet werden soll, ist von der Achse der Bahnen abgewandt; geben Sie die Achse an, um die das Werkstück gedreht wird</translation>
    </message>
    <message>
        <source>of the ball's centre</source>
        <translation>der Kugelmitte</translation>
    </message>
    <message>
        <source>of the part</source>
        <translation>des Teils</translation>
    </message>
    <message>
        <source>of the tip</source>
        <translation>der Spitze</translation>
    </message>
    <message>
        <source>of what is to be machined</source>
        <translation>der zu bearbeitenden Fläche</translation>
    </message>
    <message>
        <source>of what stays a fixture keeps the tool off so much</source>
        <translation>von dem, was stehen bleibt, hält ein Spannmittel das Werkzeug von so viel ab</translation>
    </message>
    <message>
        <source>of what stays so much is tighter than the cutter</source>
        <translation>von dem, was stehen bleibt, ist so viel enger als der Fräser</translation>
    </message>
    <message>
        <source>of what stays the table keeps the tool off so much</source>
        <translation>von dem, was stehen bleibt, hält der Tisch das Werkzeug von so viel ab</translation>
    </message>
    <message>
        <source>on every pass</source>
        <translation>auf jeder Bahn</translation>
    </message>
    <message>
        <source>on its way out along its axis the tool would come nearer to the faces to avoid {where} than {allowance}, as at {place}</source>
        <translation>das Werkzeug käme {where} auf seinem Weg entlang seiner Achse heraus den ausgesparten Flächen näher als {allowance}, etwa bei {place}</translation>
    </message>
    <message>
        <source>on its way to its first or from its last place the tool passes through the part</source>
        <translation>auf dem Weg zur ersten oder von der letzten Stelle fährt das Werkzeug durch das Teil</translation>
    </message>
    <message>
        <source>on rapids that holds for each rate at which the axes may run beside each other</source>
        <translation>im Eilgang gilt das für jedes Verhältnis der Geschwindigkeiten, in dem die Achsen laufen mögen</translation>
    </message>
    <message>
        <source>on {uncut} more than {allowed} is left, at most {most}</source>
        <translation>auf {uncut} bleibt mehr als {allowed} stehen, höchstens {most}</translation>
    </message>
    <message>
        <source>one link must carry all others and hang from none; of it hang from none: {roots}</source>
        <translation>ein Link muss alle anderen tragen und an keinem hängen; hier hängen an keinem: {roots}</translation>
    </message>
    <message>
        <source>one more</source>
        <translation>noch eine</translation>
    </message>
    <message>
        <source>only a part of the chosen faces lies on the mesh</source>
        <translation>nur ein Teil der gewählten Flächen liegt auf dem Netz</translation>
    </message>
    <message>
        <source>only a toolpath can be post-processed: select a toolpath</source>
        <translation>nur ein Werkzeugweg kann als NC-Datei ausgegeben werden: einen Werkzeugweg auswählen</translation>
    </message>
    <message>
        <source>only the cutter's own feed moves were checked against the part ({off})</source>
        <translation>nur die Vorschubbewegungen des Fräsers selbst wurden gegen das Teil geprüft ({off})</translation>
    </message>
    <message>
        <source>only the end points of {guided} of {all} feed blocks are verified: the path between them is under RTCP</source>
        <translation>nur die Endpunkte von {guided} der {all} Vorschubsätze sind nachgewiesen: dazwischen gilt RTCP</translation>
    </message>
    <message>
        <source>only {count} of {rows} CL rows can be paired with the program's {blocks} blocks; give a program that was posted from this CL path</source>
        <translation>nur {count} von {rows} CL-Zeilen lassen sich den {blocks} NC-Sätzen des Programms zuordnen; ein Programm angeben, das aus diesem CL-Weg entstand</translation>
    </message>
    <message>
        <source>order is {order}; choose one of {orders}</source>
        <translation>die Reihenfolge ist {order}; eine wählen von {orders}</translation>
    </message>
    <message>
        <source>other fixtures, the machine's own bodies, and stock that is still there</source>
        <translation>andere Spannmittel, die Körper der Maschine selbst und Rohmaterial, das noch da ist</translation>
    </message>
    <message>
        <source>other layouts of axes explain the rows as well</source>
        <translation>andere Anordnungen der Achsen erklären die Zeilen ebenso gut</translation>
    </message>
    <message>
        <source>part</source>
        <translation>Werkstück</translation>
    </message>
    <message>
        <source>part and fixtures</source>
        <translation>Werkstück und Spannmittel</translation>
    </message>
    <message>
        <source>part {file} cannot be meshed: {reason}</source>
        <translation>das Teil {file} kann nicht vernetzt werden: {reason}</translation>
    </message>
    <message>
        <source>part {file} cannot be read: {strerror}</source>
        <translation>das Teil {file} kann nicht gelesen werden: {strerror}</translation>
    </message>
    <message>
        <source>part, path or limits look as if they were in another unit</source>
        <translation>Teil, Bahn oder Grenzen sehen nach einer anderen Einheit aus</translation>
    </message>
    <message>
        <source>parts of the file that are no NC text</source>
        <translation>Teile der Datei sind kein NC-Text</translation>
    </message>
    <message>
        <source>parts of the machine's model are not read</source>
        <translation>Teile des Modells der Maschine sind nicht gelesen</translation>
    </message>
    <message>
        <source>passes along X, in direction {angle}</source>
        <translation>Bahnen entlang X, in Richtung {angle}</translation>
    </message>
    <message>
        <source>passes along Y, in direction {angle}</source>
        <translation>Bahnen entlang Y, in Richtung {angle}</translation>
    </message>
    <message>
        <source>passes are farther apart than the cutter is wide</source>
        <translation>die Bahnen liegen weiter auseinander, als der Fräser breit ist</translation>
    </message>
    <message>
        <source>passes are near to each other, for the cutter stands aslant</source>
        <translation>Bahnen liegen eng beieinander, weil der Fräser schräg steht</translation>
    </message>
    <message>
        <source>passes cannot begin at {place}: it is {off} off the surface that is to be cut; give a place or a curve on it</source>
        <translation>Bahnen können nicht bei {place} beginnen: Das liegt {off} neben der zu fräsenden Fläche; einen Ort oder eine Kurve auf ihr angeben</translation>
    </message>
    <message>
        <source>passes end at edges with more than two facets</source>
        <translation>Bahnen enden an Kanten mit mehr als zwei Facetten</translation>
    </message>
    <message>
        <source>passes end at the boundary</source>
        <translation>Bahnen enden an der Begrenzung</translation>
    </message>
    <message>
        <source>passes in direction {angle}</source>
        <translation>Bahnen in Richtung {angle}</translation>
    </message>
    <message>
        <source>passes near the pole that could not be turned past it any better</source>
        <translation>Bahnen nahe am Pol ließen sich nicht besser an ihm vorbei drehen</translation>
    </message>
    <message>
        <source>passes so close would be {length} long, more than any job can want; give a larger stepover or scallop, or check the units of the part</source>
        <translation>so dichte Bahnen wären {length} lang, mehr als ein Auftrag wollen kann; einen größeren Bahnabstand oder eine größere Rauhöhe angeben, oder die Einheit des Teils prüfen</translation>
    </message>
    <message>
        <source>passes stand no closer than the least interval, and up to {value} high stays between them</source>
        <translation>die Bahnen liegen nicht dichter als der kleinste Abstand, und bis zu {value} hoch bleibt zwischen ihnen stehen</translation>
    </message>
    <message>
        <source>passes that turn in corners or end at edges leave more than the scallop there</source>
        <translation>wo Bahnen in Ecken umlenken oder an Kanten enden, bleiben höhere Kuppen stehen</translation>
    </message>
    <message>
        <source>passes were turned past the machine's pole</source>
        <translation>Bahnen wurden am Pol der Maschine vorbei gedreht</translation>
    </message>
    <message>
        <source>pivot-length is a constant {pivot}, so LinuxCNC takes the same tool length for every tool; add motion.tooloffset.z to it by a sum2, or measure tools from the tip of that one.</source>
        <translation>pivot-length ist fest {pivot}, LinuxCNC rechnet also bei jedem Werkzeug mit derselben Länge; addieren Sie motion.tooloffset.z mit einem sum2, oder messen Sie Werkzeuge von der Spitze dieses einen aus.</translation>
    </message>
    <message>
        <source>plane normal {given} has no direction; give I,J,K across the planes, as 0,0,1</source>
        <translation>die Ebenennormale {given} hat keine Richtung; I,J,K quer zu den Ebenen angeben, etwa 0,0,1</translation>
    </message>
    <message>
        <source>plane offset {offset} follows {before}: give them ascending</source>
        <translation>der Ebenenabstand {offset} folgt auf {before}: aufsteigend angeben</translation>
    </message>
    <message>
        <source>plane offsets have shape {shape}: give one ascending row of numbers</source>
        <translation>die Ebenenabstände haben die Form {shape}: eine aufsteigende Reihe von Zahlen angeben</translation>
    </message>
    <message>
        <source>polar coordinates, whose moves are missing</source>
        <translation>Polarkoordinaten, deren Bewegungen fehlen</translation>
    </message>
    <message>
        <source>polar coordinates, whose moves are missing here; post X, Y and Z</source>
        <translation>Polarkoordinaten, deren Bewegungen hier fehlen; X, Y und Z ausgeben</translation>
    </message>
    <message>
        <source>program O{program} is not in this file; put it there, behind what calls it</source>
        <translation>Programm O{program} ist nicht in dieser Datei; es dort hinter das setzen, was es aufruft</translation>
    </message>
    <message>
        <source>program number is {program}; give 1 to 9999</source>
        <translation>die Programmnummer ist {program}; 1 bis 9999 angeben</translation>
    </message>
    <message>
        <source>programs for {name} are in mm, also on a control that shows inches; leave {option} out</source>
        <translation>Programme für {name} sind in mm, auch auf einer Steuerung, die Zoll anzeigt; lassen Sie {option} weg</translation>
    </message>
    <message>
        <source>radius {radii} is not above 0, or beyond {most} mm</source>
        <translation>Radius {radii} ist nicht größer als 0 oder jenseits von {most} mm</translation>
    </message>
    <message>
        <source>rapids were divided, so that every way of the axes is free</source>
        <translation>Eilgänge wurden geteilt, damit jeder Weg der Achsen frei ist</translation>
    </message>
    <message>
        <source>rapids, shank and holder were not looked at</source>
        <translation>Eilgänge, Schaft und Halter wurden nicht geprüft</translation>
    </message>
    <message>
        <source>reachable</source>
        <translation>erreichbar</translation>
    </message>
    <message>
        <source>region 0,0,0 with 1 turn has one setup only; give {region} a way to go along X, Y or Z, or {turns} above 1</source>
        <translation>der Bereich 0,0,0 mit 1 Drehung hat nur eine Aufspannung; {region} einen Weg entlang X, Y oder Z geben, oder {turns} über 1</translation>
    </message>
    <message>
        <source>report {path} needs one of the endings {reports}</source>
        <translation>der Bericht {path} braucht eine der Endungen {reports}</translation>
    </message>
    <message>
        <source>retract Z {z} is not finite; give a machine coordinate</source>
        <translation>Rückzug: Z {z} ist nicht endlich; eine Maschinenkoordinate angeben</translation>
    </message>
    <message>
        <source>retract {retract} is none of {retracts}</source>
        <translation>Rückzug: {retract} ist keines von {retracts}</translation>
    </message>
    <message>
        <source>retract {retract} takes no such key; leave it out</source>
        <translation>Rückzug: {retract} nimmt keinen solchen Schlüssel; weglassen</translation>
    </message>
    <message>
        <source>retract {retract}: {remedy}</source>
        <translation>Rückzug {retract}: {remedy}</translation>
    </message>
    <message>
        <source>retracts or approaches pass below the part</source>
        <translation>Wege zum Ab- oder Anfahren führen unter dem Teil hindurch</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechte</translation>
    </message>
    <message>
        <source>rises from its last place</source>
        <translation>steigt von seinem letzten Ort</translation>
    </message>
    <message>
        <source>rotary</source>
        <translation>rotatorisch</translation>
    </message>
    <message>
        <source>rotary axes turn before G255 has ended it</source>
        <translation>Rundachsen drehen, bevor G255 sie beendet hat</translation>
    </message>
    <message>
        <source>rotary axes turn evenly in divided blocks</source>
        <translation>Rundachsen drehen in geteilten Sätzen gleichmäßig</translation>
    </message>
    <message>
        <source>rotary words with a direction (ACP, ACN); taken by the shorter way. Post absolute words</source>
        <translation>Rundachswörter mit Drehsinn (ACP, ACN); auf dem kürzeren Weg genommen. Absolute Wörter ausgeben</translation>
    </message>
    <message>
        <source>roundings, chamfers or angles of a contour</source>
        <translation>Rundungen, Fasen oder Winkel einer Kontur werden nicht verstanden</translation>
    </message>
    <message>
        <source>roundings, chamfers or angles of a contour, whose moves are missing here; post straight moves and arcs</source>
        <translation>Rundungen, Fasen oder Winkel einer Kontur, deren Bewegungen hier fehlen; Geraden und Kreisbögen ausgeben</translation>
    </message>
    <message>
        <source>row {row} of the CL path is a feed move with feed {value}; give a feed above 0</source>
        <translation>Zeile {row} des CL-Wegs ist eine Vorschubbewegung mit dem Vorschub {value}; einen Vorschub über 0 angeben</translation>
    </message>
    <message>
        <source>rows of an arc run against its sense</source>
        <translation>Zeilen eines Bogens laufen gegen seinen Sinn</translation>
    </message>
    <message>
        <source>rows of passes that are close together were merged</source>
        <translation>Bahnpunkte, die dicht beieinander liegen, wurden zusammengefasst</translation>
    </message>
    <message>
        <source>rows of the control's table, whose distance is not known; the blocks between are not right. Audit each part on its own</source>
        <translation>Zeilen der Tabelle der Steuerung, deren Abstand nicht bekannt ist; die Sätze dazwischen stimmen nicht. Jeden Teil für sich prüfen</translation>
    </message>
    <message>
        <source>rows of the path that no block reaches</source>
        <translation>Zeilen der Bahn, die kein Satz erreicht</translation>
    </message>
    <message>
        <source>rows that do not fit the machine are left out</source>
        <translation>Zeilen, die nicht zur Maschine passen, sind ausgelassen</translation>
    </message>
    <message>
        <source>scallop and stepover exclude each other; give one of them</source>
        <translation>Kuppenhöhe und Zeilensprung schließen einander aus; eines davon angeben</translation>
    </message>
    <message>
        <source>scallop {scallop} is not below the cutter radius {radius}; give a smaller scallop</source>
        <translation>die Kuppenhöhe {scallop} liegt nicht unter dem Fräserradius {radius}; eine kleinere angeben</translation>
    </message>
    <message>
        <source>scallop {value} needs about {samples} samples of its passes, more than {most}; give a larger scallop or check the units of the part</source>
        <translation>die Kuppenhöhe {value} braucht etwa {samples} Stützpunkte ihrer Bahnen, mehr als {most}; eine größere angeben oder die Einheiten des Werkstücks prüfen</translation>
    </message>
    <message>
        <source>select a solid, faces of a solid, a body, a compound of solids, or a mesh</source>
        <translation>einen Volumenkörper, Flächen eines solchen, einen Körper (Body), einen Verbund von Volumenkörpern oder ein Netz auswählen</translation>
    </message>
    <message>
        <source>setup grid {count} with {turns} turns has no place; give at least 1</source>
        <translation>das Raster {count} mit {turns} Drehungen hat keinen Platz; mindestens 1 angeben</translation>
    </message>
    <message>
        <source>setup region {box}: {why}</source>
        <translation>Bereich der Aufspannungen {box}: {why}</translation>
    </message>
    <message>
        <source>setup region {low} to {high} is not finite or beyond {farthest}</source>
        <translation>der Bereich {low} bis {high} ist nicht endlich oder jenseits von {farthest}</translation>
    </message>
    <message>
        <source>setup region {low} to {high}: the low corner is above the high; swap them</source>
        <translation>der Bereich {low} bis {high}: die untere Ecke liegt über der oberen; tauschen</translation>
    </message>
    <message>
        <source>setups are passed over: the machine is hit there</source>
        <translation>Aufspannungen sind übergangen, in denen die Maschine getroffen wird</translation>
    </message>
    <message>
        <source>setups are tried for a toolpath: select a toolpath</source>
        <translation>Aufspannungen werden für einen Werkzeugweg erprobt: einen Werkzeugweg auswählen</translation>
    </message>
    <message>
        <source>shank</source>
        <translation>Schaft</translation>
    </message>
    <message>
        <source>shank and holder: none were given</source>
        <translation>Schaft und Halter: es wurden keine angegeben</translation>
    </message>
    <message>
        <source>shank in the way</source>
        <translation>Schaft im Weg</translation>
    </message>
    <message>
        <source>shank or holder enters the part</source>
        <translation>Schaft oder Halter dringt ins Teil ein</translation>
    </message>
    <message>
        <source>shank or holder hits the part</source>
        <translation>Schaft oder Halter trifft das Werkstück</translation>
    </message>
    <message>
        <source>shifts, turns or scales of the coordinates</source>
        <translation>Verschiebungen, Drehungen oder Skalierungen der Koordinaten werden nicht verstanden</translation>
    </message>
    <message>
        <source>shifts, turns or scales of the coordinates; post without them</source>
        <translation>Verschiebungen, Drehungen oder Maßstäbe der Koordinaten; ohne sie ausgeben</translation>
    </message>
    <message>
        <source>side {side} is neither table nor head</source>
        <translation>die Seite {side} ist weder table noch head</translation>
    </message>
    <message>
        <source>solids or meshes of the document</source>
        <translation>Volumenkörper oder Netze des Dokuments</translation>
    </message>
    <message>
        <source>spindle</source>
        <translation>Spindel</translation>
    </message>
    <message>
        <source>spindle speed is {speed} 1/min; give 0 to 999999</source>
        <translation>die Spindeldrehzahl ist {speed} 1/min; 0 bis 999999 angeben</translation>
    </message>
    <message>
        <source>splines, taken as straight to their end points; post straight moves</source>
        <translation>Splines, als Geraden bis zum Endpunkt genommen; Geraden ausgeben</translation>
    </message>
    <message>
        <source>splines, taken as straight to their ends</source>
        <translation>Splines gelten als gerade bis zu ihrem Ende</translation>
    </message>
    <message>
        <source>start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>statements that the reader does not interpret</source>
        <translation>Anweisungen werden nicht verstanden</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>stopped; nothing was changed</source>
        <translation>angehalten; nichts wurde geändert</translation>
    </message>
    <message>
        <source>stretches of passes are left out, since the tool would enter the part</source>
        <translation>Strecken von Bahnen sind ausgelassen, da das Werkzeug ins Teil eindränge</translation>
    </message>
    <message>
        <source>stretches that the tool could not leave are left out</source>
        <translation>Strecken, von denen das Werkzeug nicht wegkäme, sind ausgelassen</translation>
    </message>
    <message>
        <source>subprogram O{name} is not in this file, and no {file} that holds it was found beside it; give the folder of that file with {option}</source>
        <translation>Unterprogramm O{name} ist nicht in dieser Datei, und daneben liegt keine {file}, die es enthält; deren Ordner mit {option} angeben</translation>
    </message>
    <message>
        <source>table</source>
        <translation>Tisch</translation>
    </message>
    <message>
        <source>takes longer</source>
        <translation>länger dauert</translation>
    </message>
    <message>
        <source>the CL file has no tool {tool}; it has {listed}</source>
        <translation>die CL-Datei hat kein Werkzeug {tool}; sie hat {listed}</translation>
    </message>
    <message>
        <source>the CL file holds fewer than two rows: there is no path to compare with</source>
        <translation>die CL-Datei enthält weniger als zwei Zeilen: es gibt keinen Weg zum Vergleichen</translation>
    </message>
    <message>
        <source>the CL file names no tool; leave {option} out</source>
        <translation>die CL-Datei nennt kein Werkzeug; {option} weglassen</translation>
    </message>
    <message>
        <source>the CL path</source>
        <translation>der CL-Weg</translation>
    </message>
    <message>
        <source>the Z axis of {tool} leans {lean} deg from that of the root; turn the root so that the tool stands along Z</source>
        <translation>die Z-Achse von {tool} steht um {lean}° schräg zu der der Wurzel; drehen Sie die Wurzel so, dass das Werkzeug entlang Z steht</translation>
    </message>
    <message>
        <source>the arcs need {count} chords, more than {most}; is it a program in inches read as mm?</source>
        <translation>die Kreisbögen brauchen {count} Sehnen, mehr als {most}; ist es ein Programm in Zoll, das als mm gelesen wird?</translation>
    </message>
    <message>
        <source>the axes leave their limits everywhere</source>
        <translation>die Achsen verlassen überall ihre Grenzen</translation>
    </message>
    <message>
        <source>the axis may change by {change}; give an angle from {least_change} to {largest_change}</source>
        <translation>die Achse darf sich um {change} ändern; einen Winkel von {least_change} bis {largest_change} angeben</translation>
    </message>
    <message>
        <source>the axis' zero in the controller</source>
        <translation>den Nullpunkt der Achse in der Steuerung</translation>
    </message>
    <message>
        <source>the ball's centre</source>
        <translation>die Kugelmitte</translation>
    </message>
    <message>
        <source>the base</source>
        <translation>dem Gestell</translation>
    </message>
    <message>
        <source>the best position lies at the edge of the region</source>
        <translation>die beste Stellung liegt am Rand des Bereichs</translation>
    </message>
    <message>
        <source>the box of the cutting points</source>
        <translation>den Quader um die Punkte des Schnitts</translation>
    </message>
    <message>
        <source>the captures at tool and work, which main is given, do not stand in what can be read of the model</source>
        <translation>die Captures an Werkzeug und Werkstück, die main bekommt, stehen nicht in dem, was sich vom Modell lesen lässt</translation>
    </message>
    <message>
        <source>the configuration gives a rotary axis no limits</source>
        <translation>die Konfiguration gibt einer Drehachse keine Grenzen</translation>
    </message>
    <message>
        <source>the control guides the tip in mirrored or scaled coordinates</source>
        <translation>die Steuerung führt die Spitze in gespiegelten oder skalierten Koordinaten</translation>
    </message>
    <message>
        <source>the control shows other positions than it drives</source>
        <translation>die Steuerung zeigt andere Positionen an, als sie fährt</translation>
    </message>
    <message>
        <source>the controller does not take the shorter way that the machine file names</source>
        <translation>die Steuerung nimmt den kürzeren Weg nicht, den die Maschinendatei nennt</translation>
    </message>
    <message>
        <source>the controller guides the tip between block ends</source>
        <translation>die Steuerung führt die Spitze zwischen den Satzenden</translation>
    </message>
    <message>
        <source>the controller guides the tip straight between the ends of {count} blocks (RTCP); their ends alone were verified</source>
        <translation>die Steuerung führt die Spitze gerade zwischen den Enden von {count} Sätzen (RTCP); geprüft sind nur deren Enden</translation>
    </message>
    <message>
        <source>the controller knows no inverse time feeds</source>
        <translation>die Steuerung kennt keinen Vorschub in inverser Zeit</translation>
    </message>
    <message>
        <source>the controller whose language the text was read in</source>
        <translation>die Steuerung, in deren Sprache der Text gelesen wurde</translation>
    </message>
    <message>
        <source>the coordinates are mirrored or scaled (CYCL DEF 8, 11, 26)</source>
        <translation>die Koordinaten sind gespiegelt oder skaliert (CYCL DEF 8, 11, 26)</translation>
    </message>
    <message>
        <source>the cutter enters the part between passes</source>
        <translation>der Fräser dringt zwischen den Bahnen ins Teil ein</translation>
    </message>
    <message>
        <source>the cutter enters the part in a feed move</source>
        <translation>der Fräser dringt im Vorschub ins Teil ein</translation>
    </message>
    <message>
        <source>the cutter is that which the file names</source>
        <translation>der Fräser ist der, den die Datei nennt</translation>
    </message>
    <message>
        <source>the cutter is that which the program names</source>
        <translation>der Fräser ist der, den das Programm nennt</translation>
    </message>
    <message>
        <source>the cutter stays</source>
        <translation>der Fräser bleibt</translation>
    </message>
    <message>
        <source>the cutter stays out of the part (no shank or holder given)</source>
        <translation>der Fräser bleibt aus dem Werkstück (kein Schaft oder Halter gegeben)</translation>
    </message>
    <message>
        <source>the cutter's bottom stands in the part before or behind its contact</source>
        <translation>die Unterseite des Fräsers steht vor oder hinter dem Berührpunkt im Teil</translation>
    </message>
    <message>
        <source>the cutter's feed moves stay out of the part, but for {tolerance}</source>
        <translation>im Vorschub bleibt der Fräser bis auf {tolerance} aus dem Teil</translation>
    </message>
    <message>
        <source>the decimals of the words are too few for the tolerance</source>
        <translation>die Wörter haben zu wenige Dezimalen für die Toleranz</translation>
    </message>
    <message>
        <source>the deflections are {linear} and {angular}; both must be above 0</source>
        <translation>die Abweichungen des Netzes sind {linear} und {angular}; beide müssen über 0 sein</translation>
    </message>
    <message>
        <source>the direction of a rotary axis hangs on a parameter</source>
        <translation>die Richtung einer Rundachse hängt an einem Parameter</translation>
    </message>
    <message>
        <source>the direction of an axis is not proven at the machine</source>
        <translation>die Richtung einer Achse ist nicht an der Maschine geprüft</translation>
    </message>
    <message>
        <source>the direction of the planes is {angle}: give a finite angle</source>
        <translation>die Richtung der Ebenen ist {angle}: einen endlichen Winkel angeben</translation>
    </message>
    <message>
        <source>the document was closed; nothing was changed</source>
        <translation>das Dokument wurde geschlossen; nichts wurde geändert</translation>
    </message>
    <message>
        <source>the dynamic work offset (G254)</source>
        <translation>die dynamische Nullpunktverschiebung (G254)</translation>
    </message>
    <message>
        <source>the executor gave back {given} for the job {job}; choose another one</source>
        <translation>der Executor gab {given} für den Auftrag {job} zurück; einen anderen wählen</translation>
    </message>
    <message>
        <source>the faces that are to be avoided, and their area</source>
        <translation>die Flächen, die zu meiden sind, und ihr Inhalt</translation>
    </message>
    <message>
        <source>the faces that are to be milled, and their area</source>
        <translation>die Flächen, die zu fräsen sind, und ihr Inhalt</translation>
    </message>
    <message>
        <source>the facets of a closed mesh looked inward and were turned</source>
        <translation>die Facetten eines geschlossenen Netzes schauten nach innen und wurden gewendet</translation>
    </message>
    <message>
        <source>the factor is {factor}; it must be between 1e-6 and 1e6</source>
        <translation>der Faktor ist {factor}; er muss zwischen 1e-6 und 1e6 liegen</translation>
    </message>
    <message>
        <source>the field of the passes is not one finite number for each of the {count} vertices</source>
        <translation>das Feld der Bahnen hat nicht für jede der {count} Ecken eine endliche Zahl</translation>
    </message>
    <message>
        <source>the file became shorter while it was read; export it again</source>
        <translation>die Datei wurde beim Lesen kürzer; neu exportieren</translation>
    </message>
    <message>
        <source>the file changes tools, and the program cuts all of it with one</source>
        <translation>die Datei wechselt Werkzeuge, das Programm schneidet alles mit einem</translation>
    </message>
    <message>
        <source>the file ends within facet {facet}: it is cut off; export it again</source>
        <translation>die Datei endet innerhalb der Facette {facet}: sie ist abgeschnitten; neu exportieren</translation>
    </message>
    <message>
        <source>the file has several coordinate systems</source>
        <translation>die Datei hat mehrere Koordinatensysteme</translation>
    </message>
    <message>
        <source>the file holds no motion blocks: no axis word of this machine under G0 or G1</source>
        <translation>die Datei enthält keine Bewegungssätze: kein Achswort dieser Maschine unter G0 oder G1</translation>
    </message>
    <message>
        <source>the file holds {data} instead of an object with the key "machine"</source>
        <translation>die Datei enthält {data} statt eines Objekts mit dem Schlüssel „machine“</translation>
    </message>
    <message>
        <source>the file is empty; export the part again</source>
        <translation>die Datei ist leer; das Werkstück neu exportieren</translation>
    </message>
    <message>
        <source>the file says that its points are the part's contour. Have the tool's path written.</source>
        <translation>laut Datei sind ihre Punkte die Kontur des Teils. Den Weg des Werkzeugs ausgeben lassen.</translation>
    </message>
    <message>
        <source>the file {kind}; {remedy}</source>
        <translation>die Datei {kind}; {remedy}</translation>
    </message>
    <message>
        <source>the fixture {fixture} at {share} % of them</source>
        <translation>das Spannmittel {fixture} an {share} % von ihnen</translation>
    </message>
    <message>
        <source>the fixture {fixture} is in the way; clamp the part otherwise</source>
        <translation>das Spannmittel {fixture} ist im Weg; das Teil anders spannen</translation>
    </message>
    <message>
        <source>the fixture {name}</source>
        <translation>das Spannmittel {name}</translation>
    </message>
    <message>
        <source>the formula of So et al. has no root in these blocks</source>
        <translation>die Formel von So u. a. hat in Sätzen keine Lösung</translation>
    </message>
    <message>
        <source>the head of NX's listing</source>
        <translation>der Kopf eines Protokolls von NX</translation>
    </message>
    <message>
        <source>the header announces {facets} facets, but the file holds {held}: it is cut off, damaged or no STL; export it again</source>
        <translation>der Kopf kündigt {facets} Facetten an, die Datei enthält {held}: sie ist abgeschnitten, beschädigt oder kein STL; neu exportieren</translation>
    </message>
    <message>
        <source>the height of the table's face is not known; setup leaves Z alone without it</source>
        <translation>die Höhe der Tischfläche ist nicht bekannt; ohne sie lässt das Aufspannen Z, wie es ist</translation>
    </message>
    <message>
        <source>the holder is in the way; let the tool stick out farther</source>
        <translation>der Halter ist im Weg; das Werkzeug weiter auskragen lassen</translation>
    </message>
    <message>
        <source>the holder: none was given</source>
        <translation>der Halter: es wurde keiner angegeben</translation>
    </message>
    <message>
        <source>the key is missing; add "{key}"</source>
        <translation>der Schlüssel fehlt; „{key}“ ergänzen</translation>
    </message>
    <message>
        <source>the key is missing; add {example} with the axis' own limits</source>
        <translation>der Schlüssel fehlt; {example} mit den Grenzen der Achse einfügen</translation>
    </message>
    <message>
        <source>the key is missing; add {example} with the axis' own limits; -99999 and 99999 for one that turns without end</source>
        <translation>der Schlüssel fehlt; {example} mit den Grenzen der Achse einfügen; -99999 und 99999 für eine, die endlos dreht</translation>
    </message>
    <message>
        <source>the keys {lacking} are missing; add them (role: one of {roles}; parent: the axis that carries this one, or null)</source>
        <translation>die Schlüssel {lacking} fehlen; fügen Sie sie hinzu (role: eines von {roles}; parent: die Achse, die diese trägt, oder null)</translation>
    </message>
    <message>
        <source>the kinematics move axes that a machine file cannot hold</source>
        <translation>die Kinematik bewegt Achsen, die eine Maschinendatei nicht fassen kann</translation>
    </message>
    <message>
        <source>the kinematics that the program switches to are not known</source>
        <translation>die Kinematik, auf die das Programm umschaltet, ist nicht bekannt</translation>
    </message>
    <message>
        <source>the length of another tool is active</source>
        <translation>die Länge eines anderen Werkzeugs ist wirksam</translation>
    </message>
    <message>
        <source>the length of the tool is active: no G43 was read</source>
        <translation>die Werkzeuglänge ist wirksam: kein G43 wurde gelesen</translation>
    </message>
    <message>
        <source>the linear axes X, Y, Z lie in one plane; correct their directions</source>
        <translation>die Linearachsen X, Y, Z liegen in einer Ebene; ihre Richtungen berichtigen</translation>
    </message>
    <message>
        <source>the linear axes lie in one plane at {letter} {first} {other} {second} and cannot place the tip ({count} rows): lower {max_axis_angle} or take another machine</source>
        <translation>die Linearachsen liegen bei {letter} {first} {other} {second} in einer Ebene und können die Werkzeugspitze nicht setzen ({count} Punkte): {max_axis_angle} verringern oder eine andere Maschine nehmen</translation>
    </message>
    <message>
        <source>the lists have a machine called {name}; give this one a name of its own</source>
        <translation>in den Listen gibt es eine Maschine {name}; dieser einen eigenen Namen geben</translation>
    </message>
    <message>
        <source>the machine cannot stand as the program commands</source>
        <translation>die Maschine kann nicht so stehen, wie das Programm befiehlt</translation>
    </message>
    <message>
        <source>the machine is as {machine} describes it: axes, their signs, centres of rotation ({signs} shows it), and the part stands where the program takes it to stand</source>
        <translation>die Maschine ist so, wie {machine} sie beschreibt: Achsen, ihre Vorzeichen, Drehpunkte ({signs} zeigt es), und das Teil steht dort, wo das Programm es annimmt</translation>
    </message>
    <message>
        <source>the machine is in the way; use a longer tool, or clamp the part higher or elsewhere</source>
        <translation>die Maschine ist im Weg; ein längeres Werkzeug nehmen, oder das Teil höher oder woanders spannen</translation>
    </message>
    <message>
        <source>the machine's centres of rotation, about which it leads the axes, are not known</source>
        <translation>die Drehzentren der Maschine, um die sie die Achsen führt, sind nicht bekannt</translation>
    </message>
    <message>
        <source>the machine's model moves otherwise than its kinematics</source>
        <translation>das Modell der Maschine bewegt sich anders als ihre Kinematik</translation>
    </message>
    <message>
        <source>the mark</source>
        <translation>die Marke</translation>
    </message>
    <message>
        <source>the median of all blocks is {speed}</source>
        <translation>der Median aller NC-Sätze {speed} ist</translation>
    </message>
    <message>
        <source>the mesh has no facets: export a solid or a surface with at least one triangle</source>
        <translation>das Netz hat keine Facetten: einen Volumenkörper oder eine Fläche mit mindestens einem Dreieck exportieren</translation>
    </message>
    <message>
        <source>the mesh is open, and passes end at its edges</source>
        <translation>das Netz ist offen, und Bahnen enden an seinen Kanten</translation>
    </message>
    <message>
        <source>the name is empty; give the machine one</source>
        <translation>der Name ist leer; der Maschine einen geben</translation>
    </message>
    <message>
        <source>the open surface looks down, so that its underside is machined</source>
        <translation>die offene Fläche zeigt nach unten, sodass ihre Unterseite bearbeitet wird</translation>
    </message>
    <message>
        <source>the part</source>
        <translation>das Teil</translation>
    </message>
    <message>
        <source>the part is cut in frames, each with a tool axis of its own</source>
        <translation>das Teil wird in Lagen gefräst, jede mit eigener Werkzeugachse</translation>
    </message>
    <message>
        <source>the part stands in a body of the machine</source>
        <translation>das Werkstück steckt in einem Körper der Maschine</translation>
    </message>
    <message>
        <source>the part would reach below the table, which is not looked at</source>
        <translation>das Teil reichte unter den Tisch, der nicht geprüft wird</translation>
    </message>
    <message>
        <source>the part would reach into the table, so its place is not known</source>
        <translation>das Teil reichte in den Tisch, daher ist sein Ort nicht bekannt</translation>
    </message>
    <message>
        <source>the part: whether the tool enters it was not looked at</source>
        <translation>das Teil: ob das Werkzeug hineinfährt, wurde nicht geprüft</translation>
    </message>
    <message>
        <source>the path counts on compensation in the control</source>
        <translation>die Bahn rechnet mit Radiuskorrektur in der Steuerung</translation>
    </message>
    <message>
        <source>the path starts with a feed; the program goes there in rapid</source>
        <translation>die Bahn beginnt mit einem Vorschub, das Programm fährt im Eilgang hin</translation>
    </message>
    <message>
        <source>the planes cut the facets {segments} times, more than {most}; {remedy}</source>
        <translation>die Ebenen schneiden die Facetten {segments} Mal, mehr als {most}; {remedy}</translation>
    </message>
    <message>
        <source>the points are taken as the tool's own path, as CL files mean them.</source>
        <translation>die Punkte gelten als Weg des Werkzeugs selbst, wie CL-Dateien sie meinen.</translation>
    </message>
    <message>
        <source>the post had another machine in mind</source>
        <translation>der Postprozessor meinte eine andere Maschine</translation>
    </message>
    <message>
        <source>the program begins and ends at the reference point of Z</source>
        <translation>das Programm beginnt und endet am Referenzpunkt von Z</translation>
    </message>
    <message>
        <source>the program begins and ends below what the axes carry</source>
        <translation>das Programm beginnt und endet tiefer als das, was die Achsen tragen</translation>
    </message>
    <message>
        <source>the program has no block that moves; there is nothing to play</source>
        <translation>das Programm hat keinen NC-Satz mit Bewegung; es gibt nichts abzuspielen</translation>
    </message>
    <message>
        <source>the program has no feed blocks, so nothing is proven</source>
        <translation>das Programm hat keine Vorschubsätze, also ist nichts nachgewiesen</translation>
    </message>
    <message>
        <source>the program has no number; write one after the O, as O1</source>
        <translation>das Programm hat keine Nummer; eine hinter das O schreiben, wie O1</translation>
    </message>
    <message>
        <source>the program has rotary words of {names}; a five-axis machine is recovered from two of A B C</source>
        <translation>das Programm hat Rundachswörter von {names}; eine Fünfachsmaschine wird aus zweien von A B C zurückgewonnen</translation>
    </message>
    <message>
        <source>the program needs {span} of {letter}, whose travel is {travel}, for what is milled stands {distance} from the axis of {axis} and swings with it. Stand it near the axes: the work zero moved by about X {x} Y {y} Z {z} ({origin}) does.</source>
        <translation>das Programm braucht {span} von {letter}, deren Weg {travel} ist, denn was gefräst wird, steht {distance} von der Achse von {axis} entfernt und schwingt mit ihr. Es nahe an die Achsen stellen: Das tut ein Nullpunkt, der um etwa X {x} Y {y} Z {z} verschoben ist ({origin}).</translation>
    </message>
    <message>
        <source>the program needs {span} of {letter}, whose travel is {travel}, {short} too short. Take a larger machine, or mill less of the part at once.</source>
        <translation>das Programm braucht {span} von {letter}, dessen Verfahrweg {travel} ist, {short} zu kurz. Eine größere Maschine nehmen oder weniger vom Teil auf einmal fräsen.</translation>
    </message>
    <message>
        <source>the program was not built for {name} as it is to be written</source>
        <translation>das Programm wurde nicht für {name} aufgebaut, wie es geschrieben werden soll</translation>
    </message>
    <message>
        <source>the program's zero is not that of the path or machine</source>
        <translation>der Nullpunkt des Programms ist nicht der von Bahn oder Maschine</translation>
    </message>
    <message>
        <source>the retract to a machine position goes below where the program begins or ends</source>
        <translation>der Rückzug auf eine Maschinenposition geht unter die Stelle, wo das Programm beginnt oder endet</translation>
    </message>
    <message>
        <source>the rotary words never change: such rows say nothing of pivots; give a five-axis program</source>
        <translation>die Rundachswörter ändern sich nie: solche Zeilen sagen nichts über Drehpunkte; ein fünfachsiges Programm angeben</translation>
    </message>
    <message>
        <source>the rows are off the best machine by more than rounding</source>
        <translation>die Zeilen liegen um mehr als Rundung neben der besten Maschine</translation>
    </message>
    <message>
        <source>the rows do not tell a dimension of the machine</source>
        <translation>die Zeilen verraten ein Maß der Maschine nicht</translation>
    </message>
    <message>
        <source>the safe height lies beyond the limits</source>
        <translation>die sichere Höhe liegt jenseits der Grenzen</translation>
    </message>
    <message>
        <source>the scallop asks for passes nearer than the least interval</source>
        <translation>die Kuppenhöhe verlangt engere Bahnen als den kleinsten Abstand</translation>
    </message>
    <message>
        <source>the second rotary axis is parallel to the tool and never tilts it; is the order of the two right?</source>
        <translation>die zweite Rundachse ist parallel zum Werkzeug und neigt es nie; stimmt die Reihenfolge der beiden?</translation>
    </message>
    <message>
        <source>the shank is in the way; use a thinner or a longer one</source>
        <translation>der Schaft ist im Weg; einen dünneren oder längeren nehmen</translation>
    </message>
    <message>
        <source>the shank: none was given</source>
        <translation>der Schaft: es wurde keiner angegeben</translation>
    </message>
    <message>
        <source>the shift at the bottom of a boring cycle is not followed</source>
        <translation>der Versatz am Grund eines Ausdrehzyklus wird nicht verfolgt</translation>
    </message>
    <message>
        <source>the short way</source>
        <translation>der kurze Weg</translation>
    </message>
    <message>
        <source>the shortest stick-out with which the holder is free</source>
        <translation>die kürzeste Auskragung, bei der der Halter frei ist</translation>
    </message>
    <message>
        <source>the side at {letter} {at}</source>
        <translation>die Seite bei {letter} {at}</translation>
    </message>
    <message>
        <source>the side that faces {way} at {place}</source>
        <translation>die Seite, die nach {way} zeigt, bei {place}</translation>
    </message>
    <message>
        <source>the spindle is started without a speed</source>
        <translation>die Spindel ist ohne Drehzahl eingeschaltet</translation>
    </message>
    <message>
        <source>the spindle stays off</source>
        <translation>die Spindel bleibt aus</translation>
    </message>
    <message>
        <source>the spindle turns to the left</source>
        <translation>die Spindel dreht links herum</translation>
    </message>
    <message>
        <source>the spindle's speed is not told before it</source>
        <translation>die Spindeldrehzahl steht nicht davor</translation>
    </message>
    <message>
        <source>the surface curls tighter than the cutter</source>
        <translation>die Oberfläche ist enger gekrümmt als der Fräser</translation>
    </message>
    <message>
        <source>the surface that is to be cut has no border to lead passes from or to; give two guides by {from_} and {to}, a point X,Y,Z or a file CURVE.csv each</source>
        <translation>Die zu bearbeitende Fläche hat keinen Rand, von dem oder zu dem Bahnen führen könnten; zwei Leitlinien mit {from_} und {to} angeben, je einen Punkt X,Y,Z oder eine Datei CURVE.csv</translation>
    </message>
    <message>
        <source>the table</source>
        <translation>den Tisch</translation>
    </message>
    <message>
        <source>the table at {share} % of them</source>
        <translation>der Tisch an {share} % von ihnen</translation>
    </message>
    <message>
        <source>the table is in the way</source>
        <translation>der Tisch ist im Weg</translation>
    </message>
    <message>
        <source>the text cannot be shown: {strerror}</source>
        <translation>der Text kann nicht gezeigt werden: {strerror}</translation>
    </message>
    <message>
        <source>the text is in another controller's language</source>
        <translation>der Text ist in der Sprache einer anderen Steuerung</translation>
    </message>
    <message>
        <source>the tip</source>
        <translation>die Spitze</translation>
    </message>
    <message>
        <source>the tip is guided (G234) at the same time</source>
        <translation>die Spitze wird zugleich geführt (G234)</translation>
    </message>
    <message>
        <source>the tip is still guided where the program ends</source>
        <translation>am Programmende wird die Spitze noch geführt</translation>
    </message>
    <message>
        <source>the tip swinging {way}</source>
        <translation>die Werkzeugspitze schwenkt {way}</translation>
    </message>
    <message>
        <source>the tip swings {way}, {size}</source>
        <translation>die Werkzeugspitze schwenkt {way}, {size}</translation>
    </message>
    <message>
        <source>the tolerance is held as measured, not as proven</source>
        <translation>die Toleranz ist gemessen eingehalten, aber nicht bewiesen</translation>
    </message>
    <message>
        <source>the tool axis differs from that of the path</source>
        <translation>die Werkzeugachse weicht von der der Bahn ab</translation>
    </message>
    <message>
        <source>the tool axis is 0, 0, 0, or beyond all bounds</source>
        <translation>die Werkzeugachse ist 0, 0, 0 oder jenseits aller Grenzen</translation>
    </message>
    <message>
        <source>the tool axis was turned away from the part</source>
        <translation>die Werkzeugachse wurde vom Teil weggedreht</translation>
    </message>
    <message>
        <source>the tool comes nearer to a fixture than the clearance</source>
        <translation>das Werkzeug kommt einem Spannmittel näher als der Abstand</translation>
    </message>
    <message>
        <source>the tool comes nearer to faces to avoid than the allowance</source>
        <translation>das Werkzeug kommt zu meidenden Flächen näher als das Aufmaß</translation>
    </message>
    <message>
        <source>the tool could not get out along its axis {where}, for the part is over it, as at {place}</source>
        <translation>das Werkzeug {where} entlang seiner Achse nicht herauskäme, denn das Werkstück ist darüber, etwa bei {place}</translation>
    </message>
    <message>
        <source>the tool differs from that of the control's table</source>
        <translation>das Werkzeug weicht von dem der Werkzeugtabelle ab</translation>
    </message>
    <message>
        <source>the tool dips below the plane on which the part stands</source>
        <translation>das Werkzeug taucht unter die Ebene, auf der das Teil steht</translation>
    </message>
    <message>
        <source>the tool goes below the machine's table</source>
        <translation>das Werkzeug fährt unter den Tisch der Maschine</translation>
    </message>
    <message>
        <source>the tool goes below the table</source>
        <translation>das Werkzeug gerät unter den Tisch</translation>
    </message>
    <message>
        <source>the tool has the length and the shape given</source>
        <translation>das Werkzeug hat die angegebene Länge und Form</translation>
    </message>
    <message>
        <source>the tool hits a fixture</source>
        <translation>das Werkzeug trifft ein Spannmittel</translation>
    </message>
    <message>
        <source>the tool hits the machine</source>
        <translation>das Werkzeug stößt an die Maschine</translation>
    </message>
    <message>
        <source>the tool is free there in none of the frames</source>
        <translation>das Werkzeug ist dort in keiner der Lagen frei</translation>
    </message>
    <message>
        <source>the tool is lifted out of the part by up to {value}</source>
        <translation>das Werkzeug ist um bis zu {value} aus dem Werkstück gehoben</translation>
    </message>
    <message>
        <source>the tool is wider than the hole</source>
        <translation>das Werkzeug ist breiter als die Bohrung</translation>
    </message>
    <message>
        <source>the tool is {length} long, and of the shape given</source>
        <translation>das Werkzeug ist {length} lang und hat die angegebene Form</translation>
    </message>
    <message>
        <source>the tool length turns with the head only as a W offset</source>
        <translation>die Werkzeuglänge dreht nur als W-Versatz mit dem Kopf</translation>
    </message>
    <message>
        <source>the tool lies along {axis}, and holes are written along Z alone</source>
        <translation>das Werkzeug liegt längs {axis}, und Bohrungen werden nur längs Z ausgeschrieben</translation>
    </message>
    <message>
        <source>the tool moves over the part at another speed than F</source>
        <translation>das Werkzeug fährt mit anderer Geschwindigkeit als F über das Teil</translation>
    </message>
    <message>
        <source>the tool must stick out farther, so that the holder is free</source>
        <translation>das Werkzeug muss weiter auskragen, damit der Halter frei ist</translation>
    </message>
    <message>
        <source>the tool stands off the normal of its tilted plane</source>
        <translation>das Werkzeug steht nicht auf der Normalen seiner geschwenkten Ebene</translation>
    </message>
    <message>
        <source>the tool stays above the table's face, at Z {height}</source>
        <translation>das Werkzeug bleibt über der Tischfläche, bei Z {height}</translation>
    </message>
    <message>
        <source>the tool stays out of the part</source>
        <translation>das Werkzeug bleibt aus dem Werkstück</translation>
    </message>
    <message>
        <source>the tool that was taken of several</source>
        <translation>das Werkzeug, das von mehreren gewählt wurde</translation>
    </message>
    <message>
        <source>the tool turning about itself the other way</source>
        <translation>das Werkzeug dreht sich anders herum um sich selbst</translation>
    </message>
    <message>
        <source>the tool turns about itself</source>
        <translation>das Werkzeug dreht sich um sich selbst</translation>
    </message>
    <message>
        <source>the tool was lifted out of the part</source>
        <translation>das Werkzeug wurde aus dem Teil gehoben</translation>
    </message>
    <message>
        <source>the tool would come nearer to the faces to avoid {where} than {allowance}, as at {place}</source>
        <translation>das Werkzeug käme {where} den ausgesparten Flächen näher als {allowance}, etwa bei {place}</translation>
    </message>
    <message>
        <source>the tool would enter the part {where}, deepest by {depth} at {place}</source>
        <translation>das Werkzeug {where} ins Werkstück eindringen würde, am tiefsten um {depth} bei {place}</translation>
    </message>
    <message>
        <source>the tool would go below the table; clamp the part higher</source>
        <translation>das Werkzeug käme unter den Tisch; das Teil höher spannen</translation>
    </message>
    <message>
        <source>the toolpath</source>
        <translation>der Werkzeugweg</translation>
    </message>
    <message>
        <source>the toolpath of the map was deleted: make the map of another one</source>
        <translation>der Werkzeugweg der Karte wurde gelöscht: die Karte eines anderen erstellen</translation>
    </message>
    <message>
        <source>the toolpath of this preview is gone; delete the preview</source>
        <translation>der Werkzeugweg dieser Vorschau ist fort; die Vorschau löschen</translation>
    </message>
    <message>
        <source>the toolpath of {label} was deleted; the file stays as it is</source>
        <translation>der Werkzeugweg von {label} wurde gelöscht; die Datei bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>the wall at {letter} {at}</source>
        <translation>die Wand bei {letter} {at}</translation>
    </message>
    <message>
        <source>the way to stand in a tilted plane that the control takes</source>
        <translation>die Stellung, die die Steuerung für eine geschwenkte Ebene wählt</translation>
    </message>
    <message>
        <source>the whole cutter is inside the part</source>
        <translation>der ganze Fräser ist im Werkstück</translation>
    </message>
    <message>
        <source>the whole part is {size} long, and none is less than {least}: check the units of the export</source>
        <translation>das ganze Teil ist {size} lang, und keines ist kleiner als {least}: die Einheiten des Exports prüfen</translation>
    </message>
    <message>
        <source>the words of a rotary axis do not fit the way it wraps</source>
        <translation>die Wörter einer Rundachse passen nicht dazu, wie sie umläuft</translation>
    </message>
    <message>
        <source>the work offset</source>
        <translation>die Nullpunktverschiebung</translation>
    </message>
    <message>
        <source>the work zero at X {x} Y {y} Z {z} of the machine</source>
        <translation>der Werkstücknullpunkt bei X {x} Y {y} Z {z} der Maschine</translation>
    </message>
    <message>
        <source>the work zero changes within the program</source>
        <translation>der Nullpunkt wechselt im Programm</translation>
    </message>
    <message>
        <source>the work zero is a row of the control's table</source>
        <translation>der Nullpunkt ist eine Zeile der Tabelle der Steuerung</translation>
    </message>
    <message>
        <source>the zero is that row of the control's table; the program is read as if the work zero stood there</source>
        <translation>der Nullpunkt ist diese Zeile der Tabelle der Steuerung; das Programm wird gelesen, als stünde dort der Werkstücknullpunkt</translation>
    </message>
    <message>
        <source>the {all}</source>
        <translation>den {all}</translation>
    </message>
    <message>
        <source>the {what} are {form}: give numbers of shape {wanted}</source>
        <translation>{what}: {form}; Zahlen der Form {wanted} angeben</translation>
    </message>
    <message>
        <source>the {what} form no regular table: {problem}</source>
        <translation>{what}: keine regelmäßige Tabelle: {problem}</translation>
    </message>
    <message>
        <source>there</source>
        <translation>dort</translation>
    </message>
    <message>
        <source>there are no machines to compare; name at least one</source>
        <translation>es gibt keine Maschinen zu vergleichen; mindestens eine nennen</translation>
    </message>
    <message>
        <source>there are no passes: none runs over a facet that the tool reaches; check its axis, stepover and direction</source>
        <translation>es gibt keine Bahnen: keine läuft über eine Facette, die das Werkzeug erreicht; seine Achse, Bahnabstand und Richtung prüfen</translation>
    </message>
    <message>
        <source>there is no block {flat}; the last one is {count}</source>
        <translation>den NC-Satz {flat} gibt es nicht; der letzte ist {count}</translation>
    </message>
    <message>
        <source>there is no path to compare on: it has no rows</source>
        <translation>es gibt keinen Weg zum Vergleichen: er hat keine Zeilen</translation>
    </message>
    <message>
        <source>there is no path to set up: it has no rows</source>
        <translation>es gibt keinen Weg aufzuspannen: er hat keine Zeilen</translation>
    </message>
    <message>
        <source>there is nothing to compare; name at least one machine and one correction</source>
        <translation>es gibt nichts zu vergleichen; mindestens eine Maschine und eine Korrektur nennen</translation>
    </message>
    <message>
        <source>they keep {clearance} away from fixtures</source>
        <translation>sie halten {clearance} Abstand zu Spannmitteln</translation>
    </message>
    <message>
        <source>this arc alone needs {count} chords; give a larger tolerance</source>
        <translation>dieser Kreisbogen allein braucht {count} Sehnen; eine größere Toleranz angeben</translation>
    </message>
    <message>
        <source>this correction turns the tool axes over the part's facets; give it the STL, not a CL file</source>
        <translation>diese Korrektur dreht die Werkzeugachsen über den Facetten des Werkstücks; das STL angeben, keine CL-Datei</translation>
    </message>
    <message>
        <source>this end has no begin of its name</source>
        <translation>dieses Ende hat keinen Anfang seines Namens</translation>
    </message>
    <message>
        <source>this executor needs a package that is not installed: {install}</source>
        <translation>dieser Executor braucht ein Paket, das nicht installiert ist: {install}</translation>
    </message>
    <message>
        <source>this is no CL file: byte {control} (offset {offset}) stands in no text; give a text file</source>
        <translation>das ist keine CL-Datei: Byte {control} (Stelle {offset}) kommt in keinem Text vor; eine Textdatei angeben</translation>
    </message>
    <message>
        <source>this is no NC line; delete what stands before the program, or put it in brackets</source>
        <translation>das ist keine NC-Zeile; löschen, was vor dem Programm steht, oder in Klammern setzen</translation>
    </message>
    <message>
        <source>this is no STL file: its {size} bytes neither begin with 'solid' nor hold a binary header; export the part as STL</source>
        <translation>das ist keine STL-Datei: ihre {size} Bytes beginnen weder mit 'solid' noch enthalten sie einen binären Kopf; das Werkstück als STL exportieren</translation>
    </message>
    <message>
        <source>this machine cannot take up its normal</source>
        <translation>diese Maschine kann ihre Normale nicht einnehmen</translation>
    </message>
    <message>
        <source>tighter than the cutter</source>
        <translation>enger als der Fräser</translation>
    </message>
    <message>
        <source>to the back</source>
        <translation>nach hinten</translation>
    </message>
    <message>
        <source>to the front</source>
        <translation>nach vorn</translation>
    </message>
    <message>
        <source>to the left</source>
        <translation>nach links</translation>
    </message>
    <message>
        <source>to the right</source>
        <translation>nach rechts</translation>
    </message>
    <message>
        <source>tolerance is {tolerance}; blocks can be divided for a tolerance above 0 only</source>
        <translation>die Toleranz ist {tolerance}; NC-Sätze lassen sich nur für eine Toleranz über 0 teilen</translation>
    </message>
    <message>
        <source>tolerance is {tolerance}; give a length above 0</source>
        <translation>die Toleranz ist {tolerance}; eine Länge über 0 angeben</translation>
    </message>
    <message>
        <source>tolerance {tolerance} held in all {count} feed blocks, proven</source>
        <translation>Toleranz {tolerance} in allen {count} Vorschubsätzen eingehalten, nachgewiesen</translation>
    </message>
    <message>
        <source>tolerance {tolerance} held in the one feed block, proven</source>
        <translation>Toleranz {tolerance} in dem einen Vorschubsatz eingehalten, nachgewiesen</translation>
    </message>
    <message>
        <source>tolerance {tolerance} not proven in {count} of {all} feed blocks</source>
        <translation>Toleranz {tolerance} in {count} von {all} Vorschubsätzen nicht nachgewiesen</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>tool axes are told by vectors in it</source>
        <translation>in ihr stehen Werkzeugachsen als Vektoren</translation>
    </message>
    <message>
        <source>tool axes given by angles</source>
        <translation>Werkzeugachsen sind durch Winkel angegeben</translation>
    </message>
    <message>
        <source>tool axes that the machine cannot reach are left out</source>
        <translation>Werkzeugachsen, die die Maschine nicht erreicht, sind ausgelassen</translation>
    </message>
    <message>
        <source>tool axes told by spatial, Euler or lead angles; they are missing here. Post rotary words or vectors</source>
        <translation>Werkzeugachsen durch Raum-, Euler- oder Voreilwinkel; sie fehlen hier. Rundachswörter oder Vektoren ausgeben</translation>
    </message>
    <message>
        <source>tool axes were not of unit length</source>
        <translation>Werkzeugachsen hatten nicht die Länge eins</translation>
    </message>
    <message>
        <source>tool centre control</source>
        <translation>die Führung der Werkzeugspitze</translation>
    </message>
    <message>
        <source>tool number is {tool}; give 1 to 99999</source>
        <translation>die Werkzeugnummer ist {tool}; 1 bis 99999 angeben</translation>
    </message>
    <message>
        <source>tool vectors while nothing guides the tip; the rotary axes stay where they are. Switch the guide on before (M128, FUNCTION TCPM, TRAORI)</source>
        <translation>Werkzeugvektoren, während nichts die Spitze führt; die Rundachsen bleiben stehen. Die Führung vorher einschalten (M128, FUNCTION TCPM, TRAORI)</translation>
    </message>
    <message>
        <source>tool, spindle or a body of the machine comes nearer to another than the clearance</source>
        <translation>Werkzeug, Spindel oder ein Körper der Maschine kommt einem anderen näher als der Abstand</translation>
    </message>
    <message>
        <source>tool, spindle or a body of the machine hits another one</source>
        <translation>Werkzeug, Spindel oder ein Körper der Maschine trifft einen anderen</translation>
    </message>
    <message>
        <source>triangle corners</source>
        <translation>Dreiecksecken</translation>
    </message>
    <message>
        <source>trivkins does not say where {letter} stands. Taken: it turns the table about the line through the machine's zero along {along}, with the sign of ISO 841. Correct what is otherwise in the machine file; prove the signs before cutting.</source>
        <translation>trivkins sagt nicht, wo {letter} steht. Angenommen: Sie dreht den Tisch um die Gerade durch den Maschinennullpunkt entlang {along}, mit dem Vorzeichen von ISO 841. Berichtigen Sie in der Maschinendatei, was anders ist; prüfen Sie die Vorzeichen vor dem Fräsen.</translation>
    </message>
    <message>
        <source>turn the part by {turn} about Z through its zero first, counter-clockwise, and try one turn only</source>
        <translation>zuerst das Werkstück um {turn} um Z durch seinen Nullpunkt drehen, gegen den Uhrzeigersinn, und nur eine Drehung erproben</translation>
    </message>
    <message>
        <source>turns back more often</source>
        <translation>öfter zurückdreht</translation>
    </message>
    <message>
        <source>two axes are called {letter}; give each a letter of its own</source>
        <translation>zwei Achsen heißen {letter}; jeder einen eigenen Buchstaben geben</translation>
    </message>
    <message>
        <source>two bodies are called {name}; give each a name of its own</source>
        <translation>zwei Körper heißen {name}; jedem einen eigenen Namen geben</translation>
    </message>
    <message>
        <source>two joints carry the link {link}; leave one of them</source>
        <translation>zwei Gelenke tragen den Link {link}; lassen Sie eines davon übrig</translation>
    </message>
    <message>
        <source>two links or joints are called {name}; give each a name of its own</source>
        <translation>zwei Links oder Gelenke heißen {name}; geben Sie jedem einen eigenen Namen</translation>
    </message>
    <message>
        <source>unknown controller {name}; {hint}{known}</source>
        <translation>unbekannte Steuerung {name}; {hint}{known}</translation>
    </message>
    <message>
        <source>unknown correction {name}; known: {cures}</source>
        <translation>unbekannte Korrektur {name}; bekannt: {cures}</translation>
    </message>
    <message>
        <source>unknown executor {name}; known: {known}</source>
        <translation>unbekannter Executor {name}; bekannt: {known}</translation>
    </message>
    <message>
        <source>unknown method {method} of the line deviation; use one of {methods}</source>
        <translation>unbekanntes Verfahren {method} der Abweichung von der Geraden; eines nehmen von {methods}</translation>
    </message>
    <message>
        <source>unknown option {name} for {task}</source>
        <translation>unbekannte Einstellung {name} für {task}</translation>
    </message>
    <message>
        <source>unknown passes {name}; choose one of {known}</source>
        <translation>unbekannte Bahnen {name}; eine von {known} wählen</translation>
    </message>
    <message>
        <source>unknown task {task}; known: {tasks}</source>
        <translation>unbekannte Aufgabe {task}; bekannt: {tasks}</translation>
    </message>
    <message>
        <source>unknown tool-axis strategy {name}; choose one of {strategies}</source>
        <translation>unbekannte Strategie {name} der Werkzeugachse; eine wählen von {strategies}</translation>
    </message>
    <message>
        <source>unknown unit; known are MM and INCHES</source>
        <translation>unbekannte Einheit; bekannt sind MM und INCHES</translation>
    </message>
    <message>
        <source>unknown {option} {value}; choose one of {known}</source>
        <translation>unbekannt: {option} {value}; eines wählen von {known}</translation>
    </message>
    <message>
        <source>up</source>
        <translation>nach oben</translation>
    </message>
    <message>
        <source>variables, expressions or jumps</source>
        <translation>Variablen, Ausdrücke oder Sprünge werden nicht verstanden</translation>
    </message>
    <message>
        <source>variables, expressions or jumps; their words are missing here. Post without them</source>
        <translation>Variablen, Ausdrücke oder Sprünge; ihre Wörter fehlen hier. Ohne sie ausgeben</translation>
    </message>
    <message>
        <source>vertex</source>
        <translation>Ecke</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>what a change of the tool axis buys near the pole</source>
        <translation>was eine andere Werkzeugachse nahe am Pol bringt</translation>
    </message>
    <message>
        <source>what another setting would finish</source>
        <translation>was eine andere Einstellung fertig fräste</translation>
    </message>
    <message>
        <source>what carries a rotary axis is assumed</source>
        <translation>was eine Rundachse trägt, ist angenommen</translation>
    </message>
    <message>
        <source>what is left is known of a toolpath only: select a toolpath</source>
        <translation>Restmaterial ist nur von einem Werkzeugweg bekannt: einen Werkzeugweg auswählen</translation>
    </message>
    <message>
        <source>what stands after the end is not read</source>
        <translation>was nach dem Ende steht, wird nicht gelesen</translation>
    </message>
    <message>
        <source>what the drives make of it: servo lag, look-ahead, rounded corners</source>
        <translation>was die Antriebe daraus machen: Schleppabstand, Vorausschau, verrundete Ecken</translation>
    </message>
    <message>
        <source>what the machine's file does not say was taken as usual</source>
        <translation>was die Maschinendatei nicht sagt, wurde wie üblich angenommen</translation>
    </message>
    <message>
        <source>what the machine's file says of its base frame is not used</source>
        <translation>was die Maschinendatei über ihr Basissystem sagt, wird nicht benutzt</translation>
    </message>
    <message>
        <source>where an axis stands at the first motion is not said</source>
        <translation>wo eine Achse bei der ersten Bewegung steht, ist nicht gesagt</translation>
    </message>
    <message>
        <source>where it begins is not known: X, Y and Z are not all told since the tilted plane began or ended</source>
        <translation>wo er beginnt, ist nicht bekannt: X, Y und Z sind nicht alle genannt, seit die geschwenkte Ebene begann oder endete</translation>
    </message>
    <message>
        <source>where the axes stand before the program: the way of Z up to {height}, and the machine's bodies against each other while the axes go to the first block</source>
        <translation>wo die Achsen vor dem Programm stehen: der Weg von Z hinauf auf {height}, und die Körper der Maschine gegeneinander, während die Achsen zum ersten Satz fahren</translation>
    </message>
    <message>
        <source>where the controller guides the tip it turns the rotary axes evenly: so were tool, spindle and the machine's bodies looked at between the blocks' ends</source>
        <translation>wo die Steuerung die Spitze führt, dreht sie die Rundachsen gleichmäßig: so wurden Werkzeug, Spindel und die Körper der Maschine zwischen den Satzenden angesehen</translation>
    </message>
    <message>
        <source>where the program begins and ends, at Z {height}, tool and spindle are above part, fixtures and the machine's bodies, wherever the other axes stand, and from there Z comes down clear to the first block and rises clear from the last</source>
        <translation>wo das Programm beginnt und endet, auf Z {height}, sind Werkzeug und Spindel über Werkstück, Spannmitteln und den Körpern der Maschine, wo immer die anderen Achsen stehen, und von dort fährt Z frei zum ersten Satz hinab und steigt frei vom letzten</translation>
    </message>
    <message>
        <source>where the table is, is not known</source>
        <translation>wo der Tisch ist, ist nicht bekannt</translation>
    </message>
    <message>
        <source>whether tool and spindle meet {names} on the way to the first block: Z cannot go above them</source>
        <translation>ob Werkzeug und Spindel auf dem Weg zum ersten Satz auf {names} treffen: Z kann nicht darüber fahren</translation>
    </message>
    <message>
        <source>which kinematics a number switches to, as LinuxCNC counts</source>
        <translation>auf welche Kinematik eine Nummer umschaltet, wie LinuxCNC zählt</translation>
    </message>
    <message>
        <source>which lies above that place</source>
        <translation>weil dies über der Stelle liegt</translation>
    </message>
    <message>
        <source>with the part turned the rotary limits allow no way</source>
        <translation>mit gedrehtem Teil lassen die Grenzen der Rundachsen keinen Weg</translation>
    </message>
    <message>
        <source>with {letter}{first} {other}{second} the linear axes cannot place the tip; is it this machine's program?</source>
        <translation>mit {letter}{first} {other}{second} können die Linearachsen die Werkzeugspitze nicht setzen; ist es ein Programm dieser Maschine?</translation>
    </message>
    <message>
        <source>without {letters} there is no milling machine; name X, Y and Z</source>
        <translation>ohne {letters} gibt es keine Fräsmaschine; nennen Sie X, Y und Z</translation>
    </message>
    <message>
        <source>word {word} of row {row} is {value}; words are numbers up to {farthest_word} mm or degrees: correct it, or the unit of the file</source>
        <translation>Wort {word} der Zeile {row} ist {value}; Wörter sind Zahlen bis {farthest_word} mm oder Grad: berichtigen, oder die Einheit der Datei</translation>
    </message>
    <message>
        <source>words have shape {shape}; give one row of five words for each block</source>
        <translation>die Wörter haben die Form {shape}; je NC-Satz eine Zeile von fünf Wörtern angeben</translation>
    </message>
    <message>
        <source>words of an axis that the machine does not have</source>
        <translation>Wörter einer Achse, die die Maschine nicht hat</translation>
    </message>
    <message>
        <source>words that the reader does not interpret</source>
        <translation>Wörter werden nicht verstanden</translation>
    </message>
    <message>
        <source>words without a decimal point</source>
        <translation>Wörter ohne Dezimalpunkt</translation>
    </message>
    <message>
        <source>work offset is {offset}; give G54 to G59, or another that the controller has</source>
        <translation>die Nullpunktverschiebung ist {offset}; G54 bis G59 angeben oder eine andere, die die Steuerung hat</translation>
    </message>
    <message>
        <source>work offset {offset} is unknown to {name}; give {words}</source>
        <translation>die Nullpunktverschiebung {offset} kennt {name} nicht; angeben: {words}</translation>
    </message>
    <message>
        <source>wrap_strategy {wrap} is none of {wraps}</source>
        <translation>wrap_strategy {wrap} ist keines von {wraps}</translation>
    </message>
    <message>
        <source>write a decimal point</source>
        <translation>einen Dezimalpunkt schreiben</translation>
    </message>
    <message>
        <source>write one of {known}</source>
        <translation>eines schreiben von {known}</translation>
    </message>
    <message>
        <source>zeros of rotary axes are taken as right</source>
        <translation>Nullpunkte von Rundachsen gelten als richtig</translation>
    </message>
    <message>
        <source>{area} ({share} % of the mesh) at {place} lie inside another solid of the part and are not machined. Unite the solids in CAD, so that passes end at the seam.</source>
        <translation>{area} ({share} % des Netzes) bei {place} liegen in einem anderen Volumenkörper des Teils und werden nicht bearbeitet. Die Volumenkörper im CAD vereinigen, damit Bahnen an der Naht enden.</translation>
    </message>
    <message>
        <source>{area} ({share} % of the part) beside the faces to avoid are not cut, as at {place}: the cutter would come nearer to these than {allowance}. Cut them with a smaller cutter, or with a smaller allowance.</source>
        <translation>{area} ({share} % des Werkstücks) neben den ausgesparten Flächen werden nicht gefräst, etwa bei {place}: der Fräser käme diesen näher als {allowance}. Fräsen Sie sie mit einem kleineren Fräser oder mit kleinerem Abstand.</translation>
    </message>
    <message>
        <source>{area} ({share} % of the part) on facets of their own, as at {place}, lie so near to the faces to avoid that they are left out: the cutter would come nearer to these than {allowance}.</source>
        <translation>{area} ({share} % des Werkstücks) auf ganzen Facetten, etwa bei {place}, liegen so nahe an den ausgesparten Flächen, dass sie ausgelassen werden: der Fräser käme diesen näher als {allowance}.</translation>
    </message>
    <message>
        <source>{area} ({share} % {of_whole}) are left out, for no tool axis is free there: {remedy}.</source>
        <translation>{area} ({share} % {of_whole}) werden ausgelassen, weil dort keine Werkzeugachse frei ist: {remedy}.</translation>
    </message>
    <message>
        <source>{area} ({share} % {of_whole}) look down and are left out: no tool axis that the machine takes up gets there. Turn the part over.</source>
        <translation>{area} ({share} % {of_whole}) zeigen nach unten und werden ausgelassen: Keine Werkzeugachse, die die Maschine einnehmen kann, kommt dorthin. Das Werkstück wenden.</translation>
    </message>
    <message>
        <source>{area} ({share} % {of_whole}) look down and are left out: no tool axis within {most} of Z gets there. Turn the part over, or raise the largest axis angle.</source>
        <translation>{area} ({share} % {of_whole}) zeigen nach unten und werden ausgelassen: Keine Werkzeugachse innerhalb von {most} um Z kommt dorthin. Das Werkstück wenden oder den größten Achswinkel erhöhen.</translation>
    </message>
    <message>
        <source>{area} ({share} % {of_whole}), the first at {place}, are left out, for the tool is free there in none of the {count} frames, nor along any other axis that was tried: use a smaller tool.</source>
        <translation>{area} ({share} % {of_whole}), die erste Stelle bei {place}, werden ausgelassen, weil das Werkzeug dort in keiner der {count} Anstellungen frei ist, auch entlang keiner anderen versuchten Achse: ein kleineres Werkzeug verwenden.</translation>
    </message>
    <message>
        <source>{area} ({share} % {of_whole}), the first at {place}, are left out, for the tool is free there in none of the {count} frames, though it is along other axes: {more}.</source>
        <translation>{area} ({share} % {of_whole}), die erste Stelle bei {place}, werden ausgelassen, weil das Werkzeug dort in keiner der {count} Anstellungen frei ist, wohl aber entlang anderer Achsen: {more}.</translation>
    </message>
    <message>
        <source>{at} in the machine frame with the axes that carry it at zero</source>
        <translation>{at} im Maschinensystem, die tragenden Achsen auf null</translation>
    </message>
    <message>
        <source>{begin} {text}</source>
        <translation>{begin} {text}</translation>
    </message>
    <message>
        <source>{blocks} more of {letter} than it can: at most NC line {line}, {commanded_rate}, {share} times its maximum of {most}; first NC line {first}. The control slows down there, or stops with a fault. Give a lower F there, or inverse time (G93) made for this machine, as {post} does.</source>
        <translation>{blocks} mehr von {letter}, als die Achse kann: höchstens NC-Zeile {line}, {commanded_rate}, das {share}-fache ihrer größten Geschwindigkeit von {most}; die erste ist NC-Zeile {first}. Die Steuerung wird dort langsamer oder hält mit einem Fehler an. Dort ein kleineres F geben oder zeitreziproken Vorschub (G93), für diese Maschine ausgegeben, wie {post} es tut.</translation>
    </message>
    <message>
        <source>{blocks} near the pole (the tool almost along the {letter} axis), where {letter} must turn far to lean the tool a little. The worst is NC line {line}: {turns}. The axis may be too slow for the programmed feed, the tool dwells, and marks or a deviation from the path may show.</source>
        <translation>{blocks} nahe am Pol (das Werkzeug fast entlang der Achse {letter}), wo {letter} weit drehen muss, um das Werkzeug ein wenig zu neigen. Am schlimmsten ist NC-Zeile {line}: {turns}. Die Achse ist vielleicht zu langsam für den programmierten Vorschub, das Werkzeug verweilt, und Marken oder eine Abweichung vom Weg können zu sehen sein.</translation>
    </message>
    <message>
        <source>{blocks} near the pole (the tool almost along the {letter} axis), where {letter} turns more than the tool leans: most in NC line {line}, where {turns}. Each holds the tolerance by proof, and no rotary axis comes to its maximum rate there.</source>
        <translation>{blocks} nahe am Pol (das Werkzeug fast längs der {letter}-Achse); dort dreht {letter} mehr, als das Werkzeug sich neigt: am meisten in NC-Zeile {line}: {turns}. Jeder hält die Toleranz nachweislich ein, und keine Rundachse erreicht dort ihre höchste Drehzahl.</translation>
    </message>
    <message>
        <source>{blocks} so near to the tolerance of {tolerance} that the proof does not reach: the deviation is within it, its proven upper bound is not (worst, NC line {line}: bound {bound}).</source>
        <translation>{blocks} so nahe an der Toleranz von {tolerance}, dass der Nachweis nicht reicht: die Abweichung liegt darin, ihre bewiesene obere Schranke nicht (am schlimmsten NC-Zeile {line}: Schranke {bound}).</translation>
    </message>
    <message>
        <source>{blocks} the commanded path by more than {tolerance}; the worst, NC line {line}, by {deviation}: there {turns} within a step of {step}.</source>
        <translation>{blocks} den Sollweg um mehr als {tolerance}; am schlimmsten NC-Zeile {line}, um {deviation}: dort {turns} innerhalb eines Schritts von {step}.</translation>
    </message>
    <message>
        <source>{blocks} {letter} beyond its limit of {limit}: farthest NC line {line}, {letter}{word}, {beyond} too far; first NC line {first}. {help}, or take a machine with more travel.</source>
        <translation>{blocks} {letter} über die Grenze von {limit} hinaus: am weitesten NC-Zeile {line}, {letter}{word}, {beyond} zu weit; die erste ist NC-Zeile {first}. {help}, oder eine Maschine mit mehr Weg nehmen.</translation>
    </message>
    <message>
        <source>{bodies} has the bodies of a LinuxCNC .ini; leave it out for {path}</source>
        <translation>{bodies} hat die Körper zu einer .ini von LinuxCNC; lassen Sie es bei {path} weg</translation>
    </message>
    <message>
        <source>{cause} What follows from it is not told one by one ({count} in all): {codes}.</source>
        <translation>{cause} Was daraus folgt, wird nicht einzeln genannt (zusammen {count}): {codes}.</translation>
    </message>
    <message>
        <source>{change} {rate}, {turned}, {blocks}</source>
        <translation>{change} {rate}, {turned}, {blocks}</translation>
    </message>
    <message>
        <source>{clearance} mm is no clearance; give 0 to {most} mm</source>
        <translation>{clearance} mm ist kein Abstand; 0 bis {most} mm angeben</translation>
    </message>
    <message>
        <source>{count} HAL files cannot be read; {module} takes no value from them. The first: {error}</source>
        <translation>{count} HAL-Dateien lassen sich nicht lesen; {module} nimmt keinen Wert daraus. Die erste: {error}</translation>
    </message>
    <message>
        <source>{count} NC lines have an F above {most}, the largest that {name} takes under {mode}, the largest in line {line}, F{feed}: it refuses them. Post the program with longer blocks, or with a lower F.</source>
        <translation>{count} NC-Zeilen haben ein F über {most}, dem größten, das {name} unter {mode} nimmt, am größten in Zeile {line}, F{feed}: sie werden abgelehnt. Das Programm mit längeren Sätzen oder kleinerem F ausgeben.</translation>
    </message>
    <message>
        <source>{count} arcs do not pass through the points before and after them (worst line {line}: off by {off}, radius {radius}); the path goes straight there. Has the CAM system left out a move, or are the units mixed?</source>
        <translation>{count} Kreisbögen gehen nicht durch die Punkte vor und nach ihnen (am schlimmsten Zeile {line}: {off} daneben, Radius {radius}); der Weg ist dort gerade. Hat das CAM-System eine Bewegung ausgelassen, oder sind die Einheiten gemischt?</translation>
    </message>
    <message>
        <source>{count} arcs have no centre that fits their start and end; they are taken as straight. Post straight moves.</source>
        <translation>{count} Kreisbögen haben keinen Mittelpunkt, der zu Anfang und Ende passt; sie werden als Geraden genommen. Geraden ausgeben.</translation>
    </message>
    <message>
        <source>{count} arcs lack their start or their end (first line {line}): they stand before the first move, after the last one, before another arc or a hole, or their direction points to their centre. The path goes straight there.</source>
        <translation>{count} Bögen fehlt Anfang oder Ende (erste Zeile {line}): Sie stehen vor der ersten Bewegung, nach der letzten, vor einem anderen Bogen oder einer Bohrung, oder ihre Richtung zeigt auf ihren Mittelpunkt. Die Bahn geht dort gerade.</translation>
    </message>
    <message>
        <source>{count} arcs run back against the straight moves beside them (first line {line}): does the CAM system mean its circles the other way round? Have curves written as points.</source>
        <translation>{count} Kreisbögen laufen den geraden Bewegungen neben ihnen entgegen (zuerst Zeile {line}): Meint das CAM-System seine Kreise andersherum? Kurven als Punkte ausgeben lassen.</translation>
    </message>
    <message>
        <source>{count} arcs tell by I, J or K across their plane a height for each turn that is not theirs: they are taken without more turns than one. Give the plane (G17, G18, G19), or post helices turn by turn.</source>
        <translation>{count} Kreisbögen nennen mit I, J oder K quer zu ihrer Ebene eine Höhe je Umlauf, die nicht ihre ist: sie werden mit höchstens einem Umlauf gelesen. Die Ebene angeben (G17, G18, G19) oder Schraubenlinien Umlauf für Umlauf ausgeben.</translation>
    </message>
    <message>
        <source>{count} arcs turn back where straight moves meet them (first line {line}), as in corners beside islands; {on} others of the file run on as read.</source>
        <translation>{count} Bögen kehren um, wo Geraden an sie stoßen (zuerst Zeile {line}), wie in Ecken neben Inseln; {on} andere der Datei laufen weiter wie gelesen.</translation>
    </message>
    <message>
        <source>{count} block near the pole</source>
        <translation>{count} NC-Satz nahe am Pol</translation>
    </message>
    <message>
        <source>{count} blocks are over {tolerance} and were left whole (the first leads to {spot}): no number of blocks holds it there, because the linear axes turn into one plane on the way. Turn the part on the table, or take another machine.</source>
        <translation>{count} NC-Sätze liegen über {tolerance} und blieben ganz (der erste führt zu {spot}): keine Zahl von Sätzen hält es dort ein, weil die Linearachsen unterwegs in eine Ebene drehen. Das Werkstück auf dem Tisch drehen oder eine andere Maschine nehmen.</translation>
    </message>
    <message>
        <source>{count} blocks cannot be held within {tolerance}: words of {linear} and {rotary} decimals put the tip up to {most_off} off. The worst, which leads to {spot}, is proven to hold {value}. Allow more, or use a controller with finer words.</source>
        <translation>{count} NC-Sätze lassen sich nicht innerhalb {tolerance} halten: Wörter mit {linear} und {rotary} Dezimalen setzen die Werkzeugspitze bis zu {most_off} daneben. Der schlimmste, der zu {spot} führt, hält nachweislich {value} ein. Mehr erlauben oder eine Steuerung mit feineren Wörtern nehmen.</translation>
    </message>
    <message>
        <source>{count} blocks feed after a move to a machine position, before {axes} has a word again in a rapid move: they are taken from where the axis stood before. Give {axes} first.</source>
        <translation>{count} Sätze fahren nach einer Maschinenposition im Vorschub, bevor {axes} im Eilgang wieder ein Wort hat: Sie sind von dort genommen, wo die Achse vorher stand. Zuerst {axes} angeben.</translation>
    </message>
    <message>
        <source>{count} blocks have no F above 0 in force; most controllers stop there. Give F.</source>
        <translation>{count} NC-Sätze haben kein gültiges F über 0; die meisten Steuerungen halten dort an. F angeben.</translation>
    </message>
    <message>
        <source>{count} blocks lead</source>
        <translation>{count} NC-Sätze führen</translation>
    </message>
    <message>
        <source>{count} blocks near the pole</source>
        <translation>{count} NC-Sätze nahe am Pol</translation>
    </message>
    <message>
        <source>{count} blocks stand under G500 after a work offset: where they lead only the machine knows, and they are not right here. Post them under the offset, or as machine positions (SUPA).</source>
        <translation>{count} Sätze stehen nach einer Nullpunktverschiebung unter G500: wohin sie führen, weiß nur die Maschine, und sie stimmen hier nicht. Unter der Verschiebung oder als Maschinenpositionen (SUPA) ausgeben.</translation>
    </message>
    <message>
        <source>{count} blocks take the shorter way to {letter}, as the machine file says (modulo). {name} does so only if it is set to: check it.</source>
        <translation>{count} NC-Sätze nehmen den kürzeren Weg nach {letter}, wie die Maschinendatei sagt (modulo). {name} tut das nur, wenn so eingestellt: prüfen.</translation>
    </message>
    <message>
        <source>{count} blocks under G93 have no F of their own; most controllers stop there. Give F in every block.</source>
        <translation>{count} NC-Sätze unter G93 haben kein eigenes F; die meisten Steuerungen halten dort an. F in jedem Satz angeben.</translation>
    </message>
    <message>
        <source>{count} blocks were over {tolerance} and were divided into {pieces}, as few as hold it by proof.</source>
        <translation>{count} NC-Sätze lagen über {tolerance} und wurden in {pieces} geteilt, so wenige, wie es nachweislich einhalten.</translation>
    </message>
    <message>
        <source>{count} blocks would turn {letter} by more than half a turn ({cutting} of them feed blocks); the control takes the shorter way there (wrap_strategy modulo), and so do the words here. Divide blocks, or set wrap_strategy to unwound.</source>
        <translation>{count} NC-Sätze würden {letter} um mehr als eine halbe Umdrehung drehen (davon {cutting} Vorschubsätze); die Steuerung nimmt dort den kürzeren Weg (wrap_strategy modulo), und so die Wörter hier. Sätze teilen oder wrap_strategy auf unwound setzen.</translation>
    </message>
    <message>
        <source>{count} bodies of {name} are taken, moved by {shift} so that its tool's tip stands in the gauge point. By it the table moves with {table}, the tool with {head}. Take out what is only drawn there (marks, a workpiece) with the machine editor.</source>
        <translation>{count} Körper aus {name} sind übernommen, verschoben um {shift}, sodass die Spitze des Werkzeugs im Bezugspunkt steht. Danach bewegt sich der Tisch mit {table}, das Werkzeug mit {head}. Nehmen Sie im Maschineneditor heraus, was dort nur gezeichnet ist (Marken, ein Werkstück).</translation>
    </message>
    <message>
        <source>{count} corners (,R ,C, RND=, RNDM=, CHR=, CHF=) are left sharp, first NC line {line}: they stand between other moves than lines (of a rounding, arcs) in the working plane, or these are too short. Post their arcs and lines.</source>
        <translation>{count} Ecken (,R ,C, RND=, RNDM=, CHR=, CHF=) bleiben scharf, erste NC-Zeile {line}: sie stehen zwischen anderen Bewegungen als Geraden (bei Rundungen auch Bögen) in der Arbeitsebene, oder diese sind zu kurz. Ihre Bögen und Geraden ausgeben.</translation>
    </message>
    <message>
        <source>{count} corners lie on a side of another facet, the first at {at}; that facet was divided there.</source>
        <translation>{count} Ecken liegen auf der Seite einer anderen Facette, die erste bei {at}; diese Facette wurde dort geteilt.</translation>
    </message>
    <message>
        <source>{count} corners next to others, the first at {at}, were joined with them.</source>
        <translation>{count} Ecken dicht neben anderen, die erste bei {at}, wurden mit diesen verbunden.</translation>
    </message>
    <message>
        <source>{count} drilling cycles (first line {line}) are not ended by CYCLE/OFF: they are taken to end at the next tool, operation or arc (first line {end}), and the moves behind that drill no holes. Say CYCLE/OFF.</source>
        <translation>{count} Bohrzyklen (erste Zeile {line}) werden nicht durch CYCLE/OFF beendet: Sie gelten als beendet beim nächsten Werkzeug, Arbeitsgang oder Bogen (zuerst Zeile {end}), und die Bewegungen danach bohren nicht. CYCLE/OFF angeben.</translation>
    </message>
    <message>
        <source>{count} drilling cycles dwell at the bottom (first line {line}): the tool does not wait there in the program.</source>
        <translation>{count} Bohrzyklen verweilen am Grund (zuerst Zeile {line}): Im Programm wartet das Werkzeug dort nicht.</translation>
    </message>
    <message>
        <source>{count} drilling cycles with pecks say no STEP (first line {line}): their holes are drilled in one go. Say the step, if the chips are to come out.</source>
        <translation>{count} Bohrzyklen mit Zustellungen nennen kein STEP (zuerst Zeile {line}): Ihre Bohrungen werden in einem Zug gebohrt. Die Zustellung angeben, wenn die Späne herauskommen sollen.</translation>
    </message>
    <message>
        <source>{count} facets</source>
        <translation>{count} Facetten</translation>
    </message>
    <message>
        <source>{count} facets of {area} ({share} % of the part) face away from the spindle and are left out; turn the part over to cut them, or raise the largest axis angle.</source>
        <translation>{count} Facetten mit {area} ({share} % des Werkstücks) zeigen von der Spindel weg und sind ausgelassen; das Werkstück wenden, um sie zu fräsen, oder den größten Achswinkel erhöhen.</translation>
    </message>
    <message>
        <source>{count} facets of {area} ({share} % of the part) lean more than {most} from Z and are left out; raise the largest axis angle to cut them.</source>
        <translation>{count} Facetten mit {area} ({share} % des Werkstücks) neigen sich um mehr als {most} gegen Z und sind ausgelassen; den größten Achswinkel erhöhen, um sie zu fräsen.</translation>
    </message>
    <message>
        <source>{count} facets of {area} ({share} % of the part) lie across the axis of the passes or face it, and are left out: a tool square to that axis does not reach them. Cut them with other passes.</source>
        <translation>{count} Facetten mit {area} ({share} % des Werkstücks) liegen quer zur Achse der Bahnen oder sind ihr zugewandt und sind ausgelassen: ein Werkzeug senkrecht zu dieser Achse erreicht sie nicht. Fräsen Sie sie mit anderen Bahnen.</translation>
    </message>
    <message>
        <source>{count} facets of {area} ({share} % of the part) lie on {name} and are machined. The others are not; {gouge} keeps the tool out of all of them.</source>
        <translation>{count} Facetten mit {area} ({share} % des Werkstücks) liegen auf {name} und werden bearbeitet. Die anderen nicht; {gouge} hält das Werkzeug aus allen heraus.</translation>
    </message>
    <message>
        <source>{count} facets of {area} ({share} % of the part) lie on {name} and are not machined; {gouge} keeps the tool out of them.</source>
        <translation>{count} Facetten von {area} ({share} % des Teils) liegen auf {name} und werden nicht bearbeitet; {gouge} hält das Werkzeug aus ihnen heraus.</translation>
    </message>
    <message>
        <source>{count} facets of {area} ({share} % of the part) need a tool axis to which no rotary axis of the machine turns and are left out; turn the part or take another machine to cut them.</source>
        <translation>{count} Facetten mit {area} ({share} % des Werkstücks) brauchen eine Werkzeugachse, zu der keine Rundachse der Maschine schwenkt, und sind ausgelassen; das Werkstück drehen oder eine andere Maschine nehmen, um sie zu fräsen.</translation>
    </message>
    <message>
        <source>{count} facets of {area} ({share} % of the part) need {limits} beyond its limits and are left out; turn the part or take another machine to cut them.</source>
        <translation>{count} Facetten mit {area} ({share} % des Werkstücks) brauchen {limits} jenseits der Grenzen und sind ausgelassen; das Werkstück drehen oder eine andere Maschine nehmen, um sie zu fräsen.</translation>
    </message>
    <message>
        <source>{count} facets of {area} ({share} % of what was to be machined) lie outside boundary {name} and are not machined; {gouge} keeps the tool out of them.</source>
        <translation>{count} Facetten von {area} ({share} % des zu Bearbeitenden) liegen außerhalb der Begrenzung {name} und werden nicht bearbeitet; {gouge} hält das Werkzeug aus ihnen heraus.</translation>
    </message>
    <message>
        <source>{count} facets were there twice, the first at {at}; one of each was kept.</source>
        <translation>{count} Facetten waren doppelt vorhanden, die erste bei {at}; je eine wurde behalten.</translation>
    </message>
    <message>
        <source>{count} facets without area were left out, the first at {at}; passes end where that leaves a crack.</source>
        <translation>{count} Facetten ohne Fläche sind ausgelassen, die erste bei {at}; Bahnen enden, wo dadurch ein Riss bleibt.</translation>
    </message>
    <message>
        <source>{count} facets, the first at {at}, faced the other way than their neighbours and were turned round.</source>
        <translation>{count} Facetten, die erste bei {at}, zeigten zur anderen Seite als ihre Nachbarn und wurden umgedreht.</translation>
    </message>
    <message>
        <source>{count} facets, the first at {at}, make solids that looked inward beside others and were turned outward. Check the export if one of them should be a cavity.</source>
        <translation>{count} Facetten, die erste bei {at}, bilden Körper, die neben anderen nach innen zeigten und nach außen gewendet wurden. Den Export prüfen, falls einer davon ein Hohlraum sein soll.</translation>
    </message>
    <message>
        <source>{count} feed blocks</source>
        <translation>{count} Vorschubsätzen</translation>
    </message>
    <message>
        <source>{count} feed blocks (between NC lines {first} and {last})</source>
        <translation>{count} Vorschubsätzen (zwischen den NC-Zeilen {first} und {last})</translation>
    </message>
    <message>
        <source>{count} feed blocks are</source>
        <translation>{count} Vorschubsätze liegen</translation>
    </message>
    <message>
        <source>{count} feed blocks ask</source>
        <translation>{count} Vorschubsätze verlangen</translation>
    </message>
    <message>
        <source>{count} feed blocks leave</source>
        <translation>{count} Vorschubsätze verlassen</translation>
    </message>
    <message>
        <source>{count} feed blocks lie</source>
        <translation>{count} Vorschubsätze liegen</translation>
    </message>
    <message>
        <source>{count} feed blocks turn {letter} by nearly a whole turn, and all its words lie within one: they seem meant by the shorter way. If the control takes it, set wrap_strategy to modulo.</source>
        <translation>{count} Vorschubsätze drehen {letter} um fast eine ganze Umdrehung, und alle Wörter liegen innerhalb einer: gemeint ist wohl der kürzere Weg. Nimmt ihn die Steuerung, wrap_strategy auf modulo stellen.</translation>
    </message>
    <message>
        <source>{count} finite numbers</source>
        <translation>{count} endliche Zahlen</translation>
    </message>
    <message>
        <source>{count} job: {well} without errors, {errors} with errors, {failed} failed</source>
        <translation>{count} Auftrag: {well} ohne Fehler, {errors} mit Fehlern, {failed} gescheitert</translation>
    </message>
    <message>
        <source>{count} jobs: {well} without errors, {errors} with errors, {failed} failed</source>
        <translation>{count} Aufträge: {well} ohne Fehler, {errors} mit Fehlern, {failed} gescheitert</translation>
    </message>
    <message>
        <source>{count} lines begin with a colon without a number; the rest of them is read.</source>
        <translation>{count} Zeilen beginnen mit einem Doppelpunkt ohne Nummer; ihr Rest wird gelesen.</translation>
    </message>
    <message>
        <source>{count} lines begin with a slash (block skip); they are read as if the switch were off.</source>
        <translation>{count} Zeilen beginnen mit einem Schrägstrich (Satz ausblenden); sie werden gelesen, als wäre der Schalter aus.</translation>
    </message>
    <message>
        <source>{count} lines by their angle (,A, ANG=) are not worked out, first NC line {line}: it takes one coordinate of the end, or a next line with an angle and both. Post the places of their ends.</source>
        <translation>{count} Geraden mit Winkel (,A, ANG=) sind nicht bestimmt, erste NC-Zeile {line}: es braucht eine Koordinate des Endes oder eine nächste Gerade mit Winkel und beiden. Die Orte ihrer Enden ausgeben.</translation>
    </message>
    <message>
        <source>{count} lines have a slash (block skip) between their words; what stands behind it is read as if the switch were off.</source>
        <translation>In {count} Zeilen steht ein Schrägstrich (Satz ausblenden) zwischen den Wörtern; was dahinter steht, wird gelesen, als wäre der Schalter aus.</translation>
    </message>
    <message>
        <source>{count} lines hold variables, expressions or jumps, which are not interpreted; their words are missing here. Post without them. The first: {shown}.</source>
        <translation>{count} Zeilen enthalten Variablen, Ausdrücke oder Sprünge, die nicht ausgewertet werden; ihre Wörter fehlen hier. Ohne sie ausgeben. Die erste: {shown}.</translation>
    </message>
    <message>
        <source>{count} lines select a kinematics that is not known here (the first: G12.1 P{number}); the words after them are taken as those of the axes. Post with G12.1 P0 and G13.1.</source>
        <translation>{count} Zeilen wählen eine hier unbekannte Kinematik (die erste: G12.1 P{number}); die Wörter danach gelten als die der Achsen. Mit G12.1 P0 und G13.1 ausgeben.</translation>
    </message>
    <message>
        <source>{count} links or rewinds go round bodies of the machine, at most {height} higher than over the part alone.</source>
        <translation>{count} Verbindungen oder Rückdrehungen fahren um Maschinenkörper herum, höchstens {height} höher als über das Teil allein.</translation>
    </message>
    <message>
        <source>{count} more</source>
        <translation>{count} weitere</translation>
    </message>
    <message>
        <source>{count} moves after MULTAX/OFF say no axis; the tool keeps the last one, which is not upright.</source>
        <translation>{count} Bewegungen nach MULTAX/OFF nennen keine Achse; das Werkzeug behält die letzte, die nicht senkrecht ist.</translation>
    </message>
    <message>
        <source>{count} moves come before any FEDRAT; give a feed.</source>
        <translation>{count} Bewegungen kommen vor jedem FEDRAT; einen Vorschub angeben.</translation>
    </message>
    <message>
        <source>{count} numbers for {words} words; the text is malformed</source>
        <translation>{count} Zahlen für {words} Wörter; der Text ist fehlerhaft</translation>
    </message>
    <message>
        <source>{count} objects are selected ({labels}): select one, or make a compound of them.</source>
        <translation>{count} Objekte sind ausgewählt ({labels}): eines auswählen oder einen Verbund daraus machen.</translation>
    </message>
    <message>
        <source>{count} of the {all}</source>
        <translation>{count} der {all}</translation>
    </message>
    <message>
        <source>{count} of them lie</source>
        <translation>{count} davon liegen</translation>
    </message>
    <message>
        <source>{count} of them lies</source>
        <translation>{count} davon liegt</translation>
    </message>
    <message>
        <source>{count} of {all} ends of passes has a smaller lead-in or lead-out than {radius}, or none, because the tool would enter the part or the table on it; a smaller radius fits in more places.</source>
        <translation>{count} von {all} Bahnenden hat einen kleineren An- oder Abfahrbogen als {radius} oder keinen, weil das Werkzeug darauf in das Werkstück oder den Tisch eindringen würde; ein kleinerer Radius passt an mehr Stellen.</translation>
    </message>
    <message>
        <source>{count} of {all} ends of passes have a smaller lead-in or lead-out than {radius}, or none, because the tool would enter the part or the table on it; a smaller radius fits in more places.</source>
        <translation>{count} von {all} Bahnenden haben einen kleineren An- oder Abfahrbogen als {radius} oder keinen, weil das Werkzeug darauf in das Werkstück oder den Tisch eindringen würde; ein kleinerer Radius passt an mehr Stellen.</translation>
    </message>
    <message>
        <source>{count} of {all} feed blocks leave the path by up to {deviation}, {tolerance} allowed (NC line {line})</source>
        <translation>{count} von {all} Vorschubsätzen verlassen den Weg um bis zu {deviation}, erlaubt sind {tolerance} (NC-Zeile {line})</translation>
    </message>
    <message>
        <source>{count} of {all} feed blocks leaves the path by up to {deviation}, {tolerance} allowed (NC line {line})</source>
        <translation>{count} von {all} Vorschubsätzen verlässt den Weg um bis zu {deviation}, erlaubt sind {tolerance} (NC-Zeile {line})</translation>
    </message>
    <message>
        <source>{count} of {all} feed blocks {what} Worst is NC line {line}, {off} off ({tolerance} allowed); first NC line {first}.</source>
        <translation>{count} von {all} Vorschubsätzen {what} Am schlimmsten ist NC-Zeile {line}, {off} daneben ({tolerance} erlaubt); die erste ist NC-Zeile {first}.</translation>
    </message>
    <message>
        <source>{count} of {all} points need a leaning tool, the first is {axis} at {place}, and this machine has no rotary axis: keep the tool axis along Z ({fixed}) or take another machine</source>
        <translation>{count} von {all} Punkten brauchen ein geneigtes Werkzeug, der erste ist {axis} bei {place}, und diese Maschine hat keine Rundachse: die Werkzeugachse längs Z lassen ({fixed}) oder eine andere Maschine nehmen</translation>
    </message>
    <message>
        <source>{count} of {all} points need a tool axis that the rotary limits of {letters} do not allow, the first is {axis} at {place}: widen the limits, lower {max_axis_angle} or take another machine</source>
        <translation>{count} von {all} Punkten brauchen eine Werkzeugachse, die die Grenzen der Rundachsen {letters} nicht erlauben, zuerst {axis} bei {place}: die Grenzen erweitern, {max_axis_angle} verringern oder eine andere Maschine nehmen</translation>
    </message>
    <message>
        <source>{count} of {all} points need a tool axis that {letter} alone does not reach within its limits, the first is {axis} at {place}: keep the tool axis along Z ({fixed}), widen the limits or take a machine with two rotary axes</source>
        <translation>{count} von {all} Punkten brauchen eine Werkzeugachse, die {letter} allein in seinen Grenzen nicht erreicht, der erste {axis} bei {place}: die Werkzeugachse entlang Z halten ({fixed}), die Grenzen erweitern oder eine Maschine mit zwei Rundachsen nehmen</translation>
    </message>
    <message>
        <source>{count} of {all} rows do not fit and are left out (NC lines {lines}); their tips would be off by up to {miss}. Look at them: they are wrong in the CL path or in the program.</source>
        <translation>{count} von {all} Zeilen passen nicht und sind ausgelassen (NC-Zeilen {lines}); ihre Werkzeugspitzen lägen um bis zu {miss} daneben. Ansehen: sie sind im CL-Weg oder im Programm falsch.</translation>
    </message>
    <message>
        <source>{count} of {all} ways hold {tolerance}; the quickest is {way}, {time}.</source>
        <translation>{count} von {all} Wegen halten {tolerance} ein; der schnellste ist {way}, {time}.</translation>
    </message>
    <message>
        <source>{count} other layouts explain the rows as well: {more}. The plainest is written; give more rows, with larger turns of both rotary axes, or the machine with {machine}.</source>
        <translation>{count} andere Anordnungen erklären die Zeilen ebenso: {more}. Geschrieben ist die einfachste; mehr Zeilen mit größeren Drehungen beider Rundachsen angeben, oder die Maschine mit {machine}.</translation>
    </message>
    <message>
        <source>{count} passes are turned past the pole: {letter} turns at most {after} instead of {before} on them, and {turns} instead of {turned} in all, for an axis changed by up to {most}.</source>
        <translation>{count} Bahnen sind am Pol vorbeigedreht: {letter} dreht auf ihnen höchstens {after} statt {before}, und insgesamt {turns} statt {turned}, bei einer um bis zu {most} geänderten Achse.</translation>
    </message>
    <message>
        <source>{count} passes come within {limit} of the pole and could not be turned past it any better: {letter} turns up to {rate} there. A larger angle, wider rotary limits or another setup may help.</source>
        <translation>{count} Bahnen kommen dem Pol näher als {limit} und ließen sich nicht besser vorbeidrehen: {letter} dreht dort bis zu {rate}. Ein größerer Winkel, weitere Grenzen der Rundachsen oder eine andere Aufspannung können helfen.</translation>
    </message>
    <message>
        <source>{count} rapids are divided by {rows} more blocks, so that the tool stays clear of the part on whichever way {name} drives the axes between their ends.</source>
        <translation>{count} Eilgänge sind durch {rows} weitere Sätze geteilt, damit das Werkzeug vom Werkstück frei bleibt, auf welchem Weg {name} die Achsen zwischen ihren Enden auch fährt.</translation>
    </message>
    <message>
        <source>{count} retracts or approaches pass below the part, because the tool looks down there. Check that nothing holds the part from below, or choose a tool axis that looks up.</source>
        <translation>{count} Rückzüge oder Anfahrten gehen unter dem Werkstück durch, weil das Werkzeug dort nach unten zeigt. Prüfen, dass nichts das Werkstück von unten hält, oder eine Werkzeugachse wählen, die nach oben zeigt.</translation>
    </message>
    <message>
        <source>{count} rows of the CL file are not cut: no feed block comes within {tolerance} of them. The first is row {first} of {all}, the farthest row {missed}, {distance} off. Is the program whole, and made from this file?</source>
        <translation>{count} Zeilen der CL-Datei werden nicht gefräst: kein Vorschubsatz kommt ihnen näher als {tolerance}. Die erste ist Zeile {first} von {all}, die fernste Zeile {missed}, {distance} entfernt. Ist das Programm vollständig und aus dieser Datei entstanden?</translation>
    </message>
    <message>
        <source>{count} setups that were tried are passed over, because the machine is hit there: with the work zero at {origin} the {name} by {depth}.</source>
        <translation>{count} geprüfte Aufspannungen sind übergangen, weil dort die Maschine getroffen wird: mit dem Werkstück-Nullpunkt bei {origin} wird {name} um {depth} getroffen.</translation>
    </message>
    <message>
        <source>{count} shapes of {name} move with the tool's length; they are taken for the tool, not for bodies.</source>
        <translation>{count} Formen aus {name} bewegen sich mit der Werkzeuglänge; sie gelten als Werkzeug, nicht als Körper.</translation>
    </message>
    <message>
        <source>{count} sides are not machined ({area})</source>
        <translation>{count} Seiten sind nicht bearbeitet ({area})</translation>
    </message>
    <message>
        <source>{count} statements, line {lines}</source>
        <translation>{count} Anweisung, Zeile {lines}</translation>
    </message>
    <message>
        <source>{count} statements, lines {lines}</source>
        <translation>{count} Anweisungen, Zeilen {lines}</translation>
    </message>
    <message>
        <source>{count} times the tool passes below the part between two cuts, because it looks down there. Check that nothing holds the part from below, or choose a tool axis that looks up.</source>
        <translation>{count} Mal geht das Werkzeug zwischen zwei Schnitten unter dem Werkstück durch, weil es dort nach unten zeigt. Prüfen, dass nichts das Werkstück von unten hält, oder eine Werkzeugachse wählen, die nach oben zeigt.</translation>
    </message>
    <message>
        <source>{count} times the tool retracts between two cuts and {letter} turns back above the part, within its limits: that takes time and leaves no mark.</source>
        <translation>{count}-mal hebt das Werkzeug zwischen zwei Schnitten ab, und {letter} dreht über dem Werkstück zurück, um in seinen Grenzen zu bleiben: Das kostet Zeit und hinterlässt keine Spur.</translation>
    </message>
    <message>
        <source>{count} tool axes are no unit vectors; they are scaled to length 1.</source>
        <translation>{count} Werkzeugachsen sind keine Einheitsvektoren; sie werden auf Länge 1 gebracht.</translation>
    </message>
    <message>
        <source>{count} tool axes cannot be taken up by this machine; the one before each is kept. Choose its own machine.</source>
        <translation>{count} Werkzeugachsen kann diese Maschine nicht einnehmen; die jeweils vorige bleibt. Die Maschine des Programms wählen.</translation>
    </message>
    <message>
        <source>{count} words have no decimal point; taken as they stand: {word} is {value}. If the control counts its least increment, it is {small} there: give {option}.</source>
        <translation>{count} Wörter haben keinen Dezimalpunkt; gelesen, wie sie dastehen: {word} ist {value}. Zählt die Steuerung ihr kleinstes Inkrement, ist es dort {small}: {option} angeben.</translation>
    </message>
    <message>
        <source>{count} words {letter}, the first in NC line {line}, are not interpreted: what they do is missing here. Post without them, or see that they move nothing and change no feed.</source>
        <translation>{count} Wörter {letter}, das erste in NC-Zeile {line}, werden nicht ausgewertet: Was sie bewirken, fehlt hier. Ohne sie ausgeben oder nachsehen, dass sie nichts bewegen und keinen Vorschub ändern.</translation>
    </message>
    <message>
        <source>{deep} are cut too deep, at most by {most}</source>
        <translation>{deep} sind zu tief gefräst, höchstens um {most}</translation>
    </message>
    <message>
        <source>{edges} edges have more than two facets, the first at {at}; passes end there. Separate or unite the bodies that meet there.</source>
        <translation>{edges} Kanten haben mehr als zwei Facetten, die erste bei {at}; Bahnen enden dort. Die Körper, die sich dort treffen, trennen oder vereinigen.</translation>
    </message>
    <message>
        <source>{edges} edges have one facet only, the first at {at}: the facets hang together nearly nowhere, and passes end at each of them. Export the mesh again with common corners, or repair it (in FreeCAD: Evaluate and repair mesh, Duplicated points).</source>
        <translation>{edges} Kanten haben nur eine Facette, die erste bei {at}: Die Facetten hängen fast nirgends zusammen, und Bahnen enden an jeder von ihnen. Das Netz noch einmal mit gemeinsamen Ecken exportieren oder reparieren (in FreeCAD: Netz auswerten und reparieren, doppelte Punkte).</translation>
    </message>
    <message>
        <source>{edges} edges have two facets that run along them in the same sense, the first at {at}; passes end there. Unify the facet normals.</source>
        <translation>{edges} Kanten haben zwei Facetten, die sie im selben Sinn durchlaufen, die erste bei {at}; Bahnen enden dort. Die Facettennormalen vereinheitlichen.</translation>
    </message>
    <message>
        <source>{edges} edges leave the mesh open, the first at {at}; passes end there. Close the shell in CAD if it is meant to be solid.</source>
        <translation>{edges} Kanten lassen das Netz offen, die erste bei {at}; Bahnen enden dort. Die Schale im CAD schließen, wenn sie ein Volumenkörper sein soll.</translation>
    </message>
    <message>
        <source>{error}; choose another machine, or put the file back</source>
        <translation>{error}; eine andere Maschine wählen oder die Datei zurücklegen</translation>
    </message>
    <message>
        <source>{error}; post-process again</source>
        <translation>{error}; die NC-Datei neu ausgeben</translation>
    </message>
    <message>
        <source>{error}; these files are written: {written}</source>
        <translation>{error}; diese Dateien sind geschrieben: {written}</translation>
    </message>
    <message>
        <source>{fcm_file} does not end in {suffix}, as machine files do; name it so</source>
        <translation>{fcm_file} endet nicht auf {suffix} wie Maschinendateien; so benennen</translation>
    </message>
    <message>
        <source>{fcm_file} exists already; choose another name, so that no machine is lost</source>
        <translation>{fcm_file} gibt es schon; einen anderen Namen wählen, damit keine Maschine verloren geht</translation>
    </message>
    <message>
        <source>{file} exists; choose another name, or ask for it to be overwritten</source>
        <translation>{file} gibt es schon; einen anderen Namen wählen oder Überschreiben verlangen</translation>
    </message>
    <message>
        <source>{file} needs one of the endings {reports}</source>
        <translation>{file} braucht eine der Endungen {reports}</translation>
    </message>
    <message>
        <source>{file} was changed by somebody else; post-process to another file, or ask for it to be overwritten</source>
        <translation>{file} wurde von anderer Seite geändert; in eine andere Datei ausgeben oder Überschreiben verlangen</translation>
    </message>
    <message>
        <source>{first} and {second} are exchanged</source>
        <translation>{first} und {second} sind vertauscht</translation>
    </message>
    <message>
        <source>{first} and {second} both turn the wrong way</source>
        <translation>{first} und {second} drehen beide falsch herum</translation>
    </message>
    <message>
        <source>{first} is {found} and {second} is {other}: the two are exchanged; name {second} first</source>
        <translation>{first} ist {found} und {second} ist {other}: die beiden sind vertauscht; {second} zuerst nennen</translation>
    </message>
    <message>
        <source>{first} turns {turn} and {second} {other_turn}</source>
        <translation>{first} dreht {turn} und {second} {other_turn}</translation>
    </message>
    <message>
        <source>{frames} lock the rotary axes and choose the tool axes themselves; leave {option} out</source>
        <translation>{frames} klemmen die Rundachsen und wählen die Werkzeugachsen selbst; {option} weglassen</translation>
    </message>
    <message>
        <source>{frames} lock the rotary axes, {choice} turns them; choose another</source>
        <translation>{frames} klemmen die Rundachsen, {choice} dreht sie; etwas anderes wählen</translation>
    </message>
    <message>
        <source>{given} given; give either a stepover or a scallop</source>
        <translation>{given} angegeben; entweder Zeilensprung oder Kuppenhöhe angeben</translation>
    </message>
    <message>
        <source>{given} is no list; write [{{"name": ..., "carrier": ..., "box": ...}}]</source>
        <translation>{given} ist keine Liste; [{{"name": ..., "carrier": ..., "box": ...}}] schreiben</translation>
    </message>
    <message>
        <source>{given} is not an object; write {{ ... }}</source>
        <translation>{given} ist kein Objekt; {{ ... }} schreiben</translation>
    </message>
    <message>
        <source>{gouge} changes the passes: use it with {mill}; for an audit give {report}</source>
        <translation>{gouge} ändert die Bahnen: nur mit {mill} verwenden; für eine Prüfung {report} angeben</translation>
    </message>
    <message>
        <source>{joints} move neither the table nor the tool; make them fixed</source>
        <translation>{joints} bewegen weder Tisch noch Werkzeug; machen Sie sie fest (fixed)</translation>
    </message>
    <message>
        <source>{joints} would all be {letter} by their directions; call them by their letters, as axis_{small}</source>
        <translation>{joints} wären nach ihren Richtungen alle {letter}; nennen Sie sie nach ihren Buchstaben, etwa axis_{small}</translation>
    </message>
    <message>
        <source>{joint} is not [[origin], [axis]]</source>
        <translation>{joint} ist nicht [[origin], [axis]]</translation>
    </message>
    <message>
        <source>{joint} is not {{"origin": [x, y, z], "axis": [x, y, z]}}</source>
        <translation>{joint} ist nicht {{"origin": [x, y, z], "axis": [x, y, z]}}</translation>
    </message>
    <message>
        <source>{key}: {problem}</source>
        <translation>{key}: {problem}</translation>
    </message>
    <message>
        <source>{kind}, {one} nearer to the work turning about {way}, {two} about {other_way}</source>
        <translation>{kind}, {one} näher am Werkstück, drehend um {way}, {two} um {other_way}</translation>
    </message>
    <message>
        <source>{label} ({kind}) has no solid: {what}.</source>
        <translation>{label} ({kind}) hat keinen Volumenkörper: {what}.</translation>
    </message>
    <message>
        <source>{label} ({kind}) holds neither a solid nor a mesh: select a solid, a mesh, or a part or link of some.</source>
        <translation>{label} ({kind}) enthält weder einen Volumenkörper noch ein Netz: Wählen Sie einen Volumenkörper, ein Netz oder ein Part oder einen Link davon aus.</translation>
    </message>
    <message>
        <source>{label} ({typeid}) has no solid: {what}.</source>
        <translation>{label} ({typeid}) hat keinen Volumenkörper: {what}.</translation>
    </message>
    <message>
        <source>{label} could not be computed: {why}</source>
        <translation>{label} konnte nicht berechnet werden: {why}</translation>
    </message>
    <message>
        <source>{label} has changed since {file} was written; post-process again</source>
        <translation>{label} hat sich geändert, seit {file} geschrieben wurde; die NC-Datei neu ausgeben</translation>
    </message>
    <message>
        <source>{label} has changed since: try the setups again</source>
        <translation>{label} hat sich seither geändert: die Aufspannungen neu erproben</translation>
    </message>
    <message>
        <source>{label} has no mesh: choose one in its property Mesh, or copy the path together with its mesh.</source>
        <translation>{label} hat kein Netz: eines in der Eigenschaft Netz wählen oder die Werkzeugbahn mit ihrem Netz zusammen kopieren.</translation>
    </message>
    <message>
        <source>{label} has no model; add one in the Job's editor, or select the part itself</source>
        <translation>{label} hat kein Modell; im Editor des Auftrags eines hinzufügen oder das Werkstück selbst auswählen</translation>
    </message>
    <message>
        <source>{label} has no {name} on a solid, which was to be left alone: choose anew which of its faces are not machined.</source>
        <translation>{label} hat kein {name} an einem Volumenkörper, das ausgespart bleiben sollte: neu wählen, welche seiner Flächen nicht bearbeitet werden.</translation>
    </message>
    <message>
        <source>{label} has no {name} on a solid: select its faces again.</source>
        <translation>{label} hat kein {name} an einem Volumenkörper: die Flächen neu auswählen.</translation>
    </message>
    <message>
        <source>{label} has no {name}, which was picked: pick {option} anew.</source>
        <translation>{label} hat {name} nicht mehr, was gewählt war: {option} neu wählen.</translation>
    </message>
    <message>
        <source>{label} has {named}; add one to it, or give the cutter by hand</source>
        <translation>{label} hat {named}; eines hinzufügen oder den Fräser von Hand angeben</translation>
    </message>
    <message>
        <source>{label} is a mesh already: leave out {unused}</source>
        <translation>{label} ist schon ein Netz: {unused} weglassen</translation>
    </message>
    <message>
        <source>{label} is a mesh and has no faces to choose: select the whole of it.</source>
        <translation>{label} ist ein Netz und hat keine Flächen zur Wahl: das Ganze auswählen.</translation>
    </message>
    <message>
        <source>{label} is a mesh, whose faces have no names: choose the solid it is of, or mill it on the command line with {option}.</source>
        <translation>{label} ist ein Netz, dessen Flächen keine Namen haben: den Volumenkörper wählen, von dem es stammt, oder es auf der Kommandozeile mit {option} fräsen.</translation>
    </message>
    <message>
        <source>{label} is an empty mesh: select a mesh with facets, or a solid.</source>
        <translation>{label} ist ein leeres Netz: ein Netz mit Facetten oder einen Volumenkörper auswählen.</translation>
    </message>
    <message>
        <source>{label} is in another document: select something in {document}.</source>
        <translation>{label} ist in einem anderen Dokument: etwas in {document} auswählen.</translation>
    </message>
    <message>
        <source>{label} is no mesh: choose a tessellation or a mesh.</source>
        <translation>{label} ist kein Netz: eine Vernetzung oder ein Netz wählen.</translation>
    </message>
    <message>
        <source>{label} is no tool path: choose one.</source>
        <translation>{label} ist kein Werkzeugweg: einen wählen.</translation>
    </message>
    <message>
        <source>{label} is no toolpath and no audit: select one of these.</source>
        <translation>{label} ist weder Werkzeugweg noch Prüfung: eines davon auswählen.</translation>
    </message>
    <message>
        <source>{label} is old: recompute the document</source>
        <translation>{label} ist veraltet: das Dokument neu berechnen</translation>
    </message>
    <message>
        <source>{label} is the part that is milled: choose what holds it, or no fixture.</source>
        <translation>{label} ist das Teil, das gefräst wird: wählen Sie, was es hält, oder kein Spannmittel.</translation>
    </message>
    <message>
        <source>{label} is the part to compare with: choose what holds it, or no fixture.</source>
        <translation>Mit {label} wird verglichen: wählen Sie, was das Teil hält, oder kein Spannmittel.</translation>
    </message>
    <message>
        <source>{label} names no NC file: choose one in its property NCFile</source>
        <translation>{label} nennt keine NC-Datei: in der Eigenschaft NC-Datei eine wählen</translation>
    </message>
    <message>
        <source>{label} shows the result of other settings, or of another version: recompute the document</source>
        <translation>{label} zeigt das Ergebnis anderer Einstellungen oder einer anderen Version: das Dokument neu berechnen</translation>
    </message>
    <message>
        <source>{label} stands in no line of this program</source>
        <translation>{label} steht in keiner Zeile dieses Programms</translation>
    </message>
    <message>
        <source>{label} was changed: recompute the document</source>
        <translation>{label} wurde geändert: das Dokument neu berechnen</translation>
    </message>
    <message>
        <source>{label} was made by an earlier version, which did not keep where the faces to be left alone are: recompute it, that is mark it to recompute in the tree and recompute the document.</source>
        <translation>{label} stammt von einer früheren Version, die nicht festhielt, wo die ausgesparten Flächen sind: neu berechnen, also im Baum zum Neuberechnen markieren und das Dokument neu berechnen.</translation>
    </message>
    <message>
        <source>{label} was moved by the part that holds it: recompute the document</source>
        <translation>{label} wurde mit dem Teil bewegt, in dem es steckt: das Dokument neu berechnen</translation>
    </message>
    <message>
        <source>{label}: {errors}</source>
        <translation>{label}: {errors}</translation>
    </message>
    <message>
        <source>{leave_out} leaves nothing to cut: {why}; use a smaller cutter or holder, a longer tool or another tool axis, or see where with {report}</source>
        <translation>{leave_out} lässt nichts zu fräsen: {why}; einen kleineren Fräser oder Halter, ein längeres Werkzeug oder eine andere Werkzeugachse nehmen, oder mit {report} ansehen, wo</translation>
    </message>
    <message>
        <source>{length} of the passes are left out, because {why}. {remedy}</source>
        <translation>{length} der Bahnen sind ausgelassen, weil {why}. {remedy}</translation>
    </message>
    <message>
        <source>{length} of the passes, the first at {place}, lie in a closed hollow of the part, which no tool can enter; they are left out.</source>
        <translation>{length} der Bahnen, zuerst bei {place}, liegen in einem geschlossenen Hohlraum des Werkstücks, in den kein Werkzeug kommt; sie sind ausgelassen.</translation>
    </message>
    <message>
        <source>{length} of the path stay uncut at {count} rewinds: on neither side of them do the rotary limits allow the tool axis that is needed. Wider limits or another setup avoid it.</source>
        <translation>{length} des Werkzeugwegs bleiben an {count} Rückdrehungen ungefräst: auf keiner Seite davon erlauben die Grenzen der Rundachsen die nötige Werkzeugachse. Weitere Grenzen oder eine andere Aufspannung vermeiden das.</translation>
    </message>
    <message>
        <source>{letter} ({low} to {high})</source>
        <translation>{letter} ({low} bis {high})</translation>
    </message>
    <message>
        <source>{letter} alone, {amount}</source>
        <translation>{letter} allein, {amount}</translation>
    </message>
    <message>
        <source>{letter} back</source>
        <translation>{letter} zurück</translation>
    </message>
    <message>
        <source>{letter} cannot turn by {angle} within its limits {low} to {high}</source>
        <translation>{letter} kann innerhalb der Grenzen {low} bis {high} nicht um {angle} drehen</translation>
    </message>
    <message>
        <source>{letter} has to turn back from {before} to {after} inside a cut: the tool retracts, turns above the part and re-engages, which may leave a mark. {remedy}</source>
        <translation>{letter} muss mitten im Schnitt von {before} auf {after} zurückdrehen: das Werkzeug fährt frei, dreht über dem Werkstück und taucht wieder ein, was eine Marke hinterlassen kann. {remedy}</translation>
    </message>
    <message>
        <source>{letter} is another axis: the post turns it about {way}, {name} about {own}.</source>
        <translation>{letter} ist eine andere Achse: der Postprozessor dreht sie um {way}, {name} um {own}.</translation>
    </message>
    <message>
        <source>{letter} names no axis; use X Y Z and up to two of A B C</source>
        <translation>{letter} benennt keine Achse; X Y Z und bis zu zwei von A B C nehmen</translation>
    </message>
    <message>
        <source>{letter} no longer turns back inside a cut, as it had to once.</source>
        <translation>{letter} dreht nicht mehr innerhalb eines Schnitts zurück, wie zuvor einmal nötig.</translation>
    </message>
    <message>
        <source>{letter} no longer turns back inside cuts, as it had to {count} times.</source>
        <translation>{letter} dreht nicht mehr innerhalb von Schnitten zurück, wie zuvor {count}-mal nötig.</translation>
    </message>
    <message>
        <source>{letter} no longer turns back, as it had to once.</source>
        <translation>{letter} dreht nicht mehr zurück, wie zuvor einmal nötig.</translation>
    </message>
    <message>
        <source>{letter} no longer turns back, as it had to {count} times.</source>
        <translation>{letter} dreht nicht mehr zurück, wie zuvor {count}-mal nötig.</translation>
    </message>
    <message>
        <source>{letter} turns back inside a cut once instead of {before} times.</source>
        <translation>{letter} dreht innerhalb eines Schnitts einmal statt {before}-mal zurück.</translation>
    </message>
    <message>
        <source>{letter} turns back inside cuts {count} instead of {before} times.</source>
        <translation>{letter} dreht innerhalb von Schnitten {count}- statt {before}-mal zurück.</translation>
    </message>
    <message>
        <source>{letter} turns back once instead of {before} times.</source>
        <translation>{letter} dreht einmal statt {before}-mal zurück.</translation>
    </message>
    <message>
        <source>{letter} turns back {count} instead of {before} times.</source>
        <translation>{letter} dreht {count}- statt {before}-mal zurück.</translation>
    </message>
    <message>
        <source>{letter} turns the head, and it is for tables alone</source>
        <translation>{letter} dreht den Kopf, und sie ist nur für Tische</translation>
    </message>
    <message>
        <source>{letter} turns the other way: the post's positive {letter} is the negative one of {name}.{effect}</source>
        <translation>{letter} dreht anders herum: das positive {letter} des Postprozessors ist das negative von {name}.{effect}</translation>
    </message>
    <message>
        <source>{letter} turns the wrong way</source>
        <translation>{letter} dreht falsch herum</translation>
    </message>
    <message>
        <source>{letter} turns {turn} and the tool leans as before</source>
        <translation>{letter} dreht {turn}, und das Werkzeug neigt sich wie zuvor</translation>
    </message>
    <message>
        <source>{letter} turns {whole} in all in {blocks} in which the tool stands at the pole, along the {letter} axis, and does not lean: most in NC line {line}, {turn}. The surface is held: each keeps the tolerance by proof, and the tool keeps {kept} % of its feed or more. Nothing is to be done.</source>
        <translation>{letter} dreht insgesamt {whole} in {blocks}, in denen das Werkzeug am Pol steht, längs der {letter}-Achse, und sich nicht neigt: am meisten in NC-Zeile {line}, {turn}. Die Fläche stimmt: Jeder hält die Toleranz nachweislich ein, und das Werkzeug behält mindestens {kept} % seines Vorschubs. Zu tun ist nichts.</translation>
    </message>
    <message>
        <source>{letter} would have to go to {word} inside a divided block, its limit is {limit} ({count} rows): {remedy}</source>
        <translation>{letter} müsste in einem geteilten NC-Satz nach {word} fahren, die Grenze ist {limit} ({count} Punkte): {remedy}</translation>
    </message>
    <message>
        <source>{letter} would have to go to {word}, its limit is {limit} ({count} rows): {remedy}</source>
        <translation>{letter} müsste nach {word} fahren, die Grenze ist {limit} ({count} Punkte): {remedy}</translation>
    </message>
    <message>
        <source>{letter} would have to go {more} higher than its limit {limit}.</source>
        <translation>{letter} müsste {more} höher fahren als bis zur Grenze {limit}.</translation>
    </message>
    <message>
        <source>{letter} would leave its limits by {over}</source>
        <translation>{letter} würde die Grenzen um {over} verlassen</translation>
    </message>
    <message>
        <source>{letter} {low} to {high}</source>
        <translation>{letter} {low} bis {high}</translation>
    </message>
    <message>
        <source>{lies} near the pole, where {letter} must turn far to lean the tool a little.</source>
        <translation>{lies} nahe am Pol, wo {letter} weit drehen muss, um das Werkzeug ein wenig zu neigen.</translation>
    </message>
    <message>
        <source>{light}: {reasons}.</source>
        <translation>{light}: {reasons}.</translation>
    </message>
    <message>
        <source>{line} is no tool; write number, cutter and name, as T3 ball:6:30 Finisher</source>
        <translation>{line} ist kein Werkzeug; Nummer, Fräser und Namen schreiben, wie T3 ball:6:30 Schlichter</translation>
    </message>
    <message>
        <source>{line} lacks the number of its loop: DO1 ... END1</source>
        <translation>{line} fehlt die Nummer seiner Schleife: DO1 ... END1</translation>
    </message>
    <message>
        <source>{links} are all called {word}; give only one of them that name</source>
        <translation>{links} heißen alle {word}; geben Sie nur einem davon diesen Namen</translation>
    </message>
    <message>
        <source>{links} carry one another in a circle; hang one from the root</source>
        <translation>{links} tragen einander im Kreis; hängen Sie einen an die Wurzel</translation>
    </message>
    <message>
        <source>{lost} carry one another in a circle; give one the parent null</source>
        <translation>{lost} tragen einander im Kreis; einer davon parent null geben</translation>
    </message>
    <message>
        <source>{lost} of that are tighter than the cutter: a ball of its size finds no place there that leaves less. On {rest} the ball fits.</source>
        <translation>{lost} davon sind enger als der Fräser: Eine Kugel seiner Größe findet dort keinen Platz, an dem weniger stehen bleibt. Auf {rest} passt die Kugel.</translation>
    </message>
    <message>
        <source>{machine} with {cure}</source>
        <translation>{machine} mit Korrektur {cure}</translation>
    </message>
    <message>
        <source>{machine} with {cure}, tool-centre control</source>
        <translation>{machine} mit Korrektur {cure}, Werkzeugspitzenführung</translation>
    </message>
    <message>
        <source>{max_tilt} {tilt} is out of range; give {least} to {most}, or choose {facet_mean}</source>
        <translation>{max_tilt} {tilt} liegt außerhalb; {least} bis {most} angeben oder {facet_mean} wählen</translation>
    </message>
    <message>
        <source>{merged} of {count} rows of the passes, which are close together, were merged; that takes the cutter off the surface by at most {off}.</source>
        <translation>{merged} von {count} Bahnpunkten, die dicht beieinander liegen, wurden zusammengefasst; das bringt den Fräser um höchstens {off} von der Fläche ab.</translation>
    </message>
    <message>
        <source>{merge} takes no jobs; leave {source} out</source>
        <translation>{merge} nimmt keine Aufträge; {source} weglassen</translation>
    </message>
    <message>
        <source>{minimax} would lean a barrel off its flank; choose {facet_mean}, or a ball cutter</source>
        <translation>{minimax} würde einen Tonnenfräser von seiner Flanke wegneigen; {facet_mean} oder einen Kugelfräser wählen</translation>
    </message>
    <message>
        <source>{missing} is missing before {rest}</source>
        <translation>{missing} fehlt vor {rest}</translation>
    </message>
    <message>
        <source>{module} moves {letters} too, which a machine file cannot hold; the machine is right only while that stands at 0.</source>
        <translation>{module} bewegt auch {letters}, was eine Maschinendatei nicht fassen kann; die Maschine stimmt nur, solange das auf 0 steht.</translation>
    </message>
    <message>
        <source>{names} (with their first lines) stand in {count} lines: {explanation}.</source>
        <translation>{names} (mit ihrer ersten Zeile) stehen in {count} Zeilen: {explanation}.</translation>
    </message>
    <message>
        <source>{names} to be left alone is of {other}: choose faces of {label}.</source>
        <translation>{names}, auszusparen, gehört zu {other}: Flächen von {label} wählen.</translation>
    </message>
    <message>
        <source>{name} '' is empty; give a value, or leave it out</source>
        <translation>{name} '' ist leer; geben Sie einen Wert an, oder lassen Sie es weg</translation>
    </message>
    <message>
        <source>{name} = {value} is certain within {certainty} only; give rows with larger turns.</source>
        <translation>{name} = {value} ist nur auf {certainty} sicher; Zeilen mit größeren Drehungen angeben.</translation>
    </message>
    <message>
        <source>{name} deflection {value} is out of range; it must be above 0</source>
        <translation>Abweichung des Netzes {name}: {value} liegt außerhalb; sie muss über 0 sein</translation>
    </message>
    <message>
        <source>{name} does not guide the tip itself (no RTCP): leave {rtcp} out, and use {linearize}</source>
        <translation>{name} führt die Werkzeugspitze nicht selbst (kein RTCP): {rtcp} weglassen und {linearize} verwenden</translation>
    </message>
    <message>
        <source>{name} does not take the shorter way to a word of 0 to 360, as the machine file says of {letter} (modulo): the words count their turns on. Set the control accordingly, or wrap_strategy to unwound.</source>
        <translation>{name} nimmt nicht den kürzeren Weg zu einem Wort von 0 bis 360, wie es die Maschinendatei von {letter} sagt (modulo): die Wörter zählen ihre Umdrehungen weiter. Die Steuerung entsprechend einstellen oder wrap_strategy auf unwound setzen.</translation>
    </message>
    <message>
        <source>{name} has an empty list of values; give one, or leave it out</source>
        <translation>{name} hat eine leere Liste von Werten; einen angeben oder weglassen</translation>
    </message>
    <message>
        <source>{name} has no RTCP by {how}; give {guides}</source>
        <translation>{name} hat kein RTCP durch {how}; angeben: {guides}</translation>
    </message>
    <message>
        <source>{name} has no corner radius; give it one in FreeCAD's tool editor</source>
        <translation>{name} hat keinen Eckenradius; in FreeCADs Werkzeugeditor angeben</translation>
    </message>
    <message>
        <source>{name} has no diameter; give it one in FreeCAD's tool editor</source>
        <translation>{name} hat keinen Durchmesser; in FreeCADs Werkzeugeditor angeben</translation>
    </message>
    <message>
        <source>{name} has no high-speed mode to switch; leave {high_speed} out, or give {blend}</source>
        <translation>{name} hat keinen schaltbaren Hochgeschwindigkeitsmodus; {high_speed} weglassen oder {blend} angeben</translation>
    </message>
    <message>
        <source>{name} has no inverse time (G93): F is written in mm/min, one for each block.</source>
        <translation>{name} hat keinen zeitreziproken Vorschub (G93): F steht in mm/min, eines für jeden Satz.</translation>
    </message>
    <message>
        <source>{name} has no taper angle; give it one in FreeCAD's tool editor</source>
        <translation>{name} hat keinen Kegelwinkel; in FreeCADs Werkzeugeditor angeben</translation>
    </message>
    <message>
        <source>{name} has {wanted}, but only {area} of the part lie on it. Export the faces from the same solid, with as fine facets, or raise the tolerance.</source>
        <translation>{name} hat {wanted}, aber nur {area} des Werkstücks liegen darauf. Die Flächen aus demselben Volumenkörper exportieren, mit ebenso feinen Facetten, oder die Toleranz erhöhen.</translation>
    </message>
    <message>
        <source>{name} in NC line {line} is not known and not interpreted; its effect is missing here.</source>
        <translation>{name} in NC-Zeile {line} ist nicht bekannt und wird nicht ausgewertet; was es tut, fehlt hier.</translation>
    </message>
    <message>
        <source>{name} is a face of {other}: select faces of {label}.</source>
        <translation>{name} ist eine Fläche von {other}: Flächen von {label} auswählen.</translation>
    </message>
    <message>
        <source>{name} is a tool of the shape {shape}; {remedy}</source>
        <translation>{name} ist ein Werkzeug der Form {shape}; {remedy}</translation>
    </message>
    <message>
        <source>{name} is no face: select faces of {label}.</source>
        <translation>{name} ist keine Fläche: Flächen von {label} auswählen.</translation>
    </message>
    <message>
        <source>{name} is no setting of a document object; it is not one of {fields}</source>
        <translation>{name} ist keine Einstellung eines Dokumentobjekts; sie ist keine von {fields}</translation>
    </message>
    <message>
        <source>{name} is no tool bit ({error}); choose a {suffix} file of FreeCAD</source>
        <translation>{name} ist kein Werkzeug ({error}); eine {suffix}-Datei von FreeCAD wählen</translation>
    </message>
    <message>
        <source>{name} is no tool bit; choose a {suffix} file of FreeCAD</source>
        <translation>{name} ist kein Werkzeug; eine {suffix}-Datei von FreeCAD wählen</translation>
    </message>
    <message>
        <source>{name} is not interpreted ({where}); what it does is missing in the path.{remedy}</source>
        <translation>{name} wird nicht ausgewertet ({where}); was es tut, fehlt im Werkzeugweg.{remedy}</translation>
    </message>
    <message>
        <source>{name} is not known and not interpreted ({count} lines); what it does is missing here.</source>
        <translation>{name} ist nicht bekannt und wird nicht ausgewertet ({count} Zeilen); was es tut, fehlt hier.</translation>
    </message>
    <message>
        <source>{name} is not written out, and its moves are missing: {reason}. Correct it, or post straight moves.</source>
        <translation>{name} wird nicht ausgeschrieben, seine Bewegungen fehlen: {reason}. Berichtigen oder gerade Bewegungen ausgeben.</translation>
    </message>
    <message>
        <source>{name} is passed over: the machine file says that it moves nothing (no_motion).</source>
        <translation>{name} wird übergangen: Laut Maschinendatei bewegt es nichts (no_motion).</translation>
    </message>
    <message>
        <source>{name} is taken for X, Y and Z, as a TNC 640 takes it; an iTNC 530 whose MP7410 says so scales the working plane alone. Check it on the control.</source>
        <translation>{name} wird für X, Y und Z genommen, wie eine TNC 640 ihn nimmt; eine iTNC 530, deren MP7410 es so festlegt, skaliert nur die Bearbeitungsebene. An der Steuerung prüfen.</translation>
    </message>
    <message>
        <source>{name} is {value}; give a length above 0</source>
        <translation>{name} ist {value}; eine Länge über 0 angeben</translation>
    </message>
    <message>
        <source>{name} is {value}; give a number above 0</source>
        <translation>{name} ist {value}; eine Zahl über 0 angeben</translation>
    </message>
    <message>
        <source>{name} is {value}; give a number of at least 0</source>
        <translation>{name} ist {value}; eine Zahl ab 0 angeben</translation>
    </message>
    <message>
        <source>{name} is {value}; give an angle</source>
        <translation>{name} ist {value}; einen Winkel angeben</translation>
    </message>
    <message>
        <source>{name} lies on the part, but its facets look into it; export the faces again, with their normals outward</source>
        <translation>{name} liegt auf dem Werkstück, aber die Facetten zeigen hinein; die Flächen mit den Normalen nach außen neu exportieren</translation>
    </message>
    <message>
        <source>{name} line {line} moves {letter} along or about {model}, the kinematics {ours}; the machine is that of the kinematics. Which is right?</source>
        <translation>{name} Zeile {line} bewegt {letter} längs oder um {model}, die Kinematik {ours}; die Maschine ist die der Kinematik. Was stimmt?</translation>
    </message>
    <message>
        <source>{name} line {line} turns {letter} about a line that is {apart} from that of the kinematics; the machine is that of the kinematics. Which is right?</source>
        <translation>{name} Zeile {line} dreht {letter} um eine Linie, die {apart} von der der Kinematik entfernt ist; die Maschine ist die der Kinematik. Was stimmt?</translation>
    </message>
    <message>
        <source>{name} lists no sizes; save the tool once more in FreeCAD's tool editor</source>
        <translation>{name} nennt keine Maße; das Werkzeug in FreeCADs Werkzeugeditor noch einmal speichern</translation>
    </message>
    <message>
        <source>{name} of {label}</source>
        <translation>{name} von {label}</translation>
    </message>
    <message>
        <source>{name} of {label} bounds nothing: pick a face, or an edge of a closed wire.</source>
        <translation>{name} von {label} begrenzt nichts: eine Fläche oder eine Kante eines geschlossenen Kantenzugs wählen.</translation>
    </message>
    <message>
        <source>{name} of {label} has no axis: pick a straight or circular edge, or a cylindrical or conical face.</source>
        <translation>{name} von {label} hat keine Achse: eine gerade oder kreisförmige Kante oder eine Zylinder- oder Kegelfläche wählen.</translation>
    </message>
    <message>
        <source>{name} of {label} has no centre: pick a vertex, a circle or a sphere.</source>
        <translation>{name} von {label} hat keine Mitte: eine Ecke, einen Kreis oder eine Kugel wählen.</translation>
    </message>
    <message>
        <source>{name} of {label} is no vertex or edge: pick one, or name a CSV file of a curve.</source>
        <translation>{name} von {label} ist keine Ecke oder Kante: eine wählen oder eine CSV-Datei einer Kurve angeben.</translation>
    </message>
    <message>
        <source>{name} stands in NC line {line}: {explanation}.</source>
        <translation>{name} steht in NC-Zeile {line}: {explanation}.</translation>
    </message>
    <message>
        <source>{name} stands in {count} lines: {explanation}.</source>
        <translation>{name} steht in {count} Zeilen: {explanation}.</translation>
    </message>
    <message>
        <source>{name} was never set</source>
        <translation>{name} wurde nie gesetzt</translation>
    </message>
    <message>
        <source>{name} {given} holds a character that no name can have; give another</source>
        <translation>{name}: {given} enthält ein Zeichen, das kein Name haben kann; einen anderen angeben</translation>
    </message>
    <message>
        <source>{name} {given} is no speed; give a number, 1/min, or off</source>
        <translation>{name} {given} ist keine Drehzahl; eine Zahl, 1/min, oder off angeben</translation>
    </message>
    <message>
        <source>{name} {given} is not a text</source>
        <translation>{name}: {given} ist kein Text</translation>
    </message>
    <message>
        <source>{name} {given} is not a whole number</source>
        <translation>{name}: {given} ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>{name} {given} is not of the right kind</source>
        <translation>{name}: {given} ist nicht von der richtigen Art</translation>
    </message>
    <message>
        <source>{name} {given} is not one of {rules}</source>
        <translation>{name}: {given} ist keines von {rules}</translation>
    </message>
    <message>
        <source>{name} {given} is out of range; {range}</source>
        <translation>{name}: {given} liegt außerhalb; {range}</translation>
    </message>
    <message>
        <source>{name} {given} needs three numbers, as 0,0,50</source>
        <translation>{name}: {given} braucht drei Zahlen, wie 0,0,50</translation>
    </message>
    <message>
        <source>{name} {lean} leaves {minimax} no choice; leave it out, or choose {facet_mean}</source>
        <translation>{name} {lean} lässt {minimax} keine Wahl; weglassen oder {facet_mean} wählen</translation>
    </message>
    <message>
        <source>{name} {value} is out of range; give more than 0 mm</source>
        <translation>{name} {value} liegt außerhalb; mehr als 0 mm angeben</translation>
    </message>
    <message>
        <source>{name}'s {switch} names the tool's length offset: give {tool}, its number</source>
        <translation>{switch} von {name} nennt den Längenversatz des Werkzeugs: {tool} angeben, seine Nummer</translation>
    </message>
    <message>
        <source>{name}(...) stands in {count} lines and is not known; what it does is missing here. If it moves nothing, name it under no_motion in the machine file.</source>
        <translation>{name}(...) steht in {count} Zeilen und ist nicht bekannt; was es tut, fehlt hier. Bewegt es nichts, in der Maschinendatei unter no_motion nennen.</translation>
    </message>
    <message>
        <source>{name}: its mesh {file} is not found; put it beside the URDF file</source>
        <translation>{name}: Sein Netz {file} ist nicht zu finden; legen Sie es neben die URDF-Datei</translation>
    </message>
    <message>
        <source>{name}: the mesh {file} is no STL file; convert it, or give a collision shape</source>
        <translation>{name}: Das Netz {file} ist keine STL-Datei; wandeln Sie es um oder geben Sie eine Kollisionsform an</translation>
    </message>
    <message>
        <source>{name}: the post has {value} (within {certainty}), {machine} has {given}, {apart} apart.{effect}</source>
        <translation>{name}: der Postprozessor hat {value} (auf {certainty} genau), {machine} hat {given}, {apart} auseinander.{effect}</translation>
    </message>
    <message>
        <source>{name}: the scale {scale} of its mesh has a 0; give three others</source>
        <translation>{name}: Der Maßstab {scale} seines Netzes enthält eine 0; geben Sie drei andere Zahlen an</translation>
    </message>
    <message>
        <source>{name}: the sizes {sizes} of its {kind} are not above 0; give others</source>
        <translation>{name}: Die Maße {sizes} seiner Form {kind} sind nicht größer als 0; geben Sie andere an</translation>
    </message>
    <message>
        <source>{name}: this change of the coordinates is not interpreted, and those after it are taken as they were before: {reason}. Post without it.</source>
        <translation>{name}: diese Änderung der Koordinaten wird nicht ausgewertet, und die folgenden werden wie zuvor genommen: {reason}. Ohne sie ausgeben.</translation>
    </message>
    <message>
        <source>{name}: this shift of the zero is not interpreted, and the coordinates after it are taken as they were before: {reason}. Post without it.</source>
        <translation>{name}: Diese Nullpunktverschiebung wird nicht ausgewertet, die Koordinaten danach gelten wie zuvor: {reason}. Ohne sie ausgeben.</translation>
    </message>
    <message>
        <source>{name}: this tilted plane is not interpreted, and the coordinates after it are taken as they were before: {reason}. Post it another way, or post without planes.</source>
        <translation>{name}: Diese geschwenkte Ebene wird nicht ausgewertet, und die Koordinaten danach werden genommen wie davor: {reason}. Sie anders ausgeben oder ohne Ebenen ausgeben.</translation>
    </message>
    <message>
        <source>{name}: {key} {given} is no {what}</source>
        <translation>{name}: {key} {given} ist keine Angabe der Art {what}</translation>
    </message>
    <message>
        <source>{name}: {problem}</source>
        <translation>{name}: {problem}</translation>
    </message>
    <message>
        <source>{nc_path} exists; choose another name, or ask for it to be overwritten</source>
        <translation>{nc_path} gibt es schon; einen anderen Namen wählen oder Überschreiben verlangen</translation>
    </message>
    <message>
        <source>{old} is the former name of {name}; give {name} alone</source>
        <translation>{old} ist der frühere Name von {name}; nur {name} angeben</translation>
    </message>
    <message>
        <source>{one} and {other}</source>
        <translation>{one} und {other}</translation>
    </message>
    <message>
        <source>{one} and {other} tell two depths; leave one out</source>
        <translation>{one} und {other} nennen zwei Tiefen; eine weglassen</translation>
    </message>
    <message>
        <source>{one} or {other}</source>
        <translation>{one} oder {other}</translation>
    </message>
    <message>
        <source>{option}</source>
        <translation>{option}</translation>
    </message>
    <message>
        <source>{option} divides level planes from other passes, but {passes} are level planes all over; leave one of them out</source>
        <translation>{option} trennt waagrechte Ebenen von anderen Bahnen, {passes} sind aber überall waagrechte Ebenen; eines von beiden weglassen</translation>
    </message>
    <message>
        <source>{option} does not go together with {passes}; leave one of them out</source>
        <translation>{option} geht nicht zusammen mit {passes}; eines von beiden weglassen</translation>
    </message>
    <message>
        <source>{option} has no effect without {needed} and without bodies in the machine's file; give a fixture, or leave it out</source>
        <translation>{option} wirkt nicht ohne {needed} und ohne Körper in der Maschinendatei; eine Spannvorrichtung angeben oder die Option weglassen</translation>
    </message>
    <message>
        <source>{option} has no effect without {needed}; give both, or leave it out</source>
        <translation>{option} wirkt nicht ohne {needed}; beide angeben oder die Option weglassen</translation>
    </message>
    <message>
        <source>{option} has no effect: it is for {choice}</source>
        <translation>{option} bewirkt nichts: es gilt für {choice}</translation>
    </message>
    <message>
        <source>{option} has no effect: it is for {choice} and {other}</source>
        <translation>{option} bewirkt nichts: es gilt für {choice} und {other}</translation>
    </message>
    <message>
        <source>{option} is of a CL file, {source} is a part; leave it out</source>
        <translation>{option} gehört zu einer CL-Datei, {source} ist ein Teil; weglassen</translation>
    </message>
    <message>
        <source>{option} names a file of one job; leave it out: a batch names them</source>
        <translation>{option} nennt eine Datei eines einzelnen Auftrags; weglassen: eine Serie benennt sie selbst</translation>
    </message>
    <message>
        <source>{option} needs the part (.stl), {source} is none; leave it out</source>
        <translation>{option} braucht das Werkstück (.stl), {source} ist keines; weglassen</translation>
    </message>
    <message>
        <source>{option} {allowance} is an allowance on faces to avoid, and there are none: give them with {avoid}, or leave it out</source>
        <translation>{option} {allowance} ist ein Abstand zu ausgesparten Flächen, und es gibt keine: geben Sie sie mit {avoid} an, oder lassen Sie ihn weg</translation>
    </message>
    <message>
        <source>{option} {allowance} is larger than the part, which is {size} from corner to corner; give less</source>
        <translation>{option} {allowance} ist größer als das Werkstück, das von Ecke zu Ecke {size} misst; geben Sie weniger an</translation>
    </message>
    <message>
        <source>{option} {given} has no direction; give I,J,K along the axis, as 0,0,1</source>
        <translation>{option} {given} hat keine Richtung; I,J,K entlang der Achse angeben, etwa 0,0,1</translation>
    </message>
    <message>
        <source>{option} {given} has no direction; give I,J,K along which the boundary is seen, as 0,0,1</source>
        <translation>{option} {given} hat keine Richtung; I,J,K angeben, entlang derer die Begrenzung gesehen wird, etwa 0,0,1</translation>
    </message>
    <message>
        <source>{option} {given} is neither {middle} nor X,Y,Z; give one of them</source>
        <translation>{option} {given} ist weder {middle} noch X,Y,Z; eines davon angeben</translation>
    </message>
    <message>
        <source>{option} {source} is neither border nor X,Y,Z nor a file CURVE.csv; give one of them</source>
        <translation>{option} {source} ist weder border noch X,Y,Z noch eine Datei CURVE.csv; eines davon angeben</translation>
    </message>
    <message>
        <source>{option} {text}: the place is out of range; give X,Y,Z of at most 100000 mm and angles of at most 360 degrees</source>
        <translation>{option} {text}: der Ort liegt außerhalb; X,Y,Z bis 100000 mm und Winkel bis 360 Grad angeben</translation>
    </message>
    <message>
        <source>{option} {text}: {place} is no place; write X,Y,Z in mm behind the @, or X,Y,Z,RX,RY,RZ in mm and degrees, as vise.stl@10,0,-20 or vise.stl@10,0,-20,0,0,90</source>
        <translation>{option} {text}: {place} ist kein Ort; hinter das @ X,Y,Z in mm schreiben oder X,Y,Z,RX,RY,RZ in mm und Grad, wie vise.stl@10,0,-20 oder vise.stl@10,0,-20,0,0,90</translation>
    </message>
    <message>
        <source>{option} {value}</source>
        <translation>{option} {value}</translation>
    </message>
    <message>
        <source>{option}: {fixture} stands in the part, more than {depth} deep at {at}; check its place and its units</source>
        <translation>{option}: {fixture} steht im Werkstück, mehr als {depth} tief bei {at}; Ort und Einheiten prüfen</translation>
    </message>
    <message>
        <source>{option}: {problem}</source>
        <translation>{option}: {problem}</translation>
    </message>
    <message>
        <source>{output} does not end in {suffix}, as machine files do; name it so</source>
        <translation>{output} endet nicht auf {suffix} wie Maschinendateien; so benennen</translation>
    </message>
    <message>
        <source>{output} exists already; choose another name, so that no machine is lost</source>
        <translation>{output} gibt es schon; einen anderen Namen wählen, damit keine Maschine verloren geht</translation>
    </message>
    <message>
        <source>{parent} is no axis of this machine; name one, or null for the base</source>
        <translation>{parent} ist keine Achse dieser Maschine; eine nennen, oder null für das Gestell</translation>
    </message>
    <message>
        <source>{part} is no number</source>
        <translation>{part} ist keine Zahl</translation>
    </message>
    <message>
        <source>{part} with {finish}</source>
        <translation>{part} mit {finish}</translation>
    </message>
    <message>
        <source>{part}, which {label} is compared with, was deleted: undo that, choose another part in its property Part, or none in its panel.</source>
        <translation>{part}, womit {label} verglichen wird, wurde gelöscht: Machen Sie das rückgängig, wählen Sie ein anderes Teil in der Eigenschaft Part, oder keines im Fenster der Aufgabe.</translation>
    </message>
    <message>
        <source>{part}: best of {count}: {names}, {share} % unfinished, {minutes} min</source>
        <translation>{part}: bestes von {count}: {names}, {share} % unfertig, {minutes} min</translation>
    </message>
    <message>
        <source>{part}: none of {count} ways makes a program that is safe</source>
        <translation>{part}: keine von {count} Möglichkeiten ergibt ein sicheres Programm</translation>
    </message>
    <message>
        <source>{past} needs the part's passes: use it with {mill}; a CL file keeps its axes</source>
        <translation>{past} braucht die Bahnen des Werkstücks: mit {mill} verwenden; eine CL-Datei behält ihre Achsen</translation>
    </message>
    <message>
        <source>{path} cannot be read: {strerror}; check its folder and your right to read it</source>
        <translation>{path} kann nicht gelesen werden: {strerror}; Ordner und Leserecht prüfen</translation>
    </message>
    <message>
        <source>{path} cannot be the name of a file; give another</source>
        <translation>{path} kann kein Dateiname sein; einen anderen angeben</translation>
    </message>
    <message>
        <source>{path} does not exist; name the file to read</source>
        <translation>{path} gibt es nicht; die zu lesende Datei nennen</translation>
    </message>
    <message>
        <source>{path} gives {letters} neither MIN_LIMIT nor MAX_LIMIT: it turns without end, as LinuxCNC takes it. If cables or hoses stop it, write both limits there.</source>
        <translation>{path} gibt {letters} weder MIN_LIMIT noch MAX_LIMIT: Sie dreht endlos, wie LinuxCNC es auffasst. Wenn Kabel oder Schläuche sie aufhalten, beide Grenzen dort eintragen.</translation>
    </message>
    <message>
        <source>{path} has no ending that is known; give LinuxCNC's .ini, a .urdf or FreeCAD's .fcm</source>
        <translation>{path} hat keine bekannte Endung; geben Sie LinuxCNCs .ini, eine .urdf oder FreeCADs .fcm an</translation>
    </message>
    <message>
        <source>{path} is a folder; name a file</source>
        <translation>{path} ist ein Ordner; eine Datei nennen</translation>
    </message>
    <message>
        <source>{path} is a folder; name the file to read</source>
        <translation>{path} ist ein Ordner; die zu lesende Datei nennen</translation>
    </message>
    <message>
        <source>{path} is named for two outputs; name each file apart</source>
        <translation>{path} ist für zwei Ausgaben genannt; jede Datei für sich benennen</translation>
    </message>
    <message>
        <source>{path} is no file name: it holds a null character</source>
        <translation>{path} ist kein Dateiname: er enthält ein Nullzeichen</translation>
    </message>
    <message>
        <source>{path} is no ordinary file; name a file to write</source>
        <translation>{path} ist keine gewöhnliche Datei; eine Datei zum Schreiben angeben</translation>
    </message>
    <message>
        <source>{path} is no ordinary file; name the file to read</source>
        <translation>{path} ist keine gewöhnliche Datei; die zu lesende Datei nennen</translation>
    </message>
    <message>
        <source>{path} is no text file; give the {what}</source>
        <translation>{path} ist keine Textdatei; angeben: {what}</translation>
    </message>
    <message>
        <source>{path} is read-only; make it writable, or choose another name</source>
        <translation>{path} ist schreibgeschützt; den Schutz aufheben oder einen anderen Namen wählen</translation>
    </message>
    <message>
        <source>{path} is the file that is read; name another output</source>
        <translation>{path} ist die Datei, die gelesen wird; eine andere Ausgabe nennen</translation>
    </message>
    <message>
        <source>{path} is there already: name another file, or ask for it to be replaced</source>
        <translation>{path} gibt es schon: eine andere Datei nennen oder Ersetzen verlangen</translation>
    </message>
    <message>
        <source>{path} is there and not of this batch; choose another folder ({out}), or give {overwrite}</source>
        <translation>{path} ist schon da und nicht von dieser Serie; einen anderen Ordner wählen ({out}) oder {overwrite} angeben</translation>
    </message>
    <message>
        <source>{path} is {found}, needed is {wanted}; {remedy}</source>
        <translation>{path} ist {found}, gebraucht wird {wanted}; {remedy}</translation>
    </message>
    <message>
        <source>{path} needs "parts", a list of files (STL, STEP, FCStd), may have "options", and nothing else</source>
        <translation>{path} braucht "parts", eine Liste von Dateien (STL, STEP, FCStd), darf "options" haben, und sonst nichts</translation>
    </message>
    <message>
        <source>{path}: [JOINT_{joint}], {error}</source>
        <translation>{path}: [JOINT_{joint}], {error}</translation>
    </message>
    <message>
        <source>{path}: [{section}] {key} is missing; {remedy}</source>
        <translation>{path}: [{section}] {key} fehlt; {remedy}</translation>
    </message>
    <message>
        <source>{path}: {error}</source>
        <translation>{path}: {error}</translation>
    </message>
    <message>
        <source>{path}: {name}: {error}</source>
        <translation>{path}: {name}: {error}</translation>
    </message>
    <message>
        <source>{path}: {problem}</source>
        <translation>{path}: {problem}</translation>
    </message>
    <message>
        <source>{pin} comes from signal {signal} ({others}), whose value no HAL file says; write setp {pin} VALUE for the import</source>
        <translation>{pin} kommt vom Signal {signal} ({others}), dessen Wert keine HAL-Datei nennt; für den Import setp {pin} WERT schreiben</translation>
    </message>
    <message>
        <source>{pin} is a constant {given}; the rotary axes are that much higher for it. Join it to motion.tooloffset.z.</source>
        <translation>{pin} ist fest {given}; die Rundachsen liegen dafür um so viel höher. Verbinden Sie ihn mit motion.tooloffset.z.</translation>
    </message>
    <message>
        <source>{place}: word {letter} stands twice; a line takes one of each</source>
        <translation>{place}: das Wort {letter} steht zweimal; eine Zeile nimmt von jedem eines</translation>
    </message>
    <message>
        <source>{place}: {letter}{value} is beyond {farthest}; is a decimal point missing?</source>
        <translation>{place}: {letter}{value} liegt jenseits von {farthest}; fehlt ein Dezimalpunkt?</translation>
    </message>
    <message>
        <source>{problem}; left out is {parts}</source>
        <translation>{problem}; weggelassen ist {parts}</translation>
    </message>
    <message>
        <source>{reason}. {cause}</source>
        <translation>{reason}. {cause}</translation>
    </message>
    <message>
        <source>{rest} is not known here</source>
        <translation>{rest} ist hier nicht bekannt</translation>
    </message>
    <message>
        <source>{rivals} both stand on {carrier}; say by "parent" which carries which</source>
        <translation>{rivals} stehen beide auf {carrier}; mit „parent“ sagen, welche welche trägt</translation>
    </message>
    <message>
        <source>{role} contradicts the type of the axis; make them agree</source>
        <translation>{role} widerspricht der Art der Achse; in Übereinstimmung bringen</translation>
    </message>
    <message>
        <source>{rtcp} lets the controller guide the tip while rotary axes turn, and machine {name} has none; leave it out</source>
        <translation>mit {rtcp} führt die Steuerung die Spitze, während Rundachsen drehen, und die Maschine {name} hat keine; weglassen</translation>
    </message>
    <message>
        <source>{rtcp} lets the controller guide the tip, {linearize} divides blocks where it does not; give one</source>
        <translation>{rtcp} lässt die Steuerung die Spitze führen, {linearize} teilt Sätze, wo sie es nicht tut; eines davon angeben</translation>
    </message>
    <message>
        <source>{search} {folder} is no folder; name one with the called programs</source>
        <translation>{search} {folder} ist kein Ordner; einen mit den aufgerufenen Programmen angeben</translation>
    </message>
    <message>
        <source>{segments} segments of passes</source>
        <translation>{segments} Teilstrecken von Bahnen</translation>
    </message>
    <message>
        <source>{shard} {given} is not as 1/4, the first of four</source>
        <translation>{shard} {given} ist nicht wie 1/4, der erste von vier</translation>
    </message>
    <message>
        <source>{share} % it missed</source>
        <translation>{share} % hat es ausgelassen</translation>
    </message>
    <message>
        <source>{share} % of the surface to be milled stays unfinished</source>
        <translation>{share} % der zu fräsenden Fläche bleiben unbearbeitet</translation>
    </message>
    <message>
        <source>{share} % of this open surface ({area}) look down, so its underside is machined. If its upper side is meant, turn its normals round (in FreeCAD: Flip normals of a mesh, Reverse shapes of a face).</source>
        <translation>{share} % dieser offenen Fläche ({area}) zeigen nach unten, also wird ihre Unterseite bearbeitet. Ist die Oberseite gemeint, die Normalen umdrehen (in FreeCAD: Normalen umkehren bei einem Netz, Formen umkehren bei einer Fläche).</translation>
    </message>
    <message>
        <source>{share} % the settings leave out</source>
        <translation>{share} % lassen die Einstellungen aus</translation>
    </message>
    <message>
        <source>{share} % the tool cannot reach ({why})</source>
        <translation>{share} % erreicht das Werkzeug nicht ({why})</translation>
    </message>
    <message>
        <source>{shown} is {what}, no NC line; it is passed over. A control may refuse it: delete it.</source>
        <translation>{shown} ist {what}, keine NC-Zeile, und wird übergangen. Eine Steuerung kann es ablehnen: löschen.</translation>
    </message>
    <message>
        <source>{sides}; name another, or null for the base</source>
        <translation>{sides}; eine andere nennen, oder null für das Gestell</translation>
    </message>
    <message>
        <source>{side} is not machined: {area}.</source>
        <translation>{side} ist nicht bearbeitet: {area}.</translation>
    </message>
    <message>
        <source>{side}: Z {top}</source>
        <translation>{side}: Z {top}</translation>
    </message>
    <message>
        <source>{side}: as high as the part</source>
        <translation>{side}: so hoch wie das Teil</translation>
    </message>
    <message>
        <source>{side}: none</source>
        <translation>{side}: gar nicht</translation>
    </message>
    <message>
        <source>{singularity} leads past a pole, and machine {name} has none; leave it out</source>
        <translation>{singularity} führt an einem Pol vorbei, und die Maschine {name} hat keinen; weglassen</translation>
    </message>
    <message>
        <source>{size} setups are more than {most}; take a coarser grid or fewer turns</source>
        <translation>{size} Aufspannungen sind mehr als {most}; ein gröberes Raster oder weniger Drehungen nehmen</translation>
    </message>
    <message>
        <source>{skipped} blocks have no row of the CL path (moves of the post's own); they are passed over.</source>
        <translation>{skipped} NC-Sätze haben keine Zeile des CL-Wegs (eigene Bewegungen des Postprozessors); sie werden übergangen.</translation>
    </message>
    <message>
        <source>{source} is no part; give its STL</source>
        <translation>{source} ist kein Teil; geben Sie seine STL-Datei an</translation>
    </message>
    <message>
        <source>{source} is no source of a path; give an STL or a CL file</source>
        <translation>{source} ist keine Quelle eines Werkzeugwegs; ein STL oder eine CL-Datei angeben</translation>
    </message>
    <message>
        <source>{target} cannot be written: {strerror}; choose another folder</source>
        <translation>{target} kann nicht geschrieben werden: {strerror}; einen anderen Ordner wählen</translation>
    </message>
    <message>
        <source>{target} cannot be written: {strerror}; choose another name</source>
        <translation>{target} kann nicht geschrieben werden: {strerror}; einen anderen Namen wählen</translation>
    </message>
    <message>
        <source>{target} exists already; choose another name</source>
        <translation>{target} gibt es schon; einen anderen Namen wählen</translation>
    </message>
    <message>
        <source>{text} can be read in two ways; type {one} or {other}</source>
        <translation>{text} lässt sich auf zwei Arten lesen; {one} oder {other} eingeben</translation>
    </message>
    <message>
        <source>{text} is no acceleration; type one, as 2000 mm/s²</source>
        <translation>{text} ist keine Beschleunigung; eine eingeben, etwa 2000 mm/s²</translation>
    </message>
    <message>
        <source>{text} is no acceleration; type one, as 500 °/s²</source>
        <translation>{text} ist keine Beschleunigung; eine eingeben, etwa 500 °/s²</translation>
    </message>
    <message>
        <source>{text} is no angle; type one, as 30 or 12° 30'</source>
        <translation>{text} ist kein Winkel; einen eingeben, etwa 30 oder 12° 30'</translation>
    </message>
    <message>
        <source>{text} is no feed; type one, as 1000 mm/min</source>
        <translation>{text} ist kein Vorschub; einen eingeben, etwa 1000 mm/min</translation>
    </message>
    <message>
        <source>{text} is no length; type one, as 30 mm or 1.5 in</source>
        <translation>{text} ist keine Länge; eine eingeben, etwa 30 mm oder 1.5 in</translation>
    </message>
    <message>
        <source>{text} is no number; type one, as 0.5 or 1/2</source>
        <translation>{text} ist keine Zahl; eine eingeben, etwa 0.5 oder 1/2</translation>
    </message>
    <message>
        <source>{text} is no rate; type one, as 3600 °/min</source>
        <translation>{text} ist keine Drehgeschwindigkeit; eine eingeben, etwa 3600 °/min</translation>
    </message>
    <message>
        <source>{text} is no usable number; write a finite one</source>
        <translation>{text} ist keine brauchbare Zahl; eine endliche schreiben</translation>
    </message>
    <message>
        <source>{text} is no whole number; type one, as 5</source>
        <translation>{text} ist keine ganze Zahl; eine eingeben, etwa 5</translation>
    </message>
    <message>
        <source>{text} is out of range; type {low} to {high}</source>
        <translation>{text} liegt außerhalb des Bereichs; {low} bis {high} eingeben</translation>
    </message>
    <message>
        <source>{text} moves by {gain} times {letter}</source>
        <translation>{text} bewegt sich um das {gain}-fache von {letter}</translation>
    </message>
    <message>
        <source>{text} turns about no direction, or by no angle</source>
        <translation>{text} dreht um keine Richtung oder um keinen Winkel</translation>
    </message>
    <message>
        <source>{text}, which line {line} may have changed</source>
        <translation>{text}, was Zeile {line} verändert haben kann</translation>
    </message>
    <message>
        <source>{text}: {error}</source>
        <translation>{text}: {error}</translation>
    </message>
    <message>
        <source>{text}: {problem}</source>
        <translation>{text}: {problem}</translation>
    </message>
    <message>
        <source>{text}; give a smaller {angle}</source>
        <translation>{text}; {angle} verringern</translation>
    </message>
    <message>
        <source>{text}; give a smaller {angle}, or a {mark} nearer to the rotary axes</source>
        <translation>{text}; {angle} verringern oder {mark} näher an die Rundachsen legen</translation>
    </message>
    <message>
        <source>{text}; give another {origin} or {mark}, or less {gap}, {travel} or {angle}</source>
        <translation>{text}; {origin} oder {mark} anders angeben, oder weniger {gap}, {travel} oder {angle}</translation>
    </message>
    <message>
        <source>{tool_axis} turns two rotary axes, machine {name} has fewer; choose another, {fixed} keeps the tool along Z</source>
        <translation>{tool_axis} dreht zwei Rundachsen, die Maschine {name} hat weniger; eine andere wählen, {fixed} lässt das Werkzeug längs Z</translation>
    </message>
    <message>
        <source>{tool} out of the part on feed moves and rapids, but for {tolerance}</source>
        <translation>{tool} in Vorschub und Eilgang bis auf {tolerance} aus dem Teil</translation>
    </message>
    <message>
        <source>{travel} for each {arm} from the axis</source>
        <translation>{travel} je {arm} Abstand von der Achse</translation>
    </message>
    <message>
        <source>{turns} to lean the tool by {lean}</source>
        <translation>{turns}, um das Werkzeug um {lean} zu neigen</translation>
    </message>
    <message>
        <source>{unknown}: no setting of a setup; known: {known}</source>
        <translation>{unknown}: keine Einstellung einer Aufspannung; bekannt: {known}</translation>
    </message>
    <message>
        <source>{unknown}: no setting of a tessellation; known: {known}</source>
        <translation>{unknown}: keine Einstellung einer Vernetzung; bekannt: {known}</translation>
    </message>
    <message>
        <source>{unused} is {given}, but {module} does not use it.</source>
        <translation>{unused} ist {given}, aber {module} benutzt es nicht.</translation>
    </message>
    <message>
        <source>{value} are beyond the machine's limits and left out</source>
        <translation>{value} liegen jenseits der Grenzen der Maschine und sind ausgelassen</translation>
    </message>
    <message>
        <source>{value} are too steep for the largest axis angle and left out</source>
        <translation>{value} sind zu steil für den größten Achswinkel und ausgelassen</translation>
    </message>
    <message>
        <source>{value} beside the faces to avoid stay uncut for the allowance on these</source>
        <translation>{value} neben den ausgesparten Flächen bleiben wegen des Abstands zu diesen ungefräst</translation>
    </message>
    <message>
        <source>{value} is named twice in {option}; name it once</source>
        <translation>{value} ist in {option} zweimal genannt; einmal genügt</translation>
    </message>
    <message>
        <source>{value} is no list of names; write ["M202", "CYCL DEF 392"]</source>
        <translation>{value} ist keine Liste von Namen; schreiben: ["M202", "CYCL DEF 392"]</translation>
    </message>
    <message>
        <source>{value} is no name of a file: give a text or a path</source>
        <translation>{value} ist kein Dateiname: einen Text oder Pfad angeben</translation>
    </message>
    <message>
        <source>{value} is no whole number from 0 on</source>
        <translation>{value} ist keine ganze Zahl ab 0</translation>
    </message>
    <message>
        <source>{value} is none of {known}</source>
        <translation>{value} ist keines von {known}</translation>
    </message>
    <message>
        <source>{value} is not a finite number</source>
        <translation>{value} ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>{value} is not a text that can be shown; write one in quotes</source>
        <translation>{value} ist kein Text, der gezeigt werden kann; einen in Anführungszeichen schreiben</translation>
    </message>
    <message>
        <source>{value} is not a vector; write [x, y, z]</source>
        <translation>{value} ist kein Vektor; [x, y, z] schreiben</translation>
    </message>
    <message>
        <source>{value} is not an object; write {{ ... }}</source>
        <translation>{value} ist kein Objekt; {{ ... }} schreiben</translation>
    </message>
    <message>
        <source>{value} is not what is meant: give {wanted}</source>
        <translation>{value} ist nicht gemeint: {wanted} angeben</translation>
    </message>
    <message>
        <source>{value} lie too near to the faces to avoid and are left out</source>
        <translation>{value} liegen zu nahe an den ausgesparten Flächen und werden ausgelassen</translation>
    </message>
    <message>
        <source>{value} of the passes are left out</source>
        <translation>{value} der Bahnen sind ausgelassen</translation>
    </message>
    <message>
        <source>{version} cannot be read; only version {known} can</source>
        <translation>{version} ist nicht lesbar; nur Version {known} ist es</translation>
    </message>
    <message>
        <source>{ways} would cut it.</source>
        <translation>{ways} würden sie fräsen.</translation>
    </message>
    <message>
        <source>{ways} would cut it; cut the {area} that lie along those passes with another path.</source>
        <translation>{ways} würden sie fräsen; die {area}, die entlang dieser Bahnen liegen, mit einem anderen Werkzeugweg fräsen.</translation>
    </message>
    <message>
        <source>{what} is not a vector of three numbers</source>
        <translation>{what} ist kein Vektor aus drei Zahlen</translation>
    </message>
    <message>
        <source>{what} need at least {needed} GB of memory, and {free} GB are free; {remedy}</source>
        <translation>{what} brauchen mindestens {needed} GB Speicher, und {free} GB sind frei; {remedy}</translation>
    </message>
    <message>
        <source>{what} {number} of {rows} has {axis} = {value}, and no part exceeds {most}: check the units of the export</source>
        <translation>{what} {number} von {rows} hat {axis} = {value}, und kein Werkstück ist größer als {most}: die Einheiten des Exports prüfen</translation>
    </message>
    <message>
        <source>{what} {number} of {rows} has {axis} = {value}: coordinates must be finite numbers; export the mesh again</source>
        <translation>{what} {number} von {rows} hat {axis} = {value}: Koordinaten müssen endliche Zahlen sein; das Netz neu exportieren</translation>
    </message>
    <message>
        <source>{what} {part} is out of range; give diameters and lengths above 0, up to 10000 mm</source>
        <translation>{what}: {part} liegt außerhalb; Durchmesser und Längen über 0 bis 10000 mm angeben</translation>
    </message>
    <message>
        <source>{what} {path} cannot be read: {strerror}; check its name, its folder and your right to read it</source>
        <translation>{what} {path} kann nicht gelesen werden: {strerror}; Namen, Ordner und Leserecht prüfen</translation>
    </message>
    <message>
        <source>{what} {path}: its bytes</source>
        <translation>{what} {path}: der Inhalt</translation>
    </message>
    <message>
        <source>{what} {place} is not finite or beyond {most}</source>
        <translation>{what} {place} ist nicht endlich oder jenseits von {most}</translation>
    </message>
    <message>
        <source>{what} {text} is no cylinder; write diameter x length, as 40x25</source>
        <translation>{what} {text} ist kein Zylinder; Durchmesser x Länge schreiben, etwa 40x25</translation>
    </message>
    <message>
        <source>{what} {text} is no stack; write diameter x length from the cutter upwards, as 40x25,63x50</source>
        <translation>{what}: {text} ist kein Stapel; Durchmesser x Länge vom Fräser aufwärts schreiben, wie 40x25,63x50</translation>
    </message>
    <message>
        <source>{what} {text} is not a number</source>
        <translation>{what}: {text} ist keine Zahl</translation>
    </message>
    <message>
        <source>{what} {text} is not a number with one of the units {known}</source>
        <translation>{what}: {text} ist keine Zahl mit einer der Einheiten {known}</translation>
    </message>
    <message>
        <source>{what} {text} needs three numbers, as 0,0,50</source>
        <translation>{what}: {text} braucht drei Zahlen, wie 0,0,50</translation>
    </message>
    <message>
        <source>{what} {value} needs {remedy}</source>
        <translation>{what} {value} braucht {remedy}</translation>
    </message>
    <message>
        <source>{where} follows another one (mimic), as no axis does; make it fixed</source>
        <translation>{where} folgt einem anderen (mimic), was keine Achse tut; machen Sie es fest (fixed)</translation>
    </message>
    <message>
        <source>{where} has no &lt;{tag}&gt;; add it</source>
        <translation>{where} hat kein &lt;{tag}&gt;; ergänzen Sie es</translation>
    </message>
    <message>
        <source>{where} has the geometry {tags}; give one of {known}</source>
        <translation>{where} hat die Geometrie {tags}; geben Sie eine von {known} an</translation>
    </message>
    <message>
        <source>{where} is of the type {kind}; known are {known}</source>
        <translation>{where} ist vom Typ {kind}; bekannt sind {known}</translation>
    </message>
    <message>
        <source>{where} lacks {key}=; add it</source>
        <translation>{where} fehlt {key}=; ergänzen Sie es</translation>
    </message>
    <message>
        <source>{where} loads {loaded}, but [KINS] KINEMATICS is {named}; make them agree</source>
        <translation>{where} lädt {loaded}, aber [KINS] KINEMATICS ist {named}; bringen Sie beide in Einklang</translation>
    </message>
    <message>
        <source>{where}: WRAPPED_ROTARY takes {letter}-30 for 30 deg reached backwards; programs written here mean -30 deg. Set it to 0, there and on the machine.</source>
        <translation>{where}: WRAPPED_ROTARY nimmt {letter}-30 als 30 Grad, rückwärts erreicht; Programme von hier meinen -30 Grad. Dort und an der Maschine auf 0 setzen.</translation>
    </message>
    <message>
        <source>{where}: [TRAJ] {key} is {text}; known are {known}</source>
        <translation>{where}: [TRAJ] {key} ist {text}; bekannt sind {known}</translation>
    </message>
    <message>
        <source>{where}: [{section}] {key} is missing in {path}; add it</source>
        <translation>{where}: [{section}] {key} fehlt in {path}; ergänzen</translation>
    </message>
    <message>
        <source>{where}: coordinates={letters} does not name {known}; correct it</source>
        <translation>{where}: coordinates={letters} nennt nicht {known}; berichtigen</translation>
    </message>
    <message>
        <source>{where}: kinematics {module} cannot be imported; {remedy}</source>
        <translation>{where}: die Kinematik {module} kann nicht importiert werden; {remedy}</translation>
    </message>
    <message>
        <source>{where}: more than {most} files are included, some again and again; leave out {name}</source>
        <translation>{where}: Mehr als {most} Dateien werden eingebunden, manche immer wieder; {name} weglassen</translation>
    </message>
    <message>
        <source>{where}: nut-angle is {angle} degrees, so the head never tilts the tool; write setp {pin} with your head's angle</source>
        <translation>{where}: nut-angle ist {angle} Grad, der Kopf neigt das Werkzeug also nie; schreiben Sie setp {pin} mit dem Winkel Ihres Kopfs</translation>
    </message>
    <message>
        <source>{where}: trivkins has the axes {letters}; {problem}</source>
        <translation>{where}: trivkins hat die Achsen {letters}; {problem}</translation>
    </message>
    <message>
        <source>{where}: {key} is {text}; give {wanted}</source>
        <translation>{where}: {key} ist {text}; geben Sie {wanted} an</translation>
    </message>
    <message>
        <source>{where}: {name} and others include one another in a circle; remove one</source>
        <translation>{where}: {name} und andere binden einander im Kreis ein; eine entfernen</translation>
    </message>
    <message>
        <source>{where}: {name} begins with the folder of a user who is not known; write the whole path</source>
        <translation>{where}: {name} beginnt mit dem Ordner eines unbekannten Benutzers; den ganzen Pfad schreiben</translation>
    </message>
    <message>
        <source>{where}: {what} is {text}, not a number; write the number itself</source>
        <translation>{where}: {what} ist {text}, keine Zahl; die Zahl selbst schreiben</translation>
    </message>
    <message>
        <source>{words} further words ({count} statements) are not interpreted; is this a CL file?</source>
        <translation>{words} weitere Wörter ({count} Anweisungen) werden nicht ausgewertet; ist das eine CL-Datei?</translation>
    </message>
    <message>
        <source>{word} changes the coordinate system within the file; its points are taken in one. Write one file for each system.</source>
        <translation>{word} wechselt das Koordinatensystem innerhalb der Datei; ihre Punkte werden in einem genommen. Für jedes System eine Datei schreiben.</translation>
    </message>
    <message>
        <source>{word} has no condition in brackets</source>
        <translation>{word} hat keine Bedingung in Klammern</translation>
    </message>
    <message>
        <source>{word} has no end</source>
        <translation>{word} hat kein Ende</translation>
    </message>
    <message>
        <source>{word} has {count} numbers; give 3 or 6</source>
        <translation>{word} hat {count} Zahlen; 3 oder 6 angeben</translation>
    </message>
    <message>
        <source>{word} stands in no loop of its name</source>
        <translation>{word} steht in keiner Schleife seines Namens</translation>
    </message>
    <message>
        <source>{word} stands outside of a subprogram</source>
        <translation>{word} steht außerhalb eines Unterprogramms</translation>
    </message>
    <message>
        <source>{workers} {given} is no count; give a whole number from 1 on</source>
        <translation>{workers} {given} ist keine Anzahl; eine ganze Zahl ab 1 angeben</translation>
    </message>
</context>
<context>
    <name>FiveAxisPreferences</name>
    <message>
        <source>A machine that comes with the workbench, one of your folder, or the path of a .fcm file</source>
        <translation>Eine mitgelieferte Maschine, eine aus dem eigenen Ordner, oder der Pfad einer .fcm-Datei</translation>
    </message>
    <message>
        <source>Angle between the flank of a tapered cutter and its axis</source>
        <translation>Winkel zwischen der Flanke eines konischen Fräsers und seiner Achse</translation>
    </message>
    <message>
        <source>Colour of blocks near the pole, where a rotary axis turns far to lean the tool a little</source>
        <translation>Farbe der NC-Sätze nahe am Pol, wo eine Rundachse weit dreht, um das Werkzeug ein wenig zu neigen</translation>
    </message>
    <message>
        <source>Colour of blocks that follow the commanded segment</source>
        <translation>Farbe der NC-Sätze, die der Sollstrecke folgen</translation>
    </message>
    <message>
        <source>Colour of blocks that leave the commanded segment by more than the tolerance</source>
        <translation>Farbe der NC-Sätze, die um mehr als die Toleranz von der Sollstrecke abweichen</translation>
    </message>
    <message>
        <source>Colours of the path</source>
        <translation>Farben des Werkzeugwegs</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>Corner radius</source>
        <translation>Eckenradius</translation>
    </message>
    <message>
        <source>Corner radius of a bull nose, or radius of a barrel's tip</source>
        <translation>Eckenradius eines Torusfräsers oder Radius der Spitze eines Tonnenfräsers</translation>
    </message>
    <message>
        <source>Cutter</source>
        <translation>Fräser</translation>
    </message>
    <message>
        <source>Cutter diameter</source>
        <translation>Fräserdurchmesser</translation>
    </message>
    <message>
        <source>Cylinders above the cutter, diameter x length in mm, from the cutter upwards</source>
        <translation>Zylinder über dem Fräser, Durchmesser x Länge in mm, vom Fräser nach oben</translation>
    </message>
    <message>
        <source>Cylinders of the holder above cutter and shank, diameter x length in mm, upwards</source>
        <translation>Zylinder des Halters über Fräser und Schaft, Durchmesser x Länge in mm, nach oben</translation>
    </message>
    <message>
        <source>Defaults of a new tool path</source>
        <translation>Vorgaben für einen neuen Werkzeugweg</translation>
    </message>
    <message>
        <source>Diameter of a lollipop's neck, less than that of its ball</source>
        <translation>Durchmesser des Halses eines Lollipop-Fräsers, kleiner als der seiner Kugel</translation>
    </message>
    <message>
        <source>Diameter of the cutter; of a tapered one that of its rounded end</source>
        <translation>Durchmesser des Fräsers; eines konischen der seines runden Endes</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>Feed of the tip over the part</source>
        <translation>Vorschub der Werkzeugspitze über das Werkstück</translation>
    </message>
    <message>
        <source>Flank radius</source>
        <translation>Flankenradius</translation>
    </message>
    <message>
        <source>Folder that is offered for NC files; empty: the folder of the document</source>
        <translation>Ordner, der für NC-Dateien vorgeschlagen wird; leer: der Ordner des Dokuments</translation>
    </message>
    <message>
        <source>Folder with your own machine files (.fcm); they stand in the list of machines</source>
        <translation>Ordner mit eigenen Maschinendateien (.fcm); sie stehen in der Liste der Maschinen</translation>
    </message>
    <message>
        <source>Folders</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Holder</source>
        <translation>Halter</translation>
    </message>
    <message>
        <source>How many processes work on Compare machines, Where to clamp and Reach map, where these last longer than a few seconds. 1: FreeCAD's own alone. The result is always the same.</source>
        <translation>Wie viele Prozesse an „Maschinen vergleichen“, „Wohin spannen“ und „Erreichbarkeit“ rechnen, wo das länger als ein paar Sekunden dauert. 1: nur der von FreeCAD selbst. Das Ergebnis ist immer dasselbe.</translation>
    </message>
    <message>
        <source>Largest deviation of the tip from the commanded segment; blocks beyond it are marked</source>
        <translation>Größte Abweichung der Werkzeugspitze von der Sollstrecke; NC-Sätze darüber werden markiert</translation>
    </message>
    <message>
        <source>Largest ridge left between passes</source>
        <translation>Größte Kuppe, die zwischen den Bahnen stehen bleibt (Restrauhigkeit)</translation>
    </message>
    <message>
        <source>Long work</source>
        <translation>Lange Rechnungen</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>My machines</source>
        <translation>Eigene Maschinen</translation>
    </message>
    <message>
        <source>NC files</source>
        <translation>NC-Dateien</translation>
    </message>
    <message>
        <source>Neck diameter</source>
        <translation>Halsdurchmesser</translation>
    </message>
    <message>
        <source>No deviation</source>
        <translation>Keine Abweichung</translation>
    </message>
    <message>
        <source>Over tolerance</source>
        <translation>Über der Toleranz</translation>
    </message>
    <message>
        <source>Processes</source>
        <translation>Prozesse</translation>
    </message>
    <message>
        <source>Radius of a barrel's flank, more than half its diameter</source>
        <translation>Radius der Flanke eines Tonnenfräsers, größer als sein halber Durchmesser</translation>
    </message>
    <message>
        <source>Scallop height</source>
        <translation>Kuppenhöhe</translation>
    </message>
    <message>
        <source>Shank</source>
        <translation>Schaft</translation>
    </message>
    <message>
        <source>Shape of the cutter</source>
        <translation>Form des Fräsers</translation>
    </message>
    <message>
        <source>Singular</source>
        <translation>Singulär</translation>
    </message>
    <message>
        <source>Taper, each side</source>
        <translation>Kegel, je Seite</translation>
    </message>
    <message>
        <source>The language of the NC file; the machine's own is the one that its file names</source>
        <translation>Die Sprache der NC-Datei; die der Maschine steht in der Maschinendatei</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>one for each processor</source>
        <translation>einer je Prozessor</translation>
    </message>
</context>
<context>
    <name>FiveAxis_Annotate</name>
    <message>
        <source>Annotate</source>
        <translation>Markieren</translation>
    </message>
    <message>
        <source>Mark the singular blocks of a path and those over tolerance, and label the largest deviation</source>
        <translation>Die singulären NC-Sätze eines Werkzeugwegs und die über der Toleranz markieren und die größte Abweichung beschriften</translation>
    </message>
</context>
<context>
    <name>FiveAxis_Audit</name>
    <message>
        <source>Audit an NC file…</source>
        <translation>NC-Datei prüfen …</translation>
    </message>
    <message>
        <source>Read a finished NC file of any origin and prove its deviations on a machine</source>
        <translation>Eine fertige NC-Datei beliebiger Herkunft lesen und ihre Abweichungen auf einer Maschine nachweisen</translation>
    </message>
</context>
<context>
    <name>FiveAxis_Compare</name>
    <message>
        <source>Compare a tool path on several machines, with each correction: deviation and time of each</source>
        <translation>Einen Werkzeugweg auf mehreren Maschinen vergleichen, mit jeder Korrektur: Abweichung und Zeit von jeder</translation>
    </message>
    <message>
        <source>Compare machines…</source>
        <translation>Maschinen vergleichen …</translation>
    </message>
</context>
<context>
    <name>FiveAxis_EditMachine</name>
    <message>
        <source>Describe your own machine: its axes, limits, rates and bodies, from one that is known</source>
        <translation>Die eigene Maschine beschreiben: Achsen, Grenzen, Geschwindigkeiten und Körper, ausgehend von einer bekannten</translation>
    </message>
    <message>
        <source>Edit a machine…</source>
        <translation>Maschine bearbeiten…</translation>
    </message>
</context>
<context>
    <name>FiveAxis_ImportMachine</name>
    <message>
        <source>Import a machine…</source>
        <translation>Maschine übernehmen…</translation>
    </message>
    <message>
        <source>Make a machine file of a LinuxCNC configuration, a URDF file or a FreeCAD machine file</source>
        <translation>Eine Maschinendatei aus einer LinuxCNC-Konfiguration, einer URDF-Datei oder einer Maschinendatei von FreeCAD machen</translation>
    </message>
</context>
<context>
    <name>FiveAxis_JobSetup</name>
    <message>
        <source>Choose machine, controller and work zero once for all tool paths of the document</source>
        <translation>Maschine, Steuerung und Nullpunkt einmal für alle Werkzeugwege des Dokuments wählen</translation>
    </message>
    <message>
        <source>Setup…</source>
        <translation>Aufspannung …</translation>
    </message>
</context>
<context>
    <name>FiveAxis_Left</name>
    <message>
        <source>Colour the machined surface by what the cutter leaves on it, and by where it cuts too deep</source>
        <translation>Die bearbeitete Fläche danach färben, was der Fräser auf ihr stehen lässt und wo er zu tief fräst</translation>
    </message>
    <message>
        <source>What is left</source>
        <translation>Restmaterial</translation>
    </message>
</context>
<context>
    <name>FiveAxis_Play</name>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Show the tool, and the machine's table, move along a path block by block</source>
        <translation>Zeigen, wie sich Werkzeug und Maschinentisch Satz für Satz entlang eines Werkzeugwegs bewegen</translation>
    </message>
</context>
<context>
    <name>FiveAxis_PostProcess</name>
    <message>
        <source>Post-process…</source>
        <translation>NC-Datei ausgeben …</translation>
    </message>
    <message>
        <source>Write the NC file of a tool path, and a report of its deviations</source>
        <translation>Die NC-Datei eines Werkzeugwegs schreiben, und einen Bericht über seine Abweichungen</translation>
    </message>
</context>
<context>
    <name>FiveAxis_ProveSigns</name>
    <message>
        <source>Make a short safe program and a sheet that show a wrong sign or letter before it cuts</source>
        <translation>Ein kurzes, sicheres Programm und ein Blatt machen, die ein falsches Vorzeichen oder einen falschen Buchstaben zeigen, bevor gefräst wird</translation>
    </message>
    <message>
        <source>Prove the signs…</source>
        <translation>Vorzeichen nachweisen…</translation>
    </message>
</context>
<context>
    <name>FiveAxis_Reach</name>
    <message>
        <source>Colour the part by where the tool gets at all, and by what is in the way elsewhere</source>
        <translation>Das Werkstück danach färben, wo das Werkzeug überhaupt hinkommt und was sonst im Weg ist</translation>
    </message>
    <message>
        <source>Reach map…</source>
        <translation>Erreichbarkeit…</translation>
    </message>
</context>
<context>
    <name>FiveAxis_Recover</name>
    <message>
        <source>Find the machine that a post had in mind, from a CL file and the NC file made of it</source>
        <translation>Die Maschine finden, die ein Postprozessor im Sinn hatte, aus einer CL-Datei und der NC-Datei, die daraus gemacht wurde</translation>
    </message>
    <message>
        <source>Recover a machine from a program…</source>
        <translation>Maschine aus einem Programm zurückgewinnen…</translation>
    </message>
</context>
<context>
    <name>FiveAxis_Setup</name>
    <message>
        <source>Try where on the machine's table the part should stand, and show the deviation of each place</source>
        <translation>Erproben, wo auf dem Maschinentisch das Werkstück stehen sollte, und die Abweichung jedes Ortes zeigen</translation>
    </message>
    <message>
        <source>Where to clamp…</source>
        <translation>Wohin spannen …</translation>
    </message>
</context>
<context>
    <name>FiveAxis_Tessellate</name>
    <message>
        <source>Make a mesh of the selected solid, body or compound, as fine as tool paths need it</source>
        <translation>Aus dem gewählten Volumenkörper, Körper oder Verbund ein Netz machen, so fein, wie Werkzeugwege es brauchen</translation>
    </message>
    <message>
        <source>Tessellate</source>
        <translation>Tessellieren</translation>
    </message>
</context>
<context>
    <name>FiveAxis_Toolpath</name>
    <message>
        <source>Plan five-axis passes over the selected solid, its selected faces, a mesh, or the model of a CAM Job</source>
        <translation>Fünfachsige Bahnen über den gewählten Volumenkörper, seine gewählten Flächen, ein Netz oder das Modell eines CAM-Auftrags legen</translation>
    </message>
    <message>
        <source>Tool path…</source>
        <translation>Werkzeugweg …</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Five-axis</source>
        <translation>Fünfachsig</translation>
    </message>
    <message>
        <source>Five-axis machines</source>
        <translation>Fünfachsmaschinen</translation>
    </message>
    <message>
        <source>Five-axis tool paths with a proven deviation for every block</source>
        <translation>Fünfachsige Werkzeugwege mit nachgewiesener Abweichung für jeden NC-Satz</translation>
    </message>
</context>
</TS>
