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
        <source>Angular Deflection</source>
        <translation>Winkelabweichung</translation>
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
        <source>Blocks whose tip the controller guides (RTCP): proven are their ends only</source>
        <translation>NC-Sätze, in denen die Steuerung die Spitze führt (RTCP): nachgewiesen sind nur ihre Enden</translation>
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
        <source>Clearance</source>
        <translation>Sicherheitsabstand</translation>
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
        <translation type="unfinished"></translation>
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
        <source>Coolant</source>
        <translation>Kühlmittel</translation>
    </message>
    <message>
        <source>Corner radius of a bull nose, tapered or not; other kinds have none</source>
        <translation>Eckenradius eines Torusfräsers, auch eines konischen; andere Arten haben keinen</translation>
    </message>
    <message>
        <source>Cures</source>
        <translation>Abhilfen</translation>
    </message>
    <message>
        <source>Cut Length</source>
        <translation>Schnittweg</translation>
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
        <source>Cutter Kind</source>
        <translation>Fräserart</translation>
    </message>
    <message>
        <source>Cutter Length</source>
        <translation>Schneidenlänge</translation>
    </message>
    <message>
        <source>Cutter Taper</source>
        <translation>Fräser-Kegelwinkel</translation>
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
        <source>Diameter of the cutter; of a tapered one that of its rounded end</source>
        <translation>Durchmesser des Fräsers; eines konischen der seines runden Endes</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
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
        <source>File</source>
        <translation>Datei</translation>
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
        <source>High Speed</source>
        <translation>Hochgeschwindigkeit</translation>
    </message>
    <message>
        <source>Holder</source>
        <translation>Halter</translation>
    </message>
    <message>
        <source>How deep the tool enters the part at each marker, mm; 0: not at all</source>
        <translation>Wie tief das Werkzeug an jeder Markierung ins Werkstück eindringt, mm; 0: gar nicht</translation>
    </message>
    <message>
        <source>How far the part should be turned about Z, counter-clockwise</source>
        <translation>Wie weit das Werkstück um Z gedreht werden sollte, gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>I,J,K of the strategy `fixed`, tip to holder</source>
        <translation>I,J,K der Strategie „fixed“, von der Spitze zum Halter</translation>
    </message>
    <message>
        <source>KIND:DIAMETER, as ball:10 or ball:0.5in</source>
        <translation>ART:DURCHMESSER, etwa ball:10 oder ball:0.5in</translation>
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
        <source>Largest deviation where the work zero stood</source>
        <translation>Größte Abweichung dort, wo der Werkstücknullpunkt stand</translation>
    </message>
    <message>
        <source>Largest distance of a facet from the surface</source>
        <translation>Größter Abstand einer Facette von der Fläche</translation>
    </message>
    <message>
        <source>Lead</source>
        <translation>Voreilwinkel</translation>
    </message>
    <message>
        <source>Least Interval</source>
        <translation>Kleinster Zeilensprung</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Restmaterial</translation>
    </message>
    <message>
        <source>Length of the cutter's edge, from the tip upwards</source>
        <translation>Länge der Schneide, von der Spitze aufwärts</translation>
    </message>
    <message>
        <source>Length of the tool axes; 0: as the part needs it</source>
        <translation>Länge der Werkzeugachsen; 0: dem Werkstück angemessen</translation>
    </message>
    <message>
        <source>Light</source>
        <translation type="unfinished"></translation>
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
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Machine File</source>
        <translation>Maschinendatei</translation>
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
        <source>Machines</source>
        <translation>Maschinen</translation>
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
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Zeilen</translation>
    </message>
    <message>
        <source>Passes over the part</source>
        <translation>Zeilen über das Werkstück</translation>
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
        <source>Plunge Feed</source>
        <translation>Eintauchvorschub</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Proven</source>
        <translation>Bewiesen</translation>
    </message>
    <message>
        <source>Proven upper bound of the deviation from the commanded segments</source>
        <translation>Bewiesene obere Schranke der Abweichung von den Sollstrecken</translation>
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
        <source>Rtcp</source>
        <translation>RTCP</translation>
    </message>
    <message>
        <source>Safety</source>
        <translation type="unfinished"></translation>
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
        <source>Setup</source>
        <translation>Aufspannung</translation>
    </message>
    <message>
        <source>Shank</source>
        <translation>Schaft</translation>
    </message>
    <message>
        <source>Shape of the cutter: ball, flat, bull nose, tapered ball, tapered bull nose</source>
        <translation>Form des Fräsers: Kugel, Schaftfräser, Torus, konische Kugel, konischer Torus</translation>
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
        <source>Show Label</source>
        <translation>Beschriftung zeigen</translation>
    </message>
    <message>
        <source>Show Legend</source>
        <translation>Legende zeigen</translation>
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
        <source>So much may be left: twice the scallop, and the tolerance</source>
        <translation>So viel darf stehen bleiben: die doppelte Kuppenhöhe und die Toleranz</translation>
    </message>
    <message>
        <source>Spindle</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>Start and stop of the facets on the chosen faces</source>
        <translation>Anfang und Ende der Facetten auf den gewählten Flächen</translation>
    </message>
    <message>
        <source>Stepover</source>
        <translation>Zeilensprung</translation>
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
        <source>The map is of the toolpath as it is now</source>
        <translation>Die Karte gehört zum Werkzeugweg, wie er jetzt ist</translation>
    </message>
    <message>
        <source>The map is of the toolpath as it is now; if it is not, try the setups again</source>
        <translation>Die Karte gehört zum Werkzeugweg, wie er jetzt ist; sonst die Aufspannungen neu erproben</translation>
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
        <source>The solid, body, compound or mesh, and the faces of it that are milled</source>
        <translation>Der Volumenkörper, Körper, Verbund oder das Netz, und seine Flächen, die gefräst werden</translation>
    </message>
    <message>
        <source>The tessellation, or any mesh, that is milled</source>
        <translation>Die Tessellierung oder ein anderes Netz, das gefräst wird</translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The work zero in the machine frame about which setups were tried</source>
        <translation>Der Werkstücknullpunkt im Maschinensystem, um den herum Aufspannungen erprobt wurden</translation>
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
        <source>Toolpath</source>
        <translation>Werkzeugweg</translation>
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
        <source>What the result says about itself, in plain sentences</source>
        <translation>Was das Ergebnis über sich selbst sagt, in einfachen Sätzen</translation>
    </message>
    <message>
        <source>Where the markers stand in the document</source>
        <translation>Wo die Markierungen im Dokument stehen</translation>
    </message>
    <message>
        <source>Where the work zero should stand, in the machine frame</source>
        <translation>Wo der Werkstücknullpunkt stehen sollte, im Maschinensystem</translation>
    </message>
    <message>
        <source>Where the work zeros of the map lie in the document</source>
        <translation>Wo die Werkstücknullpunkte der Karte im Dokument liegen</translation>
    </message>
    <message>
        <source>Whether the program is safe to run, and why, in a plain sentence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the path in pixels</source>
        <translation>Breite des Werkzeugwegs in Bildpunkten</translation>
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
        <source>Worst Line</source>
        <translation>Schlimmste NC-Zeile</translation>
    </message>
    <message>
        <source>Written</source>
        <translation>Geschrieben</translation>
    </message>
    <message>
        <source>X,Y,Z of the work zero in the machine frame [the machine's]</source>
        <translation>X,Y,Z des Werkstücknullpunkts im Maschinensystem [der aus der Maschinendatei]</translation>
    </message>
    <message>
        <source>X,Y,Z over the work zero of a place to mark, as high as part and clamps reach</source>
        <translation>X,Y,Z über dem Werkstücknullpunkt: eine Stelle zum Anzeichnen, so hoch, wie Werkstück und Spannmittel reichen</translation>
    </message>
    <message>
        <source>X,Y,Z: so far to either side the work zero may move from where it is; 0: it stays</source>
        <translation>X,Y,Z: so weit darf der Werkstücknullpunkt von seinem Ort aus nach beiden Seiten rücken; 0: er bleibt</translation>
    </message>
    <message>
        <source>a shipped machine's name or a path to a .fcm</source>
        <translation>Name einer mitgelieferten Maschine oder Pfad einer .fcm-Datei</translation>
    </message>
    <message>
        <source>constant distance of the planes, instead of a scallop</source>
        <translation>fester Abstand der Ebenen, statt einer Kuppenhöhe</translation>
    </message>
    <message>
        <source>coolant during the program</source>
        <translation>Kühlmittel während des Programms</translation>
    </message>
    <message>
        <source>cures to compare, with commas between [every one there is]</source>
        <translation>Abhilfen zum Vergleich, mit Komma dazwischen [alle, die es gibt]</translation>
    </message>
    <message>
        <source>cylinders above the cutter, DIAMETERxLENGTH upwards in mm, as 8x20,12x30; see gouge</source>
        <translation>Zylinder über dem Fräser, DURCHMESSERxLÄNGE nach oben in mm, wie 8x20,12x30; siehe Eindringen</translation>
    </message>
    <message>
        <source>cylinders of the holder above cutter and shank, as 40x25,63x50 in mm; see gouge</source>
        <translation>Zylinder des Halters über Fräser und Schaft, wie 40x25,63x50 in mm; siehe Eindringen</translation>
    </message>
    <message>
        <source>divide feed blocks over tolerance into the fewest that hold it; off with rtcp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>facets steeper than this are left out</source>
        <translation>steilere Facetten werden ausgelassen</translation>
    </message>
    <message>
        <source>feed of all its moves, mm/min and deg/min</source>
        <translation>Vorschub aller Bewegungen, mm/min und Grad/min</translation>
    </message>
    <message>
        <source>feed of the approach, mm/min</source>
        <translation>Vorschub beim Anfahren, mm/min</translation>
    </message>
    <message>
        <source>feed of the tip over the part, mm/min</source>
        <translation>Vorschub der Werkzeugspitze über das Werkstück, mm/min</translation>
    </message>
    <message>
        <source>gauge point to tip; machines with a rotary head need it</source>
        <translation>Bezugspunkt der Spindel bis Werkzeugspitze; Maschinen mit Schwenkkopf brauchen sie</translation>
    </message>
    <message>
        <source>how far the controller may round corners, where it can; 0: exact path</source>
        <translation>wie weit die Steuerung Ecken verschleifen darf, wo sie es kann; 0: genaue Bahn</translation>
    </message>
    <message>
        <source>how far the strategy `minimax` may leave the facet normals, and gouge `tilt` the axes of any strategy</source>
        <translation>wie weit die Strategie `minimax` von den Facettennormalen abweichen darf, und bei Eindringen `tilt` von den Achsen jeder Strategie</translation>
    </message>
    <message>
        <source>inverse time, or units a minute</source>
        <translation>zeitreziprok, oder Einheiten je Minute</translation>
    </message>
    <message>
        <source>largest R - r at a convex co-edge before an arc is used</source>
        <translation>größtes R - r an einer konvexen gemeinsamen Kante, bevor ein Bogen genommen wird</translation>
    </message>
    <message>
        <source>largest angle between the tool axis and that of the CL path at a block's end</source>
        <translation>größter Winkel zwischen der Werkzeugachse und der des CL-Wegs am Ende eines Satzes</translation>
    </message>
    <message>
        <source>largest change of the tool axis where it is led past the pole (deform)</source>
        <translation>größte Änderung der Werkzeugachse, wo sie am Pol vorbeigeführt wird (deform)</translation>
    </message>
    <message>
        <source>largest deviation of the tip from the commanded segment</source>
        <translation>größte Abweichung der Werkzeugspitze von der Sollstrecke</translation>
    </message>
    <message>
        <source>largest scallop left between passes [0.01 where no stepover is given]</source>
        <translation>größte Kuppenhöhe zwischen den Zeilen [0,01, wo kein Zeilensprung gegeben ist]</translation>
    </message>
    <message>
        <source>lean of the tool across the feed direction</source>
        <translation>Neigung des Werkzeugs quer zur Vorschubrichtung</translation>
    </message>
    <message>
        <source>lean of the tool along the feed direction</source>
        <translation>Neigung des Werkzeugs in Vorschubrichtung</translation>
    </message>
    <message>
        <source>line deviation: exact, or the model of So et al. 2008</source>
        <translation>Abweichung von der Geraden: genau, oder nach dem Modell von So u. a. 2008</translation>
    </message>
    <message>
        <source>machines to compare, as for `mill`, with commas between; or --machine again for each</source>
        <translation>Maschinen zum Vergleich, wie bei `mill`, mit Komma dazwischen; oder --machine für jede</translation>
    </message>
    <message>
        <source>map of what stays uncut and of what is cut too deep, on the machined facets</source>
        <translation>Karte dessen, was auf den bearbeiteten Facetten stehen bleibt und was zu tief gefräst wird</translation>
    </message>
    <message>
        <source>near the pole: only report, divide blocks over tolerance, or lead the tool axis past it (deform)</source>
        <translation>nahe am Pol: nur berichten, NC-Sätze über der Toleranz teilen, oder die Werkzeugachse vorbeiführen (deform)</translation>
    </message>
    <message>
        <source>offsets should be that certain, and that near to those of the machine given</source>
        <translation>so sicher sollen die Versätze sein, und so nah an denen der angegebenen Maschine</translation>
    </message>
    <message>
        <source>passes run to and fro, or all in one direction</source>
        <translation>Zeilen laufen hin und her, oder alle in einer Richtung</translation>
    </message>
    <message>
        <source>places that the map shows along X,Y,Z [as many as take some seconds]</source>
        <translation>Orte, die die Karte entlang X,Y,Z zeigt [so viele, wie einige Sekunden dauern]</translation>
    </message>
    <message>
        <source>planes never come closer than this (steep walls)</source>
        <translation>dichter liegen die Ebenen nie (steile Wände)</translation>
    </message>
    <message>
        <source>rapids stay this far off the part's bounding box</source>
        <translation>so weit bleibt der Eilgang vom Hüllquader des Werkstücks weg</translation>
    </message>
    <message>
        <source>so many turns of the part about Z are tried, evenly over 360 deg [1: as it stands]</source>
        <translation>so viele Drehungen des Werkstücks um Z werden erprobt, gleichmäßig über 360 Grad [1: wie es steht]</translation>
    </message>
    <message>
        <source>spindle speed, 1/min; 0 leaves the spindle off</source>
        <translation>Spindeldrehzahl, 1/min; 0 lässt die Spindel aus</translation>
    </message>
    <message>
        <source>the CL file (.apt, .cl) or the part (.stl) that the program is compared with [neither]</source>
        <translation>die CL-Datei (.apt, .cl) oder das Teil (.stl), womit das Programm verglichen wird [nichts]</translation>
    </message>
    <message>
        <source>the NC program that was posted from the CL path</source>
        <translation>das NC-Programm, das aus der CL-Bahn gemacht wurde</translation>
    </message>
    <message>
        <source>the controller guides the tip (RTCP), told the tool axis by rotary words (angles) or vectors; off: joint output</source>
        <translation>die Steuerung führt die Spitze (RTCP); die Werkzeugachse erfährt sie durch Drehachsworte (angles) oder Vektoren (vectors); off: Ausgabe der Achsstellungen</translation>
    </message>
    <message>
        <source>the controller's high-speed mode, with the tolerance of --blend</source>
        <translation>der Hochgeschwindigkeitsmodus der Steuerung, mit der Toleranz der Eckenverrundung (--blend)</translation>
    </message>
    <message>
        <source>the dialect of the NC file [the machine's, or linuxcnc]</source>
        <translation>die Sprache der NC-Datei [die der Maschine, sonst linuxcnc]</translation>
    </message>
    <message>
        <source>the machine file (.fcm) to write</source>
        <translation>die Maschinendatei (.fcm), die geschrieben wird</translation>
    </message>
    <message>
        <source>the point of the tool that the words drive</source>
        <translation>der Punkt des Werkzeugs, den die Achswerte führen</translation>
    </message>
    <message>
        <source>the tip stops so far above the mark, and never comes nearer</source>
        <translation>so weit über der Marke hält die Spitze an, und näher kommt sie nie</translation>
    </message>
    <message>
        <source>tool number [no tool call: the operator has set tool and length]</source>
        <translation>Werkzeugnummer [kein Werkzeugaufruf: der Bediener hat Werkzeug und Länge eingerichtet]</translation>
    </message>
    <message>
        <source>tool-axis strategy (see `strategies`)</source>
        <translation>Strategie der Werkzeugachse</translation>
    </message>
    <message>
        <source>travel direction of the passes, counter-clockwise from X</source>
        <translation>Laufrichtung der Zeilen, gegen den Uhrzeigersinn von X aus</translation>
    </message>
    <message>
        <source>turn of each rotary axis</source>
        <translation>Drehung jeder Drehachse</translation>
    </message>
    <message>
        <source>way of each linear axis</source>
        <translation>Weg jeder Linearachse</translation>
    </message>
    <message>
        <source>where the tool enters the part: only report, lift it along its axis, leave out, or tilt it free within max-tilt and lift where the cutter still enters; off: no check</source>
        <translation>wo das Werkzeug ins Teil eindringt: nur melden, entlang seiner Achse abheben, auslassen oder innerhalb von max-tilt freikippen und abheben, wo die Schneide noch eindringt; off: keine Prüfung</translation>
    </message>
    <message>
        <source>work offset: G54 to G59, LinuxCNC's G59.1 to G59.3, Fanuc's G54.1 P1 to P300</source>
        <translation>Nullpunktverschiebung: G54 bis G59, bei LinuxCNC G59.1 bis G59.3, bei Fanuc G54.1 P1 bis P300</translation>
    </message>
</context>
<context>
    <name>FiveAxis</name>
    <message>
        <source> 1/min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A controller with tool tip control (RTCP) guides the tip along the line itself.</source>
        <translation>Eine Steuerung mit Werkzeugspitzenführung (RTCP) führt die Spitze von sich aus auf der Geraden.</translation>
    </message>
    <message>
        <source>A longer tool, a slimmer holder, lead or tilt away from the wall; or leave such places out.</source>
        <translation>Ein längeres Werkzeug, ein schlankerer Halter, das Werkzeug von der Wand weg voreilen lassen oder zur Seite neigen; oder solche Stellen auslassen.</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
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
        <source>Applied: the largest deviation is now {deviation}.</source>
        <translation>Übernommen: die größte Abweichung ist jetzt {deviation}.</translation>
    </message>
    <message>
        <source>Apply to the tool path</source>
        <translation>Für den Werkzeugweg übernehmen</translation>
    </message>
    <message>
        <source>Audit</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>Axis tolerance</source>
        <translation>Achstoleranz</translation>
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
        <source>Block</source>
        <translation>NC-Satz</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>NC-Sätze</translation>
    </message>
    <message>
        <source>Blocks over tolerance</source>
        <translation>NC-Sätze über der Toleranz</translation>
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
        <source>Certain within</source>
        <translation>Sicher auf</translation>
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
        <source>Clearance</source>
        <translation>Sicherheitsabstand</translation>
    </message>
    <message>
        <source>Click a point, or press Esc</source>
        <translation>Einen Punkt anklicken, oder Esc drücken</translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Collision between passes</source>
        <translation>Kollision zwischen Bahnen</translation>
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
        <source>Corner radius</source>
        <translation>Eckenradius</translation>
    </message>
    <message>
        <source>Corner rounding</source>
        <translation>Verschleifen</translation>
    </message>
    <message>
        <source>Cure</source>
        <translation>Abhilfe</translation>
    </message>
    <message>
        <source>Cures</source>
        <translation>Abhilfen</translation>
    </message>
    <message>
        <source>Cut too deep</source>
        <translation>Zu tief gefräst</translation>
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
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Direction of passes</source>
        <translation>Richtung der Zeilen</translation>
    </message>
    <message>
        <source>Distance of the tip from the commanded line</source>
        <translation>Abstand der Werkzeugspitze von der Sollstrecke</translation>
    </message>
    <message>
        <source>Draw {label}</source>
        <translation>{label} zeichnen</translation>
    </message>
    <message>
        <source>Driven point</source>
        <translation>Geführter Punkt</translation>
    </message>
    <message>
        <source>Edge tolerance</source>
        <translation>Kantentoleranz</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation type="unfinished"></translation>
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
        <source>Follow the tip</source>
        <translation>Der Spitze folgen</translation>
    </message>
    <message>
        <source>From a CAM Job…</source>
        <translation>Aus einem CAM-Auftrag …</translation>
    </message>
    <message>
        <source>From a tool file…</source>
        <translation>Aus einer Werkzeugdatei …</translation>
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
        <source>Gap above the mark</source>
        <translation>Abstand über der Marke</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation type="unfinished"></translation>
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
        <source>In the folder that is proposed it stands in every list of machines from then on.</source>
        <translation>Im vorgeschlagenen Ordner steht sie von da an in jeder Maschinenliste.</translation>
    </message>
    <message>
        <source>In the tool path's panel a larger clearance; under the part let the tool be lifted, or leave such places out.</source>
        <translation>Im Fenster des Werkzeugwegs ein größerer Sicherheitsabstand; unter dem Werkstück das Werkzeug anheben lassen oder solche Stellen auslassen.</translation>
    </message>
    <message>
        <source>In the tool path's panel let the tool be lifted there, or leave such places out; or take a smaller cutter. The command What is left shows what then stays uncut. Where that is done already, the machine leaves the path between blocks: set Linearize to on.</source>
        <translation>Im Fenster des Werkzeugwegs das Werkzeug dort anheben oder solche Stellen auslassen; oder einen kleineren Fräser nehmen. Der Befehl „Restmaterial“ zeigt, was dann stehen bleibt. Ist das schon geschehen, so verlässt die Maschine den Weg zwischen den Sätzen: „Linearisieren“ auf „an“ stellen.</translation>
    </message>
    <message>
        <source>Its name must end in {endings}.</source>
        <translation>Der Name muss auf {endings} enden.</translation>
    </message>
    <message>
        <source>Keep anyway</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the tip of the tool in the middle of the view</source>
        <translation>Die Werkzeugspitze in der Mitte der Ansicht halten</translation>
    </message>
    <message>
        <source>Keep this path anyway?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
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
        <source>Largest residual of the rows used: {length}</source>
        <translation>Größter Rest der benutzten Zeilen: {length}</translation>
    </message>
    <message>
        <source>Largest tilt</source>
        <translation>Größte Neigung</translation>
    </message>
    <message>
        <source>Largest: {largest}</source>
        <translation>Größte: {largest}</translation>
    </message>
    <message>
        <source>Lead</source>
        <translation>Voreilwinkel</translation>
    </message>
    <message>
        <source>Least interval</source>
        <translation>Kleinster Zeilensprung</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Ausgelassen</translation>
    </message>
    <message>
        <source>Let the tool path's panel lead the axis past the pole, lead or tilt the tool by a few degrees, or clamp the part in another position.</source>
        <translation>Im Fenster des Werkzeugwegs die Achse am Pol vorbeiführen lassen, das Werkzeug um einige Grad voreilen lassen oder zur Seite neigen, oder das Werkstück anders aufspannen.</translation>
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
        <source>Linearize</source>
        <translation>Linearisieren</translation>
    </message>
    <message>
        <source>LinuxCNC configurations and machine files (*.ini *.fcm)</source>
        <translation>LinuxCNC-Konfigurationen und Maschinendateien (*.ini *.fcm)</translation>
    </message>
    <message>
        <source>LinuxCNC's .ini with trt kinematics, or a .fcm of FreeCAD's Machine editor</source>
        <translation>Eine .ini von LinuxCNC mit trt-Kinematik, oder eine .fcm von FreeCADs Maschineneditor</translation>
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
        <source>Machines</source>
        <translation>Maschinen</translation>
    </message>
    <message>
        <source>Machines on {label}</source>
        <translation>Maschinen an {label}</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>Marke</translation>
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
        <source>Moves</source>
        <translation>Bewegungen</translation>
    </message>
    <message>
        <source>NC file</source>
        <translation>NC-Datei</translation>
    </message>
    <message>
        <source>NC file written</source>
        <translation type="unfinished"></translation>
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
        <source>Name the NC file.</source>
        <translation>Die NC-Datei benennen.</translation>
    </message>
    <message>
        <source>Name the machine file.</source>
        <translation>Geben Sie der Maschinendatei einen Namen.</translation>
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
        <source>Next singular</source>
        <translation>Nächster singulärer</translation>
    </message>
    <message>
        <source>Not drawn, as you stopped it: recompute to draw it</source>
        <translation>Nicht gezeichnet, weil abgebrochen: neu berechnen, um es zu zeichnen</translation>
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
        <source>Nothing to report: all blocks are as they should be.</source>
        <translation>Nichts zu melden: alle NC-Sätze sind, wie sie sein sollen.</translation>
    </message>
    <message>
        <source>Off its segment</source>
        <translation>Neben der Sollstrecke</translation>
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
        <source>One block back</source>
        <translation>Einen NC-Satz zurück</translation>
    </message>
    <message>
        <source>One block on</source>
        <translation>Einen NC-Satz weiter</translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
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
        <source>Order</source>
        <translation>Reihenfolge</translation>
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
        <source>Passes</source>
        <translation>Zeilen</translation>
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
        <source>Pick in the 3D view</source>
        <translation>In der 3D-Ansicht wählen</translation>
    </message>
    <message>
        <source>Places on the map</source>
        <translation>Orte auf der Karte</translation>
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
        <source>Preview for the CAM workbench</source>
        <translation>Vorschau für den Arbeitsbereich CAM</translation>
    </message>
    <message>
        <source>Prove the signs</source>
        <translation>Vorzeichen nachweisen</translation>
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
        <source>Recompute</source>
        <translation type="unfinished"></translation>
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
        <source>Room for the work zero</source>
        <translation>Spielraum des Nullpunkts</translation>
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
        <source>Scallop</source>
        <translation>Kuppenhöhe</translation>
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
        <source>Shank or holder collides</source>
        <translation>Schaft oder Halter kollidiert</translation>
    </message>
    <message>
        <source>Shank, Ø x length</source>
        <translation>Schaft, Ø x Länge</translation>
    </message>
    <message>
        <source>Sheet to print</source>
        <translation>Blatt zum Drucken</translation>
    </message>
    <message>
        <source>Shorter blocks help: half the length leaves about a quarter of the deviation. Linearize, in the tool path's panel, makes as many of them as are needed.</source>
        <translation>Kürzere NC-Sätze helfen: die halbe Länge lässt etwa ein Viertel der Abweichung übrig. „Linearisieren“ im Fenster des Werkzeugwegs macht so viele davon, wie nötig sind.</translation>
    </message>
    <message>
        <source>Show findings</source>
        <translation>Befunde zeigen</translation>
    </message>
    <message>
        <source>Show folder</source>
        <translation type="unfinished"></translation>
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
        <source>Spacing by</source>
        <translation>Abstand nach</translation>
    </message>
    <message>
        <source>Speed, in times of real time</source>
        <translation>Geschwindigkeit, in Vielfachen der wirklichen</translation>
    </message>
    <message>
        <source>Spindle speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spindle speed not given: the program will not start the spindle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steepest facet</source>
        <translation>Steilste Facette</translation>
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
        <source>The controller guides the tip (RTCP); shown are evenly moving axes.</source>
        <translation>Die Steuerung führt die Spitze (RTCP); gezeigt sind gleichmäßig bewegte Achsen.</translation>
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
        <source>The head of a machine that is ticked turns: give the tool length.</source>
        <translation>Der Kopf einer angehakten Maschine dreht: die Werkzeuglänge angeben.</translation>
    </message>
    <message>
        <source>The largest distance in this block</source>
        <translation>Der größte Abstand in diesem NC-Satz</translation>
    </message>
    <message>
        <source>The machine file to write</source>
        <translation>Die zu schreibende Maschinendatei</translation>
    </message>
    <message>
        <source>The next block where a rotary axis turns far to lean the tool a little</source>
        <translation>Der nächste NC-Satz, in dem eine Rundachse weit dreht, um das Werkzeug ein wenig zu neigen</translation>
    </message>
    <message>
        <source>The part was deleted meanwhile: press Cancel, and select another one.</source>
        <translation>Das Werkstück wurde inzwischen gelöscht: „Abbrechen“ drücken und ein anderes auswählen.</translation>
    </message>
    <message>
        <source>The point of the part that is the program's zero</source>
        <translation>Der Punkt des Werkstücks, der Nullpunkt des Programms ist</translation>
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
        <source>The tool is short, or leans towards a wall beside what is cut. Walls that are not selected count too.</source>
        <translation>Das Werkzeug ist kurz oder neigt sich zu einer Wand neben dem, was gefräst wird. Auch Wände, die nicht ausgewählt sind, zählen.</translation>
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
        <source>These files are there already. Replace them?</source>
        <translation>Diese Dateien gibt es schon. Ersetzen?</translation>
    </message>
    <message>
        <source>This file is there already: choose another name.</source>
        <translation>Diese Datei gibt es schon: wählen Sie einen anderen Namen.</translation>
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
        <source>Tick at least one machine and one cure.</source>
        <translation>Mindestens eine Maschine und eine Abhilfe anhaken.</translation>
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
        <source>Tolerance</source>
        <translation>Toleranz</translation>
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
        <source>Tool path</source>
        <translation>Werkzeugweg</translation>
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
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation type="unfinished"></translation>
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
        <source>What the distance is proven to stay below, all through this block</source>
        <translation>Worunter der Abstand im ganzen NC-Satz bewiesenermaßen bleibt</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Was tun</translation>
    </message>
    <message>
        <source>Where the program's zero is drawn in the document</source>
        <translation>Wo der Nullpunkt des Programms im Dokument gezeichnet wird</translation>
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
        <source>Where to clamp</source>
        <translation>Wohin spannen</translation>
    </message>
    <message>
        <source>While the rotary axes turn, the tip leaves the straight way over the part; or the part is over the tool.</source>
        <translation>Während die Drehachsen sich drehen, verlässt die Spitze den geraden Weg über dem Werkstück; oder das Werkstück ist über dem Werkzeug.</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Warum</translation>
    </message>
    <message>
        <source>Within a step of {step}, {first} turns {first_turn} and {second} {second_turn}. While rotary axes turn, even moves of the axes carry the tip along a curve beside the straight line.</source>
        <translation>In einem Schritt von {step} dreht {first} um {first_turn} und {second} um {second_turn}. Während Rundachsen drehen, tragen gleichmäßige Bewegungen der Achsen die Spitze auf einer Kurve neben der Geraden entlang.</translation>
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
        <translation type="unfinished"></translation>
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
        <source>You see: {text}</source>
        <translation>Sie sehen: {text}</translation>
    </message>
    <message>
        <source>along</source>
        <translation>entlang</translation>
    </message>
    <message>
        <source>and {count} more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>around an edge</source>
        <translation>um eine Kante</translation>
    </message>
    <message>
        <source>as many as take some seconds</source>
        <translation>so viele, wie einige Sekunden dauern</translation>
    </message>
    <message>
        <source>as the machine file says</source>
        <translation>wie in der Maschinendatei</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>ball end</source>
        <translation>Kugelfräser</translation>
    </message>
    <message>
        <source>bull nose</source>
        <translation>Torusfräser</translation>
    </message>
    <message>
        <source>by rotary words</source>
        <translation>durch Drehachsworte</translation>
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
        <source>centre of the rounding</source>
        <translation>Mitte der Rundung</translation>
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
        <source>collision between passes: {count} places</source>
        <translation>Kollision zwischen Bahnen: {count} Stellen</translation>
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
        <source>cutter {depth} in the part between passes</source>
        <translation>Fräser zwischen Bahnen {depth} im Werkstück</translation>
    </message>
    <message>
        <source>cutting the mesh</source>
        <translation>Netz schneiden</translation>
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
        <source>driving what is led</source>
        <translation>Geführtes nachfahren</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>genau</translation>
    </message>
    <message>
        <source>fitting machines</source>
        <translation>Maschinen werden angepasst</translation>
    </message>
    <message>
        <source>fixed</source>
        <translation>fest</translation>
    </message>
    <message>
        <source>flat end</source>
        <translation>Schaftfräser (flach)</translation>
    </message>
    <message>
        <source>found</source>
        <translation>gefunden</translation>
    </message>
    <message>
        <source>grbl with five axes</source>
        <translation>grbl mit fünf Achsen</translation>
    </message>
    <message>
        <source>impossible: {why}</source>
        <translation>unmöglich: {why}</translation>
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
        <source>lead the axis past it</source>
        <translation>die Achse vorbeiführen</translation>
    </message>
    <message>
        <source>lead the axis past the pole</source>
        <translation>die Achse am Pol vorbeiführen</translation>
    </message>
    <message>
        <source>leading the axis past the pole</source>
        <translation>Achse am Pol vorbeiführen</translation>
    </message>
    <message>
        <source>least deviation (minimax)</source>
        <translation>kleinste Abweichung (minimax)</translation>
    </message>
    <message>
        <source>leave out</source>
        <translation>auslassen</translation>
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
        <source>linking the passes</source>
        <translation>Zeilen verbinden</translation>
    </message>
    <message>
        <source>looking where the tool enters the part</source>
        <translation>Suche, wo das Werkzeug in das Teil eindringt</translation>
    </message>
    <message>
        <source>machines</source>
        <translation>Maschinen</translation>
    </message>
    <message>
        <source>mean of the facet normals</source>
        <translation>Mittel der Facettennormalen</translation>
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
        <source>model of So et al. 2008</source>
        <translation>Modell von So u. a. 2008</translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>normals weighted by step</source>
        <translation>nach Schrittlänge gewichtete Normalen</translation>
    </message>
    <message>
        <source>not determined</source>
        <translation>nicht bestimmt</translation>
    </message>
    <message>
        <source>not given</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not proven between their ends</source>
        <translation>zwischen ihren Enden nicht nachgewiesen</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
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
        <source>placing the passes</source>
        <translation>Zeilen legen</translation>
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
        <source>rapid</source>
        <translation>Eilgang</translation>
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
        <source>stopped by the user</source>
        <translation>vom Benutzer abgebrochen</translation>
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
        <source>the axes leave their limits</source>
        <translation>die Achsen verlassen ihre Grenzen</translation>
    </message>
    <message>
        <source>the head</source>
        <translation>den Kopf</translation>
    </message>
    <message>
        <source>the machine's own</source>
        <translation>die der Maschine</translation>
    </message>
    <message>
        <source>the table</source>
        <translation>den Tisch</translation>
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
        <source>to and fro</source>
        <translation>hin und her</translation>
    </message>
    <message>
        <source>trying setups</source>
        <translation>Aufspannungen erproben</translation>
    </message>
    <message>
        <source>turning the axes</source>
        <translation>Rundachsen berechnen</translation>
    </message>
    <message>
        <source>units a minute (G94)</source>
        <translation>Einheiten je Minute (G94)</translation>
    </message>
    <message>
        <source>where the work zero stood</source>
        <translation>wo der Werkstücknullpunkt stand</translation>
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
        <source>writing NC blocks</source>
        <translation>NC-Sätze schreiben</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>{block} of {last}, {motion}</source>
        <translation>{block} von {last}, {motion}</translation>
    </message>
    <message>
        <source>{controller} does not guide the tip itself; Linearize helps.</source>
        <translation>{controller} führt die Spitze nicht selbst; Linearisieren hilft.</translation>
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
        <source>{controller} needs the number of the tool for it: give it under More settings.</source>
        <translation>{controller} braucht dafür die Werkzeugnummer: siehe „Weitere Einstellungen“.</translation>
    </message>
    <message>
        <source>{count}, proven are only their ends</source>
        <translation>{count}, nachgewiesen sind nur ihre Enden</translation>
    </message>
    <message>
        <source>{depth} too deep</source>
        <translation>{depth} zu tief</translation>
    </message>
    <message>
        <source>{deviation}, NC line {line}</source>
        <translation>{deviation}, NC-Zeile {line}</translation>
    </message>
    <message>
        <source>{document} has no 3D view: open one and play {path} again.</source>
        <translation>{document} hat keine 3D-Ansicht: eine öffnen und {path} noch einmal abspielen.</translation>
    </message>
    <message>
        <source>{file}
{lines} lines, run time {time}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{first} turns {first_turn} and {second} {second_turn} to lean the tool by {lean}. The axis may be too slow for the programmed feed: then the tool dwells and may leave a mark.</source>
        <translation>{first} dreht um {first_turn} und {second} um {second_turn}, um das Werkzeug um {lean} zu neigen. Die Achse kann für den programmierten Vorschub zu langsam sein: dann verweilt das Werkzeug und hinterlässt womöglich eine Marke.</translation>
    </message>
    <message>
        <source>{height} left</source>
        <translation>{height} bleibt stehen</translation>
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
        <translation type="unfinished"></translation>
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
        <source>{} s</source>
        <translation>{} s</translation>
    </message>
</context>
<context>
    <name>FiveAxisCore</name>
    <message>
        <source> On that machine the tip would be off by up to {miss}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> The path goes straight on to the next GOTO: have curves written as points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> This is the deepest of {blocks} blocks in {places} places.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> of {axes}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> {name} is another machine.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> {name} is that machine.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 block leads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 feed block (NC line {first})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 feed block asks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 feed block: {count} of {all} feed blocks {what} Worst is NC line {line}, {off} off ({tolerance} allowed); first NC line {first}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A head's pivot was found as its distance from the tip, tool included. Give {tool_length} to have the gauge point's written; else use the file with tool length 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All {count} facets looked inward and were turned outward; check the export if only some of them should.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Approaches and blocks in which an axis is at its limit are rightly slower; look at the others.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At the end of {count} feed blocks the tool does not stand as the CL path says: worst NC line {line}, by {lean} ({tolerance} allowed); first NC line {first}. Are signs, order and zeros of the rotary axes those of the machine?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axis words stand under no G0 or G1; they are taken as G1. Give a motion code.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F says {speed}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FEDRAT needs one feed above 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For the post {letter} is the rotary axis nearer to the work, for {name} it is {own}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD's file does not say everything; taken: {lacking}. Correct them under fiveaxis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>GODLTA stands before the first GOTO: from where is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>If not: are {cutter}, {origin} and the machine those of the program, and does the STL stand at the work zero?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In hollows along the passes the cutter's bottom stands up to about {depth} in the part behind its contact or before it, over {count} rows. Give more lead, take a smaller cutter or a ball, or check for gouges.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In {count} blocks the controller guides the tip (RTCP): that it keeps to the segment is the controller's affair, and neither measured nor proven here. Limits and rates are those of the axes that this machine file needs for it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In {count} blocks the whole cutter is inside the part, the first at {place}. Check the work zero and the units of the part.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In {count} divided blocks the rotary axes turn evenly, because the straight swing of the tool axis would need another branch or winding; its axis deviation stays as it was. Lead the tool round the pole to avoid it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In {count} of {all} feed blocks the ball of {diameter} enters the part by more than {tolerance}; deepest in NC line {line}, {depth}; first NC line {first}. Are {cutter}, {origin} and the machine those of the program, does the STL stand at the work zero? Else the part is spoilt.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In {where} the tip moves over the part more than {factor} times faster or slower than meant: at worst {feed} in NC line {line}, where {meant}. </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the tool be lifted there or leave such places out (gouge lift, leave-out), or use a smaller cutter; where the machine leaves the path by as much, let blocks be divided (linearize on).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limits{of} are left open and maximum rates are assumed (10 m/min, 10 turns a minute): no row tells them. Correct them from the machine's data sheet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MSYS changes the coordinate system within the file; its points are taken in one. Write one file for each system.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No HAL file sets {lacking} of {module}; they are 0, as LinuxCNC has them then. Is that so?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On {area} of the machined surface more than {above} is left, most at {place}: {height}; {volume} in all. Cut these places with a smaller cutter or another tool axis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On {area} of the machined surface more than {tolerance} is cut too deep, most at {place}: {height}; {volume} in all. Let the tool be lifted there (gouge lift), or use a smaller cutter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On {machine} with cure {cure} the path cannot be driven: {problem}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Over {length} of the passes no tilt of up to {most} keeps shank and holder out of the part, the deepest entry at {place}. Allow more tilt ({max_tilt}), use a longer tool, or leave these places out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Positive {letter} words turn the tool, seen from the work, left-handed about {plus}, against ISO 841; the direction in the file is reversed accordingly.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Post it again for this machine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STL file {path} cannot be read: {strerror}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The CL file is for a cutter of {diameter}, retracts are laid out for {given}; give {cutter}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The CL file is for a {said}, retracts are laid out for a {given}; give {cutter}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cutter does not fit into the corners at {number} facet segments; {much}. Use a smaller cutter there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cutter goes {depth} into the part at {at} on its way between passes. Use a larger clearance; where the part is over the tool, let it be lifted there or leave such places out (gouge lift, leave-out).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cutter goes {depth} too deep into the part at {at}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The facets curl tighter than the cutter at {number} segments, and the cutter cuts up to {worst} into them. Use a smaller cutter or a finer mesh, or check these places before milling.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file changes tools ({told}), the program does not: it cuts all of it with one. Write one file for each tool.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file's base frame is shifted or turned and is not used; write the axes in the machine's own frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The first motion line does not say where {unknown} stand; they are taken as 0 there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The flank of the tapered cutter leans into the part over {length} of the passes, the first at {at}; they are left out. Choose another tool axis, lead or tilt, or a cutter of less taper.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The joint axes are taken as the way the tool moves relative to the work (ISO 841). Prove the signs before cutting.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The lines after the end of the program in line {last} are not read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The machine has no axis {letter}: its {count} words are left out. Choose the program's own machine.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The machine that the post had in mind is {kind}, {name} is {own}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model of So et al. finds no farthest point in {rootless} of {blocks} blocks and takes the middle there; use the exact line deviation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The path itself is free of the part there, but the machine leaves it between the ends of blocks: {way}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The post had in mind: {layout}. It explains {count} of {all} rows within {worst}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program counts {name} from {value} (within {certainty}), not from the CL path's zero. A machine file cannot hold that: correct {what}, or the post.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program has rotary words {letters}, {name} has {own}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program says {units_said}; taken as mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program uses {count} work offsets; their distance is not known, and the blocks between are not right.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The rows are off by up to {worst} and {lean} from the best machine, {scale} times what rounding explains. The program may come from another CL path, or its machine have directions or axes that are not tried here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The rows do not determine {name}; it is written {kept}. Give rows in which the rotary axes turn farther.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The text after FINI is not read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The text after the closing % is not read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The text is {language}, and read as such; give its {option}, so that feeds are taken as it takes them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The text is {language}; it is read as a program of {controller}. If it is for another, give its {option}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool axis is beyond the rotary limits over {length} of the passes, the first at {at}; they are left out. Use less lead or tilt, clamp the part in another position, or take another machine.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool axis was tilted in {count} rows, most by {angle} at {place}, so that the tool stays out of the part.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool leans into the part over {length} of the passes, the first at {at}; they are left out. Choose another tool axis, lead or tilt, or cut these places in another set-up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool was lifted over {length} of the passes, most at {place}, where {lift} stay uncut along its axis. Cut these places with a smaller cutter or another tool axis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The zeros of {assumed} are taken as right: these rows could not tell them apart from the offsets. Give rows with larger turns to have them proven too.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {count} words {letter} are not interpreted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {part} goes {depth} into the part at {at}. Let the tool be tilted free or leave these places out (gouge tilt, leave-out), use a longer tool, or more lead or tilt.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the part, or use another tool axis there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use a smaller cutter or another tool axis there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What an axis change buys on {part} passes that come within {change} of the pole (peak rate and travel of {letter}, blocks that would hold {tolerance}): {rows}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With rotary axes turning, F under G94 means other things on other controls. Post with inverse time (G93).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Words count from the work zero: is {origin} where it stood on the machine? Else move it (setup finds a place)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>X Y Z are the tips of the CL path although the rotary axes turn: the program leaves the pivots to the controller (RTCP); post it without tool centre point control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>X{x} Y{y} Z{z}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a bracket without its partner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a coordinate of {farthest} mm or rad is beyond any machine; correct it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a facet names vertex {wrong}, but the rows run from 0 to {count}: correct the facets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a feed per turn needs the spindle speed; say SPINDL/ before, or give it per minute</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number with an exponent; write it out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a piece of the tool from height {low} to {high} has no volume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a piece of the tool has sizes {sizes}; give radii of at least 0, up to {largest}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a slash must follow the word, as in GOTO/1,2,3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a whole run of facets stays uncut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a word is a letter and one number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>above {bound}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>arcs of a form that is not known here, taken as straight to their end points; post straight moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>are off the CL path, nearly all alike ({least} to {most} at their ends): the post had another machine, work zero or tool length in mind. See {origin} and {tool_length}; recover finds the machine that fits.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as given</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as in the machine given</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ask for a smaller tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at least {bound}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at least {depth}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at most {bound}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>axis {letter} needs it there or under [AXIS_{letter}]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>both rotary axes are parallel; tilt one of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>calls, whose moves are missing here; post one program without them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>character {shown} cannot be read ({hint})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clearance {clearance} must be positive: rapids and rewinds need room about the part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>co-edge tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>control_point is {control_point}; choose one of {known}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cutter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cutter compensation; the words are taken as they are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cutter corner radius is {corner}; give 0 to {radius}, half the diameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cutter length is {length}, the taper begins {begins} above the tip; give a longer cutter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cutter radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cutter taper is {taper}; give 0 to {least}, from the axis to the flank</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cutter taper {taper} makes it {width} wide; give a smaller taper or length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cutter {name} is {value}; give {least} to {most}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cutter {text} needs KIND:{words} or KIND:{words}:LENGTH, as {form} or {form}:60</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cutter {text}: only {kinds} cutters are on offer; write it as {form}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cycles, whose moves are missing here; post straight moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>each of its numbers must be {bounds}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>facet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>facet {facet} is malformed: '{said}' stands where {need} belongs; export the file again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>facets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>facets are given as {dtype} numbers: give integer rows of the vertex table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>feeds per spindle turn; no time is given for these blocks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>feeds told by a parameter or the tool; F is not known there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fixed tool axis {fixed} has no direction; give three numbers, as 0,0,1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>folder {folder} cannot be written: {strerror}; choose another one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>folder {folder} does not exist; make it first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gouge leave-out leaves nothing to cut: {why}; use a smaller cutter or holder, a longer tool or another tool axis, or see where with gouge report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>holder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>holder {sizes} is no cone; give z0, r0, z1, r1 in mm with 0 &lt;= z0 &lt; z1 and radii of at least 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it must be {bounds}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>job file {path} is not JSON: {error}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>job file {path} needs "task" (one of {tasks}) and "source", the file to read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>known are {modules}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>leave the CL path between their ends, which lie on it: the axes' even motion carries the tip off. Linearize.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>leave the CL path out along the tool and come back to the same place: ways of the post's own, as to rewind.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>leave the CL path, and end off it: a word is wrong there, or they are moves of the post's own, as retracts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>let blocks be divided (linearize on)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line 1, column 1: the CL file holds no GOTO statement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line 1, column 1: the GOTO statements cannot be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line {line}, column {at}: {reason}: {found}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line {line}, column {column}: byte {control}: this is no NC text; give a plain text file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line {line}, column {column}: {reason}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line {number}, column {column}: {reason}: {statement}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>machine file {output} needs the ending .fcm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>machine {name} has a rotary head: give {tool_length}, gauge point to tip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>machine {name}: {problem}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>max-tilt {tilt} is out of range; give {least} to {most}, or choose facet_mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>moves to machine positions unknown to the program; they are not audited</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>neither G20 nor G21</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>neither G70 nor G71 (G700, G710)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>neither MM nor INCH in BEGIN PGM</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no NC file named; give one with -o OUT.ngc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no block cuts, so nothing can be said of what is left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no facet of the part lies on {name} within {tolerance}; export the faces in the part's own place and units, or raise the tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no machine file named; give one with -o OUT.fcm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none asked for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none of the {count} facets has an area: check the units and the export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not known and not interpreted; what it does is missing here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not part of any word</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on every pass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only {count} of {rows} CL rows can be paired with the program's {blocks} blocks; give a program that was posted from this CL path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>region 0,0,0 with 1 turn has one setup only; give {region} a way to go along X, Y or Z, or {turns} above 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>report {path} needs one of the endings {reports}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rotary words with a direction (ACP, ACN); taken by the shorter way. Post absolute words</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>setup region {box}: {why}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shank</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shifts, turns or scales of the coordinates; post without them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>splines, taken as straight to their end points; post straight moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the CL file holds fewer than two rows: there is no path to compare with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the arcs need {count} chords, more than {most}; is it a program in inches read as mm?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the axes leave their limits everywhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the axis may change by {change}; give an angle from {least_change} to {largest_change}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the axis' zero in the controller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file became shorter while it was read; export it again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file ends within facet {facet}: it is cut off; export it again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file holds no motion blocks: no axis word of this machine under G0 or G1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file is empty; export the part again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the header announces {facets} facets, but the file holds {held}: it is cut off, damaged or no STL; export it again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the linear axes X, Y, Z lie in one plane; correct their directions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the linear axes lie in one plane at {letter} {first} {other} {second} and cannot place the tip ({count} rows): lower {max_axis_angle} or take another machine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the median of all blocks is {speed}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the mesh has no facets: export a solid or a surface with at least one triangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the program has no block that moves; there is nothing to play</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the program has rotary words of {names}; a five-axis machine is recovered from two of A B C</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the rotary words never change: such rows say nothing of pivots; give a five-axis program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the second rotary axis is parallel to the tool and never tilts it; is the order of the two right?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the text cannot be shown: {strerror}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the tool axis is 0, 0, 0, or beyond all bounds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the tool could not get out along its axis {where}, for the part is over it, as at {place}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the tool would enter the part {where}, deepest by {depth} at {place}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the work offset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the {all}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the {what} are {form}: give numbers of shape {wanted}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the {what} form no regular table: {problem}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there are no machines to compare; name at least one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there are no passes: no plane cuts a facet that can be reached; check stepover and direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no block {flat}; the last one is {count}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no path to compare on: it has no rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is nothing to compare; name at least one machine and one cure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this cure leads the tool axes over the part's facets; give it the STL, not a CL file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is no CL file: byte {control} (offset {offset}) stands in no text; give a text file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is no STL file: its {size} bytes neither begin with 'solid' nor hold a binary header</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tolerance is {tolerance}; blocks can be divided for a tolerance above 0 only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tolerance is {tolerance}; give a length above 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tool axes told by spatial, Euler or lead angles; they are missing here. Post rotary words or vectors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tool-offset is a constant {given}; it is in the trunnion's height. Join it to motion.tooloffset.z.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>triangle corners</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two outputs have the same name; name each file apart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown cure {name}; known: {cures}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown method {method} of the line deviation; use one of {methods}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown tool-axis strategy {name}; choose one of {strategies}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown unit; known are MM and INCHES</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>up to {height} of material stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>variables, expressions or jumps; their words are missing here. Post without them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vertex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vertices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with {letter}{first} {other}{second} the linear axes cannot place the tip; is it this machine's program?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>word {word} of row {row} is {value}; words are numbers up to {farthest_word}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>words have shape {shape}; give one row of five words for each block</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>write a decimal point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>write one of {known}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{blocks} more of {letter} than it can: at most NC line {line}, {asked}, {share} times its maximum of {most}; first NC line {first}. The control slows down there, or stops with a fault. Give a lower F there, or inverse time (G93) made for this machine, as `post` does.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{blocks} {letter} beyond its limit of {limit}: farthest NC line {line}, {letter}{word}, {beyond} too far; first NC line {first}. {help}, or take a machine with more travel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{change} {rate}, {turned}, {blocks}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} arcs have no centre that fits their start and end; they are taken as straight. Post straight moves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} blocks are over {tolerance} and were left whole (the first leads to {spot}): no number of blocks holds it there, because the linear axes turn into one plane on the way. Turn the part on the table, or take another machine.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} blocks cannot be held within {tolerance}: words of {linear} and {rotary} decimals put the tip up to {most_off} off. The worst, which leads to {spot}, is proven to hold {value}. Allow more, or use a controller with finer words.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} blocks have no F above 0 in force; most controllers stop there. Give F.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} blocks lead</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} blocks under G93 have no F of their own; most controllers stop there. Give F in every block.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} blocks were over {tolerance} and were divided into {pieces}, as few as hold it by proof.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} facets of {area} ({share} % of the part) lie on {name} and are machined. The others are not; {gouge} checks and cures against all of them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} facets without area were left out, the first at {at}; passes end where that leaves a crack.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} feed blocks (between NC lines {first} and {last})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} feed blocks ask</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} lines begin with a slash (block skip); they are read as if the switch were off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} lines hold variables, expressions or jumps, which are not interpreted; their words are missing here. Post without them. The first: {shown}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} moves after MULTAX/OFF say no axis; the tool keeps the last one, which is not upright.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} moves come before any FEDRAT; give a feed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} numbers for {words} words; the text is malformed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} of the {all}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} of {all} feed blocks {what} Worst is NC line {line}, {off} off ({tolerance} allowed); first NC line {first}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} of {all} points need a tool axis that the rotary limits of {letters} do not allow, the first is {axis} at {place}: widen the limits, lower {max_axis_angle} or take another machine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} of {all} rows do not fit and are left out (NC lines {lines}); their tips would be off by up to {miss}. Look at them: they are wrong in the CL path or in the program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} other layouts explain the rows as well: {more}. The plainest is written; give more rows, with larger turns of both rotary axes, or the machine with {machine}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} passes are led past the pole: {letter} turns at most {after} instead of {before} on them, and {turns} instead of {turned} in all, for an axis changed by up to {most}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} passes come within {limit} of the pole and could not be led past it any better: {letter} turns up to {rate} there. A larger angle, wider rotary limits or another setup may help.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} retracts or approaches pass below the part, because the tool looks down there. Check that nothing holds the part from below, or choose a tool axis that looks up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} rows of the CL file are not cut: no feed block comes within {tolerance} of them. The first is row {first} of {all}, the farthest row {missed}, {distance} off. Is the program whole, and made from this file?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} statements, line {lines}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} statements, lines {lines}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} times the rotary limits make the tool retract, turn back and re-engage inside a cut.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} tool axes are no unit vectors; they are scaled to length 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} tool axes cannot be taken up by this machine; the one before each is kept. Choose its own machine.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{edges} edges have more than two facets, the first at {at}; passes end there. Separate or unite the bodies that meet there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{edges} edges have two facets that run along them in the same sense, the first at {at}; passes end there. Unify the facet normals.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{edges} edges leave the mesh open, the first at {at}; passes end there. Close the shell in CAD if it is meant to be solid.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{error}; these files are written: {written}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{kind}, {one} nearer to the work turning about {way}, {two} about {other_way}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{length} of the passes are left out, because {why}. {remedy}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{length} of the path stay uncut at {count} rewinds: on neither side of them do the rotary limits allow the tool axis that is needed. Wider limits or another setup avoid it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{letter} has to turn back from {before} to {after} inside a cut: the tool retracts, turns above the part and re-engages, which may leave a mark. Wider limits or another setup avoid it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{letter} is another axis: the post turns it about {way}, {name} about {own}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{letter} turns the other way: the post's positive {letter} is the negative one of {name}.{effect}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{letter} would have to go to {word} inside a divided block, its limit is {limit} ({count} rows): move the work zero ({origin}) or take a larger machine.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{letter} would have to go to {word}, its limit is {limit} ({count} rows): move the work zero ({origin}) or take a larger machine.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{letter} {low} to {high}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} = {value} is certain within {certainty} only; give rows with larger turns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} has {asked}, but only {area} of the part lie on it. Export the faces from the same solid, with as fine facets, or raise the tolerance.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} is not interpreted ({where}); what it does is missing in the path.{remedy}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} is not known and not interpreted ({count} lines); what it does is missing here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} is {value}; give a length above 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} is {value}; give a number above 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} is {value}; give a number of at least 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} is {value}; give an angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} lies on the part, but its facets look into it; export the faces again, with their normals outward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} stands in {count} lines: {said}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} stands in {count} lines: {text}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} {given} holds a character that no name can have; give another</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} {given} is not a text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} {given} is not a whole number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} {given} is not of the right kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} {given} is not one of {rules}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} {given} is out of range; {range}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name}: the post has {value} (within {certainty}), {machine} has {given}, {apart} apart.{effect}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name}: {problem}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{one} and {other}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{option}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{output} does not end in {suffix}, as machine files do; name it so</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{output} exists already; choose another name, so that no machine is lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{part} is no number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} cannot be read: {strerror}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} cannot be the name of a file; give another</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} does not exist; name the file to read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} has no ending that is known; give LinuxCNC's .ini or FreeCAD's .fcm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} is a folder; name a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} is a folder; name the file to read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} is no ordinary file; name the file to read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} is no text file; give the {what}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} is the file that is read; name another output</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} line {number}: files include one another in a circle; remove one #INCLUDE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: [JOINT_{joint}], {error}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: [{section}] {key} is missing; {remedy}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: {error}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{pin} comes from signal {signal} ({others}), whose value no HAL file says; write setp {pin} VALUE for the import</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{place}: word {letter} stands twice; a line takes one of each</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{place}: {letter}{value} is beyond {farthest}; is a decimal point missing?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{skipped} blocks have no row of the CL path (moves of the post's own); they are passed over.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{source} is no source of a path; give an STL or a CL file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{target} cannot be written: {strerror}; choose another folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{unused} is {given}, but {module} does not use it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{what} {number} of {rows} has {axis} = {value}, and no part exceeds {most}: check the units of the export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{what} {number} of {rows} has {axis} = {value}: coordinates must be finite numbers; export the mesh again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{what} {part} is out of range; give diameters and lengths above 0, up to 10000 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{what} {path} cannot be read: {strerror}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{what} {text} is no stack; write DIAMETERxLENGTH from the cutter upwards, as 40x25,63x50</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{what} {text} is not a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{what} {text} is not a number with one of the units {known}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{what} {text} needs three numbers, as 0,0,50</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{where}: [TRAJ] {key} is {text}; known are {known}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{where}: [{section}] {key} is missing in {path}; add it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{where}: coordinates={letters} does not name {known}; correct it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{where}: kinematics {module} cannot be imported; {remedy}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{where}: {what} is {text}, not a number; write the number itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{words} further words ({count} statements) are not interpreted; is this a CL file?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{word} has {count} numbers; give 3 or 6</source>
        <translation type="unfinished"></translation>
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
        <source>Corner radius of a bull nose, tapered or not</source>
        <translation>Eckenradius eines Torusfräsers, auch eines konischen</translation>
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
        <source>Largest deviation of the tip from the commanded segment; blocks beyond it are marked</source>
        <translation>Größte Abweichung der Werkzeugspitze von der Sollstrecke; NC-Sätze darüber werden markiert</translation>
    </message>
    <message>
        <source>Largest ridge left between passes</source>
        <translation>Größte Kuppe, die zwischen den Zeilen stehen bleibt (Restrauhigkeit)</translation>
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
        <source>No deviation</source>
        <translation>Keine Abweichung</translation>
    </message>
    <message>
        <source>Over tolerance</source>
        <translation>Über der Toleranz</translation>
    </message>
    <message>
        <source>Scallop</source>
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
        <source>Compare machines…</source>
        <translation>Maschinen vergleichen …</translation>
    </message>
    <message>
        <source>Drive a tool path on several machines, with each cure, and show what each makes of it</source>
        <translation>Einen Werkzeugweg auf mehreren Maschinen fahren, mit jeder Abhilfe, und zeigen, was jede daraus macht</translation>
    </message>
</context>
<context>
    <name>FiveAxis_ImportMachine</name>
    <message>
        <source>Import a machine…</source>
        <translation>Maschine übernehmen…</translation>
    </message>
    <message>
        <source>Make a machine file of a LinuxCNC configuration or of a FreeCAD machine file</source>
        <translation>Aus einer LinuxCNC-Konfiguration oder einer FreeCAD-Maschinendatei eine Maschinendatei machen</translation>
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
        <translation>Fünfachsige Zeilen über den gewählten Volumenkörper, seine gewählten Flächen, ein Netz oder das Modell eines CAM-Auftrags legen</translation>
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
        <source>Five-axis tool paths with a proven deviation for every block</source>
        <translation>Fünfachsige Werkzeugwege mit nachgewiesener Abweichung für jeden NC-Satz</translation>
    </message>
</context>
</TS>
