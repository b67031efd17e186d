<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>&amp;Open...</source>
        <translation>Ö&amp;ffnen...</translation>
    </message>
    <message>
        <source>Open a mesh or a session</source>
        <translation>Ein Mesh oder eine Sitzung öffnen</translation>
    </message>
    <message>
        <source>&amp;Bumpy cube</source>
        <translation>&amp;Beulenwürfel</translation>
    </message>
    <message>
        <source>Open a cube with smooth bumps</source>
        <translation>Einen Würfel mit runden Beulen öffnen</translation>
    </message>
    <message>
        <source>&amp;Character</source>
        <translation>&amp;Figur</translation>
    </message>
    <message>
        <source>Open a figure of quads</source>
        <translation>Eine Figur aus Quads öffnen</translation>
    </message>
    <message>
        <source>&amp;Torus with handles</source>
        <translation>&amp;Torus mit Henkeln</translation>
    </message>
    <message>
        <source>Open a torus with three handles</source>
        <translation>Einen Torus mit drei Henkeln öffnen</translation>
    </message>
    <message>
        <source>&amp;Machine</source>
        <translation>&amp;Maschine</translation>
    </message>
    <message>
        <source>Open a pump of many hard-surface parts</source>
        <translation>Eine Pumpe aus vielen Hard-Surface-Teilen öffnen</translation>
    </message>
    <message>
        <source>&amp;Clear list</source>
        <translation>&amp;Liste leeren</translation>
    </message>
    <message>
        <source>Forget the recent files</source>
        <translation>Die zuletzt benutzten Dateien vergessen</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Schließen</translation>
    </message>
    <message>
        <source>Close the session</source>
        <translation>Die Sitzung schließen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>S&amp;peichern</translation>
    </message>
    <message>
        <source>Save the session</source>
        <translation>Die Sitzung speichern</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>Speichern &amp;unter...</translation>
    </message>
    <message>
        <source>Save the session under another name</source>
        <translation>Die Sitzung unter einem anderen Namen speichern</translation>
    </message>
    <message>
        <source>Re-&amp;link model...</source>
        <translation>&amp;Modell neu verknüpfen...</translation>
    </message>
    <message>
        <source>Replace the model by a changed version of it and keep seams, pins and rectangles</source>
        <translation>Das Modell durch eine geänderte Fassung ersetzen; Nähte, Pins und Rechtecke bleiben</translation>
    </message>
    <message>
        <source>&amp;Export mesh...</source>
        <translation>Mesh &amp;exportieren...</translation>
    </message>
    <message>
        <source>Write the model with its UV map</source>
        <translation>Das Modell mit seiner UV-Map schreiben</translation>
    </message>
    <message>
        <source>Export la&amp;yout...</source>
        <translation>&amp;Layout exportieren...</translation>
    </message>
    <message>
        <source>Write a picture of the UV map</source>
        <translation>Ein Bild der UV-Map schreiben</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Bee&amp;nden</translation>
    </message>
    <message>
        <source>Quit Autocuts</source>
        <translation>Autocuts beenden</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Take back the last edit</source>
        <translation>Die letzte Änderung zurücknehmen</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Do again what was undone</source>
        <translation>Das Zurückgenommene wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Shortcuts...</source>
        <translation>&amp;Tastenkürzel...</translation>
    </message>
    <message>
        <source>Choose the keys of all actions</source>
        <translation>Die Tasten aller Aktionen wählen</translation>
    </message>
    <message>
        <source>&amp;Preferences...</source>
        <translation>&amp;Einstellungen...</translation>
    </message>
    <message>
        <source>Navigation, colours, defaults and autosave</source>
        <translation>Navigation, Farben, Vorgabewerte und automatische Sicherung</translation>
    </message>
    <message>
        <source>&amp;All</source>
        <translation>A&amp;lles</translation>
    </message>
    <message>
        <source>Select everything</source>
        <translation>Alles auswählen</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Nichts</translation>
    </message>
    <message>
        <source>Select nothing</source>
        <translation>Nichts auswählen</translation>
    </message>
    <message>
        <source>&amp;Invert</source>
        <translation>&amp;Umkehren</translation>
    </message>
    <message>
        <source>Select what is not selected</source>
        <translation>Auswählen, was nicht ausgewählt ist</translation>
    </message>
    <message>
        <source>&amp;Grow</source>
        <translation>&amp;Erweitern</translation>
    </message>
    <message>
        <source>Select the neighbours too</source>
        <translation>Auch die Nachbarn auswählen</translation>
    </message>
    <message>
        <source>S&amp;hrink</source>
        <translation>&amp;Verkleinern</translation>
    </message>
    <message>
        <source>Take away the rim of the selection</source>
        <translation>Den Rand der Auswahl wegnehmen</translation>
    </message>
    <message>
        <source>&amp;Linked</source>
        <translation>Verbun&amp;denes</translation>
    </message>
    <message>
        <source>Select the whole connected parts of the model</source>
        <translation>Die ganzen zusammenhängenden Teile des Modells auswählen</translation>
    </message>
    <message>
        <source>I&amp;sland</source>
        <translation>&amp;Insel</translation>
    </message>
    <message>
        <source>Select the whole UV islands</source>
        <translation>Die ganzen UV-Inseln auswählen</translation>
    </message>
    <message>
        <source>Edge l&amp;oop</source>
        <translation>&amp;Kantenschleife</translation>
    </message>
    <message>
        <source>Select the loops through the selected edges</source>
        <translation>Die Schleifen durch die ausgewählten Kanten auswählen</translation>
    </message>
    <message>
        <source>Si&amp;milar islands</source>
        <translation>Ä&amp;hnliche Inseln</translation>
    </message>
    <message>
        <source>Select the islands that are copies of the selected ones</source>
        <translation>Die Inseln auswählen, die Kopien der ausgewählten sind</translation>
    </message>
    <message>
        <source>O&amp;verlapping faces</source>
        <translation>Ü&amp;berlappende Flächen</translation>
    </message>
    <message>
        <source>Select the faces that overlap others in the map</source>
        <translation>Die Flächen auswählen, die in der Map andere überlappen</translation>
    </message>
    <message>
        <source>Ne&amp;xt overlap</source>
        <translation>Nä&amp;chste Überlappung</translation>
    </message>
    <message>
        <source>Select the next overlap in the map, and show it</source>
        <translation>Die nächste Überlappung in der Map auswählen und zeigen</translation>
    </message>
    <message>
        <source>&amp;Previous overlap</source>
        <translation>V&amp;orige Überlappung</translation>
    </message>
    <message>
        <source>Select the overlap before, and show it</source>
        <translation>Die Überlappung davor auswählen und zeigen</translation>
    </message>
    <message>
        <source>&amp;Flipped faces</source>
        <translation>U&amp;mgedrehte Flächen</translation>
    </message>
    <message>
        <source>Select the faces that are turned over in the map</source>
        <translation>Die Flächen auswählen, die in der Map umgedreht sind</translation>
    </message>
    <message>
        <source>Select ver&amp;tices</source>
        <translation>Ve&amp;rtices auswählen</translation>
    </message>
    <message>
        <source>Clicks select vertices</source>
        <translation>Klicks wählen Vertices aus</translation>
    </message>
    <message>
        <source>Select &amp;edges</source>
        <translation>Kanten au&amp;swählen</translation>
    </message>
    <message>
        <source>Clicks select edges</source>
        <translation>Klicks wählen Kanten aus</translation>
    </message>
    <message>
        <source>Select fa&amp;ces</source>
        <translation>Flächen &amp;auswählen</translation>
    </message>
    <message>
        <source>Clicks select faces</source>
        <translation>Klicks wählen Flächen aus</translation>
    </message>
    <message>
        <source>Select islan&amp;ds</source>
        <translation>Inseln aus&amp;wählen</translation>
    </message>
    <message>
        <source>Clicks select islands</source>
        <translation>Klicks wählen Inseln aus</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>S&amp;tarten</translation>
    </message>
    <message>
        <source>Let the solver run, or pause it and keep its map</source>
        <translation>Den Solver laufen lassen, oder ihn anhalten und seine Map behalten</translation>
    </message>
    <message>
        <source>Run on selection</source>
        <translation>Für die Auswahl starten</translation>
    </message>
    <message>
        <source>Let the solver change the selected faces only, until it pauses; the map stays continuous with the rest of their islands</source>
        <translation>Den Solver nur die ausgewählten Flächen ändern lassen, bis er anhält; die Map bleibt zum Rest ihrer Inseln hin zusammenhängend</translation>
    </message>
    <message>
        <source>&amp;One step</source>
        <translation>E&amp;in Schritt</translation>
    </message>
    <message>
        <source>Make one step of the solver</source>
        <translation>Einen Schritt des Solvers ausführen</translation>
    </message>
    <message>
        <source>R&amp;estart</source>
        <translation>N&amp;eustart</translation>
    </message>
    <message>
        <source>Begin the solve again from its start</source>
        <translation>Die Berechnung noch einmal von ihrem Start aus beginnen</translation>
    </message>
    <message>
        <source>&amp;Less weight on seams</source>
        <translation>&amp;Weniger Gewicht auf Nähte</translation>
    </message>
    <message>
        <source>Lower lambda: less distortion, longer seams</source>
        <translation>Lambda senken: weniger Verzerrung, längere Nähte</translation>
    </message>
    <message>
        <source>&amp;More weight on seams</source>
        <translation>&amp;Mehr Gewicht auf Nähte</translation>
    </message>
    <message>
        <source>Raise lambda: shorter seams, more distortion</source>
        <translation>Lambda erhöhen: kürzere Nähte, mehr Verzerrung</translation>
    </message>
    <message>
        <source>Softer seams (double delta)</source>
        <translation>Weichere Nähte (Delta verdoppeln)</translation>
    </message>
    <message>
        <source>Double delta: cuts become softer and may move</source>
        <translation>Delta verdoppeln: Schnitte werden weicher und können wandern</translation>
    </message>
    <message>
        <source>S&amp;harper seams (halve delta)</source>
        <translation>Schärfere Nähte (&amp;Delta halbieren)</translation>
    </message>
    <message>
        <source>Halve delta: cuts become definite</source>
        <translation>Delta halbieren: Schnitte werden endgültig</translation>
    </message>
    <message>
        <source>Distortion &amp;budget</source>
        <translation>Ver&amp;zerrungsbudget</translation>
    </message>
    <message>
        <source>Let the solver choose lambda and delta for a distortion bound</source>
        <translation>Den Solver Lambda und Delta für eine Verzerrungsgrenze wählen lassen</translation>
    </message>
    <message>
        <source>Show the soup while solving</source>
        <translation>Beim Rechnen die Dreieckssuppe zeigen</translation>
    </message>
    <message>
        <source>While the solver runs, show the separate triangles that lambda and delta act on instead of the definite map</source>
        <translation>Solange der Solver läuft, die einzelnen Dreiecke zeigen, auf die Lambda und Delta wirken, statt der fertigen Map</translation>
    </message>
    <message>
        <source>Ghost while solving</source>
        <translation>Beim Rechnen durchscheinen lassen</translation>
    </message>
    <message>
        <source>While the solver runs, let the soup shine through the definite map, or the map through the soup</source>
        <translation>Solange der Solver läuft, die Dreieckssuppe durch die fertige Map scheinen lassen, oder die Map durch die Suppe</translation>
    </message>
    <message>
        <source>&amp;Rigid triangles</source>
        <translation>&amp;Starre Dreiecke</translation>
    </message>
    <message>
        <source>Start from every triangle laid flat on its own</source>
        <translation>Damit beginnen, dass jedes Dreieck für sich flach liegt</translation>
    </message>
    <message>
        <source>&amp;Tutte embedding</source>
        <translation>&amp;Tutte-Einbettung</translation>
    </message>
    <message>
        <source>Start from a Tutte embedding</source>
        <translation>Mit einer Tutte-Einbettung beginnen</translation>
    </message>
    <message>
        <source>Ra&amp;ndom</source>
        <translation>&amp;Zufall</translation>
    </message>
    <message>
        <source>Start from triangles at random places</source>
        <translation>Mit Dreiecken an zufälligen Stellen beginnen</translation>
    </message>
    <message>
        <source>&amp;Existing UVs</source>
        <translation>&amp;Vorhandene UVs</translation>
    </message>
    <message>
        <source>Start from the UVs that there are</source>
        <translation>Mit den UVs beginnen, die da sind</translation>
    </message>
    <message>
        <source>&amp;Symmetric Dirichlet</source>
        <translation>&amp;Symmetrische Dirichlet-Energie</translation>
    </message>
    <message>
        <source>Keep lengths</source>
        <translation>Längen erhalten</translation>
    </message>
    <message>
        <source>&amp;AMIPS</source>
        <translation>&amp;AMIPS</translation>
    </message>
    <message>
        <source>Keep angles more than areas</source>
        <translation>Winkel mehr als Flächeninhalte erhalten</translation>
    </message>
    <message>
        <source>By &amp;length</source>
        <translation>&amp;Nach Länge</translation>
    </message>
    <message>
        <source>Make the total length of the seams small</source>
        <translation>Die Gesamtlänge der Nähte klein machen</translation>
    </message>
    <message>
        <source>By &amp;count</source>
        <translation>Nach &amp;Anzahl</translation>
    </message>
    <message>
        <source>Make the number of cut edges small</source>
        <translation>Die Zahl der geschnittenen Kanten klein machen</translation>
    </message>
    <message>
        <source>&amp;Unwrap</source>
        <translation>&amp;Abwickeln</translation>
    </message>
    <message>
        <source>Make the whole map: solve, finish, take overlaps apart and pack</source>
        <translation>Die ganze Map machen: berechnen, fertigstellen, Überlappungen trennen und packen</translation>
    </message>
    <message>
        <source>Unwrap selection</source>
        <translation>Auswahl abwickeln</translation>
    </message>
    <message>
        <source>Make the map of the selected faces anew; it stays continuous with the rest of their islands, and nothing else changes</source>
        <translation>Die Map der ausgewählten Flächen neu machen; sie bleibt zum Rest ihrer Inseln hin zusammenhängend, und sonst ändert sich nichts</translation>
    </message>
    <message>
        <source>Unwrap selection, cut free</source>
        <translation>Auswahl herausschneiden und abwickeln</translation>
    </message>
    <message>
        <source>Cut the selected faces out of their islands and make their map anew; nothing else changes</source>
        <translation>Die ausgewählten Flächen aus ihren Inseln schneiden und ihre Map neu machen; sonst ändert sich nichts</translation>
    </message>
    <message>
        <source>&amp;Finish</source>
        <translation>&amp;Fertigstellen</translation>
    </message>
    <message>
        <source>Make a final map with definite seams and no overlaps</source>
        <translation>Eine endgültige Map mit festen Nähten und ohne Überlappungen machen</translation>
    </message>
    <message>
        <source>Finish selection</source>
        <translation>Auswahl fertigstellen</translation>
    </message>
    <message>
        <source>Finish the map of the selected faces; nothing else changes</source>
        <translation>Die Map der ausgewählten Flächen fertigstellen; sonst ändert sich nichts</translation>
    </message>
    <message>
        <source>&amp;Pack</source>
        <translation>Pac&amp;ken</translation>
    </message>
    <message>
        <source>Arrange all islands in the texture</source>
        <translation>Alle Inseln in der Textur anordnen</translation>
    </message>
    <message>
        <source>Pack a tile for each &amp;object</source>
        <translation>&amp;Je Objekt eine Kachel packen</translation>
    </message>
    <message>
        <source>Give every object a UDIM tile of its own, in the order of the file; islands that are selected, or all of them</source>
        <translation>Jedem Objekt eine eigene UDIM-Kachel geben, in der Reihenfolge der Datei; für die ausgewählten Inseln oder für alle</translation>
    </message>
    <message>
        <source>Pack a tile for each &amp;material</source>
        <translation>Je &amp;Material eine Kachel packen</translation>
    </message>
    <message>
        <source>Give every material a UDIM tile of its own, in the order of the file; islands that are selected, or all of them</source>
        <translation>Jedem Material eine eigene UDIM-Kachel geben, in der Reihenfolge der Datei; für die ausgewählten Inseln oder für alle</translation>
    </message>
    <message>
        <source>Pack &amp;selection</source>
        <translation>A&amp;uswahl packen</translation>
    </message>
    <message>
        <source>Arrange the selected islands around the others</source>
        <translation>Die ausgewählten Inseln um die anderen herum anordnen</translation>
    </message>
    <message>
        <source>Separate o&amp;verlaps</source>
        <translation>Ü&amp;berlappungen trennen</translation>
    </message>
    <message>
        <source>Cut islands that cover themselves, and pack</source>
        <translation>Inseln zerschneiden, die sich selbst überdecken, und packen</translation>
    </message>
    <message>
        <source>Separate overlaps greedily</source>
        <translation>Überlappungen schnell trennen</translation>
    </message>
    <message>
        <source>Cut islands that cover themselves into regions that grow breadth first, and pack: more cuts, found at once</source>
        <translation>Inseln, die sich selbst überdecken, in Bereiche zerschneiden, die in die Breite wachsen, und packen: mehr Schnitte, sofort gefunden</translation>
    </message>
    <message>
        <source>E&amp;qualise texel density</source>
        <translation>Te&amp;xeldichte angleichen</translation>
    </message>
    <message>
        <source>Give every island the same texel density</source>
        <translation>Allen Inseln dieselbe Texeldichte geben</translation>
    </message>
    <message>
        <source>&amp;Cut</source>
        <translation>S&amp;chneiden</translation>
    </message>
    <message>
        <source>Cut along the selected edges, or around the selected faces</source>
        <translation>Entlang der ausgewählten Kanten schneiden, oder um die ausgewählten Flächen herum</translation>
    </message>
    <message>
        <source>&amp;Join</source>
        <translation>&amp;Verbinden</translation>
    </message>
    <message>
        <source>Keep together along the selected edges, or inside the selected faces</source>
        <translation>Entlang der ausgewählten Kanten zusammenhalten, oder innerhalb der ausgewählten Flächen</translation>
    </message>
    <message>
        <source>Cle&amp;ar cuts and joins</source>
        <translation>&amp;Schnitte und Verbindungen löschen</translation>
    </message>
    <message>
        <source>Leave the selected edges to the solver</source>
        <translation>Die ausgewählten Kanten dem Solver überlassen</translation>
    </message>
    <message>
        <source>Rip</source>
        <translation>Auftrennen</translation>
    </message>
    <message>
        <source>Cut the map apart along the selected edges, or around the selected faces, at once and without a solve</source>
        <translation>Die Map entlang der ausgewählten Kanten oder um die ausgewählten Flächen herum auftrennen, sofort und ohne Berechnung</translation>
    </message>
    <message>
        <source>Stitch</source>
        <translation>Vernähen</translation>
    </message>
    <message>
        <source>Bring the two sides of the selected seams together at once: the smaller island comes to the larger one</source>
        <translation>Die zwei Seiten der ausgewählten Nähte sofort zusammenbringen: die kleinere Insel kommt zur größeren</translation>
    </message>
    <message>
        <source>&amp;Keep straight</source>
        <translation>&amp;Gerade halten</translation>
    </message>
    <message>
        <source>Unwrap, Finish and the live solve lay the selected edges on lines of the map</source>
        <translation>Abwickeln, Fertigstellen und die Live-Berechnung legen die ausgewählten Kanten auf Linien der Map</translation>
    </message>
    <message>
        <source>Release straight edges</source>
        <translation>Gerade Kanten freigeben</translation>
    </message>
    <message>
        <source>The selected edges need not be straight in the map</source>
        <translation>Die ausgewählten Kanten brauchen in der Map nicht gerade zu sein</translation>
    </message>
    <message>
        <source>P&amp;in</source>
        <translation>Pi&amp;nnen</translation>
    </message>
    <message>
        <source>Hold the selection where it is in the map</source>
        <translation>Die Auswahl festhalten, wo sie in der Map ist</translation>
    </message>
    <message>
        <source>Unpi&amp;n</source>
        <translation>&amp;Pins lösen</translation>
    </message>
    <message>
        <source>Remove the pins of the selection</source>
        <translation>Die Pins der Auswahl entfernen</translation>
    </message>
    <message>
        <source>&amp;Weight of the faces...</source>
        <translation>&amp;Gewicht der Flächen...</translation>
    </message>
    <message>
        <source>Say how many times the texels per length the selected faces are to have</source>
        <translation>Angeben, wie viel mal so viele Texel je Länge die ausgewählten Flächen bekommen sollen</translation>
    </message>
    <message>
        <source>&amp;Clear the weight</source>
        <translation>Gewicht &amp;löschen</translation>
    </message>
    <message>
        <source>Give the selected faces the usual texel density again</source>
        <translation>Den ausgewählten Flächen wieder die übliche Texeldichte geben</translation>
    </message>
    <message>
        <source>Clear &amp;all weights</source>
        <translation>&amp;Alle Gewichte löschen</translation>
    </message>
    <message>
        <source>Give all faces the usual texel density again</source>
        <translation>Allen Flächen wieder die übliche Texeldichte geben</translation>
    </message>
    <message>
        <source>&amp;Lock</source>
        <translation>&amp;Sperren</translation>
    </message>
    <message>
        <source>Keep the selected islands where they are</source>
        <translation>Die ausgewählten Inseln lassen, wo sie sind</translation>
    </message>
    <message>
        <source>&amp;Unlock</source>
        <translation>&amp;Entsperren</translation>
    </message>
    <message>
        <source>Let the selected islands move again</source>
        <translation>Die ausgewählten Inseln sich wieder bewegen lassen</translation>
    </message>
    <message>
        <source>Keep &amp;orientation</source>
        <translation>&amp;Ausrichtung behalten</translation>
    </message>
    <message>
        <source>Packing does not turn the selected islands</source>
        <translation>Das Packen dreht die ausgewählten Inseln nicht</translation>
    </message>
    <message>
        <source>&amp;Free orientation</source>
        <translation>Ausrichtung &amp;freigeben</translation>
    </message>
    <message>
        <source>Packing may turn the selected islands again</source>
        <translation>Das Packen darf die ausgewählten Inseln wieder drehen</translation>
    </message>
    <message>
        <source>U&amp;nstack</source>
        <translation>Sta&amp;pel auflösen</translation>
    </message>
    <message>
        <source>Pack the selected islands one by one</source>
        <translation>Die ausgewählten Inseln einzeln packen</translation>
    </message>
    <message>
        <source>&amp;Group</source>
        <translation>&amp;Gruppieren</translation>
    </message>
    <message>
        <source>Keep the arrangement of the selected islands</source>
        <translation>Die Anordnung der ausgewählten Inseln behalten</translation>
    </message>
    <message>
        <source>Ungrou&amp;p</source>
        <translation>G&amp;ruppe auflösen</translation>
    </message>
    <message>
        <source>Let the selected islands move on their own</source>
        <translation>Die ausgewählten Inseln sich einzeln bewegen lassen</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>&amp;Auswählen</translation>
    </message>
    <message>
        <source>Select with the mouse</source>
        <translation>Mit der Maus auswählen</translation>
    </message>
    <message>
        <source>&amp;Lasso</source>
        <translation>&amp;Lasso</translation>
    </message>
    <message>
        <source>Select what a line drawn with the mouse encloses</source>
        <translation>Auswählen, was eine mit der Maus gezogene Linie umschließt</translation>
    </message>
    <message>
        <source>Select &amp;by brush</source>
        <translation>&amp;Mit Pinsel auswählen</translation>
    </message>
    <message>
        <source>Select what a brush passes over</source>
        <translation>Auswählen, worüber ein Pinsel fährt</translation>
    </message>
    <message>
        <source>C&amp;ut edges</source>
        <translation>&amp;Kanten schneiden</translation>
    </message>
    <message>
        <source>Cut edges, ways and loops with the mouse</source>
        <translation>Kanten, Wege und Schleifen mit der Maus schneiden</translation>
    </message>
    <message>
        <source>&amp;Join edges</source>
        <translation>Kanten &amp;verbinden</translation>
    </message>
    <message>
        <source>Keep edges, ways and loops together with the mouse</source>
        <translation>Kanten, Wege und Schleifen mit der Maus zusammenhalten</translation>
    </message>
    <message>
        <source>Paint &amp;weights</source>
        <translation>&amp;Gewichte malen</translation>
    </message>
    <message>
        <source>Paint where seams are welcome and where not</source>
        <translation>Malen, wo Nähte willkommen sind und wo nicht</translation>
    </message>
    <message>
        <source>Paint &amp;texel density</source>
        <translation>&amp;Texeldichte malen</translation>
    </message>
    <message>
        <source>Paint which faces are to have more texels, and which fewer</source>
        <translation>Malen, welche Flächen mehr Texel bekommen sollen und welche weniger</translation>
    </message>
    <message>
        <source>&amp;Overlap region</source>
        <translation>Ü&amp;berlappungsbereich</translation>
    </message>
    <message>
        <source>Select a part without overlaps and drag it away</source>
        <translation>Einen Teil ohne Überlappungen auswählen und wegziehen</translation>
    </message>
    <message>
        <source>&amp;Move islands</source>
        <translation>&amp;Inseln verschieben</translation>
    </message>
    <message>
        <source>Move the selected islands in the map</source>
        <translation>Die ausgewählten Inseln in der Map verschieben</translation>
    </message>
    <message>
        <source>&amp;Rotate islands</source>
        <translation>Inseln &amp;drehen</translation>
    </message>
    <message>
        <source>Rotate the selected islands in the map</source>
        <translation>Die ausgewählten Inseln in der Map drehen</translation>
    </message>
    <message>
        <source>S&amp;cale islands</source>
        <translation>Inseln &amp;skalieren</translation>
    </message>
    <message>
        <source>Scale the selected islands in the map</source>
        <translation>Die ausgewählten Inseln in der Map skalieren</translation>
    </message>
    <message>
        <source>&amp;Drag</source>
        <translation>&amp;Ziehen</translation>
    </message>
    <message>
        <source>Pull at the map: deform it, tear it, attach it</source>
        <translation>An der Map ziehen: sie verformen, aufreißen, anfügen</translation>
    </message>
    <message>
        <source>Rela&amp;x brush</source>
        <translation>&amp;Entspannen-Pinsel</translation>
    </message>
    <message>
        <source>Lower the distortion of the map under a brush</source>
        <translation>Die Verzerrung der Map unter einem Pinsel verringern</translation>
    </message>
    <message>
        <source>Pinc&amp;h brush</source>
        <translation>Zusammenziehen-&amp;Pinsel</translation>
    </message>
    <message>
        <source>Draw the map together, or apart, under a brush</source>
        <translation>Die Map unter einem Pinsel zusammenziehen oder auseinanderschieben</translation>
    </message>
    <message>
        <source>&amp;Grab brush</source>
        <translation>G&amp;reifen-Pinsel</translation>
    </message>
    <message>
        <source>Move the part of an island under a brush; nothing overlaps</source>
        <translation>Den Teil einer Insel unter einem Pinsel verschieben; nichts überlappt</translation>
    </message>
    <message>
        <source>&amp;Pin</source>
        <translation>Pi&amp;n</translation>
    </message>
    <message>
        <source>Pin and unpin by clicks and boxes, drag pins</source>
        <translation>Durch Klicks und Rahmen Pins setzen und lösen, Pins ziehen</translation>
    </message>
    <message>
        <source>R&amp;ectangles</source>
        <translation>Re&amp;chtecke</translation>
    </message>
    <message>
        <source>Draw rectangles in the map and assign islands to them</source>
        <translation>Rechtecke in die Map zeichnen und ihnen Inseln zuweisen</translation>
    </message>
    <message>
        <source>Pack i&amp;nto a box</source>
        <translation>In einen Ra&amp;hmen packen</translation>
    </message>
    <message>
        <source>Drag a box in the map and pack the selected islands into it</source>
        <translation>Einen Rahmen in der Map aufziehen und die ausgewählten Inseln hineinpacken</translation>
    </message>
    <message>
        <source>&amp;New UV set</source>
        <translation>&amp;Neuer UV-Satz</translation>
    </message>
    <message>
        <source>Add a UV set without UVs and choose it</source>
        <translation>Einen UV-Satz ohne UVs hinzufügen und wählen</translation>
    </message>
    <message>
        <source>&amp;Copy UV set</source>
        <translation>&amp;UV-Satz kopieren</translation>
    </message>
    <message>
        <source>Add a copy of the chosen UV set and choose it</source>
        <translation>Eine Kopie des gewählten UV-Satzes hinzufügen und wählen</translation>
    </message>
    <message>
        <source>New set for &amp;lightmaps</source>
        <translation>Neuer &amp;Satz für Lightmaps</translation>
    </message>
    <message>
        <source>Add a UV set in which every face has a place of its own: stacks are taken apart, overlaps are cut, the margin is that of the Packing panel</source>
        <translation>Einen UV-Satz hinzufügen, in dem jede Fläche ihren eigenen Platz hat: Stapel werden aufgelöst, Überlappungen zerschnitten, der Abstand ist der aus dem Bedienfeld Packen</translation>
    </message>
    <message>
        <source>&amp;Delete UV set</source>
        <translation>UV-Satz &amp;löschen</translation>
    </message>
    <message>
        <source>Delete the chosen UV set; the last one stays</source>
        <translation>Den gewählten UV-Satz löschen; der letzte bleibt</translation>
    </message>
    <message>
        <source>Choose the n&amp;ext UV set</source>
        <translation>Nächsten UV-Satz &amp;wählen</translation>
    </message>
    <message>
        <source>Work on the next UV set, after the last one on the first</source>
        <translation>Am nächsten UV-Satz arbeiten, nach dem letzten am ersten</translation>
    </message>
    <message>
        <source>Cancel job</source>
        <translation>Auftrag abbrechen</translation>
    </message>
    <message>
        <source>End the running job and keep what it has</source>
        <translation>Den laufenden Auftrag beenden und behalten, was er hat</translation>
    </message>
    <message>
        <source>Frame &amp;all</source>
        <translation>&amp;Alles einpassen</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>Frame &amp;selected</source>
        <translation>Auswahl &amp;einpassen</translation>
    </message>
    <message>
        <source>Show the selection large</source>
        <translation>Die Auswahl groß zeigen</translation>
    </message>
    <message>
        <source>Hi&amp;de selected</source>
        <translation>Aus&amp;wahl ausblenden</translation>
    </message>
    <message>
        <source>Hide the selected faces in both views; jobs still work on them</source>
        <translation>Die ausgewählten Flächen in beiden Ansichten ausblenden; Aufträge bearbeiten sie weiterhin</translation>
    </message>
    <message>
        <source>Hide others</source>
        <translation>Andere ausblenden</translation>
    </message>
    <message>
        <source>Show the selected faces alone</source>
        <translation>Nur die ausgewählten Flächen zeigen</translation>
    </message>
    <message>
        <source>Show all hidden</source>
        <translation>Ausgeblendetes zeigen</translation>
    </message>
    <message>
        <source>Show all hidden faces again and select them</source>
        <translation>Alle ausgeblendeten Flächen wieder zeigen und auswählen</translation>
    </message>
    <message>
        <source>&amp;3D view only</source>
        <translation>Nur 3D-An&amp;sicht</translation>
    </message>
    <message>
        <source>Give the 3D view all room</source>
        <translation>Der 3D-Ansicht den ganzen Platz geben</translation>
    </message>
    <message>
        <source>&amp;UV view only</source>
        <translation>Nur UV-Ansi&amp;cht</translation>
    </message>
    <message>
        <source>Give the UV view all room</source>
        <translation>Der UV-Ansicht den ganzen Platz geben</translation>
    </message>
    <message>
        <source>&amp;Both views</source>
        <translation>&amp;Beide Ansichten</translation>
    </message>
    <message>
        <source>Show both views side by side</source>
        <translation>Beide Ansichten nebeneinander zeigen</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>Fill the screen</source>
        <translation>Den Bildschirm füllen</translation>
    </message>
    <message>
        <source>&amp;Plain</source>
        <translation>&amp;Einfarbig</translation>
    </message>
    <message>
        <source>Faces in one colour</source>
        <translation>Flächen in einer Farbe</translation>
    </message>
    <message>
        <source>&amp;Islands</source>
        <translation>&amp;Inseln</translation>
    </message>
    <message>
        <source>Every island in a colour of its own</source>
        <translation>Jede Insel in ihrer eigenen Farbe</translation>
    </message>
    <message>
        <source>&amp;Signed stretch</source>
        <translation>&amp;Dehnung mit Vorzeichen</translation>
    </message>
    <message>
        <source>Where the map is too small or too large</source>
        <translation>Wo die Map zu klein oder zu groß ist</translation>
    </message>
    <message>
        <source>Stretch &amp;magnitude</source>
        <translation>&amp;Betrag der Dehnung</translation>
    </message>
    <message>
        <source>How much the map is distorted</source>
        <translation>Wie stark die Map verzerrt ist</translation>
    </message>
    <message>
        <source>Where seams are welcome and where not</source>
        <translation>Wo Nähte willkommen sind und wo nicht</translation>
    </message>
    <message>
        <source>Texel &amp;density</source>
        <translation>&amp;Texeldichte</translation>
    </message>
    <message>
        <source>Where the map has fewer or more texels per unit than it should</source>
        <translation>Wo die Map weniger oder mehr Texel je Einheit hat, als sie sollte</translation>
    </message>
    <message>
        <source>Painted te&amp;xel density</source>
        <translation>Ge&amp;malte Texeldichte</translation>
    </message>
    <message>
        <source>Which faces are to have more texels than others</source>
        <translation>Welche Flächen mehr Texel bekommen sollen als andere</translation>
    </message>
    <message>
        <source>Next &amp;heat-map</source>
        <translation>Nächste &amp;Heatmap</translation>
    </message>
    <message>
        <source>Change between plain faces and the heat-maps</source>
        <translation>Zwischen einfarbigen Flächen und den Heatmaps wechseln</translation>
    </message>
    <message>
        <source>Nothing on the model</source>
        <translation>Nichts auf dem Modell</translation>
    </message>
    <message>
        <source>&amp;Checkerboard</source>
        <translation>&amp;Schachbrett</translation>
    </message>
    <message>
        <source>A checkerboard on the model and behind the map</source>
        <translation>Ein Schachbrett auf dem Modell und hinter der Map</translation>
    </message>
    <message>
        <source>&amp;Lettered cells</source>
        <translation>&amp;Beschriftete Felder</translation>
    </message>
    <message>
        <source>Cells with names, arrows and hues of their own, which show what is mirrored, turned or stacked</source>
        <translation>Felder mit Namen, Pfeilen und eigenen Farbtönen, die zeigen, was gespiegelt, gedreht oder gestapelt ist</translation>
    </message>
    <message>
        <source>&amp;Texture</source>
        <translation>&amp;Textur</translation>
    </message>
    <message>
        <source>The texture on the model and behind the map</source>
        <translation>Die Textur auf dem Modell und hinter der Map</translation>
    </message>
    <message>
        <source>Next pa&amp;ttern</source>
        <translation>Nächstes &amp;Muster</translation>
    </message>
    <message>
        <source>&amp;Load texture...</source>
        <translation>Te&amp;xtur laden...</translation>
    </message>
    <message>
        <source>Choose the picture to show on the model</source>
        <translation>Das Bild wählen, das auf dem Modell gezeigt wird</translation>
    </message>
    <message>
        <source>Texture preview...</source>
        <translation>Texturvorschau...</translation>
    </message>
    <message>
        <source>Show the model with a texture of a chosen size</source>
        <translation>Das Modell mit einer Textur von gewählter Größe zeigen</translation>
    </message>
    <message>
        <source>S&amp;mooth shading</source>
        <translation>&amp;Glatte Schattierung</translation>
    </message>
    <message>
        <source>Shade the model smoothly, or every face flat</source>
        <translation>Das Modell glatt schattieren, oder jede Fläche flach</translation>
    </message>
    <message>
        <source>&amp;Wireframe</source>
        <translation>&amp;Drahtgitter</translation>
    </message>
    <message>
        <source>Show the edges of the polygons</source>
        <translation>Die Kanten der Polygone zeigen</translation>
    </message>
    <message>
        <source>&amp;X-ray</source>
        <translation>Röntgenb&amp;lick</translation>
    </message>
    <message>
        <source>See and select through the model: clicks, boxes and lassos in the 3D view reach what lies behind, and a second click goes deeper</source>
        <translation>Durch das Modell sehen und auswählen: Klicks, Rahmen und Lassos in der 3D-Ansicht erreichen, was dahinter liegt, und ein zweiter Klick geht tiefer</translation>
    </message>
    <message>
        <source>S&amp;eams</source>
        <translation>&amp;Nähte</translation>
    </message>
    <message>
        <source>Show the seams, or while solving where they begin to open</source>
        <translation>Die Nähte zeigen, oder beim Rechnen, wo sie sich zu öffnen beginnen</translation>
    </message>
    <message>
        <source>Stee&amp;ring</source>
        <translation>V&amp;orgaben</translation>
    </message>
    <message>
        <source>Show forced cuts and joins, pins and rectangles</source>
        <translation>Erzwungene Schnitte und Verbindungen, Pins und Rechtecke zeigen</translation>
    </message>
    <message>
        <source>Fli&amp;ps and overlaps</source>
        <translation>Umgedrehtes und Überla&amp;ppungen</translation>
    </message>
    <message>
        <source>Mark flipped faces and hatch overlaps</source>
        <translation>Umgedrehte Flächen markieren und Überlappungen schraffieren</translation>
    </message>
    <message>
        <source>F&amp;ill islands</source>
        <translation>&amp;Inseln füllen</translation>
    </message>
    <message>
        <source>Fill the islands in the UV view</source>
        <translation>Die Inseln in der UV-Ansicht füllen</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>&amp;Raster</translation>
    </message>
    <message>
        <source>Show the grid and the texture tiles</source>
        <translation>Das Raster und die Texturkacheln zeigen</translation>
    </message>
    <message>
        <source>Rulers</source>
        <translation>Lineale</translation>
    </message>
    <message>
        <source>Show rulers in texels in the UV view</source>
        <translation>Lineale in Texeln in der UV-Ansicht zeigen</translation>
    </message>
    <message>
        <source>Follow the live map</source>
        <translation>Der Live-Map folgen</translation>
    </message>
    <message>
        <source>Show the whole live map in the UV view as it changes</source>
        <translation>Die ganze Live-Map in der UV-Ansicht zeigen, während sie sich ändert</translation>
    </message>
    <message>
        <source>Island marks</source>
        <translation>Inselmarken</translation>
    </message>
    <message>
        <source>Show locks, groups and stacks in the UV view</source>
        <translation>Sperren, Gruppen und Stapel in der UV-Ansicht zeigen</translation>
    </message>
    <message>
        <source>Island numbers</source>
        <translation>Inselnummern</translation>
    </message>
    <message>
        <source>Show the numbers of the islands in the UV view</source>
        <translation>Die Nummern der Inseln in der UV-Ansicht zeigen</translation>
    </message>
    <message>
        <source>Pack live</source>
        <translation>Live packen</translation>
    </message>
    <message>
        <source>While the solver runs, show its islands beside each other; the map itself stays as it is</source>
        <translation>Solange der Solver läuft, seine Inseln nebeneinander zeigen; die Map selbst bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>&amp;Orthographic</source>
        <translation>Or&amp;thografisch</translation>
    </message>
    <message>
        <source>Show the model without perspective</source>
        <translation>Das Modell ohne Perspektive zeigen</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>&amp;Vorn</translation>
    </message>
    <message>
        <source>Look at the model from the front</source>
        <translation>Das Modell von vorn ansehen</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Hinten</translation>
    </message>
    <message>
        <source>Look at the model from the back</source>
        <translation>Das Modell von hinten ansehen</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Rechts</translation>
    </message>
    <message>
        <source>Look at the model from the right</source>
        <translation>Das Modell von rechts ansehen</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Links</translation>
    </message>
    <message>
        <source>Look at the model from the left</source>
        <translation>Das Modell von links ansehen</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Oben</translation>
    </message>
    <message>
        <source>Look at the model from above</source>
        <translation>Das Modell von oben ansehen</translation>
    </message>
    <message>
        <source>Botto&amp;m</source>
        <translation>&amp;Unten</translation>
    </message>
    <message>
        <source>Look at the model from below</source>
        <translation>Das Modell von unten ansehen</translation>
    </message>
    <message>
        <source>&amp;Restore the arrangement</source>
        <translation>&amp;Anordnung wiederherstellen</translation>
    </message>
    <message>
        <source>Put all panels where they were at first</source>
        <translation>Alle Bedienfelder dahin setzen, wo sie am Anfang waren</translation>
    </message>
    <message>
        <source>&amp;Find action...</source>
        <translation>&amp;Aktion suchen...</translation>
    </message>
    <message>
        <source>Search all actions by name and run one</source>
        <translation>Alle Aktionen nach dem Namen durchsuchen und eine ausführen</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>&amp;Tastenkürzel</translation>
    </message>
    <message>
        <source>List all keys</source>
        <translation>Alle Tasten auflisten</translation>
    </message>
    <message>
        <source>&amp;Recovery folder</source>
        <translation>&amp;Wiederherstellungsordner</translation>
    </message>
    <message>
        <source>Show the folder in which autosaves are kept</source>
        <translation>Den Ordner zeigen, in dem die automatischen Sicherungen liegen</translation>
    </message>
    <message>
        <source>&amp;About Autocuts</source>
        <translation>Ü&amp;ber Autocuts</translation>
    </message>
    <message>
        <source>Version, licence and libraries</source>
        <translation>Version, Lizenz und Bibliotheken</translation>
    </message>
    <message>
        <source>Of the same &amp;area</source>
        <translation>&amp;Von gleichem Flächeninhalt</translation>
    </message>
    <message>
        <source>Select the faces with an area like that of a selected one, within a tenth</source>
        <translation>Die Flächen auswählen, deren Inhalt bis auf ein Zehntel dem einer ausgewählten gleicht</translation>
    </message>
    <message>
        <source>Of the same &amp;direction</source>
        <translation>Von &amp;gleicher Richtung</translation>
    </message>
    <message>
        <source>Select the faces that look the same way as a selected one, within 10 degrees</source>
        <translation>Die Flächen auswählen, die bis auf 10 Grad in dieselbe Richtung blicken wie eine ausgewählte</translation>
    </message>
    <message>
        <source>Of the same &amp;material</source>
        <translation>Von gleichem &amp;Material</translation>
    </message>
    <message>
        <source>Select the faces that have the material of a selected one</source>
        <translation>Die Flächen auswählen, die das Material einer ausgewählten haben</translation>
    </message>
    <message>
        <source>With as many &amp;corners</source>
        <translation>Mit gleich vielen &amp;Ecken</translation>
    </message>
    <message>
        <source>Select the faces with as many corners as a selected one: all triangles, or all quads</source>
        <translation>Die Flächen mit so vielen Ecken wie eine ausgewählte auswählen: alle Dreiecke, oder alle Quads</translation>
    </message>
    <message>
        <source>&amp;Sharp edges...</source>
        <translation>&amp;Scharfe Kanten...</translation>
    </message>
    <message>
        <source>Select the edges at which the model is bent by more than an angle</source>
        <translation>Die Kanten auswählen, an denen das Modell um mehr als einen Winkel geknickt ist</translation>
    </message>
    <message>
        <source>&amp;Border of the model</source>
        <translation>&amp;Rand des Modells</translation>
    </message>
    <message>
        <source>Select the edges that have one face only: the rims of holes</source>
        <translation>Die Kanten auswählen, die nur eine Fläche haben: die Ränder von Löchern</translation>
    </message>
    <message>
        <source>S&amp;eams of the map</source>
        <translation>&amp;Nähte der Map</translation>
    </message>
    <message>
        <source>Select the edges at which the map is cut apart</source>
        <translation>Die Kanten auswählen, an denen die Map aufgeschnitten ist</translation>
    </message>
    <message>
        <source>&amp;Outline of the selection</source>
        <translation>&amp;Umriss der Auswahl</translation>
    </message>
    <message>
        <source>Select the edges around the selected faces</source>
        <translation>Die Kanten um die ausgewählten Flächen herum auswählen</translation>
    </message>
    <message>
        <source>&amp;Stretched above the bound</source>
        <translation>Über &amp;die Grenze gedehnte</translation>
    </message>
    <message>
        <source>Select the islands that are distorted more than the stretch that the session allows</source>
        <translation>Die Inseln auswählen, die stärker verzerrt sind, als die Sitzung an Dehnung erlaubt</translation>
    </message>
    <message>
        <source>S&amp;mall ones...</source>
        <translation>&amp;Kleine...</translation>
    </message>
    <message>
        <source>Select the islands that are less than some texels long</source>
        <translation>Die Inseln auswählen, die weniger als einige Texel lang sind</translation>
    </message>
    <message>
        <source>Texel density &amp;outliers...</source>
        <translation>&amp;Ausreißer der Texeldichte...</translation>
    </message>
    <message>
        <source>Select the islands with more or fewer texels per unit than most</source>
        <translation>Die Inseln mit mehr oder weniger Texeln je Einheit als die meisten auswählen</translation>
    </message>
    <message>
        <source>&amp;Left sides</source>
        <translation>&amp;Linke Seiten</translation>
    </message>
    <message>
        <source>Align the left sides of the selected islands; one island alone goes to the side of its tile</source>
        <translation>Die linken Seiten der ausgewählten Inseln ausrichten; eine einzelne Insel kommt an die Seite ihrer Kachel</translation>
    </message>
    <message>
        <source>&amp;Centres on a vertical line</source>
        <translation>&amp;Mitten auf eine senkrechte Linie</translation>
    </message>
    <message>
        <source>Bring the centres of the selected islands onto one vertical line</source>
        <translation>Die Mitten der ausgewählten Inseln auf eine senkrechte Linie bringen</translation>
    </message>
    <message>
        <source>&amp;Right sides</source>
        <translation>&amp;Rechte Seiten</translation>
    </message>
    <message>
        <source>Align the right sides of the selected islands</source>
        <translation>Die rechten Seiten der ausgewählten Inseln ausrichten</translation>
    </message>
    <message>
        <source>&amp;Top sides</source>
        <translation>&amp;Obere Seiten</translation>
    </message>
    <message>
        <source>Align the top sides of the selected islands</source>
        <translation>Die oberen Seiten der ausgewählten Inseln ausrichten</translation>
    </message>
    <message>
        <source>Centres on a &amp;horizontal line</source>
        <translation>Mitten &amp;auf eine waagerechte Linie</translation>
    </message>
    <message>
        <source>Bring the centres of the selected islands onto one horizontal line</source>
        <translation>Die Mitten der ausgewählten Inseln auf eine waagerechte Linie bringen</translation>
    </message>
    <message>
        <source>&amp;Bottom sides</source>
        <translation>&amp;Untere Seiten</translation>
    </message>
    <message>
        <source>Align the bottom sides of the selected islands</source>
        <translation>Die unteren Seiten der ausgewählten Inseln ausrichten</translation>
    </message>
    <message>
        <source>&amp;Centres from left to right</source>
        <translation>&amp;Mitten von links nach rechts</translation>
    </message>
    <message>
        <source>Put the centres of the selected islands at equal distances from left to right</source>
        <translation>Die Mitten der ausgewählten Inseln von links nach rechts in gleiche Abstände bringen</translation>
    </message>
    <message>
        <source>Centres from top to &amp;bottom</source>
        <translation>Mitten &amp;von oben nach unten</translation>
    </message>
    <message>
        <source>Put the centres of the selected islands at equal distances from top to bottom</source>
        <translation>Die Mitten der ausgewählten Inseln von oben nach unten in gleiche Abstände bringen</translation>
    </message>
    <message>
        <source>&amp;Gaps from left to right</source>
        <translation>&amp;Lücken von links nach rechts</translation>
    </message>
    <message>
        <source>Make the gaps between the selected islands equal from left to right</source>
        <translation>Die Lücken zwischen den ausgewählten Inseln von links nach rechts gleich machen</translation>
    </message>
    <message>
        <source>Gaps from to&amp;p to bottom</source>
        <translation>Lücken von &amp;oben nach unten</translation>
    </message>
    <message>
        <source>Make the gaps between the selected islands equal from top to bottom</source>
        <translation>Die Lücken zwischen den ausgewählten Inseln von oben nach unten gleich machen</translation>
    </message>
    <message>
        <source>Mirror from &amp;left to right</source>
        <translation>&amp;Von links nach rechts spiegeln</translation>
    </message>
    <message>
        <source>Turn the selected islands over in place: their picture is mirrored, which is reported as mirrored and not as flipped</source>
        <translation>Die ausgewählten Inseln an Ort und Stelle wenden: ihr Bild ist gespiegelt, was als gespiegelt und nicht als umgedreht gemeldet wird</translation>
    </message>
    <message>
        <source>Mirror from &amp;top to bottom</source>
        <translation>Von &amp;oben nach unten spiegeln</translation>
    </message>
    <message>
        <source>Turn a quarter le&amp;ft</source>
        <translation>Vierteldrehung &amp;nach links</translation>
    </message>
    <message>
        <source>Turn the selected islands by 90 degrees about the pivot</source>
        <translation>Die ausgewählten Inseln um 90 Grad um den Drehpunkt drehen</translation>
    </message>
    <message>
        <source>Turn a &amp;quarter right</source>
        <translation>Vierteldrehung nach &amp;rechts</translation>
    </message>
    <message>
        <source>Fit to t&amp;he tile</source>
        <translation>&amp;In die Kachel einpassen</translation>
    </message>
    <message>
        <source>Move and scale the selected islands together so that they fill their tile</source>
        <translation>Die ausgewählten Inseln zusammen so verschieben und skalieren, dass sie ihre Kachel füllen</translation>
    </message>
    <message>
        <source>Squeeze to the texture&apos;s shape</source>
        <translation>An die Form der Textur stauchen</translation>
    </message>
    <message>
        <source>Scale V of the selected islands by height / width of the texture: for maps that were made for a texture of this shape, before it was set in the Packing panel</source>
        <translation>V der ausgewählten Inseln mit Höhe / Breite der Textur skalieren: für Maps, die für eine Textur dieser Form gemacht wurden, bevor sie im Bedienfeld Packen eingestellt war</translation>
    </message>
    <message>
        <source>&amp;Orient to the smallest box</source>
        <translation>Nach &amp;dem kleinsten Kasten ausrichten</translation>
    </message>
    <message>
        <source>Turn each selected island so that the smallest box around it lies along the axes</source>
        <translation>Jede ausgewählte Insel so drehen, dass der kleinste Kasten um sie entlang der Achsen liegt</translation>
    </message>
    <message>
        <source>Orient to selected &amp;edges</source>
        <translation>Nach &amp;ausgewählten Kanten ausrichten</translation>
    </message>
    <message>
        <source>Turn the islands so that the selected edges lie along the axes</source>
        <translation>Die Inseln so drehen, dass die ausgewählten Kanten entlang der Achsen liegen</translation>
    </message>
    <message>
        <source>Align to the axes</source>
        <translation>An den Achsen ausrichten</translation>
    </message>
    <message>
        <source>Turn the selected islands to the axes and make straight what is straight on the model, with little distortion</source>
        <translation>Die ausgewählten Inseln zu den Achsen drehen und mit wenig Verzerrung gerade machen, was am Modell gerade ist</translation>
    </message>
    <message>
        <source>&amp;Straighten edges</source>
        <translation>&amp;Kanten begradigen</translation>
    </message>
    <message>
        <source>Make each chain of selected edges a straight line; the rest of its island follows</source>
        <translation>Jede Kette ausgewählter Kanten zu einer geraden Linie machen; der Rest ihrer Insel folgt</translation>
    </message>
    <message>
        <source>Straighten to a &amp;grid</source>
        <translation>&amp;Zu einem Raster begradigen</translation>
    </message>
    <message>
        <source>Make the selected quads a rectangle of straight rows and columns, each as wide as on the model; the rest of their islands follows</source>
        <translation>Die ausgewählten Quads zu einem Rechteck aus geraden Zeilen und Spalten machen, jede so breit wie am Modell; der Rest ihrer Inseln folgt</translation>
    </message>
    <message>
        <source>Rela&amp;x selected faces</source>
        <translation>Ausgewählte &amp;Flächen entspannen</translation>
    </message>
    <message>
        <source>Make the distortion of the selected faces small while all others stay</source>
        <translation>Die Verzerrung der ausgewählten Flächen klein machen, während alle anderen bleiben</translation>
    </message>
    <message>
        <source>Stack &amp;identical islands</source>
        <translation>&amp;Gleiche Inseln stapeln</translation>
    </message>
    <message>
        <source>Lay copies exactly on top of each other and pack them as one; one island alone finds all its copies</source>
        <translation>Kopien genau übereinander legen und als eine packen; eine einzelne Insel findet alle ihre Kopien</translation>
    </message>
    <message>
        <source>Lay stac&amp;ks apart</source>
        <translation>&amp;Stapel auseinanderlegen</translation>
    </message>
    <message>
        <source>Take the selected islands out of their stacks and lay them beside the map</source>
        <translation>Die ausgewählten Inseln aus ihren Stapeln nehmen und neben die Map legen</translation>
    </message>
    <message>
        <source>&amp;Randomise...</source>
        <translation>Z&amp;ufällig anordnen...</translation>
    </message>
    <message>
        <source>Move, turn and scale the selected islands at random, within limits</source>
        <translation>Die ausgewählten Inseln innerhalb von Grenzen zufällig verschieben, drehen und skalieren</translation>
    </message>
    <message>
        <source>Set texel &amp;density...</source>
        <translation>&amp;Texeldichte setzen...</translation>
    </message>
    <message>
        <source>Scale the selected islands to a texel density in texels per unit of the model</source>
        <translation>Die ausgewählten Inseln auf eine Texeldichte in Texeln je Einheit des Modells skalieren</translation>
    </message>
    <message>
        <source>Painted &amp;weights</source>
        <translation>&amp;Gemalte Gewichte</translation>
    </message>
    <message>
        <source>Export re&amp;port...</source>
        <translation>&amp;Bericht exportieren...</translation>
    </message>
    <message>
        <source>Write the figures of the map, of objects, materials and tiles as JSON, as the command line does</source>
        <translation>Die Kennzahlen der Map, der Objekte, Materialien und Kacheln als JSON schreiben, wie die Kommandozeile</translation>
    </message>
    <message>
        <source>Pack at a texel &amp;density...</source>
        <translation>Mit &amp;einer Texeldichte packen...</translation>
    </message>
    <message>
        <source>Give islands a texel density and pack them into as many UDIM tiles as that needs; islands that are selected, or all of them</source>
        <translation>Inseln eine Texeldichte geben und sie in so viele UDIM-Kacheln packen, wie das braucht; die ausgewählten Inseln oder alle</translation>
    </message>
    <message>
        <source>&amp;Fill the tiles in use</source>
        <translation>&amp;Benutzte Kacheln auffüllen</translation>
    </message>
    <message>
        <source>Pack the selected islands into the free room of the tiles in which the others lie, at their texel density; what does not fit gets new tiles</source>
        <translation>Die ausgewählten Inseln mit der Texeldichte der anderen in den freien Platz von deren Kacheln packen; was nicht passt, bekommt neue Kacheln</translation>
    </message>
    <message>
        <source>Transfer UVs from...</source>
        <translation>UVs übertragen von...</translation>
    </message>
    <message>
        <source>Bring the UVs of another file, UV set or object onto the model, also of another resolution</source>
        <translation>Die UVs einer anderen Datei, eines anderen UV-Satzes oder Objekts auf das Modell bringen, auch bei anderer Auflösung</translation>
    </message>
    <message>
        <source>Textures of the &amp;model</source>
        <translation>Texturen &amp;des Modells</translation>
    </message>
    <message>
        <source>On every material the picture that the model&apos;s file names for it; behind the map that of the selected face</source>
        <translation>Auf jedem Material das Bild, das die Datei des Modells dafür nennt; hinter der Map das der ausgewählten Fläche</translation>
    </message>
    <message>
        <source>Change between no pattern, the checkerboard, the lettered cells, the texture and the textures of the model</source>
        <translation>Zwischen keinem Muster, dem Schachbrett, den beschrifteten Feldern, der Textur und den Texturen des Modells wechseln</translation>
    </message>
    <message>
        <source>Texture &amp;sets in light</source>
        <translation>Te&amp;xtursätze im Licht</translation>
    </message>
    <message>
        <source>All channels of the materials&apos; textures, physically based, in the light of surroundings; see the panel Textures</source>
        <translation>Alle Kanäle der Texturen der Materialien, physikalisch basiert, im Licht einer Umgebung; siehe das Bedienfeld Texturen</translation>
    </message>
    <message>
        <source>Bake...</source>
        <translation>Backen...</translation>
    </message>
    <message>
        <source>Bake normals, occlusion and more into pictures for the map, from a detailed model or from this one</source>
        <translation>Normalen, Verdeckung und mehr in Bilder für die UV-Map backen, von einem detaillierten Modell oder von diesem</translation>
    </message>
    <message>
        <source>&amp;Vertex colours</source>
        <translation>&amp;Vertexfarben</translation>
    </message>
    <message>
        <source>The colours that the model&apos;s file gives its vertices</source>
        <translation>Die Farben, die die Datei des Modells seinen Vertices gibt</translation>
    </message>
    <message>
        <source>Carry textures over...</source>
        <translation>Texturen übertragen...</translation>
    </message>
    <message>
        <source>Make the textures of all materials new for this map, as files, from the map that they were made for</source>
        <translation>Die Texturen aller Materialien für diese UV-Map neu machen, als Dateien, aus der UV-Map, für die sie gemacht sind</translation>
    </message>
    <message>
        <source>Bake light...</source>
        <translation>Licht backen...</translation>
    </message>
    <message>
        <source>Bake the light of a sun, a sky, area lights and emissive materials into a picture for the map</source>
        <translation>Das Licht von Sonne, Himmel, Flächenlichtern und emissiven Materialien in ein Bild für die Map backen</translation>
    </message>
    <message>
        <source>Treat as a &amp;stack</source>
        <translation>Als S&amp;tapel behandeln</translation>
    </message>
    <message>
        <source>Pack the selected islands on top of each other, whether they are alike or not</source>
        <translation>Die ausgewählten Inseln aufeinander packen, ob sie gleich sind oder nicht</translation>
    </message>
    <message>
        <source>Open a model first</source>
        <translation>Öffnen Sie zuerst ein Modell</translation>
    </message>
    <message>
        <source>A job is running: wait for its end, or cancel it</source>
        <translation>Eine Aufgabe läuft: warten Sie ihr Ende ab, oder brechen Sie sie ab</translation>
    </message>
    <message>
        <source>There is no map yet: unwrap first</source>
        <translation>Es gibt noch keine Map: wickeln Sie zuerst ab</translation>
    </message>
    <message>
        <source>Select edges first</source>
        <translation>Wählen Sie zuerst Kanten aus</translation>
    </message>
    <message>
        <source>Select faces or islands first</source>
        <translation>Wählen Sie zuerst Flächen oder Inseln aus</translation>
    </message>
    <message>
        <source>Select edges or faces first</source>
        <translation>Wählen Sie zuerst Kanten oder Flächen aus</translation>
    </message>
    <message>
        <source>Select something first</source>
        <translation>Wählen Sie zuerst etwas aus</translation>
    </message>
    <message>
        <source>There is nothing to take back</source>
        <translation>Es gibt nichts zurückzunehmen</translation>
    </message>
    <message>
        <source>Nothing was taken back</source>
        <translation>Es wurde nichts zurückgenommen</translation>
    </message>
    <message>
        <source>No job is running</source>
        <translation>Es läuft keine Aufgabe</translation>
    </message>
    <message>
        <source>No overlaps are known</source>
        <translation>Es sind keine Überlappungen bekannt</translation>
    </message>
    <message>
        <source>Nothing is hidden</source>
        <translation>Nichts ist ausgeblendet</translation>
    </message>
    <message>
        <source>&amp;Hide or show all panels</source>
        <translation>Alle Bereiche aus- oder &amp;einblenden</translation>
    </message>
    <message>
        <source>Give the views all room, and bring the panels back</source>
        <translation>Den Ansichten allen Platz geben, und die Bereiche zurückholen</translation>
    </message>
    <message>
        <source>&amp;Send to a tile...</source>
        <translation>In eine Kachel &amp;senden ...</translation>
    </message>
    <message>
        <source>Move the selected islands into a UDIM tile, to the same place in it</source>
        <translation>Die ausgewählten Inseln in eine UDIM-Kachel verschieben, an denselben Ort darin</translation>
    </message>
    <message>
        <source>Of the same &amp;shape</source>
        <translation>Von gleicher &amp;Form</translation>
    </message>
    <message>
        <source>Select the faces with sides and angles like those of a selected one, at any size, turned or mirrored</source>
        <translation>Die Flächen auswählen, deren Seiten und Winkel denen einer ausgewählten gleichen, in jeder Größe, gedreht oder gespiegelt</translation>
    </message>
    <message>
        <source>Of the same area in the ma&amp;p</source>
        <translation>Von gleichem &amp;Inhalt in der Map</translation>
    </message>
    <message>
        <source>Select the faces that take as much of the texture as a selected one, within a tenth</source>
        <translation>Die Flächen auswählen, die bis auf ein Zehntel so viel von der Textur einnehmen wie eine ausgewählte</translation>
    </message>
    <message>
        <source>&amp;Flat with the selection...</source>
        <translation>Eben mit der A&amp;uswahl...</translation>
    </message>
    <message>
        <source>Select the connected faces between which the model is bent by no more than an angle</source>
        <translation>Die verbundenen Flächen auswählen, zwischen denen das Modell nicht mehr als um einen Winkel geknickt ist</translation>
    </message>
    <message>
        <source>Of the same &amp;length</source>
        <translation>Von gleicher &amp;Länge</translation>
    </message>
    <message>
        <source>Select the edges that are as long on the model as a selected one, within a tenth</source>
        <translation>Die Kanten auswählen, die bis auf ein Zehntel auf dem Modell so lang sind wie eine ausgewählte</translation>
    </message>
    <message>
        <source>Of the same length in the &amp;map</source>
        <translation>Von gleicher Länge in der &amp;Map</translation>
    </message>
    <message>
        <source>Select the edges that are as long in the map as a selected one, within a tenth</source>
        <translation>Die Kanten auswählen, die bis auf ein Zehntel in der Map so lang sind wie eine ausgewählte</translation>
    </message>
    <message>
        <source>Of the same &amp;direction in the map</source>
        <translation>Von gleicher &amp;Richtung in der Map</translation>
    </message>
    <message>
        <source>Select the edges that run in the map as a selected one does, within 10 degrees</source>
        <translation>Die Kanten auswählen, die in der Map bis auf 10 Grad so laufen wie eine ausgewählte</translation>
    </message>
    <message>
        <source>Edge &amp;ring</source>
        <translation>Kanten&amp;ring</translation>
    </message>
    <message>
        <source>Select the edges that lie across quads from the selected ones, and so on</source>
        <translation>Die Kanten auswählen, die den ausgewählten in Vierecken gegenüberliegen, und so weiter</translation>
    </message>
    <message>
        <source>Strip of &amp;faces</source>
        <translation>&amp;Flächenstreifen</translation>
    </message>
    <message>
        <source>Select the rows of quads through the selected faces: in the direction of two neighbours, or in both</source>
        <translation>Die Reihen von Vierecken durch die ausgewählten Flächen auswählen: in der Richtung zweier Nachbarn, oder in beiden</translation>
    </message>
    <message>
        <source>&amp;Every second one</source>
        <translation>&amp;Jedes zweite</translation>
    </message>
    <message>
        <source>Keep every second element of the selection: a checkerboard of faces, every second edge of a loop</source>
        <translation>Jedes zweite Element der Auswahl behalten: Flächen wie auf einem Schachbrett, jede zweite Kante einer Schleife</translation>
    </message>
    <message>
        <source>&amp;Grow along rows</source>
        <translation>In Reihen &amp;erweitern</translation>
    </message>
    <message>
        <source>Add one element at both ends of each row of selected ones</source>
        <translation>An beiden Enden jeder Reihe ausgewählter Elemente eines hinzunehmen</translation>
    </message>
    <message>
        <source>&amp;Shrink along rows</source>
        <translation>In Reihen &amp;verkleinern</translation>
    </message>
    <message>
        <source>Take away the elements at both ends of each row of selected ones</source>
        <translation>Die Elemente an beiden Enden jeder Reihe ausgewählter wegnehmen</translation>
    </message>
    <message>
        <source>Pack a tile for each &amp;tag</source>
        <translation>Je Ma&amp;rkierung eine Kachel packen</translation>
    </message>
    <message>
        <source>Give the islands of every tag a UDIM tile of their own, those without a tag the last one; islands that are selected, or all of them</source>
        <translation>Gibt den Inseln jeder Markierung eine eigene UDIM-Kachel, denen ohne Markierung die letzte; gewählten Inseln oder allen</translation>
    </message>
    <message>
        <source>&amp;Lock or unlock the tile</source>
        <translation>&amp;Kachel sperren oder entsperren</translation>
    </message>
    <message>
        <source>Lock all islands of the tiles of the selected islands, or unlock them when all are locked</source>
        <translation>Sperrt alle Inseln der Kacheln der gewählten Inseln, oder entsperrt sie, wenn alle gesperrt sind</translation>
    </message>
    <message>
        <source>Tags of islands...</source>
        <translation>Markierungen von Inseln ...</translation>
    </message>
    <message>
        <source>Give the selected islands a tag, take it from them, or select the islands that have one</source>
        <translation>Den ausgewählten Inseln eine Markierung geben, sie ihnen nehmen oder die Inseln auswählen, die eine haben</translation>
    </message>
    <message>
        <source>&amp;Make meshes unique</source>
        <translation>&amp;Meshes eigenständig machen</translation>
    </message>
    <message>
        <source>Give each object that shares a mesh with others in the file of the model a mesh and a map of its own</source>
        <translation>Gibt jedem Objekt, das sich in der Datei des Modells ein Mesh mit anderen teilt, ein eigenes Mesh und eine eigene Abwicklung</translation>
    </message>
    <message>
        <source>The model is from no file: re-link it to one</source>
        <translation>Das Modell ist aus keiner Datei: mit einer verknüpfen</translation>
    </message>
    <message>
        <source>&amp;Watch the file</source>
        <translation>&amp;Datei überwachen</translation>
    </message>
    <message>
        <source>Re-link the model whenever another program saves its file. The session remembers it</source>
        <translation>Das Modell neu verknüpfen, sobald ein anderes Programm seine Datei speichert. Die Sitzung merkt es sich</translation>
    </message>
    <message>
        <source>Export a&amp;gain after each re-link</source>
        <translation>Nach &amp;jeder Verknüpfung exportieren</translation>
    </message>
    <message>
        <source>Write the model with its UV map beside its file, as NAME_uv, after each re-link. The session remembers it</source>
        <translation>Das Modell mit seiner UV-Map nach jeder Verknüpfung neben seine Datei schreiben, als NAME_uv. Die Sitzung merkt es sich</translation>
    </message>
    <message>
        <source>There is only one UV set: make another one first</source>
        <translation>Es gibt nur einen UV-Satz: legen Sie zuerst einen weiteren an</translation>
    </message>
</context>
<context>
    <name>Brush</name>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Radius of the brush; Shift+wheel</source>
        <translation>Radius des Pinsels; Umschalt+Mausrad</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>Effect in the middle; Ctrl+wheel</source>
        <translation>Wirkung in der Mitte; Strg+Mausrad</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Hardness</source>
        <translation>Härte</translation>
    </message>
    <message>
        <source>Share of the brush with full strength; Alt+wheel</source>
        <translation>Anteil des Pinsels mit voller Stärke; Alt+Mausrad</translation>
    </message>
</context>
<context>
    <name>DetailedModel</name>
    <message>
        <source>it was taken %1 times as large</source>
        <translation>es wurde %1-mal so groß genommen</translation>
    </message>
    <message>
        <source>its upward axis was turned</source>
        <translation>seine Hochachse wurde gedreht</translation>
    </message>
    <message>
        <source>The detailed model has other units or axes than the model: %1</source>
        <translation>Das detaillierte Modell hat andere Einheiten oder Achsen als das Modell: %1</translation>
    </message>
</context>
<context>
    <name>EnergyGain</name>
    <message>
        <source>D %1 → %2</source>
        <translation>D %1 → %2</translation>
    </message>
    <message>
        <source>Since the edit: %1</source>
        <translation>Seit der Änderung: %1</translation>
    </message>
    <message>
        <source>Energy saved since the edit: %1 (%2 %)</source>
        <translation>Seit der Änderung gesparte Energie: %1 (%2 %)</translation>
    </message>
    <message>
        <source>Energy added by the edit: %1 (%2 %)</source>
        <translation>Durch die Änderung hinzugekommene Energie: %1 (%2 %)</translation>
    </message>
</context>
<context>
    <name>ExportLosses</name>
    <message>
        <source>UV sets that were removed stay in the file: its materials name UV sets by their numbers</source>
        <translation>entfernte UV-Sätze bleiben in der Datei: ihre Materialien nennen UV-Sätze mit Nummern</translation>
    </message>
    <message>
        <source>UV sets after the eighth are lost</source>
        <translation>UV-Sätze nach dem achten gehen verloren</translation>
    </message>
    <message>
        <source>OBJ holds one UV set: only &quot;%1&quot; is written</source>
        <translation>OBJ enthält einen UV-Satz: nur „%1“ wird geschrieben</translation>
    </message>
    <message>
        <source>normals and vertex colours are lost</source>
        <translation>Normalen und Vertexfarben gehen verloren</translation>
    </message>
    <message>
        <source>materials are lost</source>
        <translation>Materialien gehen verloren</translation>
    </message>
    <message>
        <source>shape keys (morph targets) are lost</source>
        <translation>Formschlüssel (Morph-Targets) gehen verloren</translation>
    </message>
    <message>
        <source>bones and animations are lost</source>
        <translation>Knochen und Animationen gehen verloren</translation>
    </message>
    <message>
        <source>the node hierarchy is lost; positions are written in world space</source>
        <translation>die Knotenhierarchie geht verloren; Positionen werden in Weltkoordinaten geschrieben</translation>
    </message>
    <message>
        <source>lights and cameras are lost</source>
        <translation>Lichter und Kameras gehen verloren</translation>
    </message>
    <message>
        <source>meshes that several nodes share become one copy per node, with its own UVs</source>
        <translation>Meshes, die sich mehrere Knoten teilen, werden zu einer Kopie je Knoten mit eigenen UVs</translation>
    </message>
    <message>
        <source>bones and animations are lost: only FBX can hold those of this file</source>
        <translation>Knochen und Animationen gehen verloren: nur FBX kann die dieser Datei aufnehmen</translation>
    </message>
    <message>
        <source>the node hierarchy, lights and cameras are lost; positions are written in world space</source>
        <translation>Knotenhierarchie, Lichter und Kameras gehen verloren; Positionen werden in Weltkoordinaten geschrieben</translation>
    </message>
    <message>
        <source>corners without UV get the UV 0 0</source>
        <translation>Ecken ohne UV bekommen die UV 0 0</translation>
    </message>
    <message>
        <source>positions and UVs are rounded to single precision</source>
        <translation>Positionen und UVs werden auf einfache Genauigkeit gerundet</translation>
    </message>
    <message>
        <source>tangents of changed UVs are left out: programs compute them from the UVs</source>
        <translation>Tangenten geänderter UVs werden weggelassen: Programme berechnen sie aus den UVs</translation>
    </message>
    <message>
        <source>changed meshes are written without compression</source>
        <translation>geänderte Meshes werden ohne Kompression geschrieben</translation>
    </message>
    <message>
        <source>changed UVs are rounded to single precision</source>
        <translation>geänderte UVs werden auf einfache Genauigkeit gerundet</translation>
    </message>
    <message>
        <source>pictures that are not found stay names: %1</source>
        <translation>Bilder, die nicht gefunden werden, bleiben Namen: %1</translation>
    </message>
    <message>
        <source>pictures of roughness and metalness are lost: the format holds them in another way than this file</source>
        <translation>Bilder von Rauheit und Metall gehen verloren: Das Format hält sie anders als diese Datei</translation>
    </message>
    <message>
        <source>comments and groups of the OBJ file are lost</source>
        <translation>Kommentare und Gruppen der OBJ-Datei gehen verloren</translation>
    </message>
    <message>
        <source>comments, groups and smoothing groups of the OBJ file are lost</source>
        <translation>Kommentare, Gruppen und Glättungsgruppen der OBJ-Datei gehen verloren</translation>
    </message>
    <message>
        <source>meshes that several nodes share get the UVs of the first node, unless they are made unique</source>
        <translation>Meshes, die sich mehrere Knoten teilen, bekommen die UVs des ersten Knotens, außer wenn sie eigenständig gemacht werden</translation>
    </message>
    <message>
        <source>objects that share a mesh have one map in the file: that of the first one whose UVs were changed is written, unless the meshes are made unique</source>
        <translation>Objekte, die sich ein Mesh teilen, haben in der Datei eine gemeinsame Abwicklung: geschrieben wird die des ersten, dessen UVs geändert wurden, außer wenn die Meshes eigenständig gemacht werden</translation>
    </message>
    <message>
        <source>animations are kept of objects and bones only, not of shape keys, materials, lights and cameras</source>
        <translation>Animationen bleiben nur von Objekten und Knochen, nicht von Formschlüsseln, Materialien, Lichtern und Kameras</translation>
    </message>
    <message>
        <source>Only the first animation is written to Collada</source>
        <translation>Collada enthält eine Animation: nur die erste wird geschrieben</translation>
    </message>
    <message>
        <source>some programs show a Collada model without animations in its rest pose</source>
        <translation>manche Programme zeigen ein Collada-Modell ohne Animationen in seiner Ruhepose</translation>
    </message>
    <message>
        <source>the dual quaternions by which bones bend meshes are lost: bent shapes differ</source>
        <translation>die dualen Quaternionen, mit denen Knochen Netze biegen, gehen verloren: gebogene Formen weichen ab</translation>
    </message>
    <message>
        <source>scales are passed on to all that is below: the file has another rule for some objects, whose shapes can differ</source>
        <translation>Skalierungen gehen auf alles darunter über: Für einige Objekte, deren Formen abweichen können, hat die Datei eine andere Regel</translation>
    </message>
    <message>
        <source>curves and NURBS surfaces are lost: only their places are written</source>
        <translation>Kurven und NURBS-Flächen gehen verloren: nur ihre Lage wird geschrieben</translation>
    </message>
    <message>
        <source>stereo cameras are lost: only their places are written</source>
        <translation>Stereokameras gehen verloren: nur ihre Lage wird geschrieben</translation>
    </message>
    <message>
        <source>%1 holds one object: all are joined</source>
        <translation>%1 enthält ein Objekt: alle werden verbunden</translation>
    </message>
    <message>
        <source>%1 holds one UV set: only &quot;%2&quot; is written</source>
        <translation>%1 enthält einen UV-Satz: nur „%2“ wird geschrieben</translation>
    </message>
    <message>
        <source>%1 holds triangles only: polygons are split</source>
        <translation>%1 enthält nur Dreiecke: Polygone werden geteilt</translation>
    </message>
</context>
<context>
    <name>FileErrors</name>
    <message>
        <source>there is no space left on the disk</source>
        <translation>auf dem Datenträger ist kein Platz mehr</translation>
    </message>
    <message>
        <source>Free some space, or choose another folder</source>
        <translation>Schaffen Sie Platz, oder wählen Sie einen anderen Ordner</translation>
    </message>
    <message>
        <source>the file cannot be written (%1)</source>
        <translation>die Datei lässt sich nicht schreiben (%1)</translation>
    </message>
    <message>
        <source>Check the permissions and the free space of the folder, or choose another one</source>
        <translation>Prüfen Sie die Rechte und den freien Platz des Ordners, oder wählen Sie einen anderen</translation>
    </message>
    <message>
        <source>this is a folder, not a file</source>
        <translation>das ist ein Ordner, keine Datei</translation>
    </message>
    <message>
        <source>Add a file name to the path</source>
        <translation>Fügen Sie dem Pfad einen Dateinamen hinzu</translation>
    </message>
    <message>
        <source>this is not a regular file and cannot be replaced</source>
        <translation>das ist keine gewöhnliche Datei und lässt sich nicht ersetzen</translation>
    </message>
    <message>
        <source>Choose another file name</source>
        <translation>Wählen Sie einen anderen Dateinamen</translation>
    </message>
    <message>
        <source>the folder %1 does not exist</source>
        <translation>den Ordner %1 gibt es nicht</translation>
    </message>
    <message>
        <source>Create the folder or choose another one</source>
        <translation>Legen Sie den Ordner an oder wählen Sie einen anderen</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>Check the path</source>
        <translation>Prüfen Sie den Pfad</translation>
    </message>
    <message>
        <source>Name a file in it</source>
        <translation>Nennen Sie eine Datei darin</translation>
    </message>
    <message>
        <source>this is not a regular file</source>
        <translation>das ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>Copy its content to a file first</source>
        <translation>Kopieren Sie den Inhalt erst in eine Datei</translation>
    </message>
    <message>
        <source>the file has %1 bytes, the limit is %2</source>
        <translation>die Datei hat %1 Byte, die Grenze ist %2</translation>
    </message>
    <message>
        <source>Split the model into several files</source>
        <translation>Teilen Sie das Modell in mehrere Dateien auf</translation>
    </message>
    <message>
        <source>the file cannot be read (%1)</source>
        <translation>die Datei lässt sich nicht lesen (%1)</translation>
    </message>
    <message>
        <source>Check its permissions</source>
        <translation>Prüfen Sie ihre Rechte</translation>
    </message>
    <message>
        <source>reading the file failed (%1)</source>
        <translation>das Lesen der Datei ist fehlgeschlagen (%1)</translation>
    </message>
    <message>
        <source>Check the disk and try again</source>
        <translation>Prüfen Sie den Datenträger und versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>reading was cancelled</source>
        <translation>das Lesen wurde abgebrochen</translation>
    </message>
    <message>
        <source>this would overwrite another file that is read or written</source>
        <translation>damit würde eine andere Datei überschrieben, die gelesen oder geschrieben wird</translation>
    </message>
    <message>
        <source>Give it a name of its own</source>
        <translation>Geben Sie ihr einen eigenen Namen</translation>
    </message>
    <message>
        <source>cancelled: no picture was written</source>
        <translation>abgebrochen: es wurde kein Bild geschrieben</translation>
    </message>
    <message>
        <source>the file is write-protected</source>
        <translation>die Datei ist schreibgeschützt</translation>
    </message>
    <message>
        <source>Check its permissions, or choose another file name</source>
        <translation>Prüfen Sie ihre Rechte, oder wählen Sie einen anderen Dateinamen</translation>
    </message>
    <message>
        <source>; these files are replaced already: %1</source>
        <translation>; diese Dateien sind schon ersetzt: %1</translation>
    </message>
    <message>
        <source>A program ended before it replaced these files, which are as they were: %1 (in %2)</source>
        <translation>Ein Programm endete, bevor es diese Dateien ersetzt hat. Sie sind, wie sie waren: %1 (in %2)</translation>
    </message>
    <message>
        <source>A program ended while it replaced files together, and %1 was changed since. What was to be written is in files that end with %2: rename or remove them (in %3)</source>
        <translation>Ein Programm endete, während es zusammengehörende Dateien ersetzte, und %1 wurde seitdem geändert. Was geschrieben werden sollte, steht in Dateien, die auf %2 enden: benennen Sie sie um oder löschen Sie sie (in %3)</translation>
    </message>
    <message>
        <source>A program ended while it replaced files together, and the rest of them cannot be replaced: %1 (in %2). Check the permissions of the folder</source>
        <translation>Ein Programm endete, während es zusammengehörende Dateien ersetzte, und die übrigen lassen sich nicht ersetzen: %1 (in %2). Prüfen Sie die Rechte des Ordners</translation>
    </message>
    <message>
        <source>A program ended while it replaced files together. All of them are the new ones now: %1 (in %2)</source>
        <translation>Ein Programm endete, während es zusammengehörende Dateien ersetzte. Jetzt sind alle die neuen: %1 (in %2)</translation>
    </message>
    <message>
        <source>A program ended while it replaced files of several folders together, and another of these folders is gone or was changed. What was to be written is in files that end with %1, what was there before in files that end with %2: rename or remove them (in %3)</source>
        <translation>Ein Programm endete, während es zusammengehörende Dateien mehrerer Ordner ersetzte, und ein anderer dieser Ordner fehlt oder wurde geändert. Was geschrieben werden sollte, steht in Dateien, die auf %1 enden, was vorher dort stand, in Dateien, die auf %2 enden: benennen Sie sie um oder löschen Sie sie (in %3)</translation>
    </message>
    <message>
        <source>the folder for recovery cannot be made</source>
        <translation>der Ordner für die Wiederherstellung kann nicht angelegt werden</translation>
    </message>
    <message>
        <source>Check the permissions of the folders above it</source>
        <translation>Prüfen Sie die Rechte der Ordner darüber</translation>
    </message>
    <message>
        <source>another program has this session open</source>
        <translation>ein anderes Programm hat diese Sitzung geöffnet</translation>
    </message>
    <message>
        <source>the folder for recovery cannot be written</source>
        <translation>in den Ordner für die Wiederherstellung kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>Go on there</source>
        <translation>Arbeiten Sie dort weiter</translation>
    </message>
    <message>
        <source>Check the permissions and the free space of the folder</source>
        <translation>Prüfen Sie die Rechte und den freien Platz des Ordners</translation>
    </message>
</context>
<context>
    <name>IslandTool</name>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>× %1</source>
        <translation>× %1</translation>
    </message>
    <message>
        <source>%1, %2 texels</source>
        <translation>%1, %2 Texel</translation>
    </message>
    <message>
        <source>%1, %2 UV units</source>
        <translation>%1, %2 UV-Einheiten</translation>
    </message>
</context>
<context>
    <name>LayoutChoices</name>
    <message>
        <source>Pivot</source>
        <translation>Drehpunkt</translation>
    </message>
    <message>
        <source>The point about which islands are turned and scaled</source>
        <translation>Der Punkt, um den Inseln gedreht und skaliert werden</translation>
    </message>
    <message>
        <source>Centre of the box</source>
        <translation>Mitte des Kastens</translation>
    </message>
    <message>
        <source>Lower left corner</source>
        <translation>Linke untere Ecke</translation>
    </message>
    <message>
        <source>2D cursor</source>
        <translation>2D-Cursor</translation>
    </message>
    <message>
        <source>Each island its own</source>
        <translation>Jede Insel ihr eigener</translation>
    </message>
    <message>
        <source>Snap to</source>
        <translation>Einrasten an</translation>
    </message>
    <message>
        <source>What a move snaps to without keys; Ctrl, Shift and Alt ask for something else</source>
        <translation>Woran eine Verschiebung ohne Tasten einrastet; mit Strg, Umschalt und Alt an etwas anderem</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>Other islands</source>
        <translation>Andere Inseln</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>Texels</source>
        <translation>Texel</translation>
    </message>
    <message>
        <source>Tiles</source>
        <translation>Kacheln</translation>
    </message>
    <message>
        <source>In</source>
        <translation>In</translation>
    </message>
    <message>
        <source>Unit of lengths that are shown here and typed during a move; texels are those of the texture size of the Packing panel</source>
        <translation>Einheit von Längen, die hier gezeigt und beim Verschieben getippt werden; Texel sind die der Texturgröße im Bedienfeld Packen</translation>
    </message>
    <message>
        <source>UV units</source>
        <translation>UV-Einheiten</translation>
    </message>
</context>
<context>
    <name>MapOutcome</name>
    <message>
        <source>Triangles are flipped.</source>
        <translation>Dreiecke sind umgedreht.</translation>
    </message>
    <message>
        <source>Faces overlap.</source>
        <translation>Flächen überlappen.</translation>
    </message>
    <message>
        <source>More stretch than allowed.</source>
        <translation>Mehr Dehnung als erlaubt.</translation>
    </message>
    <message>
        <source>Not packed.</source>
        <translation>Nicht gepackt.</translation>
    </message>
    <message>
        <source>Ready.</source>
        <translation>Fertig.</translation>
    </message>
    <message>
        <source>No map yet</source>
        <translation>Noch keine Map</translation>
    </message>
    <message>
        <source>D %1, seams %2, islands: %3</source>
        <translation>D %1, Nähte %2, Inseln: %3</translation>
    </message>
    <message>
        <source>Texel densities differ.</source>
        <translation>Die Texeldichten sind verschieden.</translation>
    </message>
    <message>
        <source>island %1 (of %2)</source>
        <translation>Insel %1 (von %2)</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>%1 weitere</translation>
    </message>
    <message>
        <source>Not in one tile as a whole: %1.</source>
        <translation>Nicht ganz in einer Kachel: %1.</translation>
    </message>
</context>
<context>
    <name>MapOverlays</name>
    <message>
        <source>G%1</source>
        <translation>G%1</translation>
    </message>
    <message>
        <source>S%1</source>
        <translation>S%1</translation>
    </message>
    <message>
        <source>%1: of %2</source>
        <translation>%1: von %2</translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>&amp;File</source>
        <translation>D&amp;atei</translation>
    </message>
    <message>
        <source>Open sa&amp;mple</source>
        <translation>Be&amp;ispiel öffnen</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>Aus&amp;wahl</translation>
    </message>
    <message>
        <source>Simila&amp;r faces</source>
        <translation>Ähnliche &amp;Flächen</translation>
    </message>
    <message>
        <source>Edges &amp;by kind</source>
        <translation>Kan&amp;ten nach Art</translation>
    </message>
    <message>
        <source>Islands b&amp;y figures</source>
        <translation>Inseln nach Kenn&amp;zahlen</translation>
    </message>
    <message>
        <source>&amp;UV</source>
        <translation>&amp;UV</translation>
    </message>
    <message>
        <source>S&amp;tart mode</source>
        <translation>Startm&amp;odus</translation>
    </message>
    <message>
        <source>Ener&amp;gy</source>
        <translation>Ene&amp;rgie</translation>
    </message>
    <message>
        <source>Seam &amp;weighting</source>
        <translation>Na&amp;htgewichtung</translation>
    </message>
    <message>
        <source>UV sets</source>
        <translation>UV-Sätze</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Pack into tiles</source>
        <translation>In Kacheln packen</translation>
    </message>
    <message>
        <source>Islan&amp;ds</source>
        <translation>Inse&amp;ln</translation>
    </message>
    <message>
        <source>Texel density</source>
        <translation>Texeldichte</translation>
    </message>
    <message>
        <source>La&amp;yout</source>
        <translation>La&amp;yout</translation>
    </message>
    <message>
        <source>&amp;Align</source>
        <translation>Ausri&amp;chten</translation>
    </message>
    <message>
        <source>Distri&amp;bute</source>
        <translation>V&amp;erteilen</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>Ansich&amp;t</translation>
    </message>
    <message>
        <source>&amp;Colouring</source>
        <translation>&amp;Färbung</translation>
    </message>
    <message>
        <source>Patter&amp;n</source>
        <translation>M&amp;uster</translation>
    </message>
    <message>
        <source>Look from</source>
        <translation>Blickrichtung</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Bedienfelder</translation>
    </message>
    <message>
        <source>He&amp;lp</source>
        <translation>Hi&amp;lfe</translation>
    </message>
    <message>
        <source>So&amp;lver</source>
        <translation>Solve&amp;r</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Reihen</translation>
    </message>
    <message>
        <source>Similar edges</source>
        <translation>Ähnliche Kanten</translation>
    </message>
</context>
<context>
    <name>MeshDoctor</name>
    <message>
        <source>face %1</source>
        <translation>Fläche %1</translation>
    </message>
    <message>
        <source>faces %1</source>
        <translation>Flächen %1</translation>
    </message>
    <message>
        <source>No faces: there is nothing to unwrap</source>
        <translation>Keine Flächen: es gibt nichts abzuwickeln</translation>
    </message>
    <message>
        <source>non-manifold edge</source>
        <translation>nicht-mannigfaltige Kante</translation>
    </message>
    <message>
        <source>non-manifold edges</source>
        <translation>nicht-mannigfaltige Kanten</translation>
    </message>
    <message>
        <source>each face was joined to its best partner, the other sides are treated as boundary</source>
        <translation>jede Fläche wurde mit ihrem besten Partner verbunden, die anderen Seiten gelten als Rand</translation>
    </message>
    <message>
        <source>edge between faces of opposite winding</source>
        <translation>Kante zwischen gegensinnigen Flächen</translation>
    </message>
    <message>
        <source>edges between faces of opposite winding</source>
        <translation>Kanten zwischen gegensinnigen Flächen</translation>
    </message>
    <message>
        <source>treated as boundary, because the two sides cannot be continued into each other without a flip</source>
        <translation>gelten als Rand, weil die zwei Seiten sich nicht ohne Umdrehen ineinander fortsetzen lassen</translation>
    </message>
    <message>
        <source>triangle without area</source>
        <translation>Dreieck ohne Flächeninhalt</translation>
    </message>
    <message>
        <source>triangles without area</source>
        <translation>Dreiecke ohne Flächeninhalt</translation>
    </message>
    <message>
        <source>kept, and given a thin stand-in shape so that it gets UVs</source>
        <translation>bleiben erhalten und bekommen eine dünne Ersatzform, um UVs zu erhalten</translation>
    </message>
    <message>
        <source>duplicated face</source>
        <translation>doppelte Fläche</translation>
    </message>
    <message>
        <source>duplicated faces</source>
        <translation>doppelte Flächen</translation>
    </message>
    <message>
        <source>kept, and unwrapped as a layer of its own</source>
        <translation>bleiben erhalten und werden als eigene Lage abgewickelt</translation>
    </message>
    <message>
        <source>%1 (%2): cut off from the faces around where it does so</source>
        <translation>%1 (%2): dort von den Flächen ringsum abgeschnitten</translation>
    </message>
    <message>
        <source>polygon meets itself</source>
        <translation>Polygon berührt sich selbst</translation>
    </message>
    <message>
        <source>polygons meet themselves</source>
        <translation>Polygone berühren sich selbst</translation>
    </message>
    <message>
        <source>vertex at the place of another</source>
        <translation>Vertex an der Stelle eines anderen</translation>
    </message>
    <message>
        <source>vertices at the place of another</source>
        <translation>Vertices an der Stelle eines anderen</translation>
    </message>
    <message>
        <source>treated as joined, and kept apart in the saved file</source>
        <translation>gelten als verbunden und bleiben in der gespeicherten Datei getrennt</translation>
    </message>
    <message>
        <source>vertex without a face</source>
        <translation>Vertex ohne Fläche</translation>
    </message>
    <message>
        <source>vertices without a face</source>
        <translation>Vertices ohne Fläche</translation>
    </message>
    <message>
        <source>kept in the saved file</source>
        <translation>bleiben in der gespeicherten Datei</translation>
    </message>
    <message>
        <source>separate parts</source>
        <translation>getrennte Teile</translation>
    </message>
    <message>
        <source>each gets islands of its own</source>
        <translation>jeder bekommt eigene Inseln</translation>
    </message>
    <message>
        <source>The mesh lies %1 times its own size from the origin: it is moved there for solving, and saved where it was</source>
        <translation>Das Mesh liegt das %1-Fache seiner Größe vom Ursprung entfernt: zum Berechnen wird es dorthin verschoben und gespeichert, wo es war</translation>
    </message>
    <message>
        <source>The mesh has no area: its UVs have no meaning</source>
        <translation>Das Mesh hat keinen Flächeninhalt: seine UVs haben keine Bedeutung</translation>
    </message>
    <message>
        <source>polygon that is not convex</source>
        <translation>Polygon, das nicht konvex ist</translation>
    </message>
    <message>
        <source>polygons that are not convex</source>
        <translation>Polygone, die nicht konvex sind</translation>
    </message>
    <message>
        <source>split into triangles along diagonals inside it; the polygon itself stays whole</source>
        <translation>entlang innerer Diagonalen in Dreiecke geteilt; das Polygon selbst bleibt ganz</translation>
    </message>
</context>
<context>
    <name>Overlays</name>
    <message>
        <source>Area in UV space</source>
        <translation>Fläche im UV-Raum</translation>
    </message>
    <message>
        <source>even</source>
        <translation>gleich</translation>
    </message>
    <message>
        <source>Distortion</source>
        <translation>Verzerrung</translation>
    </message>
    <message>
        <source>Texels per cm</source>
        <translation>Texel je cm</translation>
    </message>
    <message>
        <source>Texels per unit</source>
        <translation>Texel je Einheit</translation>
    </message>
    <message>
        <source>target %1</source>
        <translation>Ziel %1</translation>
    </message>
    <message>
        <source>median %1</source>
        <translation>Median %1</translation>
    </message>
    <message>
        <source>Texel density weight</source>
        <translation>Gewicht der Texeldichte</translation>
    </message>
    <message>
        <source>Painted weights</source>
        <translation>Gemalte Gewichte</translation>
    </message>
    <message>
        <source>attract cuts</source>
        <translation>schneiden</translation>
    </message>
    <message>
        <source>keep together</source>
        <translation>zusammenhalten</translation>
    </message>
    <message>
        <source>Kept straight</source>
        <translation>Gerade gehalten</translation>
    </message>
</context>
<context>
    <name>PictureFiles</name>
    <message>
        <source>the picture cannot be written (%1)</source>
        <translation>das Bild lässt sich nicht schreiben (%1)</translation>
    </message>
    <message>
        <source>OpenEXR files have no whole numbers of 8 bits</source>
        <translation>OpenEXR-Dateien haben keine ganzen Zahlen von 8 Bit</translation>
    </message>
    <message>
        <source>Choose 16 bits or float numbers, or a .png file</source>
        <translation>Wählen Sie 16 Bit oder Gleitkommazahlen, oder eine .png-Datei</translation>
    </message>
    <message>
        <source>pictures cannot be written in the format &quot;%1&quot;</source>
        <translation>Bilder lassen sich nicht im Format „%1“ schreiben</translation>
    </message>
    <message>
        <source>Choose a file name that ends in .png, .tif, .jpg, .tga or .exr</source>
        <translation>Wählen Sie einen Dateinamen, der auf .png, .tif, .jpg, .tga oder .exr endet</translation>
    </message>
    <message>
        <source>.%1 files have no numbers of 16 bits</source>
        <translation>.%1-Dateien haben keine Zahlen von 16 Bit</translation>
    </message>
    <message>
        <source>.%1 files have no float numbers</source>
        <translation>.%1-Dateien haben keine Gleitkommazahlen</translation>
    </message>
    <message>
        <source>Choose a .png, .tif or .exr file, or 8 bits</source>
        <translation>Wählen Sie eine .png-, .tif- oder .exr-Datei, oder 8 Bit</translation>
    </message>
    <message>
        <source>Choose an .exr file, or 8 or 16 bits</source>
        <translation>Wählen Sie eine .exr-Datei, oder 8 oder 16 Bit</translation>
    </message>
    <message>
        <source>there is not enough memory for the picture</source>
        <translation>für das Bild reicht der Speicher nicht</translation>
    </message>
    <message>
        <source>Close other programs, or scale the picture down</source>
        <translation>Schließen Sie andere Programme, oder verkleinern Sie das Bild</translation>
    </message>
    <message>
        <source>the picture has %1 bytes, the limit is %2</source>
        <translation>das Bild hat %1 Bytes, die Grenze ist %2</translation>
    </message>
    <message>
        <source>Scale the picture down to sides of %1 pixels at most</source>
        <translation>Verkleinern Sie das Bild auf Seiten von höchstens %1 Pixeln</translation>
    </message>
    <message>
        <source>the picture has no pixels</source>
        <translation>das Bild hat keine Pixel</translation>
    </message>
    <message>
        <source>it has several depths at a pixel</source>
        <translation>es hat mehrere Tiefen an einem Pixel</translation>
    </message>
    <message>
        <source>it has too many channels</source>
        <translation>es hat zu viele Kanäle</translation>
    </message>
    <message>
        <source>it has no channels</source>
        <translation>es hat keine Kanäle</translation>
    </message>
    <message>
        <source>its colours are not RGBE</source>
        <translation>seine Farben sind nicht RGBE</translation>
    </message>
    <message>
        <source>it is too short</source>
        <translation>es ist zu kurz</translation>
    </message>
    <message>
        <source>line %1 is damaged</source>
        <translation>Zeile %1 ist beschädigt</translation>
    </message>
    <message>
        <source>Save it again in the program that it comes from</source>
        <translation>Speichern Sie es noch einmal in dem Programm, aus dem es kommt</translation>
    </message>
    <message>
        <source>%1 x %2 pixels are too many</source>
        <translation>%1 x %2 Pixel sind zu viele</translation>
    </message>
    <message>
        <source>the picture is damaged, or its format is not known</source>
        <translation>das Bild ist beschädigt, oder sein Format ist nicht bekannt</translation>
    </message>
    <message>
        <source>the picture cannot be read (%1)</source>
        <translation>das Bild lässt sich nicht lesen (%1)</translation>
    </message>
    <message>
        <source>a colour is not in its palette</source>
        <translation>eine Farbe fehlt in seiner Palette</translation>
    </message>
    <message>
        <source>%1 files have no numbers of %2 bits</source>
        <translation>%1-Dateien haben keine Zahlen mit %2 Bit</translation>
    </message>
    <message>
        <source>Choose other bits or another format</source>
        <translation>Eine andere Bitzahl oder ein anderes Format wählen</translation>
    </message>
    <message>
        <source>the folder for the pictures cannot be written</source>
        <translation>in den Ordner für die Bilder kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>Check its permissions or choose another one</source>
        <translation>Seine Zugriffsrechte prüfen oder einen anderen wählen</translation>
    </message>
    <message>
        <source>there is no such picture</source>
        <translation>dieses Bild gibt es nicht</translation>
    </message>
    <message>
        <source>Check its name</source>
        <translation>Prüfen Sie seinen Namen</translation>
    </message>
</context>
<context>
    <name>Pictures</name>
    <message>
        <source>it cannot be opened</source>
        <translation>lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>%1 x %2 pixels are too many</source>
        <translation>%1 x %2 Pixel sind zu viele</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>nicht gefunden</translation>
    </message>
</context>
<context>
    <name>Relink</name>
    <message>
        <source>%1 of %2 faces are not in the new model: their UVs are lost</source>
        <translation>%1 von %2 Flächen sind nicht im neuen Modell: ihre UVs gehen verloren</translation>
    </message>
    <message>
        <source>new faces without UVs: %1</source>
        <translation>neue Flächen ohne UVs: %1</translation>
    </message>
    <message>
        <source>%1 of %2 cut, joined, painted or straight edges are lost</source>
        <translation>von %2 geschnittenen, verbundenen, bemalten oder geraden Kanten gehen %1 verloren</translation>
    </message>
    <message>
        <source>%1 of %2 pins are lost</source>
        <translation>von %2 Pins gehen %1 verloren</translation>
    </message>
    <message>
        <source>%1 of %2 assignments of faces to rectangles are lost</source>
        <translation>von %2 Zuweisungen von Flächen zu Rechtecken gehen %1 verloren</translation>
    </message>
    <message>
        <source>%1 of %2 faces that are locked, stacked or grouped are lost</source>
        <translation>von %2 gesperrten, gestapelten oder gruppierten Flächen gehen %1 verloren</translation>
    </message>
    <message>
        <source>%1 of %2 faces with a painted texel density are lost</source>
        <translation>von %2 Flächen mit gemalter Texeldichte gehen %1 verloren</translation>
    </message>
    <message>
        <source>tags of which no face is left: %1</source>
        <translation>Namen, von denen keine Fläche übrig ist: %1</translation>
    </message>
    <message>
        <source>%1 of %2 faces are not in the new model</source>
        <translation>%1 von %2 Flächen sind nicht im neuen Modell</translation>
    </message>
    <message>
        <source>new faces with the UVs of the old model&apos;s nearest points: %1</source>
        <translation>neue Flächen mit den UVs der nächsten Punkte des alten Modells: %1</translation>
    </message>
    <message>
        <source>the new model has other units: %1 of its units are one of the old model</source>
        <translation>das neue Modell hat andere Einheiten: %1 seiner Einheiten sind eine des alten Modells</translation>
    </message>
    <message>
        <source>the new model has another axis up: it was turned to be compared</source>
        <translation>beim neuen Modell zeigt eine andere Achse nach oben: Es wurde zum Vergleich gedreht</translation>
    </message>
    <message>
        <source>new faces that lie flat beside the map and are still to be unwrapped: %1</source>
        <translation>neue Flächen, die flach neben der UV-Map liegen und noch abgewickelt werden müssen: %1</translation>
    </message>
</context>
<context>
    <name>SessionLock</name>
    <message>
        <source>%1 on %2 (process %3)</source>
        <translation>%1 auf %2 (Prozess %3)</translation>
    </message>
</context>
<context>
    <name>TextureChannels</name>
    <message>
        <source>Base colour</source>
        <translation>Grundfarbe</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Rauheit</translation>
    </message>
    <message>
        <source>Metalness</source>
        <translation>Metall</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normalen</translation>
    </message>
    <message>
        <source>Occlusion</source>
        <translation>Verdeckung</translation>
    </message>
    <message>
        <source>Emission</source>
        <translation>Leuchten</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
</context>
<context>
    <name>Transfer</name>
    <message>
        <source>centre %1, %2, %3, size %4</source>
        <translation>Mitte %1, %2, %3, Größe %4</translation>
    </message>
    <message>
        <source>there are no UVs to transfer</source>
        <translation>es gibt keine UVs zum Übertragen</translation>
    </message>
    <message>
        <source>Choose a source that has UVs</source>
        <translation>Wählen Sie eine Quelle, die UVs hat</translation>
    </message>
    <message>
        <source>the polygons are not the same, faces of the source: %1, of the model: %2</source>
        <translation>die Polygone sind nicht gleich, Flächen der Quelle: %1, des Modells: %2</translation>
    </message>
    <message>
        <source>Match by position</source>
        <translation>Ordnen Sie nach der Lage zu</translation>
    </message>
    <message>
        <source>the models do not lie in one place: the source has its %1, the model its %2</source>
        <translation>die Modelle liegen nicht an einer Stelle: die Quelle hat %1, das Modell %2</translation>
    </message>
    <message>
        <source>Save both at the same place, in the same units</source>
        <translation>Speichern Sie beide an derselben Stelle, in denselben Einheiten</translation>
    </message>
    <message>
        <source>no face is to get UVs</source>
        <translation>keine Fläche soll UVs bekommen</translation>
    </message>
    <message>
        <source>Choose another part of the model, or unlock its islands</source>
        <translation>Wählen Sie einen anderen Teil des Modells, oder entsperren Sie seine Inseln</translation>
    </message>
    <message>
        <source>%1 of %2 faces are the same</source>
        <translation>%1 von %2 Flächen sind gleich</translation>
    </message>
    <message>
        <source>%1 of %2 faces matched by position, mean distance %3, largest %4</source>
        <translation>%1 von %2 Flächen nach der Lage zugeordnet, mittlere Entfernung %3, größte %4</translation>
    </message>
    <message>
        <source>the seams are %1 times as long as in the source</source>
        <translation>die Nähte sind %1-mal so lang wie in der Quelle</translation>
    </message>
    <message>
        <source>%1 of %2 faces are too far from the source, or it has no UVs there: they keep what they had</source>
        <translation>%1 von %2 Flächen sind zu weit von der Quelle, oder sie hat dort keine UVs: sie behalten, was sie hatten</translation>
    </message>
    <message>
        <source>the source lies elsewhere: it was moved onto the model to match it</source>
        <translation>die Quelle liegt woanders: zum Zuordnen wurde sie auf das Modell verschoben</translation>
    </message>
    <message>
        <source>the surfaces are %1 % of the model&apos;s size apart: are both in the same place and pose?</source>
        <translation>die Oberflächen liegen um %1 % der Größe des Modells auseinander: haben beide dieselbe Stelle und Haltung?</translation>
    </message>
    <message>
        <source>triangles turned over in the map: %1; Finish mends them, but lays the map out anew</source>
        <translation>in der Map umgedrehte Dreiecke: %1; Fertigstellen behebt sie, ordnet die Map aber neu an</translation>
    </message>
    <message>
        <source>triangles with hardly any area in the map: %1; Finish mends them, but lays the map out anew</source>
        <translation>Dreiecke mit kaum Flächeninhalt in der Map: %1; Fertigstellen behebt sie, ordnet die Map aber neu an</translation>
    </message>
    <message>
        <source>the source has other units: it was taken %1 times as large</source>
        <translation>die Quelle hat andere Einheiten: Sie wurde %1-mal so groß genommen</translation>
    </message>
    <message>
        <source>the source has another axis up: it was turned to match</source>
        <translation>bei der Quelle zeigt eine andere Achse nach oben: Sie wurde passend gedreht</translation>
    </message>
</context>
<context>
    <name>UndoText</name>
    <message>
        <source>Change lambda</source>
        <translation>Lambda ändern</translation>
    </message>
    <message>
        <source>Change delta</source>
        <translation>Delta ändern</translation>
    </message>
    <message>
        <source>Change rectangle weight</source>
        <translation>Gewicht der Rechtecke ändern</translation>
    </message>
    <message>
        <source>Change distortion energy</source>
        <translation>Verzerrungsenergie ändern</translation>
    </message>
    <message>
        <source>Change seam weighting</source>
        <translation>Nahtgewichtung ändern</translation>
    </message>
    <message>
        <source>Change start</source>
        <translation>Start ändern</translation>
    </message>
    <message>
        <source>Change solver</source>
        <translation>Solver ändern</translation>
    </message>
    <message>
        <source>Change seed</source>
        <translation>Startwert ändern</translation>
    </message>
    <message>
        <source>Change seams on creases</source>
        <translation>Nähte an Knicken ändern</translation>
    </message>
    <message>
        <source>Change weight of creases</source>
        <translation>Gewicht der Knicke ändern</translation>
    </message>
    <message>
        <source>Change hiding of seams</source>
        <translation>Verstecken der Nähte ändern</translation>
    </message>
    <message>
        <source>Change symmetry of cuts</source>
        <translation>Symmetrie der Schnitte ändern</translation>
    </message>
    <message>
        <source>Change whose seams</source>
        <translation>Herkunft der Nähte ändern</translation>
    </message>
    <message>
        <source>Change sources of given seams</source>
        <translation>Quellen der vorgegebenen Nähte ändern</translation>
    </message>
    <message>
        <source>Change angle of sharp edges</source>
        <translation>Winkel scharfer Kanten ändern</translation>
    </message>
    <message>
        <source>Change alignment to the axes</source>
        <translation>Ausrichtung an den Achsen ändern</translation>
    </message>
    <message>
        <source>Change mirrored maps</source>
        <translation>Gespiegelte Maps ändern</translation>
    </message>
    <message>
        <source>Change what is up in the map</source>
        <translation>Oben in der Map ändern</translation>
    </message>
    <message>
        <source>Change distortion budget</source>
        <translation>Verzerrungsbudget ändern</translation>
    </message>
    <message>
        <source>Change texture size</source>
        <translation>Texturgröße ändern</translation>
    </message>
    <message>
        <source>Change margin</source>
        <translation>Abstand ändern</translation>
    </message>
    <message>
        <source>Change UDIM tile</source>
        <translation>UDIM-Kachel ändern</translation>
    </message>
    <message>
        <source>Change rotation of islands</source>
        <translation>Drehung der Inseln ändern</translation>
    </message>
    <message>
        <source>Change keep scale</source>
        <translation>Größe behalten ändern</translation>
    </message>
    <message>
        <source>Change border of the tile</source>
        <translation>Rand der Kachel ändern</translation>
    </message>
    <message>
        <source>Change packing effort</source>
        <translation>Packaufwand ändern</translation>
    </message>
    <message>
        <source>Change settings</source>
        <translation>Einstellungen ändern</translation>
    </message>
    <message numerus="yes">
        <source>Rip %n edges</source>
        <translation>
            <numerusform>%n Kante auftrennen</numerusform>
            <numerusform>%n Kanten auftrennen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Stitch %n edges</source>
        <translation>
            <numerusform>%n Kante vernähen</numerusform>
            <numerusform>%n Kanten vernähen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Pin %n corners</source>
        <translation>
            <numerusform>%n Ecke pinnen</numerusform>
            <numerusform>%n Ecken pinnen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Unpin %n corners</source>
        <translation>
            <numerusform>%n Ecke lösen</numerusform>
            <numerusform>%n Ecken lösen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move %n pins</source>
        <translation>
            <numerusform>%n Pin verschieben</numerusform>
            <numerusform>%n Pins verschieben</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Change %n pins</source>
        <translation>
            <numerusform>%n Pin ändern</numerusform>
            <numerusform>%n Pins ändern</numerusform>
        </translation>
    </message>
    <message>
        <source>Add rectangle</source>
        <translation>Rechteck hinzufügen</translation>
    </message>
    <message numerus="yes">
        <source>Remove %n rectangles</source>
        <translation>
            <numerusform>Rechteck entfernen</numerusform>
            <numerusform>%n Rechtecke entfernen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move %n rectangles</source>
        <translation>
            <numerusform>Rechteck verschieben</numerusform>
            <numerusform>%n Rechtecke verschieben</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Resize %n rectangles</source>
        <translation>
            <numerusform>Größe des Rechtecks ändern</numerusform>
            <numerusform>Größe von %n Rechtecken ändern</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Assign faces to %n rectangles</source>
        <translation>
            <numerusform>Rechteck Flächen zuweisen</numerusform>
            <numerusform>%n Rechtecken Flächen zuweisen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Rename %n rectangles</source>
        <translation>
            <numerusform>Rechteck umbenennen</numerusform>
            <numerusform>%n Rechtecke umbenennen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Recolor %n rectangles</source>
        <translation>
            <numerusform>Rechteck umfärben</numerusform>
            <numerusform>%n Rechtecke umfärben</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Change %n rectangles</source>
        <translation>
            <numerusform>Rechteck ändern</numerusform>
            <numerusform>%n Rechtecke ändern</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose UV set</source>
        <translation>UV-Satz wählen</translation>
    </message>
    <message>
        <source>Add UV set</source>
        <translation>UV-Satz hinzufügen</translation>
    </message>
    <message>
        <source>Rename UV set</source>
        <translation>UV-Satz umbenennen</translation>
    </message>
    <message>
        <source>Delete UV set</source>
        <translation>UV-Satz löschen</translation>
    </message>
    <message>
        <source>Show all faces</source>
        <translation>Alle Flächen zeigen</translation>
    </message>
    <message>
        <source>Hide other faces</source>
        <translation>Andere Flächen ausblenden</translation>
    </message>
    <message numerus="yes">
        <source>Hide %n faces</source>
        <translation>
            <numerusform>%n Fläche ausblenden</numerusform>
            <numerusform>%n Flächen ausblenden</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Show %n faces</source>
        <translation>
            <numerusform>%n Fläche zeigen</numerusform>
            <numerusform>%n Flächen zeigen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Keep %n edges straight</source>
        <translation>
            <numerusform>%n Kante gerade halten</numerusform>
            <numerusform>%n Kanten gerade halten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Release %n straight edges</source>
        <translation>
            <numerusform>%n gerade Kante freigeben</numerusform>
            <numerusform>%n gerade Kanten freigeben</numerusform>
        </translation>
    </message>
    <message>
        <source>Re-link to %1</source>
        <translation>Mit %1 neu verknüpfen</translation>
    </message>
    <message>
        <source>Reset seams</source>
        <translation>Nähte zurücksetzen</translation>
    </message>
    <message>
        <source>Reset painted weights</source>
        <translation>Gemalte Gewichte zurücksetzen</translation>
    </message>
    <message>
        <source>Release all straight edges</source>
        <translation>Alle geraden Kanten freigeben</translation>
    </message>
    <message>
        <source>Remove all pins</source>
        <translation>Alle Pins entfernen</translation>
    </message>
    <message>
        <source>Remove all rectangles</source>
        <translation>Alle Rechtecke entfernen</translation>
    </message>
    <message>
        <source>Reset texel density weights</source>
        <translation>Gewichte der Texeldichte zurücksetzen</translation>
    </message>
    <message>
        <source>Reset island marks</source>
        <translation>Inselmarken zurücksetzen</translation>
    </message>
    <message>
        <source>Reset settings</source>
        <translation>Einstellungen zurücksetzen</translation>
    </message>
    <message>
        <source>Clear UVs</source>
        <translation>UVs löschen</translation>
    </message>
    <message>
        <source>Reset steering</source>
        <translation>Vorgaben zurücksetzen</translation>
    </message>
    <message>
        <source>Reset everything</source>
        <translation>Alles zurücksetzen</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message numerus="yes">
        <source>Lock %n islands</source>
        <translation>
            <numerusform>%n Insel sperren</numerusform>
            <numerusform>%n Inseln sperren</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Unlock %n islands</source>
        <translation>
            <numerusform>%n Insel entsperren</numerusform>
            <numerusform>%n Inseln entsperren</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Stack %n islands</source>
        <translation>
            <numerusform>%n Insel stapeln</numerusform>
            <numerusform>%n Inseln stapeln</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Unstack %n islands</source>
        <translation>
            <numerusform>%n Insel aus dem Stapel nehmen</numerusform>
            <numerusform>%n Inseln aus dem Stapel nehmen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Group %n islands</source>
        <translation>
            <numerusform>%n Insel gruppieren</numerusform>
            <numerusform>%n Inseln gruppieren</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Ungroup %n islands</source>
        <translation>
            <numerusform>%n Insel aus der Gruppe nehmen</numerusform>
            <numerusform>%n Inseln aus der Gruppe nehmen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Keep orientation of %n islands</source>
        <translation>
            <numerusform>Ausrichtung von %n Insel behalten</numerusform>
            <numerusform>Ausrichtung von %n Inseln behalten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Free orientation of %n islands</source>
        <translation>
            <numerusform>Ausrichtung von %n Insel freigeben</numerusform>
            <numerusform>Ausrichtung von %n Inseln freigeben</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Clear flags of %n islands</source>
        <translation>
            <numerusform>Marken von %n Insel löschen</numerusform>
            <numerusform>Marken von %n Inseln löschen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Tag %n islands</source>
        <translation>
            <numerusform>%n Insel markieren</numerusform>
            <numerusform>%n Inseln markieren</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Untag %n islands</source>
        <translation>
            <numerusform>Markierung von %n Insel entfernen</numerusform>
            <numerusform>Markierung von %n Inseln entfernen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Cut %n edges</source>
        <translation>
            <numerusform>%n Kante schneiden</numerusform>
            <numerusform>%n Kanten schneiden</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Join %n edges</source>
        <translation>
            <numerusform>%n Kante verbinden</numerusform>
            <numerusform>%n Kanten verbinden</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Clear %n edges</source>
        <translation>
            <numerusform>%n Kante freigeben</numerusform>
            <numerusform>%n Kanten freigeben</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Paint %n edges</source>
        <translation>
            <numerusform>%n Kante bemalen</numerusform>
            <numerusform>%n Kanten bemalen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Texel density weight of %n faces</source>
        <translation>
            <numerusform>Gewicht der Texeldichte von %n Fläche</numerusform>
            <numerusform>Gewicht der Texeldichte von %n Flächen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move %n islands</source>
        <translation>
            <numerusform>%n Insel verschieben</numerusform>
            <numerusform>%n Inseln verschieben</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Rotate %n islands</source>
        <translation>
            <numerusform>%n Insel drehen</numerusform>
            <numerusform>%n Inseln drehen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Scale %n islands</source>
        <translation>
            <numerusform>%n Insel skalieren</numerusform>
            <numerusform>%n Inseln skalieren</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Drag %n vertices</source>
        <translation>
            <numerusform>%n Vertex ziehen</numerusform>
            <numerusform>%n Vertices ziehen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Pack %n islands</source>
        <translation>
            <numerusform>%n Insel packen</numerusform>
            <numerusform>%n Inseln packen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Align %n islands</source>
        <translation>
            <numerusform>%n Insel ausrichten</numerusform>
            <numerusform>%n Inseln ausrichten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Distribute %n islands</source>
        <translation>
            <numerusform>%n Insel verteilen</numerusform>
            <numerusform>%n Inseln verteilen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Mirror %n islands</source>
        <translation>
            <numerusform>%n Insel spiegeln</numerusform>
            <numerusform>%n Inseln spiegeln</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Orient %n islands</source>
        <translation>
            <numerusform>Lage von %n Insel ausrichten</numerusform>
            <numerusform>Lage von %n Inseln ausrichten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Randomise %n islands</source>
        <translation>
            <numerusform>%n Insel zufällig anordnen</numerusform>
            <numerusform>%n Inseln zufällig anordnen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Straighten %n chains of edges</source>
        <translation>
            <numerusform>%n Kantenkette begradigen</numerusform>
            <numerusform>%n Kantenketten begradigen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Relax %n faces</source>
        <translation>
            <numerusform>%n Fläche entspannen</numerusform>
            <numerusform>%n Flächen entspannen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Align %n islands to the axes</source>
        <translation>
            <numerusform>%n Insel an den Achsen ausrichten</numerusform>
            <numerusform>%n Inseln an den Achsen ausrichten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Straighten %n faces to a grid</source>
        <translation>
            <numerusform>%n Fläche zu einem Raster begradigen</numerusform>
            <numerusform>%n Flächen zu einem Raster begradigen</numerusform>
        </translation>
    </message>
    <message>
        <source>Solve</source>
        <translation>Berechnen</translation>
    </message>
    <message>
        <source>Unwrap</source>
        <translation>Abwickeln</translation>
    </message>
    <message>
        <source>Finish map</source>
        <translation>Map fertigstellen</translation>
    </message>
    <message>
        <source>Separate overlaps</source>
        <translation>Überlappungen trennen</translation>
    </message>
    <message>
        <source>Relax with a brush</source>
        <translation>Mit dem Pinsel entspannen</translation>
    </message>
    <message>
        <source>Pinch</source>
        <translation>Zusammenziehen</translation>
    </message>
    <message>
        <source>Grab</source>
        <translation>Greifen</translation>
    </message>
    <message>
        <source>Transfer UVs</source>
        <translation>UVs übertragen</translation>
    </message>
    <message>
        <source>Remove all chosen textures</source>
        <translation>Alle gewählten Texturen entfernen</translation>
    </message>
    <message numerus="yes">
        <source>Add %n textures</source>
        <translation>
            <numerusform>%n Textur hinzufügen</numerusform>
            <numerusform>%n Texturen hinzufügen</numerusform>
        </translation>
    </message>
    <message>
        <source>Change textures</source>
        <translation>Texturen ändern</translation>
    </message>
    <message>
        <source>Carry textures over</source>
        <translation>Texturen übertragen</translation>
    </message>
    <message>
        <source>Change shape of flat faces</source>
        <translation>Form ebener Flächen ändern</translation>
    </message>
    <message>
        <source>Change what the model is like</source>
        <translation>Art des Modells ändern</translation>
    </message>
    <message>
        <source>Change cuts of alike parts</source>
        <translation>Schnitte gleicher Teile ändern</translation>
    </message>
    <message>
        <source>Unwrap selection</source>
        <translation>Auswahl abwickeln</translation>
    </message>
    <message>
        <source>Finish selection</source>
        <translation>Auswahl fertigstellen</translation>
    </message>
    <message numerus="yes">
        <source>Tear %n edges</source>
        <translation>
            <numerusform>%n Kante aufreißen</numerusform>
            <numerusform>%n Kanten aufreißen</numerusform>
        </translation>
    </message>
    <message>
        <source>Make meshes unique</source>
        <translation>Meshes eigenständig machen</translation>
    </message>
    <message>
        <source>Bake</source>
        <translation>Backen</translation>
    </message>
</context>
<context>
    <name>autocuts::AboutDialog</name>
    <message>
        <source>window and drawing</source>
        <translation>Fenster und Zeichnen</translation>
    </message>
    <message>
        <source>linear algebra</source>
        <translation>lineare Algebra</translation>
    </message>
    <message>
        <source>dense linear algebra</source>
        <translation>dicht besetzte lineare Algebra</translation>
    </message>
    <message>
        <source>sparse solver</source>
        <translation>Solver für dünn besetzte Systeme</translation>
    </message>
    <message>
        <source>mesh formats besides OBJ</source>
        <translation>Meshformate außer OBJ</translation>
    </message>
    <message>
        <source>compression of sessions</source>
        <translation>Kompression der Sitzungen</translation>
    </message>
    <message>
        <source>UV maps with distortion and cuts optimised together.</source>
        <translation>UV-Maps, deren Verzerrung und Schnitte gemeinsam optimiert werden.</translation>
    </message>
    <message>
        <source>After &lt;i&gt;Autocuts: Simultaneous Distortion and Cut Optimization for UV Mapping&lt;/i&gt; by R. Poranne, M. Tarini, S. Huber, D. Panozzo and O. Sorkine-Hornung, SIGGRAPH Asia 2017.</source>
        <translation>Nach &lt;i&gt;Autocuts: Simultaneous Distortion and Cut Optimization for UV Mapping&lt;/i&gt; von R. Poranne, M. Tarini, S. Huber, D. Panozzo und O. Sorkine-Hornung, SIGGRAPH Asia 2017.</translation>
    </message>
    <message>
        <source>Free software under the &lt;a href=&apos;https://www.gnu.org/licenses/gpl-3.0.html&apos;&gt;GNU General Public License&lt;/a&gt;, version 3 or later. It comes without any warranty.</source>
        <translation>Freie Software unter der &lt;a href=&apos;https://www.gnu.org/licenses/gpl-3.0.html&apos;&gt;GNU General Public License&lt;/a&gt;, Version 3 oder später. Sie kommt ohne jede Gewährleistung.</translation>
    </message>
    <message>
        <source>About Autocuts</source>
        <translation>Über Autocuts</translation>
    </message>
</context>
<context>
    <name>autocuts::ActionPalette</name>
    <message>
        <source>Find action</source>
        <translation>Aktion suchen</translation>
    </message>
    <message>
        <source>Words of an action&apos;s name or menu</source>
        <translation>Wörter aus dem Namen oder dem Menü einer Aktion</translation>
    </message>
    <message>
        <source>No action has all of these words in its name or menu</source>
        <translation>Keine Aktion hat all diese Wörter in ihrem Namen oder Menü</translation>
    </message>
</context>
<context>
    <name>autocuts::AlbedoForm</name>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Colour of the surface</source>
        <translation>Farbe der Oberfläche</translation>
    </message>
    <message>
        <source>The colours of the model</source>
        <translation>Die Farben des Modells</translation>
    </message>
    <message>
        <source>One colour</source>
        <translation>Eine Farbe</translation>
    </message>
    <message>
        <source>A picture</source>
        <translation>Ein Bild</translation>
    </message>
    <message>
        <source>What the surface reflects; the colours of the model are those of its textures, else of its vertices or materials</source>
        <translation>Was die Oberfläche zurückwirft; die Farben des Modells sind die seiner Texturen, sonst die seiner Punkte oder Materialien</translation>
    </message>
    <message>
        <source>Brow&amp;se...</source>
        <translation>Dur&amp;chsuchen...</translation>
    </message>
    <message>
        <source>That of the light map</source>
        <translation>Der der Light-Map</translation>
    </message>
    <message>
        <source>&amp;Reflects:</source>
        <translation>&amp;Reflektiert:</translation>
    </message>
    <message>
        <source>Colour:</source>
        <translation>Farbe:</translation>
    </message>
    <message>
        <source>Picture:</source>
        <translation>Bild:</translation>
    </message>
    <message>
        <source>For the UV set:</source>
        <translation>Für den UV-Satz:</translation>
    </message>
    <message>
        <source>Choose the picture of the surface&apos;s colours.</source>
        <translation>Wählen Sie das Bild mit den Farben der Oberfläche.</translation>
    </message>
    <message>
        <source>Picture of the surface&apos;s colours</source>
        <translation>Bild mit den Farben der Oberfläche</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Bilder (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>autocuts::BakeDialog</name>
    <message>
        <source>Normals (tangent space)</source>
        <translation>Normalen (Tangentenraum)</translation>
    </message>
    <message>
        <source>MikkTSpace, as Blender and game engines use it</source>
        <translation>MikkTSpace, wie in Blender und Spiele-Engines</translation>
    </message>
    <message>
        <source>Normals (object space)</source>
        <translation>Normalen (Objektraum)</translation>
    </message>
    <message>
        <source>Ambient occlusion</source>
        <translation>Umgebungsverdeckung</translation>
    </message>
    <message>
        <source>Bent normals</source>
        <translation>Gebogene Normalen</translation>
    </message>
    <message>
        <source>The mean direction from which light arrives</source>
        <translation>Die mittlere Richtung, aus der Licht kommt</translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation>Krümmung</translation>
    </message>
    <message>
        <source>Bright on edges, dark in grooves</source>
        <translation>Hell an Kanten, dunkel in Rillen</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Material ID</source>
        <translation>Material-ID</translation>
    </message>
    <message>
        <source>A colour for each material</source>
        <translation>Eine Farbe für jedes Material</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Of the detailed model above this one</source>
        <translation>Des detaillierten Modells über diesem</translation>
    </message>
    <message>
        <source>&amp;Objects see those of the same name only</source>
        <translation>&amp;Objekte sehen nur solche mit gleichem Namen</translation>
    </message>
    <message>
        <source>Green points &amp;down (DirectX)</source>
        <translation>Grün zeigt nach &amp;unten (DirectX)</translation>
    </message>
    <message>
        <source>Bake</source>
        <translation>Backen</translation>
    </message>
    <message>
        <source>&amp;Browse...</source>
        <translation>&amp;Durchsuchen...</translation>
    </message>
    <message>
        <source>None: this model itself</source>
        <translation>Keines: dieses Modell selbst</translation>
    </message>
    <message>
        <source>Places in each texel that are baked and averaged</source>
        <translation>Stellen in jedem Texel, die gebacken und gemittelt werden</translation>
    </message>
    <message>
        <source>For occlusion, bent normals, curvature and thickness, in each texel</source>
        <translation>Für Verdeckung, gebogene Normalen, Krümmung und Dicke, in jedem Texel</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>How far the detailed model is looked for, outside and inside of the surface; 100 % is the diagonal of the model</source>
        <translation>Wie weit nach dem detaillierten Modell gesucht wird, außerhalb und innerhalb der Fläche; 100 % ist die Diagonale des Modells</translation>
    </message>
    <message>
        <source>Smooth: no gaps at edges</source>
        <translation>Glatt: keine Lücken an Kanten</translation>
    </message>
    <message>
        <source>Along the shading normals</source>
        <translation>Entlang der Normalen der Schattierung</translation>
    </message>
    <message>
        <source>Smooth at edges, straight elsewhere</source>
        <translation>Glatt an Kanten, sonst gerade</translation>
    </message>
    <message>
        <source>In which direction the detailed model is looked for</source>
        <translation>In welcher Richtung nach dem detaillierten Modell gesucht wird</translation>
    </message>
    <message>
        <source>Endings such as _low and _high do not count</source>
        <translation>Endungen wie _low und _high zählen nicht</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Texels around islands that are filled with the nearest value</source>
        <translation>Texel um die Inseln, die mit dem nächsten Wert gefüllt werden</translation>
    </message>
    <message>
        <source>%1, %2 bits</source>
        <translation>%1, %2 Bit</translation>
    </message>
    <message>
        <source>Ba&amp;ke</source>
        <translation>&amp;Backen</translation>
    </message>
    <message>
        <source>Show li&amp;ve</source>
        <translation>&amp;Live zeigen</translation>
    </message>
    <message>
        <source>Show the first chosen map in both views, also while the UVs change; no files are written</source>
        <translation>Die erste gewählte Karte in beiden Ansichten zeigen, auch während sich die UVs ändern; es werden keine Dateien geschrieben</translation>
    </message>
    <message>
        <source>De&amp;tailed model:</source>
        <translation>De&amp;tailliertes Modell:</translation>
    </message>
    <message>
        <source>&amp;Maps:</source>
        <translation>&amp;Karten:</translation>
    </message>
    <message>
        <source>Sam&amp;ples per texel:</source>
        <translation>&amp;Proben pro Texel:</translation>
    </message>
    <message>
        <source>Ra&amp;ys per texel:</source>
        <translation>St&amp;rahlen pro Texel:</translation>
    </message>
    <message>
        <source>C&amp;age:</source>
        <translation>Kä&amp;fig:</translation>
    </message>
    <message>
        <source>D&amp;irection:</source>
        <translation>R&amp;ichtung:</translation>
    </message>
    <message>
        <source>Di&amp;lation:</source>
        <translation>R&amp;and:</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>For&amp;mat:</translation>
    </message>
    <message>
        <source>Detailed model</source>
        <translation>Detailliertes Modell</translation>
    </message>
    <message>
        <source>Folder for the pictures</source>
        <translation>Ordner für die Bilder</translation>
    </message>
    <message>
        <source>There is no such detailed model.</source>
        <translation>Das detaillierte Modell gibt es nicht.</translation>
    </message>
    <message>
        <source>Choose at least one map.</source>
        <translation>Mindestens eine Karte wählen.</translation>
    </message>
    <message>
        <source>The model has no UVs: unwrap it first.</source>
        <translation>Das Modell hat keine UVs: zuerst abwickeln.</translation>
    </message>
    <message>
        <source>Choose a folder for the pictures.</source>
        <translation>Einen Ordner für die Bilder wählen.</translation>
    </message>
    <message>
        <source>The folder cannot be written.</source>
        <translation>In den Ordner kann nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>Fold&amp;er:</source>
        <translation>Ord&amp;ner:</translation>
    </message>
    <message>
        <source>From textures where there are any, else vertex colours, else the colours of materials</source>
        <translation>Aus Texturen, wo es welche gibt, sonst Vertexfarben, sonst die Farben der Materialien</translation>
    </message>
    <message>
        <source>Width of the pictures; at first that of the texture in the Packing panel, whose proportions they have</source>
        <translation>Breite der Bilder; zunächst die der Textur im Bereich Packen, deren Seitenverhältnis sie haben</translation>
    </message>
    <message>
        <source>Si&amp;ze:</source>
        <translation>Gr&amp;öße:</translation>
    </message>
    <message>
        <source>Bro&amp;wse...</source>
        <translation>Durch&amp;suchen...</translation>
    </message>
    <message>
        <source>Show &amp;normals, occlusion and colours on the model</source>
        <translation>Normalen, Verdeckung und Farben am Modell &amp;zeigen</translation>
    </message>
    <message>
        <source>The pictures become textures of the materials, shown in light; this can be undone</source>
        <translation>Die Bilder werden Texturen der Materialien und im Licht gezeigt; das lässt sich rückgängig machen</translation>
    </message>
    <message>
        <source>Models and maps</source>
        <translation>Modelle und Karten</translation>
    </message>
    <message>
        <source>Brow&amp;se...</source>
        <translation>Dur&amp;chsuchen...</translation>
    </message>
    <message>
        <source>Propose</source>
        <translation>Vorschlagen</translation>
    </message>
    <message>
        <source>None: by distance</source>
        <translation>Keine: nach dem Abstand</translation>
    </message>
    <message>
        <source>This model with its vertices moved outwards; rays run from there through the surface</source>
        <translation>Dieses Modell mit nach außen verschobenen Punkten; von dort laufen Strahlen durch die Oberfläche</translation>
    </message>
    <message>
        <source>Ca&amp;ge file:</source>
        <translation>Käfi&amp;g-Datei:</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>What is farther away casts no occlusion; 100 % is the diagonal of the model</source>
        <translation>Was weiter weg ist, verdeckt nichts; 100 % ist die Diagonale des Modells</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>Size of what shows as curvature; 100 % is the diagonal of the model</source>
        <translation>Größe dessen, was als Krümmung erscheint; 100 % ist die Diagonale des Modells</translation>
    </message>
    <message>
        <source>Thickness that is white; 100 % is the diagonal of the model</source>
        <translation>Dicke, die weiß ist; 100 % ist die Diagonale des Modells</translation>
    </message>
    <message>
        <source>What the model has</source>
        <translation>Was das Modell hat</translation>
    </message>
    <message>
        <source>Textures</source>
        <translation>Texturen</translation>
    </message>
    <message>
        <source>Vertex colours</source>
        <translation>Vertexfarben</translation>
    </message>
    <message>
        <source>Colours of materials</source>
        <translation>Farben der Materialien</translation>
    </message>
    <message>
        <source>Where the colours of the map of colours come from</source>
        <translation>Woher die Farben der Farbkarte kommen</translation>
    </message>
    <message>
        <source>Occl&amp;usion reaches:</source>
        <translation>&amp;Verdeckung reicht:</translation>
    </message>
    <message>
        <source>&amp;Curvature radius:</source>
        <translation>Radius d&amp;er Krümmung:</translation>
    </message>
    <message>
        <source>T&amp;hickness limit:</source>
        <translation>&amp;Höchste Dicke:</translation>
    </message>
    <message>
        <source>Colou&amp;rs from:</source>
        <translation>&amp;Woher die Farben:</translation>
    </message>
    <message>
        <source>Cage</source>
        <translation>Käfig</translation>
    </message>
    <message>
        <source>Measuring how far the models are apart...</source>
        <translation>Misst, wie weit die Modelle auseinander sind...</translation>
    </message>
    <message>
        <source>There is no such cage.</source>
        <translation>Diesen Käfig gibt es nicht.</translation>
    </message>
    <message>
        <source>The cage file says how far rays go</source>
        <translation>Die Käfig-Datei sagt, wie weit Strahlen reichen</translation>
    </message>
    <message>
        <source>Only measured for a model in a file</source>
        <translation>Wird nur für ein Modell in einer Datei gemessen</translation>
    </message>
    <message>
        <source>Choose a detailed model first</source>
        <translation>Zuerst ein detailliertes Modell wählen</translation>
    </message>
    <message>
        <source>Measure how far the models are apart, and take that and half as much again; done for each bake where no distance is typed</source>
        <translation>Misst, wie weit die Modelle auseinanderliegen, und nimmt das und die Hälfte dazu; geschieht bei jedem Backen, für das kein Abstand eingegeben ist</translation>
    </message>
    <message>
        <source>Occlusion has no cage: it is that of this model by itself</source>
        <translation>Verdeckung hat keinen Käfig: Sie ist die dieses Modells für sich allein</translation>
    </message>
    <message>
        <source>Proposed, from the distance of both models</source>
        <translation>Vorgeschlagen, aus dem Abstand beider Modelle</translation>
    </message>
</context>
<context>
    <name>autocuts::Canvas</name>
    <message>
        <source>The graphics driver does not offer OpenGL 3.3.</source>
        <translation>Der Grafiktreiber bietet kein OpenGL 3.3.</translation>
    </message>
    <message>
        <source>No 3D graphics</source>
        <translation>Keine 3D-Grafik</translation>
    </message>
</context>
<context>
    <name>autocuts::CarryDialog</name>
    <message>
        <source>Base colour</source>
        <translation>Grundfarbe</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Rauheit</translation>
    </message>
    <message>
        <source>Metalness</source>
        <translation>Metall</translation>
    </message>
    <message>
        <source>Normals</source>
        <translation>Normalen</translation>
    </message>
    <message>
        <source>Occlusion</source>
        <translation>Verdeckung</translation>
    </message>
    <message>
        <source>Emission</source>
        <translation>Leuchten</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>No material</source>
        <translation>Kein Material</translation>
    </message>
    <message>
        <source>Carry textures over</source>
        <translation>Texturen übertragen</translation>
    </message>
    <message>
        <source>Goes to the end of the names, so that the old pictures stay</source>
        <translation>Kommt an das Ende der Namen, damit die alten Bilder bleiben</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Texels around islands that are filled with the nearest value</source>
        <translation>Texel um die Inseln, die mit dem nächsten Wert gefüllt werden</translation>
    </message>
    <message>
        <source>The map they were made for</source>
        <translation>Die UV-Map, für die sie gemacht sind</translation>
    </message>
    <message>
        <source>The map as it was when the model was opened, the first textures were chosen, or they were last carried over</source>
        <translation>Die UV-Map, wie sie war, als das Modell geöffnet, die ersten Texturen gewählt oder sie zuletzt übertragen wurden</translation>
    </message>
    <message>
        <source>Another UV set</source>
        <translation>Ein anderer UV-Satz</translation>
    </message>
    <message>
        <source>The map of a file</source>
        <translation>Die UV-Map einer Datei</translation>
    </message>
    <message>
        <source>For which map the textures are as they are now</source>
        <translation>Zu welcher UV-Map die Texturen passen, wie sie jetzt sind</translation>
    </message>
    <message>
        <source>As the old pictures</source>
        <translation>Wie die alten Bilder</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>JPEG pictures become PNG: they would lose by being compressed again</source>
        <translation>JPEG-Bilder werden PNG: sie würden verlieren, wenn man sie noch einmal komprimiert</translation>
    </message>
    <message>
        <source>&amp;Browse...</source>
        <translation>D&amp;urchsuchen...</translation>
    </message>
    <message>
        <source>B&amp;rowse...</source>
        <translation>Durch&amp;suchen...</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Shown as</source>
        <translation>Gezeigt als</translation>
    </message>
    <message>
        <source>Old picture</source>
        <translation>Altes Bild</translation>
    </message>
    <message>
        <source>New file</source>
        <translation>Neue Datei</translation>
    </message>
    <message>
        <source>&amp;Carry over</source>
        <translation>Ü&amp;bertragen</translation>
    </message>
    <message>
        <source>Textures &amp;fit:</source>
        <translation>Texturen &amp;passen zu:</translation>
    </message>
    <message>
        <source>UV &amp;set:</source>
        <translation>U&amp;V-Satz:</translation>
    </message>
    <message>
        <source>F&amp;ile:</source>
        <translation>&amp;Datei:</translation>
    </message>
    <message>
        <source>Fold&amp;er:</source>
        <translation>Ord&amp;ner:</translation>
    </message>
    <message>
        <source>Si&amp;ze:</source>
        <translation>&amp;Größe:</translation>
    </message>
    <message>
        <source>For&amp;mat:</source>
        <translation>For&amp;mat:</translation>
    </message>
    <message>
        <source>Di&amp;lation:</source>
        <translation>R&amp;and:</translation>
    </message>
    <message>
        <source>Model with the map of the textures</source>
        <translation>Modell mit der UV-Map der Texturen</translation>
    </message>
    <message>
        <source>Folder for the pictures</source>
        <translation>Ordner für die Bilder</translation>
    </message>
    <message numerus="yes">
        <source>%n of the new files exist already and would be replaced.</source>
        <translation>
            <numerusform>%n der neuen Dateien gibt es schon; sie würde ersetzt.</numerusform>
            <numerusform>%n der neuen Dateien gibt es schon; sie würden ersetzt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Pictures that are not there stay as they are: %1.</source>
        <translation>Bilder, die nicht da sind, bleiben, wie sie sind: %1.</translation>
    </message>
    <message>
        <source>in the model&apos;s file</source>
        <translation>in der Datei des Modells</translation>
    </message>
    <message>
        <source>not there</source>
        <translation>nicht da</translation>
    </message>
    <message>
        <source>The model has no UVs: unwrap it first.</source>
        <translation>Das Modell hat keine UVs: zuerst abwickeln.</translation>
    </message>
    <message>
        <source>There is no such file.</source>
        <translation>Diese Datei gibt es nicht.</translation>
    </message>
    <message>
        <source>The model has no textures: choose some in the Textures panel.</source>
        <translation>Das Modell hat keine Texturen: im Bedienfeld Texturen welche wählen.</translation>
    </message>
    <message>
        <source>The textures are not there: %1.</source>
        <translation>Die Texturen sind nicht da: %1.</translation>
    </message>
    <message>
        <source>Choose a folder for the pictures.</source>
        <translation>Einen Ordner für die Bilder wählen.</translation>
    </message>
    <message>
        <source>The folder cannot be written.</source>
        <translation>In den Ordner kann nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>The ending has a sign that names of files cannot have.</source>
        <translation>Die Endung hat ein Zeichen, das in Namen von Dateien nicht erlaubt ist.</translation>
    </message>
    <message>
        <source>%1 would overwrite the picture it is made from: choose another ending or folder.</source>
        <translation>%1 würde das Bild überschreiben, aus dem es gemacht wird: eine andere Endung oder einen anderen Ordner wählen.</translation>
    </message>
    <message>
        <source>E&amp;nding of names:</source>
        <translation>&amp;Endung der Namen:</translation>
    </message>
</context>
<context>
    <name>autocuts::ConvergenceGraph</name>
    <message>
        <source>Convergence</source>
        <translation>Konvergenz</translation>
    </message>
    <message>
        <source>Distortion D (left axis) and separation S (right axis) of every iteration, or of every definite map that was found; the steps behind them are delta. Point at the graph, or use Left and Right, to read values.</source>
        <translation>Verzerrung D (linke Achse) und Trennung S (rechte Achse) jeder Iteration, oder jeder fertigen Map, die gefunden wurde; die Stufen dahinter sind Delta. Zeigen Sie auf das Diagramm, oder benutzen Sie Links und Rechts, um Werte abzulesen.</translation>
    </message>
    <message>
        <source>Run the solver to see how it converges</source>
        <translation>Lassen Sie den Solver laufen, um die Konvergenz zu sehen</translation>
    </message>
    <message>
        <source>iterations</source>
        <translation>Iterationen</translation>
    </message>
    <message>
        <source>maps</source>
        <translation>Maps</translation>
    </message>
    <message>
        <source>D %1</source>
        <translation>D %1</translation>
    </message>
    <message>
        <source>S %1</source>
        <translation>S %1</translation>
    </message>
    <message>
        <source>δ %1</source>
        <translation>δ %1</translation>
    </message>
    <message>
        <source>#%1</source>
        <translation>#%1</translation>
    </message>
</context>
<context>
    <name>autocuts::DensityDialog</name>
    <message>
        <source>Texel density</source>
        <translation>Texeldichte</translation>
    </message>
    <message>
        <source> px/unit</source>
        <translation> px/Einheit</translation>
    </message>
    <message>
        <source>Texels per unit of the model</source>
        <translation>Texel je Einheit des Modells</translation>
    </message>
    <message>
        <source>&amp;Set</source>
        <translation>&amp;Setzen</translation>
    </message>
    <message>
        <source>&amp;Density:</source>
        <translation>&amp;Dichte:</translation>
    </message>
    <message>
        <source>With a texture of %1 × %2 texels; locked islands stay.</source>
        <translation>Bei einer Textur von %1 × %2 Texeln; gesperrte Inseln bleiben.</translation>
    </message>
    <message>
        <source>The islands have %1 texels per unit now.</source>
        <translation>Die Inseln haben jetzt %1 Texel je Einheit.</translation>
    </message>
    <message>
        <source>The islands have no area.</source>
        <translation>Die Inseln haben keinen Flächeninhalt.</translation>
    </message>
    <message>
        <source>Pack at a texel density</source>
        <translation>Mit einer Texeldichte packen</translation>
    </message>
    <message>
        <source>&amp;Pack</source>
        <translation>&amp;Packen</translation>
    </message>
    <message>
        <source>%1
The islands alone fill %2 tiles; with the room between them they need more.</source>
        <translation>%1
Die Inseln allein füllen %2 Kacheln; mit dem Platz zwischen ihnen brauchen sie mehr.</translation>
    </message>
</context>
<context>
    <name>autocuts::DoctorPanel</name>
    <message>
        <source>Open a model to have it examined.</source>
        <translation>Öffnen Sie ein Modell, um es prüfen zu lassen.</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Map</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Of these polygons, that is faces with more than three corners, in brackets</source>
        <translation>In Klammern davon Polygone, also Flächen mit mehr als drei Ecken</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Vertices</translation>
    </message>
    <message>
        <source>As in the file</source>
        <translation>Wie in der Datei</translation>
    </message>
    <message>
        <source>Objects, parts</source>
        <translation>Objekte, Teile</translation>
    </message>
    <message>
        <source>Objects of the file, and connected parts</source>
        <translation>Objekte der Datei und zusammenhängende Teile</translation>
    </message>
    <message>
        <source>Boundary edges</source>
        <translation>Randkanten</translation>
    </message>
    <message>
        <source>Edges with a face on one side only</source>
        <translation>Kanten mit einer Fläche auf nur einer Seite</translation>
    </message>
    <message>
        <source>Non-manifold edges</source>
        <translation>Nicht-mannigfaltige Kanten</translation>
    </message>
    <message>
        <source>Edges with three or more faces: each face was joined to its best partner</source>
        <translation>Kanten mit drei oder mehr Flächen: jede Fläche wurde mit ihrem besten Partner verbunden</translation>
    </message>
    <message>
        <source>Edges of opposite winding</source>
        <translation>Kanten mit Gegensinn</translation>
    </message>
    <message>
        <source>Edges between faces that look to different sides: treated as boundary</source>
        <translation>Kanten zwischen Flächen, die nach verschiedenen Seiten blicken: als Rand behandelt</translation>
    </message>
    <message>
        <source>Triangles without area</source>
        <translation>Dreiecke ohne Fläche</translation>
    </message>
    <message>
        <source>Kept, with a thin stand-in shape while solving</source>
        <translation>Bleiben erhalten, beim Rechnen mit einer dünnen Ersatzform</translation>
    </message>
    <message>
        <source>Duplicated faces</source>
        <translation>Doppelte Flächen</translation>
    </message>
    <message>
        <source>Faces at the place of another one</source>
        <translation>Flächen an der Stelle einer anderen</translation>
    </message>
    <message>
        <source>Concave polygons</source>
        <translation>Konkave Polygone</translation>
    </message>
    <message>
        <source>Polygons that are not convex: split along diagonals inside them</source>
        <translation>Polygone, die nicht konvex sind: entlang von Diagonalen in ihrem Inneren geteilt</translation>
    </message>
    <message>
        <source>Polygons that meet themselves</source>
        <translation>Sich berührende Polygone</translation>
    </message>
    <message>
        <source>Polygons with a vertex twice, such as a, b, c, b: cut off from the faces around there</source>
        <translation>Polygone, die einen Vertex zweimal haben, etwa a, b, c, b: von den Flächen ringsum abgeschnitten</translation>
    </message>
    <message>
        <source>Surface area</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>In the units of the model</source>
        <translation>In den Einheiten des Modells</translation>
    </message>
    <message>
        <source>Diagonal</source>
        <translation>Diagonale</translation>
    </message>
    <message>
        <source>Diagonal of the bounding box, in the units of the model</source>
        <translation>Diagonale des umgebenden Quaders, in den Einheiten des Modells</translation>
    </message>
    <message>
        <source>Distortion, mean</source>
        <translation>Verzerrung, Mittel</translation>
    </message>
    <message>
        <source>Area-weighted mean symmetric Dirichlet energy, 4 where nothing is distorted</source>
        <translation>Mit dem Flächeninhalt gewichtetes Mittel der symmetrischen Dirichlet-Energie, 4 wo nichts verzerrt ist</translation>
    </message>
    <message>
        <source>Distortion, 99 %</source>
        <translation>Verzerrung, 99 %</translation>
    </message>
    <message>
        <source>99 per cent of the triangles are below this</source>
        <translation>99 Prozent der Dreiecke liegen darunter</translation>
    </message>
    <message>
        <source>Distortion, largest</source>
        <translation>Verzerrung, größte</translation>
    </message>
    <message>
        <source>Of the worst triangle</source>
        <translation>Des schlechtesten Dreiecks</translation>
    </message>
    <message>
        <source>L2 stretch</source>
        <translation>L2-Dehnung</translation>
    </message>
    <message>
        <source>Sander et al. 2001; 1 where nothing is stretched</source>
        <translation>Sander u. a. 2001; 1 wo nichts gedehnt ist</translation>
    </message>
    <message>
        <source>Angle distortion</source>
        <translation>Winkelverzerrung</translation>
    </message>
    <message>
        <source>Mean ratio of the two stretches of a triangle; 1 keeps all angles</source>
        <translation>Mittleres Verhältnis der zwei Dehnungen eines Dreiecks; 1 erhält alle Winkel</translation>
    </message>
    <message>
        <source>Area distortion</source>
        <translation>Flächenverzerrung</translation>
    </message>
    <message>
        <source>Mean factor between the shares of area in the map and on the model; 1 is best</source>
        <translation>Mittlerer Faktor zwischen den Flächenanteilen in der Map und am Modell; 1 ist am besten</translation>
    </message>
    <message>
        <source>Density spread</source>
        <translation>Streuung der Dichte</translation>
    </message>
    <message>
        <source>Largest texel density of an island divided by the smallest; 1 is equal</source>
        <translation>Größte Texeldichte einer Insel geteilt durch die kleinste; 1 ist gleichmäßig</translation>
    </message>
    <message>
        <source>Faces without UVs</source>
        <translation>Flächen ohne UVs</translation>
    </message>
    <message>
        <source>Faces that are not in the map</source>
        <translation>Flächen, die nicht in der Map sind</translation>
    </message>
    <message>
        <source>Collapsed triangles</source>
        <translation>Kollabierte Dreiecke</translation>
    </message>
    <message>
        <source>Triangles without area in the map</source>
        <translation>Dreiecke ohne Flächeninhalt in der Map</translation>
    </message>
    <message>
        <source>Mirrored islands</source>
        <translation>Gespiegelte Inseln</translation>
    </message>
    <message>
        <source>Islands that lie face down</source>
        <translation>Inseln, die mit der Rückseite nach oben liegen</translation>
    </message>
    <message>
        <source>✓ All fine: nothing unusual was found.</source>
        <translation>✓ Alles in Ordnung: nichts Auffälliges gefunden.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>autocuts::DragTool</name>
    <message>
        <source>vertices</source>
        <translation>Vertices</translation>
    </message>
    <message>
        <source>edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>islands</source>
        <translation>Inseln</translation>
    </message>
    <message>
        <source>Drag %1 in the UV view: the map follows, tears and joins; Shift+wheel: circle, Escape: cancel</source>
        <translation>%1 in der UV-Ansicht ziehen: die Map folgt, reißt und verbindet sich; Umschalt+Mausrad: Kreis, Esc: abbrechen</translation>
    </message>
    <message>
        <source>Drag %1 in the UV view: what is in the circle follows; Shift+wheel: circle, Escape: cancel</source>
        <translation>%1 in der UV-Ansicht ziehen: was im Kreis ist, folgt; Umschalt+Mausrad: Kreis, Esc: abbrechen</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>Radius of what follows the drag; Shift+wheel</source>
        <translation>Radius dessen, was dem Ziehen folgt; Umschalt+Mausrad</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Torn off: what was in the circle moves alone; Escape: cancel</source>
        <translation>Abgerissen: Was im Kreis war, bewegt sich allein; Esc: abbrechen</translation>
    </message>
    <message>
        <source>Pull further: what is in the circle tears off; Shift+wheel: circle, Escape: cancel</source>
        <translation>Weiter ziehen: Was im Kreis liegt, reißt ab; Umschalt+Mausrad: Kreis, Esc: abbrechen</translation>
    </message>
</context>
<context>
    <name>autocuts::EditActions</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>&amp;Wiederholen: %1</translation>
    </message>
</context>
<context>
    <name>autocuts::ExportLayoutDialog</name>
    <message>
        <source>F&amp;ill the islands</source>
        <translation>Inseln &amp;füllen</translation>
    </message>
    <message>
        <source>&amp;Edges inside the islands</source>
        <translation>&amp;Kanten in den Inseln</translation>
    </message>
    <message>
        <source>O&amp;utlines of the islands</source>
        <translation>&amp;Umrisse der Inseln</translation>
    </message>
    <message>
        <source>Hatch &amp;overlaps</source>
        <translation>Übe&amp;rlappungen schraffieren</translation>
    </message>
    <message>
        <source>Export layout</source>
        <translation>Layout exportieren</translation>
    </message>
    <message>
        <source>PNG, to paint over</source>
        <translation>PNG, zum Übermalen</translation>
    </message>
    <message>
        <source>SVG, to print or edit</source>
        <translation>SVG, zum Drucken oder Bearbeiten</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>Durchsichtig</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Pixels along the longer side; the picture has the shape of the texture</source>
        <translation>Pixel entlang der längeren Seite; das Bild hat die Form der Textur</translation>
    </message>
    <message>
        <source>How far the fill of an island goes on beyond its outline; it never covers another island</source>
        <translation>Wie weit die Füllung einer Insel über ihren Umriss hinausgeht; sie überdeckt nie eine andere Insel</translation>
    </message>
    <message>
        <source>The map has no overlaps, or was not measured yet</source>
        <translation>Die Map hat keine Überlappungen oder wurde noch nicht gemessen</translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation>E&amp;xportieren</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>F&amp;ormat:</translation>
    </message>
    <message>
        <source>&amp;Size:</source>
        <translation>&amp;Größe:</translation>
    </message>
    <message>
        <source>Back&amp;ground:</source>
        <translation>&amp;Hintergrund:</translation>
    </message>
    <message>
        <source>&amp;Part:</source>
        <translation>&amp;Teil:</translation>
    </message>
    <message>
        <source>&amp;Bleed:</source>
        <translation>&amp;Beschnitt:</translation>
    </message>
    <message>
        <source>Own colours:</source>
        <translation>Eigene Farben:</translation>
    </message>
    <message>
        <source>Fi&amp;le:</source>
        <translation>&amp;Datei:</translation>
    </message>
    <message>
        <source>Isla&amp;nds</source>
        <translation>I&amp;nseln</translation>
    </message>
    <message>
        <source>E&amp;dges</source>
        <translation>K&amp;anten</translation>
    </message>
    <message>
        <source>Ou&amp;tlines</source>
        <translation>U&amp;mrisse</translation>
    </message>
    <message>
        <source>The whole map</source>
        <translation>Die ganze Map</translation>
    </message>
    <message>
        <source>What is shown</source>
        <translation>Was gezeigt wird</translation>
    </message>
    <message>
        <source>The selected faces</source>
        <translation>Die ausgewählten Flächen</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>PNG-Bild (*.png)</translation>
    </message>
    <message>
        <source>SVG drawing (*.svg)</source>
        <translation>SVG-Zeichnung (*.svg)</translation>
    </message>
    <message>
        <source>The suffix must be .png or .svg.</source>
        <translation>Die Endung muss .png oder .svg sein.</translation>
    </message>
    <message>
        <source>Tick the box beside it first</source>
        <translation>Zuerst das Kästchen daneben ankreuzen</translation>
    </message>
    <message>
        <source>Only filled islands bleed</source>
        <translation>Nur gefüllte Inseln laufen über ihren Rand hinaus</translation>
    </message>
    <message>
        <source>Nothing is hidden, and no face is selected</source>
        <translation>Nichts ist ausgeblendet und keine Fläche ausgewählt</translation>
    </message>
</context>
<context>
    <name>autocuts::ExportMeshDialog</name>
    <message>
        <source>Wavefront OBJ</source>
        <translation>Wavefront OBJ</translation>
    </message>
    <message>
        <source>glTF binary</source>
        <translation>glTF binär</translation>
    </message>
    <message>
        <source>glTF with embedded data</source>
        <translation>glTF mit eingebetteten Daten</translation>
    </message>
    <message>
        <source>Collada</source>
        <translation>Collada</translation>
    </message>
    <message>
        <source>FBX</source>
        <translation>FBX</translation>
    </message>
    <message>
        <source>Stanford PLY</source>
        <translation>Stanford PLY</translation>
    </message>
    <message>
        <source>Export mesh</source>
        <translation>Mesh exportieren</translation>
    </message>
    <message>
        <source>What this format cannot hold</source>
        <translation>Was dieses Format nicht aufnehmen kann</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exportieren</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>F&amp;ormat:</translation>
    </message>
    <message>
        <source>F&amp;ile:</source>
        <translation>&amp;Datei:</translation>
    </message>
    <message>
        <source>Nothing is lost.</source>
        <translation>Nichts geht verloren.</translation>
    </message>
    <message>
        <source>No format has this suffix.</source>
        <translation>Kein Format hat diese Endung.</translation>
    </message>
</context>
<context>
    <name>autocuts::FileActions</name>
    <message>
        <source>Meshes and sessions (%1)</source>
        <translation>Meshes und Sitzungen (%1)</translation>
    </message>
    <message>
        <source>Autocuts sessions (%1)</source>
        <translation>Autocuts-Sitzungen (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Save session</source>
        <translation>Sitzung speichern</translation>
    </message>
    <message>
        <source>Meshes (%1)</source>
        <translation>Meshes (%1)</translation>
    </message>
    <message>
        <source>Re-link model</source>
        <translation>Modell neu verknüpfen</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>unbenannt</translation>
    </message>
    <message>
        <source>Export report</source>
        <translation>Bericht exportieren</translation>
    </message>
    <message>
        <source>JSON report (*.json)</source>
        <translation>JSON-Bericht (*.json)</translation>
    </message>
    <message numerus="yes">
        <source>Replace the pictures of %n tiles?</source>
        <translation>
            <numerusform>Die Bilder von %n Kachel ersetzen?</numerusform>
            <numerusform>Die Bilder von %n Kacheln ersetzen?</numerusform>
        </translation>
    </message>
    <message>
        <source>Their content is lost.</source>
        <translation>Ihr Inhalt geht verloren.</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Ersetzen</translation>
    </message>
    <message>
        <source>Replace %1 after each re-link?</source>
        <translation>%1 nach jeder Verknüpfung ersetzen?</translation>
    </message>
    <message>
        <source>Its content is lost.</source>
        <translation>Der Inhalt geht verloren.</translation>
    </message>
    <message>
        <source>%1 is still going on. Stop it?</source>
        <translation>%1 läuft noch. Abbrechen?</translation>
    </message>
    <message>
        <source>What it has found so far will be lost.</source>
        <translation>Was bisher gefunden wurde, geht verloren.</translation>
    </message>
    <message>
        <source>Stop it</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>autocuts::FileController</name>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>Recovering</source>
        <translation>Wird wiederhergestellt</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>The model was not re-linked, because the session was edited while the model was read</source>
        <translation>Das Modell wurde nicht neu verknüpft, weil die Sitzung bearbeitet wurde, während es gelesen wurde</translation>
    </message>
    <message>
        <source>Re-link it again and wait until it is read</source>
        <translation>Verknüpfen Sie es noch einmal und warten Sie, bis es gelesen ist</translation>
    </message>
    <message>
        <source>Re-linked to %1: everything was kept</source>
        <translation>Mit %1 neu verknüpft: alles wurde behalten</translation>
    </message>
    <message>
        <source>Re-linked to %1: %2</source>
        <translation>Mit %1 neu verknüpft: %2</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>%1 wird geschrieben</translation>
    </message>
    <message>
        <source>Drawing %1</source>
        <translation>%1 wird gezeichnet</translation>
    </message>
    <message>
        <source>Another file is being read or written</source>
        <translation>Eine andere Datei wird gelesen oder geschrieben</translation>
    </message>
    <message>
        <source>Wait or cancel it first</source>
        <translation>Warten Sie darauf oder brechen Sie es erst ab</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 geschrieben</translation>
    </message>
    <message>
        <source>Wrote %1 and %2 more</source>
        <translation>%1 und %2 weitere geschrieben</translation>
    </message>
    <message>
        <source>Measuring the map</source>
        <translation>Die Map wird gemessen</translation>
    </message>
    <message>
        <source>Check the permissions of the folder</source>
        <translation>Die Rechte am Ordner prüfen</translation>
    </message>
    <message>
        <source>%1 is open in %2 as well. What is saved first stays; the other one is asked</source>
        <translation>%1 ist auch in %2 offen. Was zuerst gespeichert wird, bleibt; das andere Programm fragt nach</translation>
    </message>
    <message>
        <source>Saved %1 anew: the file was gone</source>
        <translation>%1 neu gespeichert: Die Datei war verschwunden</translation>
    </message>
    <message>
        <source>what only the file before had, such as bones and animation, is not written again</source>
        <translation>was nur die Datei davor hatte, etwa Knochen und Animation, wird nicht wieder geschrieben</translation>
    </message>
</context>
<context>
    <name>autocuts::FoldSection</name>
    <message>
        <source>Show or hide what follows</source>
        <translation>Zeigen oder verbergen, was folgt</translation>
    </message>
</context>
<context>
    <name>autocuts::GivenSeamForm</name>
    <message>
        <source>Free</source>
        <translation>Frei</translation>
    </message>
    <message>
        <source>Keep mine</source>
        <translation>Meine behalten</translation>
    </message>
    <message>
        <source>Only mine</source>
        <translation>Nur meine</translation>
    </message>
    <message>
        <source>Whose</source>
        <translation>Herkunft</translation>
    </message>
    <message>
        <source>Free: the search finds the seams. Keep mine: the seams given below stay, and the search adds what the distortion budget needs. Only mine: exactly the seams given below.</source>
        <translation>Frei: die Suche findet die Nähte. Meine behalten: die unten vorgegebenen Nähte bleiben, und die Suche fügt hinzu, was das Verzerrungsbudget braucht. Nur meine: genau die unten vorgegebenen Nähte.</translation>
    </message>
    <message>
        <source>Forced cuts</source>
        <translation>Erzwungene Schnitte</translation>
    </message>
    <message>
        <source>Edges that you cut</source>
        <translation>Kanten, die Sie geschnitten haben</translation>
    </message>
    <message>
        <source>Seams of the map</source>
        <translation>Nähte der Map</translation>
    </message>
    <message>
        <source>Seams of the map as it is now</source>
        <translation>Nähte der Map, wie sie jetzt ist</translation>
    </message>
    <message>
        <source>Hard edges of the file</source>
        <translation>Harte Kanten der Datei</translation>
    </message>
    <message>
        <source>Edges that the model&apos;s file does not shade smoothly: between smoothing groups, or where the normals of the two sides differ</source>
        <translation>Kanten, die die Datei des Modells nicht glatt schattiert: zwischen Glättungsgruppen, oder wo die Normalen der zwei Seiten sich unterscheiden</translation>
    </message>
    <message>
        <source>Material borders</source>
        <translation>Materialgrenzen</translation>
    </message>
    <message>
        <source>Edges between two materials. Borders of objects are seams in any case.</source>
        <translation>Kanten zwischen zwei Materialien. Grenzen von Objekten sind in jedem Fall Nähte.</translation>
    </message>
    <message>
        <source>Edges at which the model is bent by more than this angle</source>
        <translation>Kanten, an denen das Modell um mehr als diesen Winkel geknickt ist</translation>
    </message>
    <message>
        <source>Edges sharper than</source>
        <translation>Kanten schärfer als</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Free seams do not depend on it: choose those of yours, to keep or alone</source>
        <translation>Freie Nähte hängen nicht davon ab: wählen Sie Ihre eigenen</translation>
    </message>
</context>
<context>
    <name>autocuts::HeatLegend</name>
    <message>
        <source>Legend from %1 to %2</source>
        <translation>Legende von %1 bis %2</translation>
    </message>
</context>
<context>
    <name>autocuts::HistoryPanel</name>
    <message>
        <source>Open a model: every edit will be listed here.</source>
        <translation>Öffnen Sie ein Modell: hier wird jede Änderung aufgelistet.</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Wie geöffnet</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Click an entry to go back to it, or forward. Undo: Ctrl+Z, redo: Ctrl+Shift+Z</source>
        <translation>Klicken Sie auf einen Eintrag, um zu ihm zurück- oder vorzugehen. Rückgängig: Strg+Z, wiederholen: Strg+Umschalt+Z</translation>
    </message>
    <message>
        <source>%1 of %2 used</source>
        <translation>%1 von %2 benutzt</translation>
    </message>
    <message>
        <source>Too old to go back to: %1</source>
        <translation>Zu alt, um dahin zurückzugehen: %1</translation>
    </message>
</context>
<context>
    <name>autocuts::HistoryView</name>
    <message>
        <source>saved</source>
        <translation>gespeichert</translation>
    </message>
</context>
<context>
    <name>autocuts::IslandActions</name>
    <message>
        <source>The selected islands are locked</source>
        <translation>Die ausgewählten Inseln sind gesperrt</translation>
    </message>
    <message>
        <source>Nothing to do: the islands lie that way already</source>
        <translation>Nichts zu tun: die Inseln liegen schon so</translation>
    </message>
    <message>
        <source>Select three islands or more to distribute them</source>
        <translation>Wählen Sie zum Verteilen drei oder mehr Inseln aus</translation>
    </message>
    <message>
        <source>No two of the islands are copies of each other</source>
        <translation>Keine zwei der Inseln sind Kopien voneinander</translation>
    </message>
    <message>
        <source>, of them turned over, since they are mirror images: %1</source>
        <translation>, davon umgeklappt, weil sie Spiegelbilder sind: %1</translation>
    </message>
    <message>
        <source>The islands are in no stack</source>
        <translation>Die Inseln sind in keinem Stapel</translation>
    </message>
    <message>
        <source>Send to a tile</source>
        <translation>In eine Kachel senden</translation>
    </message>
    <message>
        <source>The selected islands keep their place in the tile, their scale and direction.</source>
        <translation>Die ausgewählten Inseln behalten ihren Ort in der Kachel, ihre Größe und Richtung.</translation>
    </message>
    <message>
        <source>&amp;Tile:</source>
        <translation>&amp;Kachel:</translation>
    </message>
    <message>
        <source>&amp;Send</source>
        <translation>&amp;Senden</translation>
    </message>
    <message>
        <source>Islands sent to tile %1: %2</source>
        <translation>In Kachel %1 gesendete Inseln: %2</translation>
    </message>
    <message>
        <source>The selected islands belong to no tile</source>
        <translation>Die gewählten Inseln gehören zu keiner Kachel</translation>
    </message>
    <message>
        <source>Islands unlocked: %1</source>
        <translation>Inseln entsperrt: %1</translation>
    </message>
    <message>
        <source>Islands locked: %1</source>
        <translation>Inseln gesperrt: %1</translation>
    </message>
    <message>
        <source>Islands selected: %1</source>
        <translation>Ausgewählte Inseln: %1</translation>
    </message>
    <message>
        <source>No objects share a mesh in the file of the model</source>
        <translation>In der Datei des Modells teilen sich keine Objekte ein Mesh</translation>
    </message>
    <message>
        <source>Each object gets a mesh and a map of its own when the model is written</source>
        <translation>Jedes Objekt bekommt ein eigenes Mesh und eine eigene Abwicklung, wenn das Modell geschrieben wird</translation>
    </message>
    <message>
        <source>The meshes are unique already</source>
        <translation>Die Meshes sind schon eigenständig</translation>
    </message>
</context>
<context>
    <name>autocuts::IslandPanel</name>
    <message>
        <source>Open a model to see the islands of its map.</source>
        <translation>Öffnen Sie ein Modell, um die Inseln seiner Map zu sehen.</translation>
    </message>
    <message>
        <source>Texel density</source>
        <translation>Texeldichte</translation>
    </message>
    <message>
        <source>Islands</source>
        <translation>Inseln</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Sperren</translation>
    </message>
    <message>
        <source>Keep the selected islands where they are</source>
        <translation>Die ausgewählten Inseln lassen, wo sie sind</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppieren</translation>
    </message>
    <message>
        <source>The selected islands move together</source>
        <translation>Die ausgewählten Inseln bewegen sich gemeinsam</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Entsperren</translation>
    </message>
    <message>
        <source>Let the selected islands move</source>
        <translation>Die ausgewählten Inseln sich bewegen lassen</translation>
    </message>
    <message>
        <source>Unstack</source>
        <translation>Entstapeln</translation>
    </message>
    <message>
        <source>Take the selected islands out of their stacks</source>
        <translation>Die ausgewählten Inseln aus ihren Stapeln nehmen</translation>
    </message>
    <message>
        <source>Ungroup</source>
        <translation>Auflösen</translation>
    </message>
    <message>
        <source>Take the selected islands out of their groups</source>
        <translation>Die ausgewählten Inseln aus ihren Gruppen nehmen</translation>
    </message>
    <message>
        <source> px/unit</source>
        <translation> px/Einheit</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Setzen</translation>
    </message>
    <message>
        <source>Equalise all</source>
        <translation>Alle angleichen</translation>
    </message>
    <message>
        <source>Take over the mean texel density of the selected islands</source>
        <translation>Die mittlere Texeldichte der ausgewählten Inseln übernehmen</translation>
    </message>
    <message>
        <source>Scale the selected islands to this texel density; locked ones stay. Painted faces get theirs: the density is that of faces with a weight of 1</source>
        <translation>Die ausgewählten Inseln auf diese Texeldichte skalieren; gesperrte bleiben. Bemalte Flächen bekommen ihre eigene: die Dichte ist die von Flächen mit dem Gewicht 1</translation>
    </message>
    <message>
        <source>Give all islands the same texel density; locked ones stay</source>
        <translation>Allen Inseln dieselbe Texeldichte geben; gesperrte bleiben</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>Texels per unit of the model at the texture size of the Packing panel</source>
        <translation>Texel je Einheit des Modells bei der Texturgröße aus dem Bedienfeld Packen</translation>
    </message>
    <message>
        <source>Pause the solver to list its islands.</source>
        <translation>Halten Sie den Solver an, um seine Inseln aufzulisten.</translation>
    </message>
    <message>
        <source>The islands are listed when the map is ready.</source>
        <translation>Die Inseln werden aufgelistet, wenn die Map fertig ist.</translation>
    </message>
    <message>
        <source>No UVs yet: run the solver, or unwrap.</source>
        <translation>Noch keine UVs: starten Sie den Solver, oder wickeln Sie ab.</translation>
    </message>
    <message>
        <source>Islands: %1, selected: %2</source>
        <translation>Inseln: %1, ausgewählt: %2</translation>
    </message>
    <message>
        <source>Stack identical</source>
        <translation>Gleiche stapeln</translation>
    </message>
    <message>
        <source>Lay those of the selected islands that are alike on top of each other; one alone finds all its copies</source>
        <translation>Die gleichen unter den ausgewählten Inseln aufeinander legen; eine allein findet alle ihre Kopien</translation>
    </message>
    <message>
        <source>Select faces or islands first</source>
        <translation>Wählen Sie zuerst Flächen oder Inseln aus</translation>
    </message>
    <message>
        <source>Islands of the map before: %1, selected: %2. The list follows once the new map is there.</source>
        <translation>Inseln der vorigen Map: %1, ausgewählt: %2. Die Liste folgt, sobald die neue Map da ist.</translation>
    </message>
    <message>
        <source>Nothing to do: the selected islands are so already</source>
        <translation>Nichts zu tun: Die ausgewählten Inseln sind schon so</translation>
    </message>
</context>
<context>
    <name>autocuts::IslandTable</name>
    <message>
        <source>Island</source>
        <translation>Insel</translation>
    </message>
    <message>
        <source>Colour, number and tags</source>
        <translation>Farbe, Nummer und Namen</translation>
    </message>
    <message>
        <source>Locked islands are not moved</source>
        <translation>Gesperrte Inseln werden nicht bewegt</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Number of faces</source>
        <translation>Anzahl der Flächen</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>Share of the model&apos;s surface</source>
        <translation>Anteil an der Oberfläche des Modells</translation>
    </message>
    <message>
        <source>px/unit</source>
        <translation>px/Einheit</translation>
    </message>
    <message>
        <source>D</source>
        <translation>D</translation>
    </message>
    <message>
        <source>Mean distortion of the island, whatever its size: symmetric Dirichlet energy, 4 where nothing is distorted</source>
        <translation>Mittlere Verzerrung der Insel, gleich wie groß sie ist: symmetrische Dirichlet-Energie, 4 wo nichts verzerrt ist</translation>
    </message>
    <message>
        <source>Islands of one stack lie on top of each other</source>
        <translation>Inseln eines Stapels liegen übereinander</translation>
    </message>
    <message>
        <source>Islands of one group move together</source>
        <translation>Inseln einer Gruppe bewegen sich gemeinsam</translation>
    </message>
    <message>
        <source>Texel density: texels per unit of the model at the texture size of the Packing panel, where the painted texel density weight is 1</source>
        <translation>Texeldichte: Texel je Einheit des Modells bei der Texturgröße im Bedienfeld Packen, wo das gemalte Gewicht der Texeldichte 1 ist</translation>
    </message>
    <message>
        <source>true px</source>
        <translation>echte px</translation>
    </message>
    <message>
        <source>Texels per unit of the model that the island has, with its painted weights</source>
        <translation>Texel je Einheit des Modells, die die Insel hat, mit ihren gemalten Gewichten</translation>
    </message>
</context>
<context>
    <name>autocuts::IslandTool</name>
    <message>
        <source>%1   X or Y: one axis, digits: exact, Ctrl or Shift: snap, Enter: done, Escape: cancel</source>
        <translation>%1   X oder Y: eine Achse, Ziffern: genau, Strg oder Umschalt: einrasten, Eingabe: fertig, Esc: abbrechen</translation>
    </message>
    <message>
        <source>The selected islands are locked</source>
        <translation>Die ausgewählten Inseln sind gesperrt</translation>
    </message>
    <message>
        <source>Rotate islands: drag an island or the ring, Ctrl turns by 15 degrees, with Alt by 90</source>
        <translation>Inseln drehen: eine Insel oder den Ring ziehen, Strg dreht um 15 Grad, mit Alt um 90</translation>
    </message>
    <message>
        <source>Scale islands: drag an island or a handle, Ctrl scales by tenths</source>
        <translation>Inseln skalieren: eine Insel oder einen Griff ziehen, Strg skaliert in Zehnteln</translation>
    </message>
    <message>
        <source>Move islands: drag an island or an arrow, Shift snaps to other islands, Ctrl to the grid, Ctrl+Shift to texels, Ctrl+Alt to tiles</source>
        <translation>Inseln verschieben: eine Insel oder einen Pfeil ziehen, Umschalt rastet an anderen Inseln ein, Strg am Raster, Strg+Umschalt an Texeln, Strg+Alt an Kacheln</translation>
    </message>
</context>
<context>
    <name>autocuts::KeyField</name>
    <message>
        <source>Press a key...</source>
        <translation>Taste drücken...</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
</context>
<context>
    <name>autocuts::LampForm</name>
    <message>
        <source>Area light at</source>
        <translation>Flächenlicht bei</translation>
    </message>
    <message>
        <source>Aimed at</source>
        <translation>Gerichtet auf</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Emissive material</source>
        <translation>Emissives Material</translation>
    </message>
    <message>
        <source>Rectangles that emit light to one side, in units of the model; they are not seen themselves. Light is red, green, blue, or one number</source>
        <translation>Rechtecke, die nach einer Seite Licht abgeben, in Einheiten des Modells; sie selbst sind nicht zu sehen. Licht ist Rot, Grün, Blau oder eine Zahl</translation>
    </message>
    <message>
        <source>The faces of a ticked material emit light: red, green, blue or one number</source>
        <translation>Die Flächen eines angekreuzten Materials geben Licht ab: Rot, Grün, Blau oder eine Zahl</translation>
    </message>
    <message>
        <source>Add area &amp;light</source>
        <translation>F&amp;lächenlicht hinzufügen</translation>
    </message>
    <message>
        <source>Re&amp;move area light</source>
        <translation>Flächenlicht entfer&amp;nen</translation>
    </message>
    <message>
        <source>An area light needs two different places (x, y, z), a size (width x height) and its light (a number, or red, green, blue).</source>
        <translation>Ein Flächenlicht braucht zwei verschiedene Orte (x, y, z), eine Größe (Breite x Höhe) und ihr Licht (eine Zahl oder Rot, Grün, Blau).</translation>
    </message>
    <message>
        <source>The light of a material is a number, or red, green, blue.</source>
        <translation>Das Licht eines Materials ist eine Zahl oder Rot, Grün, Blau.</translation>
    </message>
    <message>
        <source>There is no area light</source>
        <translation>Es gibt kein Flächenlicht</translation>
    </message>
</context>
<context>
    <name>autocuts::LayoutPanel</name>
    <message>
        <source>Open a model to arrange the islands of its map.</source>
        <translation>Öffnen Sie ein Modell, um die Inseln seiner Map anzuordnen.</translation>
    </message>
    <message>
        <source>Selected islands</source>
        <translation>Ausgewählte Inseln</translation>
    </message>
    <message>
        <source>Keep proportions</source>
        <translation>Seitenverhältnis behalten</translation>
    </message>
    <message>
        <source>Of the lower left corner when that is the pivot, else of the centre</source>
        <translation>Der linken unteren Ecke, wenn sie der Drehpunkt ist, sonst der Mitte</translation>
    </message>
    <message>
        <source>Of the box around the selected islands</source>
        <translation>Des Kastens um die ausgewählten Inseln</translation>
    </message>
    <message>
        <source>U</source>
        <translation>U</translation>
    </message>
    <message>
        <source>V</source>
        <translation>V</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Turn by</source>
        <translation>Drehen um</translation>
    </message>
    <message>
        <source>Degrees, counter-clockwise, about the pivot</source>
        <translation>Grad, gegen den Uhrzeigersinn, um den Drehpunkt</translation>
    </message>
    <message>
        <source>Cursor</source>
        <translation>Cursor</translation>
    </message>
    <message>
        <source>The 2D cursor; Shift+right click in the UV view places it</source>
        <translation>Der 2D-Cursor; Umschalt+Rechtsklick in der UV-Ansicht setzt ihn</translation>
    </message>
    <message>
        <source>The pivot is not the 2D cursor</source>
        <translation>Der Drehpunkt ist nicht der 2D-Cursor</translation>
    </message>
    <message>
        <source>Select islands that may move first</source>
        <translation>Wählen Sie zuerst bewegliche Inseln aus</translation>
    </message>
    <message>
        <source>Islands are placed when no solve and no job runs</source>
        <translation>Inseln lassen sich platzieren, wenn weder der Solver noch eine Aufgabe läuft</translation>
    </message>
</context>
<context>
    <name>autocuts::LightBakeDialog</name>
    <message>
        <source>Light map</source>
        <translation>Lightmap</translation>
    </message>
    <message>
        <source>Bake light</source>
        <translation>Licht backen</translation>
    </message>
    <message>
        <source>Ba&amp;ke light</source>
        <translation>Licht bac&amp;ken</translation>
    </message>
    <message>
        <source>&amp;Sun</source>
        <translation>&amp;Sonne</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Direction of the sun, clockwise from north, which is -z, or y where z is up</source>
        <translation>Richtung der Sonne, im Uhrzeigersinn von Norden aus; das ist -z, oder y, wenn z nach oben zeigt</translation>
    </message>
    <message>
        <source>Height of the sun above the horizon</source>
        <translation>Höhe der Sonne über dem Horizont</translation>
    </message>
    <message>
        <source>Light on a surface that faces the sun (irradiance); 3.14 makes white of white</source>
        <translation>Licht auf einer Fläche, die zur Sonne zeigt (Bestrahlungsstärke); 3,14 macht aus Weiß Weiß</translation>
    </message>
    <message>
        <source>Diameter as seen from the model; a larger sun makes softer shadows</source>
        <translation>Durchmesser vom Modell aus; eine größere Sonne macht weichere Schatten</translation>
    </message>
    <message>
        <source>Colour of the sun</source>
        <translation>Farbe der Sonne</translation>
    </message>
    <message>
        <source>Direction:</source>
        <translation>Richtung:</translation>
    </message>
    <message>
        <source>Height:</source>
        <translation>Höhe:</translation>
    </message>
    <message>
        <source>Strength:</source>
        <translation>Stärke:</translation>
    </message>
    <message>
        <source>Size:</source>
        <translation>Größe:</translation>
    </message>
    <message>
        <source>Colour:</source>
        <translation>Farbe:</translation>
    </message>
    <message>
        <source>Sky</source>
        <translation>Himmel</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keiner</translation>
    </message>
    <message>
        <source>One colour</source>
        <translation>Eine Farbe</translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Clear day</source>
        <translation>Klarer Tag</translation>
    </message>
    <message>
        <source>Light from all around; a clear day is that of the sun&apos;s place, also where the sun is off</source>
        <translation>Licht von allen Seiten; ein klarer Tag richtet sich nach dem Ort der Sonne, auch wenn sie aus ist</translation>
    </message>
    <message>
        <source>Factor on the colours; of a clear day, the brightness of the zenith</source>
        <translation>Faktor für die Farben; beim klaren Tag die Helligkeit des Zenits</translation>
    </message>
    <message>
        <source>Haze of a clear day: 2 is clear, 10 hazy</source>
        <translation>Dunst des klaren Tages: 2 ist klar, 10 dunstig</translation>
    </message>
    <message>
        <source>Colour of the zenith</source>
        <translation>Farbe des Zenits</translation>
    </message>
    <message>
        <source>Colour of the horizon</source>
        <translation>Farbe des Horizonts</translation>
    </message>
    <message>
        <source>Colour of the ground</source>
        <translation>Farbe des Bodens</translation>
    </message>
    <message>
        <source>Colours:</source>
        <translation>Farben:</translation>
    </message>
    <message>
        <source>Haze:</source>
        <translation>Dunst:</translation>
    </message>
    <message>
        <source>New set for lightmaps</source>
        <translation>Neuer Satz für Lightmaps</translation>
    </message>
    <message>
        <source>The map that light is baked into. In a map for lightmaps no islands lie on each other: a new one is made of the active map, and packed with the margin of the Packing panel</source>
        <translation>Die Map, in die Licht gebacken wird. In einer Map für Lightmaps liegen keine Inseln aufeinander: Eine neue wird aus der aktiven Map gemacht und mit dem Abstand aus dem Bedienfeld Packen gepackt</translation>
    </message>
    <message>
        <source>Light, times the colour of the surface it is what is seen</source>
        <translation>Licht: mal der Farbe der Fläche ist es, was man sieht</translation>
    </message>
    <message>
        <source>Irradiance</source>
        <translation>Bestrahlungsstärke</translation>
    </message>
    <message>
        <source>What is seen, with the colours of the materials</source>
        <translation>Was man sieht, mit den Farben der Materialien</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Texels around islands that are filled with the nearest value</source>
        <translation>Texel um die Inseln, die mit dem nächsten Wert gefüllt werden</translation>
    </message>
    <message>
        <source>&amp;UV set:</source>
        <translation>&amp;UV-Satz:</translation>
    </message>
    <message>
        <source>Si&amp;ze:</source>
        <translation>&amp;Größe:</translation>
    </message>
    <message>
        <source>&amp;Values:</source>
        <translation>&amp;Werte:</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Paths of light in each texel: more of them leave less noise</source>
        <translation>Lichtwege in jedem Texel: mehr davon lassen weniger Rauschen übrig</translation>
    </message>
    <message>
        <source>How often light is reflected before it arrives</source>
        <translation>Wie oft Licht zurückgeworfen wird, bevor es ankommt</translation>
    </message>
    <message>
        <source>Direct light</source>
        <translation>Direktes Licht</translation>
    </message>
    <message>
        <source>Indirect light</source>
        <translation>Indirektes Licht</translation>
    </message>
    <message>
        <source>Take out the &amp;noise</source>
        <translation>&amp;Rauschen entfernen</translation>
    </message>
    <message>
        <source>The axis that points to the zenith</source>
        <translation>Die Achse, die zum Zenit zeigt</translation>
    </message>
    <message>
        <source>Sam&amp;ples per texel:</source>
        <translation>&amp;Proben pro Texel:</translation>
    </message>
    <message>
        <source>B&amp;ounces:</source>
        <translation>Refle&amp;xionen:</translation>
    </message>
    <message>
        <source>Up:</source>
        <translation>Oben:</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>%1, %2 bits</source>
        <translation>%1, %2 Bit</translation>
    </message>
    <message>
        <source>EXR keeps light above 1 and is linear; the others are cut off at 1 and in sRGB</source>
        <translation>EXR behält Licht über 1 und ist linear; die anderen sind bei 1 abgeschnitten und in sRGB</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Bilder (%1)</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Format:</translation>
    </message>
    <message>
        <source>Fil&amp;e:</source>
        <translation>Dat&amp;ei:</translation>
    </message>
    <message>
        <source>The model has no UVs: unwrap it first.</source>
        <translation>Das Modell hat keine UVs: zuerst abwickeln.</translation>
    </message>
    <message>
        <source>Choose at least one light.</source>
        <translation>Wählen Sie mindestens ein Licht.</translation>
    </message>
    <message>
        <source>Choose direct or indirect light.</source>
        <translation>Wählen Sie direktes oder indirektes Licht.</translation>
    </message>
    <message>
        <source>The file cannot be written in this format: %1</source>
        <translation>Die Datei kann in diesem Format nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>Sk&amp;y:</source>
        <translation>H&amp;immel:</translation>
    </message>
    <message>
        <source>D&amp;ilation:</source>
        <translation>R&amp;and:</translation>
    </message>
    <message>
        <source>This kind of sky has no such colour</source>
        <translation>Diese Art von Himmel hat keine solche Farbe</translation>
    </message>
    <message>
        <source>Width of the picture; at first that of the texture in the Packing panel, whose proportions it has</source>
        <translation>Breite des Bildes; zuerst die der Textur im Packen-Bereich, deren Seitenverhältnis es hat</translation>
    </message>
    <message>
        <source>There is no sky</source>
        <translation>Es gibt keinen Himmel</translation>
    </message>
    <message>
        <source>Only the sky of a day has haze</source>
        <translation>Nur der Taghimmel hat Dunst</translation>
    </message>
</context>
<context>
    <name>autocuts::LightForm</name>
    <message>
        <source>Load…</source>
        <translation>Laden …</translation>
    </message>
    <message>
        <source>Visible behind the model</source>
        <translation>Hinter dem Modell sichtbar</translation>
    </message>
    <message>
        <source>All, in light</source>
        <translation>Alle, im Licht</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>All channels under light, or one of them as it is; it also lies behind the map</source>
        <translation>Alle Kanäle im Licht, oder einer davon, wie er ist; er liegt auch hinter der Map</translation>
    </message>
    <message>
        <source>Studio</source>
        <translation>Studio</translation>
    </message>
    <message>
        <source>Sky</source>
        <translation>Himmel</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Choose a panorama, .hdr or .exr, whose light falls on the model</source>
        <translation>Ein Panorama wählen, .hdr oder .exr, dessen Licht auf das Modell fällt</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>What is around the model and lights it</source>
        <translation>Was das Modell umgibt und beleuchtet</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Turns the light about the vertical</source>
        <translation>Dreht das Licht um die Senkrechte</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Belichtung</translation>
    </message>
    <message>
        <source>Brightness in stops: each one doubles the light</source>
        <translation>Helligkeit in Blendenstufen: jede verdoppelt das Licht</translation>
    </message>
    <message>
        <source>Shows the surroundings as the background of the 3D view</source>
        <translation>Zeigt die Umgebung als Hintergrund der 3D-Ansicht</translation>
    </message>
    <message>
        <source>Load surroundings</source>
        <translation>Umgebung laden</translation>
    </message>
    <message>
        <source>Panoramas (*.hdr *.exr)</source>
        <translation>Panoramen (*.hdr *.exr)</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Bilder (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>autocuts::LinkButton</name>
    <message>
        <source>Programs that get this map while you work</source>
        <translation>Programme, die diese Map während der Arbeit bekommen</translation>
    </message>
    <message>
        <source>Send the map now</source>
        <translation>Map jetzt senden</translation>
    </message>
    <message>
        <source>End the link</source>
        <translation>Verbindung beenden</translation>
    </message>
    <message>
        <source>Linked: %1</source>
        <translation>Verbunden: %1</translation>
    </message>
</context>
<context>
    <name>autocuts::LinkController</name>
    <message>
        <source>%1 is no longer linked</source>
        <translation>%1 ist nicht mehr verbunden</translation>
    </message>
    <message>
        <source>%1 is linked</source>
        <translation>%1 ist verbunden</translation>
    </message>
</context>
<context>
    <name>autocuts::LiveBake</name>
    <message>
        <source>%1 % of the surface found nothing of the detailed model: a larger cage reaches farther</source>
        <translation>%1 % der Oberfläche fanden nichts vom detaillierten Modell: Ein größerer Käfig reicht weiter</translation>
    </message>
</context>
<context>
    <name>autocuts::LivePacker</name>
    <message>
        <source>Packing</source>
        <translation>Wird gepackt</translation>
    </message>
</context>
<context>
    <name>autocuts::MainWindow</name>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Mesh doctor</source>
        <translation>Mesh-Doktor</translation>
    </message>
    <message>
        <source>UV sets</source>
        <translation>UV-Sätze</translation>
    </message>
    <message>
        <source>Unwrap</source>
        <translation>Abwickeln</translation>
    </message>
    <message>
        <source>Islands</source>
        <translation>Inseln</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Layout</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Nähte</translation>
    </message>
    <message>
        <source>Packing</source>
        <translation>Packen</translation>
    </message>
    <message>
        <source>Overlaps</source>
        <translation>Überlappungen</translation>
    </message>
    <message>
        <source>Main tool bar</source>
        <translation>Werkzeugleiste</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>The solver stopped: %1</source>
        <translation>Der Solver hat angehalten: %1</translation>
    </message>
    <message>
        <source>Autocuts</source>
        <translation>Autocuts</translation>
    </message>
    <message>
        <source>%1[*] - Autocuts</source>
        <translation>%1[*] - Autocuts</translation>
    </message>
    <message>
        <source>Opened %1</source>
        <translation>%1 geöffnet</translation>
    </message>
    <message>
        <source>Opened %1: see the mesh doctor</source>
        <translation>%1 geöffnet: siehe Mesh-Doktor</translation>
    </message>
    <message>
        <source>Textures</source>
        <translation>Texturen</translation>
    </message>
    <message>
        <source>%1 makes one, %2 solves live</source>
        <translation>%1 erstellt eine, %2 löst live</translation>
    </message>
</context>
<context>
    <name>autocuts::MapController</name>
    <message>
        <source>The chain cannot be made straight without turning faces over</source>
        <translation>Die Kette lässt sich nicht begradigen, ohne Flächen umzudrehen</translation>
    </message>
    <message>
        <source>The faces around the grid cannot follow it without turning over: cut it out first (rip, V)</source>
        <translation>Die Flächen um das Raster können ihm nicht folgen, ohne sich umzudrehen: schneiden Sie es erst heraus (Auftrennen, V)</translation>
    </message>
    <message>
        <source>The map was edited meanwhile: the result was not used</source>
        <translation>Die Map wurde inzwischen bearbeitet: das Ergebnis wurde nicht verwendet</translation>
    </message>
    <message>
        <source>Nothing to do: the edges are cut already</source>
        <translation>Nichts zu tun: die Kanten sind schon geschnitten</translation>
    </message>
    <message>
        <source>Unwrapping</source>
        <translation>Wird abgewickelt</translation>
    </message>
    <message>
        <source>Finishing</source>
        <translation>Wird fertiggestellt</translation>
    </message>
    <message>
        <source>Packing</source>
        <translation>Wird gepackt</translation>
    </message>
    <message>
        <source>Separating overlaps</source>
        <translation>Überlappungen werden getrennt</translation>
    </message>
    <message>
        <source>Lightmap</source>
        <translation>Lightmap</translation>
    </message>
    <message>
        <source>Making a map for lightmaps</source>
        <translation>Eine Map für Lightmaps wird gemacht</translation>
    </message>
    <message>
        <source>Equalising texel density</source>
        <translation>Texeldichte wird angeglichen</translation>
    </message>
    <message>
        <source>Relaxing</source>
        <translation>Wird entspannt</translation>
    </message>
    <message>
        <source>Straightening</source>
        <translation>Wird begradigt</translation>
    </message>
    <message>
        <source>Aligning to the axes</source>
        <translation>Wird an den Achsen ausgerichtet</translation>
    </message>
    <message>
        <source>Straightening to a grid</source>
        <translation>Wird zu einem Raster begradigt</translation>
    </message>
    <message>
        <source>Pricing seams</source>
        <translation>Preise der Nähte werden ermittelt</translation>
    </message>
    <message>
        <source>Ripping</source>
        <translation>Wird aufgetrennt</translation>
    </message>
    <message>
        <source>Stitching</source>
        <translation>Wird vernäht</translation>
    </message>
    <message>
        <source>The faces are turned over in the map and cannot be solved</source>
        <translation>Die Flächen sind in der Map umgedreht und lassen sich nicht berechnen</translation>
    </message>
    <message>
        <source>Nothing can move: select more faces, or remove pins and locks</source>
        <translation>Nichts kann sich bewegen: wählen Sie mehr Flächen aus, oder entfernen Sie Pins und Sperren</translation>
    </message>
    <message>
        <source>Cancelled: the map stays as it was</source>
        <translation>Abgebrochen: die Map bleibt, wie sie war</translation>
    </message>
    <message>
        <source>Relaxed: distortion of these faces %1 before, %2 now</source>
        <translation>Entspannt: Verzerrung dieser Flächen vorher %1, jetzt %2</translation>
    </message>
    <message>
        <source>Select edges that follow each other: a loop without ends, a fork or a locked island cannot be straightened</source>
        <translation>Wählen Sie Kanten aus, die aufeinander folgen: eine Schleife ohne Enden, eine Gabelung oder eine gesperrte Insel lässt sich nicht begradigen</translation>
    </message>
    <message>
        <source>Chains made straight: %1, distortion of their islands %2 before, %3 now</source>
        <translation>Begradigte Ketten: %1, Verzerrung ihrer Inseln vorher %2, jetzt %3</translation>
    </message>
    <message>
        <source>The selected faces are no grid: that needs quads in rows and columns, four around every point inside, not closed around a tube and without pins</source>
        <translation>Die ausgewählten Flächen sind kein Raster: das braucht Quads in Zeilen und Spalten, vier um jeden Punkt im Inneren, nicht um ein Rohr geschlossen und ohne Pins</translation>
    </message>
    <message>
        <source>Faces in straight grids: %1</source>
        <translation>Flächen in geraden Rastern: %1</translation>
    </message>
    <message>
        <source>%1. Faces that stay, because they are no quads in rows and columns or are pinned: %2</source>
        <translation>%1. Flächen, die bleiben, weil sie keine Quads in Zeilen und Spalten sind oder Pins haben: %2</translation>
    </message>
    <message>
        <source>Locked islands are not aligned: select others, or unlock them (Ctrl+Shift+L)</source>
        <translation>Gesperrte Inseln werden nicht ausgerichtet: wählen Sie andere, oder entsperren Sie sie (Strg+Umschalt+L)</translation>
    </message>
    <message>
        <source>Islands with pins and stacked or grouped ones are not aligned</source>
        <translation>Inseln mit Pins und gestapelte oder gruppierte werden nicht ausgerichtet</translation>
    </message>
    <message>
        <source>Triangles of these islands are flipped: unwrap them first</source>
        <translation>Dreiecke dieser Inseln sind umgedreht: wickeln Sie sie erst ab</translation>
    </message>
    <message>
        <source>Islands aligned: %1, distortion of these islands %2 before, %3 now</source>
        <translation>Ausgerichtete Inseln: %1, Verzerrung dieser Inseln vorher %2, jetzt %3</translation>
    </message>
    <message>
        <source>solving to the end</source>
        <translation>wird zu Ende berechnet</translation>
    </message>
    <message>
        <source>fitting the map to the fine mesh</source>
        <translation>die Map wird an das feine Mesh angepasst</translation>
    </message>
    <message>
        <source>packing</source>
        <translation>wird gepackt</translation>
    </message>
    <message>
        <source>adding cuts until the stretch is allowed, D %1 so far</source>
        <translation>Schnitte kommen hinzu, bis die Dehnung erlaubt ist, bisher D %1</translation>
    </message>
    <message>
        <source>shortening seams, %1 so far, D %2</source>
        <translation>Nähte werden gekürzt, bisher %1, D %2</translation>
    </message>
    <message>
        <source>There is no room for the margins: use a smaller margin or a larger texture</source>
        <translation>Für die Abstände ist kein Platz: nehmen Sie einen kleineren Abstand oder eine größere Textur</translation>
    </message>
    <message>
        <source>%1. Now faces overlap that did not before: %2. Pack (P), separate (O) or undo</source>
        <translation>%1. Jetzt überlappen Flächen, die es vorher nicht taten: %2. Packen (P), trennen (O) oder zurücknehmen</translation>
    </message>
    <message>
        <source>Unwrapping was cancelled: the map stays as it was</source>
        <translation>Das Abwickeln wurde abgebrochen: die Map bleibt, wie sie war</translation>
    </message>
    <message>
        <source>Unwrapping was cancelled before there was a map</source>
        <translation>Das Abwickeln wurde abgebrochen, bevor es eine Map gab</translation>
    </message>
    <message>
        <source>Unwrapped: distortion %1</source>
        <translation>Abgewickelt: Verzerrung %1</translation>
    </message>
    <message>
        <source>The distortion of %1 is above the bound of %2: allow more, or remove joins</source>
        <translation>Die Verzerrung von %1 liegt über der Grenze von %2: erlauben Sie mehr, oder entfernen Sie Verbindungen</translation>
    </message>
    <message>
        <source>The map still covers itself: joined edges hold it together there. Clear some joins and finish again</source>
        <translation>Die Map überdeckt sich noch selbst: verbundene Kanten halten sie dort zusammen. Löschen Sie einige Verbindungen und stellen Sie noch einmal fertig</translation>
    </message>
    <message>
        <source>Finished: distortion %1</source>
        <translation>Fertiggestellt: Verzerrung %1</translation>
    </message>
    <message>
        <source>Seams have no price on a map with turned-over triangles or open joins: unwrap or finish it first</source>
        <translation>Auf einer Map mit umgedrehten Dreiecken oder offenen Verbindungen haben Nähte keinen Preis: wickeln Sie sie erst ab oder stellen Sie sie fertig</translation>
    </message>
    <message>
        <source>Seams priced: %1</source>
        <translation>Nähte mit Preis: %1</translation>
    </message>
    <message>
        <source>Select the islands to pack first</source>
        <translation>Wählen Sie erst die Inseln aus, die gepackt werden sollen</translation>
    </message>
    <message>
        <source>There are more objects or materials than UDIM tiles</source>
        <translation>Es gibt mehr Objekte oder Materialien als UDIM-Kacheln</translation>
    </message>
    <message>
        <source>Islands packed: %1</source>
        <translation>Gepackte Inseln: %1</translation>
    </message>
    <message>
        <source>There is no room in the rectangle: draw a larger one or use a smaller margin</source>
        <translation>Im Rechteck ist kein Platz: zeichnen Sie ein größeres oder nehmen Sie einen kleineren Abstand</translation>
    </message>
    <message>
        <source>Overlaps inside single polygons or across joined edges, which stay whole: %1</source>
        <translation>Überlappungen in einzelnen Polygonen oder über verbundene Kanten hinweg, die ganz bleiben: %1</translation>
    </message>
    <message>
        <source>There are no overlaps: the map stays as it is</source>
        <translation>Es gibt keine Überlappungen: die Map bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>All islands have the same texel density</source>
        <translation>Alle Inseln haben dieselbe Texeldichte</translation>
    </message>
    <message>
        <source>Edges ripped: %1</source>
        <translation>Aufgetrennte Kanten: %1</translation>
    </message>
    <message>
        <source>new islands: %1</source>
        <translation>neue Inseln: %1</translation>
    </message>
    <message>
        <source>cut, but closed as long as they reach no border and no other cut: %1</source>
        <translation>geschnitten, aber geschlossen, solange sie keinen Rand und keinen anderen Schnitt erreichen: %1</translation>
    </message>
    <message>
        <source>left out in locked islands: %1</source>
        <translation>in gesperrten Inseln ausgelassen: %1</translation>
    </message>
    <message>
        <source>both sides are locked or pinned</source>
        <translation>beide Seiten gesperrt sind oder Pins haben</translation>
    </message>
    <message>
        <source>the island would overlap itself</source>
        <translation>die Insel sich selbst überlappen würde</translation>
    </message>
    <message>
        <source>faces would turn over</source>
        <translation>Flächen sich umdrehen würden</translation>
    </message>
    <message>
        <source>There is no map to rip</source>
        <translation>Es gibt keine Map zum Auftrennen</translation>
    </message>
    <message>
        <source>The island is locked: unlock it to rip it</source>
        <translation>Die Insel ist gesperrt: entsperren Sie sie zum Auftrennen</translation>
    </message>
    <message>
        <source>Select edges between two faces to rip</source>
        <translation>Wählen Sie zum Auftrennen Kanten zwischen zwei Flächen aus</translation>
    </message>
    <message>
        <source>There is no map to stitch</source>
        <translation>Es gibt keine Map zum Vernähen</translation>
    </message>
    <message>
        <source>Select seams of the map to stitch</source>
        <translation>Wählen Sie zum Vernähen Nähte der Map aus</translation>
    </message>
    <message>
        <source>Edges stitched: %1</source>
        <translation>Vernähte Kanten: %1</translation>
    </message>
    <message>
        <source>not stitched, because %1: %2</source>
        <translation>nicht vernäht, weil %1: %2</translation>
    </message>
    <message>
        <source>Transferring UVs</source>
        <translation>UVs werden übertragen</translation>
    </message>
    <message>
        <source>The islands need more UDIM tiles than there are: choose a lower density or a larger texture</source>
        <translation>Die Inseln brauchen mehr UDIM-Kacheln, als es gibt: wählen Sie eine geringere Dichte oder eine größere Textur</translation>
    </message>
    <message>
        <source>Islands packed: %1, into the tiles %2</source>
        <translation>Gepackte Inseln: %1, in die Kacheln %2</translation>
    </message>
    <message>
        <source>Cancelled: the map stays as it is</source>
        <translation>Abgebrochen: die Map bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>UVs transferred: %1</source>
        <translation>UVs übertragen: %1</translation>
    </message>
    <message>
        <source>No object of the detailed model belongs to: %1</source>
        <translation>Kein Objekt des detaillierten Modells gehört zu: %1</translation>
    </message>
    <message>
        <source>Cancelled: nothing was baked</source>
        <translation>Abgebrochen: es wurde nichts gebacken</translation>
    </message>
    <message numerus="yes">
        <source>Cancelled: %n pictures were finished in %1</source>
        <translation>
            <numerusform>Abgebrochen: %n Bild wurde fertig, in %1</numerusform>
            <numerusform>Abgebrochen: %n Bilder wurden fertig, in %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Baked %n pictures into %1</source>
        <translation>
            <numerusform>%n Bild gebacken, in %1</numerusform>
            <numerusform>%n Bilder gebacken, in %1</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 % of the texels found nothing of the detailed model: a larger cage reaches farther</source>
        <translation>%1 % der Texel fanden nichts vom detaillierten Modell: ein größerer Käfig reicht weiter</translation>
    </message>
    <message>
        <source>%1 % of the texels are shared by several faces and show the first one</source>
        <translation>%1 % der Texel gehören mehreren Flächen und zeigen die erste</translation>
    </message>
    <message>
        <source>Textures that cannot be read: %1</source>
        <translation>Texturen, die nicht gelesen werden können: %1</translation>
    </message>
    <message>
        <source>cannot tell which UV map these textures were made for</source>
        <translation>es lässt sich nicht feststellen, für welche UV-Map diese Texturen gemacht wurden</translation>
    </message>
    <message>
        <source>Choose the file or the UV set that has it</source>
        <translation>Die Datei oder den UV-Satz wählen, der sie hat</translation>
    </message>
    <message>
        <source>Pictures that are not there: %1</source>
        <translation>Bilder, die nicht da sind: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n faces get nothing: they have no UVs, or their islands cross the border of a tile</source>
        <translation>
            <numerusform>%n Fläche bekommt nichts: sie hat keine UVs, oder ihre Insel kreuzt den Rand einer Kachel</numerusform>
            <numerusform>%n Flächen bekommen nichts: sie haben keine UVs, oder ihre Inseln kreuzen den Rand einer Kachel</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 % of the texels found nothing of the other model</source>
        <translation>%1 % der Texel fanden nichts vom anderen Modell</translation>
    </message>
    <message>
        <source>Cancelled: no picture was written</source>
        <translation>Abgebrochen: kein Bild wurde geschrieben</translation>
    </message>
    <message numerus="yes">
        <source>Carried %n pictures over into %1</source>
        <translation>
            <numerusform>%n Bild nach %1 übertragen</numerusform>
            <numerusform>%n Bilder nach %1 übertragen</numerusform>
        </translation>
    </message>
    <message>
        <source>. The textures fit the map before: UV &gt; Carry textures over... makes them new for this one</source>
        <translation>. Die Texturen passen zur UV-Map davor: UV &gt; Texturen übertragen... macht sie neu für diese</translation>
    </message>
    <message>
        <source>The map or its textures were edited meanwhile: the new pictures are written, but not shown</source>
        <translation>Die UV-Map oder ihre Texturen wurden inzwischen bearbeitet: die neuen Bilder sind geschrieben, werden aber nicht gezeigt</translation>
    </message>
    <message>
        <source>Cancelled: no light was baked</source>
        <translation>Abgebrochen: es wurde kein Licht gebacken</translation>
    </message>
    <message>
        <source>Cancelled: %1 has what was found so far</source>
        <translation>Abgebrochen: %1 enthält, was bis dahin gefunden war</translation>
    </message>
    <message>
        <source>Baked light into %1</source>
        <translation>Licht gebacken, in %1</translation>
    </message>
    <message>
        <source>%1. Hidden faces stay as they were</source>
        <translation>%1. Ausgeblendete Flächen bleiben, wie sie waren</translation>
    </message>
    <message>
        <source>The mesh is not symmetric: nor are the cuts</source>
        <translation>Das Modell ist nicht symmetrisch, die Schnitte daher auch nicht</translation>
    </message>
    <message>
        <source>%1 % of the surface have no mirror image: their cuts are free</source>
        <translation>%1 % der Oberfläche haben kein Spiegelbild: Ihre Schnitte sind frei</translation>
    </message>
    <message>
        <source>No symmetric cuts met the bound: the cuts are free</source>
        <translation>Keine symmetrischen Schnitte hielten die Grenze ein: Die Schnitte sind frei</translation>
    </message>
    <message>
        <source>the cage has other faces than the model</source>
        <translation>der Käfig hat andere Flächen als das Modell</translation>
    </message>
    <message>
        <source>Make it by moving the vertices of the model</source>
        <translation>Entsteht, wenn die Punkte des Modells verschoben werden</translation>
    </message>
    <message>
        <source>The model has no colours of the chosen kind: those of its materials are baked</source>
        <translation>Das Modell hat keine Farben der gewählten Art: die seiner Materialien werden gebacken</translation>
    </message>
    <message>
        <source>the detailed model is nowhere near this one</source>
        <translation>das detaillierte Modell ist nirgends in der Nähe von diesem</translation>
    </message>
    <message>
        <source>Choose the model that belongs to this one</source>
        <translation>Wählen Sie das Modell, das zu diesem gehört</translation>
    </message>
    <message numerus="yes">
        <source>%n faces are not baked as a whole: they have no UVs, or their islands reach over the border of their tile</source>
        <translation>
            <numerusform>%n Fläche wird nicht ganz gebacken: sie hat keine UVs, oder ihre Insel reicht über den Rand ihrer Kachel</numerusform>
            <numerusform>%n Flächen werden nicht ganz gebacken: sie haben keine UVs, oder ihre Inseln reichen über den Rand ihrer Kachel</numerusform>
        </translation>
    </message>
    <message>
        <source>%1. There was no room at their size: all islands of the tile are smaller now</source>
        <translation>%1. In ihrer Größe war kein Platz: alle Inseln der Kachel sind jetzt kleiner</translation>
    </message>
    <message>
        <source>The islands do not fit at their size: switch off &quot;Keep each island&apos;s scale&quot; or use a smaller margin</source>
        <translation>Die Inseln passen in ihrer Größe nicht hinein: „Größe jeder Insel behalten“ ausschalten oder einen kleineren Abstand wählen</translation>
    </message>
    <message>
        <source>No island has a tag: Select &gt; Tags of islands gives one</source>
        <translation>Keine Insel hat eine Markierung: Auswahl &gt; Markierungen von Inseln gibt eine</translation>
    </message>
    <message>
        <source>The detailed model is nowhere near this one: the cage is %1 % of its diagonal</source>
        <translation>Das detaillierte Modell ist nirgends in der Nähe von diesem: Der Käfig ist %1 % seiner Diagonale</translation>
    </message>
    <message>
        <source>light maps have at most %1 x %1 texels</source>
        <translation>Lightmaps haben höchstens %1 x %1 Texel</translation>
    </message>
    <message>
        <source>pictures of %1 x %2 texels are too large</source>
        <translation>Bilder mit %1 x %2 Texeln sind zu groß</translation>
    </message>
    <message>
        <source>Bake at most %1 x %1, and use UDIM tiles for more</source>
        <translation>Höchstens %1 x %1 backen, und für mehr UDIM-Kacheln verwenden</translation>
    </message>
    <message>
        <source>the model has no UV map to bake into</source>
        <translation>das Modell hat keine UV-Map, in die gebacken werden kann</translation>
    </message>
    <message>
        <source>Unwrap it first</source>
        <translation>Es zuerst abwickeln</translation>
    </message>
    <message>
        <source>the model has no UV map that its textures could be for</source>
        <translation>das Modell hat keine UV-Map, zu der seine Texturen gehören könnten</translation>
    </message>
    <message>
        <source>there are no pictures that could be carried over</source>
        <translation>es gibt keine Bilder, die übertragen werden könnten</translation>
    </message>
    <message>
        <source>Check the textures of the materials</source>
        <translation>Die Texturen der Materialien prüfen</translation>
    </message>
    <message>
        <source>the new picture would overwrite the one it is made from</source>
        <translation>das neue Bild würde das überschreiben, aus dem es gemacht wird</translation>
    </message>
    <message>
        <source>Choose another folder or another ending of the names</source>
        <translation>Einen anderen Ordner oder eine andere Endung der Namen wählen</translation>
    </message>
    <message>
        <source>there is no such picture</source>
        <translation>es gibt kein solches Bild</translation>
    </message>
    <message>
        <source>Check its name</source>
        <translation>Seinen Namen prüfen</translation>
    </message>
    <message>
        <source>the textures seem to fit this UV map already</source>
        <translation>die Texturen passen anscheinend schon zu dieser UV-Map</translation>
    </message>
    <message>
        <source>the textures fit this map already</source>
        <translation>die Texturen passen schon zu dieser UV-Map</translation>
    </message>
    <message>
        <source>Choose the file or the UV set that they are for</source>
        <translation>Die Datei oder den UV-Satz wählen, zu dem sie gehören</translation>
    </message>
    <message>
        <source>In %1 % of the texels light is above 1 and was cut off: EXR keeps it, or take weaker lights</source>
        <translation>In %1 % der Texel liegt das Licht über 1 und wurde abgeschnitten: EXR behält es, oder schwächere Lichter nehmen</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>eine Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>%1 needs a value</source>
        <translation>%1 braucht einen Wert</translation>
    </message>
    <message>
        <source>%1 takes no value</source>
        <translation>%1 nimmt keinen Wert</translation>
    </message>
    <message>
        <source>%1 takes %2, not &quot;%3&quot;</source>
        <translation>%1 nimmt %2, nicht „%3“</translation>
    </message>
    <message>
        <source>Correct the line, or save the preset again</source>
        <translation>Die Zeile berichtigen oder die Vorlage neu speichern</translation>
    </message>
    <message>
        <source>the margin or the border of the tile does not fit the texture</source>
        <translation>der Abstand der Inseln oder der zum Rand der Kachel passt nicht zur Textur</translation>
    </message>
    <message>
        <source>Make it smaller, or the texture larger</source>
        <translation>Ihn verkleinern oder die Textur vergrößern</translation>
    </message>
    <message>
        <source>there is no preset &quot;%1&quot;</source>
        <translation>es gibt keine Vorlage „%1“</translation>
    </message>
    <message>
        <source>There are %1, and files: NAME.preset in %2</source>
        <translation>Es gibt %1, und Dateien: NAME.preset in %2</translation>
    </message>
    <message>
        <source>Check the path and its permissions</source>
        <translation>Den Pfad und seine Rechte prüfen</translation>
    </message>
    <message>
        <source>the file is too large for a preset</source>
        <translation>die Datei ist für eine Vorlage zu groß</translation>
    </message>
    <message>
        <source>Name a file with one option per line</source>
        <translation>Eine Datei mit einer Option je Zeile nennen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be the name of a file</source>
        <translation>„%1“ kann nicht der Name einer Datei sein</translation>
    </message>
    <message>
        <source>Choose another name</source>
        <translation>Einen anderen Namen wählen</translation>
    </message>
    <message>
        <source>the preset %1 comes with the program</source>
        <translation>die Vorlage %1 gehört zum Programm</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>der Ordner kann nicht angelegt werden</translation>
    </message>
    <message>
        <source>Check the permissions</source>
        <translation>Die Rechte prüfen</translation>
    </message>
    <message>
        <source>Check the permissions of its folder</source>
        <translation>Die Rechte des Ordners prüfen</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2, or two as in 2048x1024</source>
        <translation>eine ganze Zahl von %1 bis %2, oder zwei wie in 2048x1024</translation>
    </message>
    <message>
        <source>a list of cuts, uv, sharp, sharp:DEGREES (0 to 180), hard, materials and objects</source>
        <translation>eine Liste aus cuts, uv, sharp, sharp:GRAD (0 bis 180), hard, materials und objects</translation>
    </message>
    <message>
        <source>%1 was ended: the map was edited meanwhile</source>
        <translation>%1 wurde beendet: die Map wurde inzwischen bearbeitet</translation>
    </message>
    <message>
        <source>Nothing may move: the islands are locked or pinned</source>
        <translation>Nichts darf sich bewegen: die Inseln sind gesperrt oder haben Pins</translation>
    </message>
    <message>
        <source>All faces are hidden: show those whose map is to change</source>
        <translation>Alle Flächen sind ausgeblendet: die zeigen, deren Layout sich ändern soll</translation>
    </message>
    <message>
        <source>seams already, forced now: %1</source>
        <translation>waren schon Nähte, jetzt erzwungen: %1</translation>
    </message>
    <message>
        <source>There is no map yet: unwrap first</source>
        <translation>Es gibt noch keine Map: wickeln Sie zuerst ab</translation>
    </message>
    <message>
        <source>Unwrapping ended early, with the best map so far: distortion %1</source>
        <translation>Das Abwickeln endete vorzeitig mit der bisher besten Map: Verzerrung %1</translation>
    </message>
    <message>
        <source>light is baked into exr, png, tif and tga files</source>
        <translation>Licht wird in Dateien der Formate exr, png, tif und tga gebacken</translation>
    </message>
    <message>
        <source>Choose a file name that ends in .exr, .png, .tif or .tga</source>
        <translation>Wählen Sie einen Dateinamen, der auf .exr, .png, .tif oder .tga endet</translation>
    </message>
    <message>
        <source>the folder for the picture does not exist or cannot be written</source>
        <translation>den Ordner für das Bild gibt es nicht, oder es kann nicht in ihn geschrieben werden</translation>
    </message>
    <message>
        <source>Check its permissions or choose another one</source>
        <translation>Prüfen Sie seine Rechte oder wählen Sie einen anderen</translation>
    </message>
    <message>
        <source>there is no material &quot;%1&quot; that could be emissive</source>
        <translation>es gibt kein Material „%1“, das leuchten könnte</translation>
    </message>
    <message>
        <source>The model has no materials</source>
        <translation>Das Modell hat keine Materialien</translation>
    </message>
    <message>
        <source>It has: %1</source>
        <translation>Es hat: %1</translation>
    </message>
    <message>
        <source>there is no object &quot;%1&quot;</source>
        <translation>es gibt kein Objekt „%1“</translation>
    </message>
    <message>
        <source>Check its name in the file</source>
        <translation>Prüfen Sie seinen Namen in der Datei</translation>
    </message>
    <message>
        <source>The map stays as it is: locks, pins, stacks, groups or the scope leave nothing to change</source>
        <translation>Die Map bleibt, wie sie ist: Sperren, Pins, Stapel, Gruppen oder der Umfang lassen nichts zu ändern</translation>
    </message>
    <message>
        <source>There is no room for the islands at their scale: all of a tile are smaller now</source>
        <translation>In ihrer Größe ist für die Inseln kein Platz: alle einer Kachel sind jetzt kleiner</translation>
    </message>
    <message>
        <source>Islands larger than a tile at this density, and made smaller to fit: %1</source>
        <translation>Inseln, die bei dieser Dichte größer als eine Kachel sind und deshalb verkleinert wurden: %1</translation>
    </message>
    <message>
        <source>Hard pins that could not be reached: %1</source>
        <translation>Harte Pins, die nicht erreicht werden konnten: %1</translation>
    </message>
    <message>
        <source>Joined edges that had to stay open: %1</source>
        <translation>Verbundene Kanten, die offen bleiben mussten: %1</translation>
    </message>
    <message>
        <source>Rectangles that islands reach out of: %1</source>
        <translation>Rechtecke, aus denen Inseln herausragen: %1</translation>
    </message>
    <message>
        <source>Seams that are not given and were needed: %1</source>
        <translation>Nicht vorgegebene Nähte, die nötig waren: %1</translation>
    </message>
    <message>
        <source>Edges kept straight, which are bent: %1</source>
        <translation>Kanten, die gerade bleiben sollen, aber gebogen sind: %1</translation>
    </message>
    <message>
        <source>Pins or locks hold faces on each other: remove some of them</source>
        <translation>Pins oder Sperren halten Flächen aufeinander: entfernen Sie einige davon</translation>
    </message>
    <message>
        <source>The mesh is too irregular for a map with few seams: this one is made of many flat patches</source>
        <translation>Das Netz ist zu unregelmäßig für eine Map mit wenigen Nähten: diese besteht aus vielen flachen Stücken</translation>
    </message>
    <message>
        <source>Stopped before a map with few seams was found: this one is made of many flat patches</source>
        <translation>Angehalten, bevor eine Map mit wenigen Nähten gefunden war: diese besteht aus vielen flachen Stücken</translation>
    </message>
    <message>
        <source>Stopped early: this map is not, or not wholly, straightened</source>
        <translation>Vorzeitig angehalten: diese Map ist nicht oder nicht ganz begradigt</translation>
    </message>
    <message>
        <source>Stopped before there was a result: the map stays as it was</source>
        <translation>Angehalten, bevor es ein Ergebnis gab: die Map bleibt, wie sie war</translation>
    </message>
    <message>
        <source>No better map was found: it stays as it was</source>
        <translation>Keine bessere Map gefunden: sie bleibt, wie sie war</translation>
    </message>
    <message>
        <source>Islands that stay as they were, because there is no room for better ones: %1</source>
        <translation>Inseln, die bleiben, wie sie waren, weil für bessere kein Platz ist: %1</translation>
    </message>
    <message>
        <source>Stopped early: this map is straightened</source>
        <translation>Vorzeitig angehalten: diese Map ist begradigt</translation>
    </message>
    <message>
        <source>The islands stand upright</source>
        <translation>Die Inseln stehen aufrecht</translation>
    </message>
    <message>
        <source>Symmetric part of the seams: %1 %</source>
        <translation>Symmetrischer Anteil der Nähte: %1 %</translation>
    </message>
    <message>
        <source>Edges cut to take overlaps apart: %1</source>
        <translation>Geschnittene Kanten, um Überlappungen zu trennen: %1</translation>
    </message>
</context>
<context>
    <name>autocuts::MapMeasuring</name>
    <message>
        <source>Measuring</source>
        <translation>Wird gemessen</translation>
    </message>
</context>
<context>
    <name>autocuts::MeshView</name>
    <message>
        <source>Open a model</source>
        <translation>Öffnen Sie ein Modell</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>Röntgenblick</translation>
    </message>
    <message>
        <source>Hidden faces: %1</source>
        <translation>Ausgeblendete Flächen: %1</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Drop a file here, or choose File &gt; Open</source>
        <translation>Ziehen Sie eine Datei hierher, oder wählen Sie Datei &gt; Öffnen</translation>
    </message>
</context>
<context>
    <name>autocuts::ModelPictures</name>
    <message>
        <source>a picture inside of the model&apos;s file</source>
        <translation>ein Bild in der Datei des Modells</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>Textures that cannot be shown: %1</source>
        <translation>Texturen, die sich nicht zeigen lassen: %1</translation>
    </message>
</context>
<context>
    <name>autocuts::NoticeBar</name>
    <message>
        <source>Select them</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>Select what the message is about</source>
        <translation>Auswählen, worum es in der Meldung geht</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
</context>
<context>
    <name>autocuts::OverlapModel</name>
    <message>
        <source>faces %1 and %2</source>
        <translation>Flächen %1 und %2</translation>
    </message>
    <message>
        <source>Island %1: face %2 covers itself</source>
        <translation>Insel %1: Fläche %2 überdeckt sich selbst</translation>
    </message>
    <message>
        <source>Island %1: %2</source>
        <translation>Insel %1: %2</translation>
    </message>
    <message>
        <source>Islands %1 and %2: %3</source>
        <translation>Inseln %1 und %2: %3</translation>
    </message>
</context>
<context>
    <name>autocuts::OverlapPanel</name>
    <message>
        <source>Open a model to look for overlaps in its map.</source>
        <translation>Öffnen Sie ein Modell, um in seiner Map nach Überlappungen zu suchen.</translation>
    </message>
    <message>
        <source>Overlaps</source>
        <translation>Überlappungen</translation>
    </message>
    <message>
        <source>Overlapping faces, the largest overlap first; choosing a row selects them</source>
        <translation>Überlappende Flächen, die größte Überlappung zuerst; eine Zeile zu wählen, wählt sie aus</translation>
    </message>
    <message>
        <source>Overlapping pairs</source>
        <translation>Überlappende Paare</translation>
    </message>
    <message>
        <source>Pairs of triangles that overlap in the map</source>
        <translation>Paare von Dreiecken, die in der Map überlappen</translation>
    </message>
    <message>
        <source>Overlapping triangles</source>
        <translation>Überlappende Dreiecke</translation>
    </message>
    <message>
        <source>Triangles that overlap at least one other</source>
        <translation>Dreiecke, die mindestens ein anderes überlappen</translation>
    </message>
    <message>
        <source>Overlapping area</source>
        <translation>Überlappende Fläche</translation>
    </message>
    <message>
        <source>Area of all overlaps, as a share of the map&apos;s area</source>
        <translation>Fläche aller Überlappungen, als Anteil an der Fläche der Map</translation>
    </message>
    <message>
        <source>Stacked pairs</source>
        <translation>Gestapelte Paare</translation>
    </message>
    <message>
        <source>Pairs of triangles of islands that are stacked: they overlap on purpose and are not counted above</source>
        <translation>Paare von Dreiecken gestapelter Inseln: sie überlappen mit Absicht und sind oben nicht mitgezählt</translation>
    </message>
    <message>
        <source>Flipped triangles</source>
        <translation>Umgedrehte Dreiecke</translation>
    </message>
    <message>
        <source>Triangles that lie face down in their island</source>
        <translation>Dreiecke, die in ihrer Insel mit der Rückseite nach oben liegen</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Vorige</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Nächste</translation>
    </message>
    <message>
        <source>Select flipped</source>
        <translation>Umgedrehte auswählen</translation>
    </message>
    <message>
        <source>Separate all</source>
        <translation>Alle trennen</translation>
    </message>
    <message>
        <source>Select the overlap before, and show it</source>
        <translation>Die Überlappung davor auswählen und zeigen</translation>
    </message>
    <message>
        <source>Select the next overlap, and show it</source>
        <translation>Die nächste Überlappung auswählen und zeigen</translation>
    </message>
    <message>
        <source>Select the faces of flipped triangles, and show them</source>
        <translation>Die Flächen umgedrehter Dreiecke auswählen und zeigen</translation>
    </message>
    <message>
        <source>Cut islands that cover themselves, and pack</source>
        <translation>Inseln zerschneiden, die sich selbst überdecken, und packen</translation>
    </message>
    <message>
        <source>Greedily</source>
        <translation>Schnell</translation>
    </message>
    <message>
        <source>The same by regions that grow breadth first: more cuts, found at once</source>
        <translation>Dasselbe mit Bereichen, die in die Breite wachsen: mehr Schnitte, sofort gefunden</translation>
    </message>
    <message>
        <source>No map yet: run the solver, or unwrap.</source>
        <translation>Noch keine Map: starten Sie den Solver, oder wickeln Sie ab.</translation>
    </message>
    <message>
        <source>The map has changed; measuring it…</source>
        <translation>Die Map hat sich geändert und wird gemessen…</translation>
    </message>
    <message>
        <source>No overlaps and no flips.</source>
        <translation>Keine Überlappungen und nichts umgedreht.</translation>
    </message>
    <message>
        <source>Choose an overlap to see where it is.</source>
        <translation>Wählen Sie eine Überlappung, um zu sehen, wo sie ist.</translation>
    </message>
    <message>
        <source>No face is known to be flipped</source>
        <translation>Es ist keine umgedrehte Fläche bekannt</translation>
    </message>
</context>
<context>
    <name>autocuts::PackBoxTool</name>
    <message>
        <source>Box of %1 × %2 texels: release to pack, Escape: cancel</source>
        <translation>Rahmen von %1 × %2 Texeln: loslassen packt, Esc: abbrechen</translation>
    </message>
    <message>
        <source>Pack into a box: drag a box in the UV view for all islands, Ctrl snaps to the grid</source>
        <translation>In einen Rahmen packen: einen Rahmen in der UV-Ansicht für alle Inseln aufziehen, Strg rastet am Raster ein</translation>
    </message>
    <message>
        <source>Pack into a box: drag a box in the UV view for the selected islands, Ctrl snaps to the grid</source>
        <translation>In einen Rahmen packen: einen Rahmen in der UV-Ansicht für die ausgewählten Inseln aufziehen, Strg rastet am Raster ein</translation>
    </message>
</context>
<context>
    <name>autocuts::PackPanel</name>
    <message>
        <source>Open a model to pack its islands into a texture.</source>
        <translation>Öffnen Sie ein Modell, um seine Inseln in eine Textur zu packen.</translation>
    </message>
    <message>
        <source>The map</source>
        <translation>Die Map</translation>
    </message>
    <message>
        <source>Height of the texture</source>
        <translation>Höhe der Textur</translation>
    </message>
    <message>
        <source>Width and height of the texture in texels; choose or type numbers. Islands keep their shapes on a texture of another shape, so their UVs in the model&apos;s file change</source>
        <translation>Breite und Höhe der Textur in Texeln; wählen oder tippen Sie Zahlen. Auf einer Textur anderer Form behalten Inseln ihre Gestalt, ihre UVs in der Datei des Modells ändern sich also</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Textur</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>True distance between two islands in texels, and half of it to the border of the texture</source>
        <translation>Wirklicher Abstand zwischen zwei Inseln in Texeln, und die Hälfte davon zum Rand der Textur</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Half turns</source>
        <translation>Halbe Drehungen</translation>
    </message>
    <message>
        <source>Quarter turns</source>
        <translation>Vierteldrehungen</translation>
    </message>
    <message>
        <source>Steps of 45°</source>
        <translation>Schritte von 45°</translation>
    </message>
    <message>
        <source>Steps of 30°</source>
        <translation>Schritte von 30°</translation>
    </message>
    <message>
        <source>Steps of 15°</source>
        <translation>Schritte von 15°</translation>
    </message>
    <message>
        <source>Any angle</source>
        <translation>Beliebiger Winkel</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>How islands may be turned to fit; those that keep their orientation are not turned</source>
        <translation>Wie Inseln gedreht werden dürfen, damit sie passen; solche, die ihre Ausrichtung behalten, werden nicht gedreht</translation>
    </message>
    <message>
        <source>UDIM tile</source>
        <translation>UDIM-Kachel</translation>
    </message>
    <message>
        <source>Tile that is packed into: 1001 is the first, ten tiles in a row</source>
        <translation>Kachel, in die gepackt wird: 1001 ist die erste, zehn Kacheln in einer Reihe</translation>
    </message>
    <message>
        <source>Half the margin</source>
        <translation>Halber Abstand</translation>
    </message>
    <message>
        <source>Border</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>Least distance to the border of the tile in texels</source>
        <translation>Kleinster Abstand zum Rand der Kachel in Texeln</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Effort</source>
        <translation>Aufwand</translation>
    </message>
    <message>
        <source>How long to search for a better arrangement, in seconds of one processor core</source>
        <translation>Wie lange nach einer besseren Anordnung gesucht wird, in Sekunden eines Prozessorkerns</translation>
    </message>
    <message>
        <source>Pack</source>
        <translation>Packen</translation>
    </message>
    <message>
        <source>Pack selection</source>
        <translation>Auswahl packen</translation>
    </message>
    <message>
        <source>Place all islands; locked ones stay</source>
        <translation>Alle Inseln anordnen; gesperrte bleiben</translation>
    </message>
    <message>
        <source>Place the selected islands around the others</source>
        <translation>Die ausgewählten Inseln um die anderen herum anordnen</translation>
    </message>
    <message>
        <source>Efficiency</source>
        <translation>Ausnutzung</translation>
    </message>
    <message>
        <source>Smallest gutter</source>
        <translation>Kleinster Abstand</translation>
    </message>
    <message>
        <source>Smallest distance between two islands, in texels</source>
        <translation>Kleinste Entfernung zwischen zwei Inseln, in Texeln</translation>
    </message>
    <message>
        <source>To the border</source>
        <translation>Zum Rand</translation>
    </message>
    <message>
        <source>In the texture</source>
        <translation>In der Textur</translation>
    </message>
    <message>
        <source>= %1 UV</source>
        <translation>= %1 UV</translation>
    </message>
    <message>
        <source>U %1, V %2</source>
        <translation>U %1, V %2</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>Share of the texture that islands cover; of all tiles in use</source>
        <translation>Anteil der Textur, den Inseln bedecken; aller benutzten Kacheln</translation>
    </message>
    <message>
        <source>Smallest distance of an island to the border of its tile, in texels</source>
        <translation>Kleinste Entfernung einer Insel zum Rand ihrer Kachel, in Texeln</translation>
    </message>
    <message>
        <source>Whether all islands lie in tile 1001, or in tiles at all</source>
        <translation>Ob alle Inseln in der Kachel 1001 liegen, oder überhaupt in Kacheln</translation>
    </message>
    <message>
        <source>Tiles in use</source>
        <translation>Benutzte Kacheln</translation>
    </message>
    <message>
        <source>Tile</source>
        <translation>Kachel</translation>
    </message>
    <message>
        <source>Islands</source>
        <translation>Inseln</translation>
    </message>
    <message>
        <source>px per unit</source>
        <translation>px je Einheit</translation>
    </message>
    <message>
        <source>in other tiles</source>
        <translation>in anderen Kacheln</translation>
    </message>
    <message>
        <source>Keep each island&apos;s scale</source>
        <translation>Größe jeder Insel behalten</translation>
    </message>
    <message>
        <source>Every job leaves the islands the texel density that they have. Off: Pack, Unwrap and Separate give all islands of a tile the same one, as large as there is room</source>
        <translation>Jede Aufgabe lässt den Inseln die Texeldichte, die sie haben. Aus: Packen, Abwickeln und Trennen geben allen Inseln einer Kachel dieselbe, so groß, wie Platz ist</translation>
    </message>
    <message>
        <source>The UDIM tiles to which islands belong: how many, what share of the tile they cover, and their texel density</source>
        <translation>Die UDIM-Kacheln, zu denen Inseln gehören: wie viele, welchen Teil der Kachel sie bedecken, und ihre Texeldichte</translation>
    </message>
</context>
<context>
    <name>autocuts::PaintTool</name>
    <message>
        <source>Keep together</source>
        <translation>Zusammenhalten</translation>
    </message>
    <message>
        <source>Attract cuts</source>
        <translation>Schnitte anziehen</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Radieren</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Malen</translation>
    </message>
    <message>
        <source>What the brush does; keys 1 to 3, Shift erases, Ctrl reverses</source>
        <translation>Was der Pinsel tut; Tasten 1 bis 3, Umschalt radiert, Strg kehrt um</translation>
    </message>
    <message>
        <source>%1: 1-3 choose, Shift erases, Ctrl inverts; wheel with Shift size, Ctrl strength, Alt hardness; X symmetry</source>
        <translation>%1: 1-3 wählen, Umschalt radiert, Strg kehrt um; Mausrad mit Umschalt Größe, Strg Stärke, Alt Härte; X Symmetrie</translation>
    </message>
</context>
<context>
    <name>autocuts::PanelDocks</name>
    <message>
        <source>Drag to move the panel, double-click to take it out of the window</source>
        <translation>Ziehen verschiebt den Bereich, ein Doppelklick löst ihn aus dem Fenster</translation>
    </message>
</context>
<context>
    <name>autocuts::PathField</name>
    <message>
        <source>&amp;Browse...</source>
        <translation>&amp;Suchen...</translation>
    </message>
    <message>
        <source>Enter a file name.</source>
        <translation>Geben Sie einen Dateinamen ein.</translation>
    </message>
    <message>
        <source>This is a folder.</source>
        <translation>Das ist ein Ordner.</translation>
    </message>
    <message>
        <source>There is no such folder.</source>
        <translation>Diesen Ordner gibt es nicht.</translation>
    </message>
    <message>
        <source>Replace %1?</source>
        <translation>%1 ersetzen?</translation>
    </message>
    <message>
        <source>Its content is lost.</source>
        <translation>Der Inhalt geht verloren.</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Ersetzen</translation>
    </message>
</context>
<context>
    <name>autocuts::PictureController</name>
    <message>
        <source>Baking</source>
        <translation>Backen</translation>
    </message>
    <message>
        <source>Carrying textures over</source>
        <translation>Texturen werden übertragen</translation>
    </message>
    <message>
        <source>Baking light</source>
        <translation>Licht wird gebacken</translation>
    </message>
    <message>
        <source>%1. The UV set %2 is the active one now</source>
        <translation>%1. Der UV-Satz %2 ist jetzt der aktive</translation>
    </message>
</context>
<context>
    <name>autocuts::PinTool</name>
    <message>
        <source>Pin islands: click or drag a box to pin, Shift makes soft pins, Ctrl+box unpins, drag a pin to move all of its island</source>
        <translation>Inseln pinnen: klicken oder einen Rahmen aufziehen, Umschalt setzt weiche Pins, Strg+Rahmen löst Pins, einen Pin ziehen verschiebt seine ganze Insel</translation>
    </message>
    <message>
        <source>Pin vertices: click or drag a box to pin, Shift makes soft pins, Ctrl+box unpins, drag a pin to move it</source>
        <translation>Vertices pinnen: klicken oder einen Rahmen aufziehen, Umschalt setzt weiche Pins, Strg+Rahmen löst Pins, einen Pin ziehen verschiebt ihn</translation>
    </message>
    <message>
        <source>There is no island: click on one to pin it</source>
        <translation>Hier ist keine Insel: klicken Sie auf eine, um sie festzustecken</translation>
    </message>
    <message>
        <source>No vertex is near: click on one, or drag a box around several</source>
        <translation>Kein Eckpunkt ist in der Nähe: klicken Sie auf einen, oder ziehen Sie einen Rahmen um mehrere</translation>
    </message>
</context>
<context>
    <name>autocuts::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Restore &amp;defaults</source>
        <translation>Vor&amp;gabewerte</translation>
    </message>
    <message>
        <source>Blender</source>
        <translation>Blender</translation>
    </message>
    <message>
        <source>Maya</source>
        <translation>Maya</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Start &amp;solving when a model without UVs is opened</source>
        <translation>Berechnung &amp;starten, wenn ein Modell ohne UVs geöffnet wird</translation>
    </message>
    <message>
        <source>Never</source>
        <translation>Nie</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Maus</translation>
    </message>
    <message>
        <source>&amp;Navigation:</source>
        <translation>&amp;Navigation:</translation>
    </message>
    <message>
        <source>Blender: middle button turns, with Shift moves, the wheel zooms. Maya: Alt with the left button turns, middle moves, right zooms.</source>
        <translation>Blender: die mittlere Taste dreht, mit Umschalt verschiebt sie, das Mausrad zoomt. Maya: Alt mit der linken Taste dreht, mit der mittleren verschiebt, mit der rechten zoomt.</translation>
    </message>
    <message>
        <source>New sessions</source>
        <translation>Neue Sitzungen</translation>
    </message>
    <message>
        <source>&amp;Texture size:</source>
        <translation>&amp;Texturgröße:</translation>
    </message>
    <message>
        <source>&amp;Margin between islands:</source>
        <translation>&amp;Abstand der Inseln:</translation>
    </message>
    <message>
        <source>&amp;Distortion budget:</source>
        <translation>&amp;Verzerrungsbudget:</translation>
    </message>
    <message>
        <source>4 is a map without any distortion; 4.1 is hardly seen.</source>
        <translation>4 ist eine Map ohne jede Verzerrung; 4,1 sieht man kaum.</translation>
    </message>
    <message>
        <source>Safety</source>
        <translation>Sicherheit</translation>
    </message>
    <message>
        <source>Memory for &amp;undo:</source>
        <translation>S&amp;peicher für Rückgängig:</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Heat-maps in colours that &amp;all can tell apart</source>
        <translation>Heatmaps in Farben, die &amp;alle unterscheiden können</translation>
    </message>
    <message>
        <source>Colour of seams</source>
        <translation>Farbe der Nähte</translation>
    </message>
    <message>
        <source>Colour of the selection</source>
        <translation>Farbe der Auswahl</translation>
    </message>
    <message>
        <source>Colour of forced cuts</source>
        <translation>Farbe erzwungener Schnitte</translation>
    </message>
    <message>
        <source>Colour of joined edges</source>
        <translation>Farbe verbundener Kanten</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>&amp;Theme:</source>
        <translation>&amp;Thema:</translation>
    </message>
    <message>
        <source>S&amp;ize:</source>
        <translation>G&amp;röße:</translation>
    </message>
    <message>
        <source>&amp;Language:</source>
        <translation>Spra&amp;che:</translation>
    </message>
    <message>
        <source>Size, of texts and controls, and language take effect at the next start.</source>
        <translation>Größe (von Texten und Bedienelementen) und Sprache wirken ab dem nächsten Start.</translation>
    </message>
    <message>
        <source>Colours of the views</source>
        <translation>Farben der Ansichten</translation>
    </message>
    <message>
        <source>&amp;Seams:</source>
        <translation>&amp;Nähte:</translation>
    </message>
    <message>
        <source>S&amp;election:</source>
        <translation>Aus&amp;wahl:</translation>
    </message>
    <message>
        <source>Forced &amp;cuts:</source>
        <translation>&amp;Erzwungene Schnitte:</translation>
    </message>
    <message>
        <source>&amp;Joined edges:</source>
        <translation>&amp;Verbundene Kanten:</translation>
    </message>
    <message>
        <source>Show the te&amp;xtures of a model when it is opened</source>
        <translation>Te&amp;xturen eines Modells beim Öffnen zeigen</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>&amp;Autosave at the latest after:</source>
        <translation>A&amp;utomatisch sichern spätestens nach:</translation>
    </message>
    <message>
        <source>&amp;Let other programs of mine link to this one</source>
        <translation>Andere Progra&amp;mme von mir verbinden lassen</translation>
    </message>
    <message>
        <source>Such as Blender, by Open in Autocuts; nothing is reached from other computers</source>
        <translation>Etwa Blender, mit Open in Autocuts; von anderen Rechnern aus ist nichts erreichbar</translation>
    </message>
</context>
<context>
    <name>autocuts::PresetDialog</name>
    <message>
        <source>Save settings as preset</source>
        <translation>Einstellungen als Vorlage speichern</translation>
    </message>
    <message>
        <source>The name of a new preset, or of one that is replaced</source>
        <translation>Der Name einer neuen Vorlage, oder einer, die ersetzt wird</translation>
    </message>
    <message>
        <source>The settings of the panels Unwrap and Packing, for other sessions and for the command line: autocuts-cli unwrap --preset NAME</source>
        <translation>Die Einstellungen der Bedienfelder Abwickeln und Packen, für andere Sitzungen und für die Befehlszeile: autocuts-cli unwrap --preset NAME</translation>
    </message>
    <message>
        <source>&amp;Name:</source>
        <translation>&amp;Name:</translation>
    </message>
    <message>
        <source>Type a name first</source>
        <translation>Zuerst einen Namen eingeben</translation>
    </message>
    <message>
        <source>A name has no slash</source>
        <translation>Ein Name hat keinen Schrägstrich</translation>
    </message>
</context>
<context>
    <name>autocuts::PresetMenu</name>
    <message>
        <source>&amp;Save settings as preset...</source>
        <translation>Einstellungen als Vorlage &amp;speichern...</translation>
    </message>
    <message>
        <source>&amp;Delete preset</source>
        <translation>Vorlage &amp;löschen</translation>
    </message>
    <message>
        <source>Settings of the preset %1</source>
        <translation>Einstellungen der Vorlage %1</translation>
    </message>
    <message>
        <source>Settings of the preset %1. For the command line only: %2</source>
        <translation>Einstellungen der Vorlage %1. Nur für die Befehlszeile: %2</translation>
    </message>
    <message>
        <source>Replace the preset %1?</source>
        <translation>Die Vorlage %1 ersetzen?</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Delete the preset %1?</source>
        <translation>Die Vorlage %1 löschen?</translation>
    </message>
    <message>
        <source>Its file is removed.</source>
        <translation>Ihre Datei wird entfernt.</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
</context>
<context>
    <name>autocuts::PreviewDialog</name>
    <message>
        <source>The picture could not be made</source>
        <translation>Das Bild konnte nicht gemacht werden</translation>
    </message>
    <message>
        <source>&amp;Seams</source>
        <translation>&amp;Nähte</translation>
    </message>
    <message>
        <source>Texture preview</source>
        <translation>Texturvorschau</translation>
    </message>
    <message>
        <source>Save &amp;picture...</source>
        <translation>&amp;Bild speichern...</translation>
    </message>
    <message>
        <source>Checkerboard</source>
        <translation>Schachbrett</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Textur</translation>
    </message>
    <message>
        <source>Picture of the layout</source>
        <translation>Bild des Layouts</translation>
    </message>
    <message>
        <source>Texels along the longer side of the texture</source>
        <translation>Texel entlang der längeren Seite der Textur</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>&amp;Load texture...</source>
        <translation>&amp;Textur laden...</translation>
    </message>
    <message>
        <source>Load texture</source>
        <translation>Textur laden</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.tif *.tiff *.bmp *.tga *.webp)</source>
        <translation>Bilder (*.png *.jpg *.jpeg *.tif *.tiff *.bmp *.tga *.webp)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Squares of %1 texels</source>
        <translation>Quadrate von %1 Texeln</translation>
    </message>
    <message>
        <source>Making the picture...</source>
        <translation>Das Bild wird gemacht...</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>PNG-Bild (*.png)</translation>
    </message>
    <message>
        <source>The picture could not be written</source>
        <translation>Das Bild konnte nicht geschrieben werden</translation>
    </message>
    <message>
        <source>Choose another folder, and a name that ends with .png</source>
        <translation>Wählen Sie einen anderen Ordner und einen Namen, der auf .png endet</translation>
    </message>
</context>
<context>
    <name>autocuts::Questions</name>
    <message>
        <source>Unsaved changes</source>
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation>Die Änderungen an %1 speichern?</translation>
    </message>
    <message>
        <source>What is not saved is lost.</source>
        <translation>Was nicht gespeichert ist, geht verloren.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, Zeile %2</translation>
    </message>
    <message>
        <source>Changed on disk</source>
        <translation>Auf der Platte geändert</translation>
    </message>
    <message>
        <source>Another program has changed %1 since it was opened here.</source>
        <translation>Ein anderes Programm hat %1 geändert, seit die Datei hier geöffnet wurde.</translation>
    </message>
    <message>
        <source>Overwrite replaces those changes; a backup of them stays beside the session. Reload loses the changes made here.</source>
        <translation>„Überschreiben“ ersetzt diese Änderungen; neben der Sitzung bleibt eine Sicherung davon. „Neu laden“ verwirft die Änderungen, die hier gemacht wurden.</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>Speichern &amp;unter...</translation>
    </message>
    <message>
        <source>&amp;Overwrite</source>
        <translation>Ü&amp;berschreiben</translation>
    </message>
    <message>
        <source>&amp;Reload</source>
        <translation>&amp;Neu laden</translation>
    </message>
    <message>
        <source>Hidden faces</source>
        <translation>Ausgeblendete Flächen</translation>
    </message>
    <message>
        <source>Hidden faces: %1. Is their map to change too?</source>
        <translation>Ausgeblendete Flächen: %1. Soll sich auch deren Abwicklung ändern?</translation>
    </message>
    <message>
        <source>The answer holds until all faces are shown again.</source>
        <translation>Die Antwort gilt, bis alle Flächen wieder eingeblendet sind.</translation>
    </message>
    <message>
        <source>&amp;Only what is shown</source>
        <translation>&amp;Nur was zu sehen ist</translation>
    </message>
    <message>
        <source>&amp;All faces</source>
        <translation>&amp;Alle Flächen</translation>
    </message>
    <message>
        <source>The file of %1 is gone. Save it anew?</source>
        <translation>Die Datei von %1 ist verschwunden. Neu speichern?</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message numerus="yes">
        <source>Replace %n pictures? Undo does not bring them back.</source>
        <translation>
            <numerusform>%n Bild ersetzen? Rückgängig bringt es nicht zurück.</numerusform>
            <numerusform>%n Bilder ersetzen? Rückgängig bringt sie nicht zurück.</numerusform>
        </translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
</context>
<context>
    <name>autocuts::RecoveryDialog</name>
    <message>
        <source>Recover sessions</source>
        <translation>Sitzungen wiederherstellen</translation>
    </message>
    <message>
        <source>Autocuts ended unexpectedly. These sessions were saved automatically and can be recovered; what was saved by hand is as it was.</source>
        <translation>Autocuts wurde unerwartet beendet. Diese Sitzungen wurden automatisch gesichert und lassen sich wiederherstellen; was von Hand gespeichert wurde, ist, wie es war.</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>Last autosave</source>
        <translation>Letzte Sicherung</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>&amp;Recover</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>&amp;Später</translation>
    </message>
    <message>
        <source>Ask again at the next start</source>
        <translation>Beim nächsten Start wieder fragen</translation>
    </message>
    <message>
        <source>Never saved</source>
        <translation>Nie gespeichert</translation>
    </message>
    <message>
        <source>%1 (never saved)</source>
        <translation>%1 (nie gespeichert)</translation>
    </message>
    <message>
        <source>Discard what was recovered of %1?</source>
        <translation>Verwerfen, was von %1 wiederhergestellt wurde?</translation>
    </message>
    <message>
        <source>The changes since it was last saved by hand are lost.</source>
        <translation>Die Änderungen, seit zuletzt von Hand gespeichert wurde, gehen verloren.</translation>
    </message>
</context>
<context>
    <name>autocuts::RectangleBar</name>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Hard</source>
        <translation>Hart</translation>
    </message>
    <message>
        <source>Hard: no face may leave. Soft: leaving costs energy</source>
        <translation>Hart: keine Fläche darf heraus. Weich: herauszugehen kostet Energie</translation>
    </message>
    <message>
        <source>How strongly faces are pulled into this rectangle, as a factor of beta</source>
        <translation>Wie stark Flächen in dieses Rechteck gezogen werden, als Faktor von Beta</translation>
    </message>
    <message>
        <source>Assign the selected faces</source>
        <translation>Die ausgewählten Flächen zuweisen</translation>
    </message>
    <message>
        <source>Pack its islands into the rectangle, or the selected ones when it has none</source>
        <translation>Seine Inseln in das Rechteck packen, oder die ausgewählten, wenn es keine hat</translation>
    </message>
    <message>
        <source>Let all its faces go</source>
        <translation>Alle seine Flächen freigeben</translation>
    </message>
    <message>
        <source>Remove the rectangle [Del]</source>
        <translation>Das Rechteck entfernen [Entf]</translation>
    </message>
    <message>
        <source>U</source>
        <translation>U</translation>
    </message>
    <message>
        <source>Left side</source>
        <translation>Linke Seite</translation>
    </message>
    <message>
        <source>V</source>
        <translation>V</translation>
    </message>
    <message>
        <source>Lower side</source>
        <translation>Untere Seite</translation>
    </message>
    <message>
        <source>W</source>
        <translation>B</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>H</source>
        <translation>H</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>UV</source>
        <translation>UV</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>UV units, or texels of the texture size of the Packing panel</source>
        <translation>UV-Einheiten, oder Texel der Texturgröße aus dem Bedienfeld Packen</translation>
    </message>
    <message>
        <source>A hard rectangle is obeyed in any case</source>
        <translation>Ein hartes Rechteck wird in jedem Fall eingehalten</translation>
    </message>
    <message>
        <source>No faces belong to it</source>
        <translation>Keine Flächen gehören dazu</translation>
    </message>
</context>
<context>
    <name>autocuts::RectangleTool</name>
    <message>
        <source>Drop into a rectangle to assign the island, outside to let it go</source>
        <translation>In ein Rechteck fallen lassen weist die Insel zu, außerhalb gibt sie frei</translation>
    </message>
    <message>
        <source>Drag handles to resize, the outline to move, islands into it to assign them; double-click: rename, Delete: remove, Ctrl: snap</source>
        <translation>Griffe ziehen ändert die Größe, den Umriss ziehen verschiebt, Inseln hineinziehen weist sie zu; Doppelklick: umbenennen, Entf: entfernen, Strg: einrasten</translation>
    </message>
    <message>
        <source>Rectangles: drag over empty space, or with Shift anywhere, to draw one; drag islands into it</source>
        <translation>Rechtecke: über leerem Raum ziehen, oder mit Umschalt irgendwo, um eines zu zeichnen; Inseln hineinziehen</translation>
    </message>
    <message>
        <source>Rectangle %1</source>
        <translation>Rechteck %1</translation>
    </message>
</context>
<context>
    <name>autocuts::RegionTool</name>
    <message>
        <source>Looking for the largest part without overlaps; Escape: cancel</source>
        <translation>Der größte Teil ohne Überlappungen wird gesucht; Esc: abbrechen</translation>
    </message>
    <message>
        <source>Overlap region: drag it away, then click the rest, which still covers itself; no single region takes all overlaps away</source>
        <translation>Überlappungsbereich: ziehen Sie ihn weg und klicken Sie dann auf den Rest, der sich noch selbst überdeckt; kein einzelner Bereich nimmt alle Überlappungen weg</translation>
    </message>
    <message>
        <source>Overlap region: drag the selection away in the UV view; click elsewhere for another region, Shift adds</source>
        <translation>Überlappungsbereich: die Auswahl in der UV-Ansicht wegziehen; anderswo klicken für einen anderen Bereich, Umschalt fügt hinzu</translation>
    </message>
    <message>
        <source>Overlap region: click where the largest part without overlaps is wanted</source>
        <translation>Überlappungsbereich: klicken, wo der größte Teil ohne Überlappungen gewünscht ist</translation>
    </message>
    <message>
        <source>Looking for a region</source>
        <translation>Bereich wird gesucht</translation>
    </message>
</context>
<context>
    <name>autocuts::ScatterDialog</name>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>How far an island may move along each axis, in texels</source>
        <translation>Wie weit eine Insel sich entlang jeder Achse verschieben darf, in Texeln</translation>
    </message>
    <message>
        <source>How far an island may turn to either side</source>
        <translation>Wie weit eine Insel sich nach jeder Seite drehen darf</translation>
    </message>
    <message>
        <source>How much an island may grow; it may shrink as much</source>
        <translation>Wie viel eine Insel wachsen darf; ebenso viel darf sie schrumpfen</translation>
    </message>
    <message>
        <source>Randomise islands</source>
        <translation>Inseln zufällig anordnen</translation>
    </message>
    <message>
        <source>The same seed gives the same result</source>
        <translation>Derselbe Startwert gibt dasselbe Ergebnis</translation>
    </message>
    <message>
        <source>&amp;Randomise</source>
        <translation>&amp;Anordnen</translation>
    </message>
    <message>
        <source>&amp;Move:</source>
        <translation>&amp;Verschieben:</translation>
    </message>
    <message>
        <source>&amp;Turn:</source>
        <translation>&amp;Drehen:</translation>
    </message>
    <message>
        <source>&amp;Scale:</source>
        <translation>&amp;Skalieren:</translation>
    </message>
    <message>
        <source>S&amp;eed:</source>
        <translation>S&amp;tartwert:</translation>
    </message>
</context>
<context>
    <name>autocuts::SceneLight</name>
    <message>
        <source>The surroundings cannot be shown: %1</source>
        <translation>Die Umgebung lässt sich nicht zeigen: %1</translation>
    </message>
</context>
<context>
    <name>autocuts::ScenePanel</name>
    <message>
        <source>Open a model to see its objects and materials.</source>
        <translation>Öffnen Sie ein Modell, um seine Objekte und Materialien zu sehen.</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objekte</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>Materialien</translation>
    </message>
    <message>
        <source>Objects or groups of the file</source>
        <translation>Objekte oder Gruppen der Datei</translation>
    </message>
    <message>
        <source>Materials of the file</source>
        <translation>Materialien der Datei</translation>
    </message>
    <message>
        <source>Filter by name</source>
        <translation>Nach Namen filtern</translation>
    </message>
    <message>
        <source>Objects and materials</source>
        <translation>Objekte und Materialien</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>Isolieren</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>Aufträge</translation>
    </message>
    <message>
        <source>Show the selected rows alone</source>
        <translation>Nur die ausgewählten Zeilen zeigen</translation>
    </message>
    <message>
        <source>Show everything that is hidden</source>
        <translation>Alles zeigen, was ausgeblendet ist</translation>
    </message>
    <message>
        <source>Unwrap, pack or export the selected rows; also by a right click on the list</source>
        <translation>Die ausgewählten Zeilen abwickeln, packen oder exportieren; auch mit einem Rechtsklick auf die Liste</translation>
    </message>
    <message>
        <source>The file names no materials.</source>
        <translation>Die Datei nennt keine Materialien.</translation>
    </message>
    <message>
        <source>No object has such a name.</source>
        <translation>Kein Objekt hat einen solchen Namen.</translation>
    </message>
    <message>
        <source>No material has such a name.</source>
        <translation>Kein Material hat einen solchen Namen.</translation>
    </message>
    <message>
        <source>Objects: %1, selected: %2, hidden: %3</source>
        <translation>Objekte: %1, ausgewählt: %2, ausgeblendet: %3</translation>
    </message>
    <message>
        <source>Materials: %1, selected: %2, hidden: %3</source>
        <translation>Materialien: %1, ausgewählt: %2, ausgeblendet: %3</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Save figures...</source>
        <translation>Kennzahlen speichern...</translation>
    </message>
    <message>
        <source>Write the figures of the selected rows, or of all, as a table (CSV)</source>
        <translation>Die Kennzahlen der ausgewählten Zeilen, oder aller, als Tabelle schreiben (CSV)</translation>
    </message>
    <message>
        <source>Save figures</source>
        <translation>Kennzahlen speichern</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>autocuts::SceneTable</name>
    <message>
        <source>(no object)</source>
        <translation>(kein Objekt)</translation>
    </message>
    <message>
        <source>(object %1)</source>
        <translation>(Objekt %1)</translation>
    </message>
    <message>
        <source>(no material)</source>
        <translation>(kein Material)</translation>
    </message>
    <message>
        <source>(material %1)</source>
        <translation>(Material %1)</translation>
    </message>
    <message>
        <source>Hidden: a click shows it, with Alt it alone</source>
        <translation>Ausgeblendet: ein Klick zeigt es, mit Alt allein</translation>
    </message>
    <message>
        <source>%1 of its faces are hidden</source>
        <translation>%1 seiner Flächen sind ausgeblendet</translation>
    </message>
    <message>
        <source>Shown: a click hides it, with Alt it alone is shown</source>
        <translation>Gezeigt: ein Klick blendet es aus, mit Alt wird nur es gezeigt</translation>
    </message>
    <message>
        <source>What is shown in the views</source>
        <translation>Was in den Ansichten gezeigt wird</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Name in the file</source>
        <translation>Name in der Datei</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Number of faces</source>
        <translation>Anzahl der Flächen</translation>
    </message>
    <message>
        <source>Islands</source>
        <translation>Inseln</translation>
    </message>
    <message>
        <source>Number of islands of the map</source>
        <translation>Anzahl der Inseln der Map</translation>
    </message>
    <message>
        <source>D</source>
        <translation>D</translation>
    </message>
    <message>
        <source>Mean distortion of its islands, each at its own size: symmetric Dirichlet energy, 4 where nothing is distorted</source>
        <translation>Mittlere Verzerrung seiner Inseln, jede in ihrer eigenen Größe: symmetrische Dirichlet-Energie, 4 wo nichts verzerrt ist</translation>
    </message>
    <message>
        <source>px/unit</source>
        <translation>px/Einheit</translation>
    </message>
    <message>
        <source>Texel density: texels per unit of the model at the texture size of the Packing panel</source>
        <translation>Texeldichte: Texel je Einheit des Modells bei der Texturgröße aus dem Bedienfeld Packen</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>The part of a texture that its islands take</source>
        <translation>Der Teil einer Textur, den seine Inseln einnehmen</translation>
    </message>
</context>
<context>
    <name>autocuts::SeamPanel</name>
    <message>
        <source>Open a model to decide about its seams.</source>
        <translation>Öffnen Sie ein Modell, um über seine Nähte zu entscheiden.</translation>
    </message>
    <message>
        <source>Selected edges</source>
        <translation>Ausgewählte Kanten</translation>
    </message>
    <message>
        <source>Paint selected faces</source>
        <translation>Ausgewählte Flächen bemalen</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Nähte</translation>
    </message>
    <message>
        <source>What seams are worth</source>
        <translation>Was Nähte wert sind</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Freigeben</translation>
    </message>
    <message>
        <source>Free all edges</source>
        <translation>Alle Kanten freigeben</translation>
    </message>
    <message>
        <source>Force a cut along the selected edges</source>
        <translation>Einen Schnitt entlang der ausgewählten Kanten erzwingen</translation>
    </message>
    <message>
        <source>Force the selected edges together</source>
        <translation>Die ausgewählten Kanten zusammenzwingen</translation>
    </message>
    <message>
        <source>Leave the selected edges to the solver</source>
        <translation>Die ausgewählten Kanten dem Solver überlassen</translation>
    </message>
    <message>
        <source>Leave all edges to the solver: no cut and no join is forced</source>
        <translation>Alle Kanten dem Solver überlassen: kein Schnitt und keine Verbindung ist erzwungen</translation>
    </message>
    <message>
        <source>Keep straight</source>
        <translation>Gerade halten</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Freigeben</translation>
    </message>
    <message>
        <source>Lay the selected edges on lines of the map</source>
        <translation>Die ausgewählten Kanten auf Linien der Map legen</translation>
    </message>
    <message>
        <source>The selected edges need not be straight in the map</source>
        <translation>Die ausgewählten Kanten brauchen in der Map nicht gerade zu sein</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Keep together</source>
        <translation>Zusammenhalten</translation>
    </message>
    <message>
        <source>Attract cuts</source>
        <translation>Schnitte anziehen</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Radieren</translation>
    </message>
    <message>
        <source>Erase all paint</source>
        <translation>Alle Farbe entfernen</translation>
    </message>
    <message>
        <source>Seams avoid the edges of the selected faces</source>
        <translation>Nähte meiden die Kanten der ausgewählten Flächen</translation>
    </message>
    <message>
        <source>Seams are welcome on the edges of the selected faces</source>
        <translation>Nähte sind an den Kanten der ausgewählten Flächen willkommen</translation>
    </message>
    <message>
        <source>Take the paint off the edges of the selected faces</source>
        <translation>Die Farbe von den Kanten der ausgewählten Flächen nehmen</translation>
    </message>
    <message>
        <source>Take the paint off the whole model</source>
        <translation>Die Farbe vom ganzen Modell nehmen</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>Of Keep together: a factor of 1 to 100 on the separation energy; of Attract cuts: 1 down to 0</source>
        <translation>Von Zusammenhalten: ein Faktor von 1 bis 100 auf die Trennungsenergie; von Schnitte anziehen: von 1 hinab bis 0</translation>
    </message>
    <message>
        <source>Given seams</source>
        <translation>Vorgegebene Nähte</translation>
    </message>
    <message>
        <source>Edges at which you want seams, by the choices above; light blue in both views</source>
        <translation>Kanten, an denen Sie Nähte wollen, nach der Wahl oben; hellblau in beiden Ansichten</translation>
    </message>
    <message>
        <source>Forced cuts</source>
        <translation>Erzwungene Schnitte</translation>
    </message>
    <message>
        <source>Edges that are cut because you said so</source>
        <translation>Kanten, die geschnitten sind, weil Sie es gesagt haben</translation>
    </message>
    <message>
        <source>Half-cuts</source>
        <translation>Halbe Schnitte</translation>
    </message>
    <message>
        <source>Edges that you cut at one end only</source>
        <translation>Kanten, die Sie nur an einem Ende geschnitten haben</translation>
    </message>
    <message>
        <source>Forced joins</source>
        <translation>Erzwungene Verbindungen</translation>
    </message>
    <message>
        <source>Edges that are held together because you said so</source>
        <translation>Kanten, die zusammengehalten werden, weil Sie es gesagt haben</translation>
    </message>
    <message>
        <source>Painted: keep together</source>
        <translation>Gemalt: zusammenhalten</translation>
    </message>
    <message>
        <source>Edges that seams avoid</source>
        <translation>Kanten, die Nähte meiden</translation>
    </message>
    <message>
        <source>Painted: attract cuts</source>
        <translation>Gemalt: Schnitte anziehen</translation>
    </message>
    <message>
        <source>Edges where seams are welcome</source>
        <translation>Kanten, an denen Nähte willkommen sind</translation>
    </message>
    <message>
        <source>Kept straight</source>
        <translation>Gerade gehalten</translation>
    </message>
    <message>
        <source>Edges that are to lie on lines of the map; lime in both views</source>
        <translation>Kanten, die auf Linien der Map liegen sollen; hellgrün in beiden Ansichten</translation>
    </message>
    <message>
        <source>Seam edges of the map</source>
        <translation>Nahtkanten der Map</translation>
    </message>
    <message>
        <source>Edges whose two sides have different UVs</source>
        <translation>Kanten, deren zwei Seiten verschiedene UVs haben</translation>
    </message>
    <message>
        <source>Seam length</source>
        <translation>Nahtlänge</translation>
    </message>
    <message>
        <source>In the units of the model</source>
        <translation>In den Einheiten des Modells</translation>
    </message>
    <message>
        <source>Seam length, relative</source>
        <translation>Nahtlänge, relativ</translation>
    </message>
    <message>
        <source>On the model scaled to area π</source>
        <translation>Am Modell, skaliert auf den Flächeninhalt π</translation>
    </message>
    <message>
        <source>Select edges to steer them.</source>
        <translation>Wählen Sie Kanten aus, um sie vorzugeben.</translation>
    </message>
    <message>
        <source>Edges selected: %1</source>
        <translation>Ausgewählte Kanten: %1</translation>
    </message>
    <message>
        <source>Select faces to paint their edges.</source>
        <translation>Wählen Sie Flächen aus, um ihre Kanten zu bemalen.</translation>
    </message>
    <message>
        <source>Faces selected: %1</source>
        <translation>Ausgewählte Flächen: %1</translation>
    </message>
    <message>
        <source>Select faces or islands first</source>
        <translation>Wählen Sie zuerst Flächen oder Inseln aus</translation>
    </message>
    <message>
        <source>No edge is cut or joined by hand</source>
        <translation>Keine Kante ist von Hand geschnitten oder verbunden</translation>
    </message>
    <message>
        <source>Nothing is painted</source>
        <translation>Nichts ist bemalt</translation>
    </message>
</context>
<context>
    <name>autocuts::SeamPreferenceForm</name>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>On creases</source>
        <translation>Bei Knicken</translation>
    </message>
    <message>
        <source>On</source>
        <translation>An</translation>
    </message>
    <message>
        <source>Sharp edges</source>
        <translation>Scharfe Kanten</translation>
    </message>
    <message>
        <source>Seams along sharp edges. On creases: where clear creases make up the sharp edges of the model.</source>
        <translation>Nähte entlang scharfer Kanten. Bei Knicken: wo deutliche Knicke die scharfen Kanten des Modells ausmachen.</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>Part of its cost that a seam on a sharp edge saves. Higher: seams leave the creases less often.</source>
        <translation>Anteil seiner Kosten, den eine Naht an einer scharfen Kante spart. Höher: Nähte verlassen die Knicke seltener.</translation>
    </message>
    <message>
        <source>Hide seams</source>
        <translation>Nähte verstecken</translation>
    </message>
    <message>
        <source>Seams rather where the model hides them: in folds, between parts, underneath. 0 is no matter where.</source>
        <translation>Nähte eher dort, wo das Modell sie versteckt: in Falten, zwischen Teilen, unten. Bei 0 ist es gleich, wo.</translation>
    </message>
    <message>
        <source>Sharp edges do not count</source>
        <translation>Scharfe Kanten zählen nicht</translation>
    </message>
</context>
<context>
    <name>autocuts::SeamPriceList</name>
    <message>
        <source>Price seams</source>
        <translation>Preise ermitteln</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Best to drop</source>
        <translation>Am ehesten entfernen</translation>
    </message>
    <message>
        <source>Best to add</source>
        <translation>Am ehesten hinzufügen</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>Saves</source>
        <translation>Spart</translation>
    </message>
    <message>
        <source>D without</source>
        <translation>D ohne</translation>
    </message>
    <message>
        <source>Length that the seams lose without it, on the mesh scaled to area π</source>
        <translation>Länge, die die Nähte ohne sie verlieren, am Mesh, skaliert auf den Flächeninhalt π</translation>
    </message>
    <message>
        <source>Distortion of the map without it; – where it cannot be closed</source>
        <translation>Verzerrung der Map ohne sie; – wo sie sich nicht schließen lässt</translation>
    </message>
    <message>
        <source>Measure what the distortion would be without each seam; with given seams, without each of these</source>
        <translation>Messen, wie die Verzerrung ohne jede einzelne Naht wäre; bei vorgegebenen Nähten ohne jede von diesen</translation>
    </message>
    <message>
        <source>Join the edges of the seam, so that it is no seam any more (Delete)</source>
        <translation>Die Kanten der Naht verbinden, sodass sie keine Naht mehr ist (Entf)</translation>
    </message>
    <message>
        <source>Select the seam whose loss adds the least distortion per length</source>
        <translation>Die Naht auswählen, deren Verlust je Länge die wenigste Verzerrung hinzufügt</translation>
    </message>
    <message>
        <source>Cut the new seam that lowers the distortion most per length</source>
        <translation>Die neue Naht schneiden, die die Verzerrung je Länge am meisten senkt</translation>
    </message>
    <message>
        <source>The map stays within its bound without this seam</source>
        <translation>Die Map bleibt ohne diese Naht innerhalb ihrer Grenze</translation>
    </message>
    <message>
        <source>Not priced since the last change of the map.</source>
        <translation>Seit der letzten Änderung der Map nicht ermittelt.</translation>
    </message>
    <message>
        <source>D is %1; one more seam of %2 would make it %3.</source>
        <translation>D ist %1; eine weitere Naht von %2 würde es zu %3 machen.</translation>
    </message>
    <message>
        <source>D is %1; no further seam would lower it.</source>
        <translation>D ist %1; keine weitere Naht würde es senken.</translation>
    </message>
    <message>
        <source>There is no map yet, or a job is running</source>
        <translation>Es gibt noch keine Map, oder eine Aufgabe läuft</translation>
    </message>
    <message>
        <source>Choose a seam of the list that can be closed</source>
        <translation>Wählen Sie in der Liste eine Naht, die sich schließen lässt</translation>
    </message>
    <message>
        <source>Price the seams first</source>
        <translation>Bewerten Sie zuerst die Nähte</translation>
    </message>
    <message>
        <source>No new seam is known: price the seams first</source>
        <translation>Es ist keine neue Naht bekannt: bewerten Sie zuerst die Nähte</translation>
    </message>
</context>
<context>
    <name>autocuts::SeamTool</name>
    <message>
        <source>Cut: click an edge, drag along a way, double-click a loop, Ctrl+click the way from the last click, Shift clears</source>
        <translation>Schneiden: auf eine Kante klicken, einen Weg entlangziehen, Doppelklick auf eine Schleife, Strg+Klick für den Weg vom letzten Klick, Umschalt löscht</translation>
    </message>
    <message>
        <source>Join: click an edge, drag along a way, double-click a loop, Ctrl+click the way from the last click, Shift clears</source>
        <translation>Verbinden: auf eine Kante klicken, einen Weg entlangziehen, Doppelklick auf eine Schleife, Strg+Klick für den Weg vom letzten Klick, Umschalt löscht</translation>
    </message>
</context>
<context>
    <name>autocuts::SelectActions</name>
    <message>
        <source>Sharp edges</source>
        <translation>Scharfe Kanten</translation>
    </message>
    <message>
        <source>Select the edges that are bent by more than this angle.</source>
        <translation>Die Kanten auswählen, die um mehr als diesen Winkel geknickt sind.</translation>
    </message>
    <message>
        <source>&amp;Angle:</source>
        <translation>&amp;Winkel:</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>Auswä&amp;hlen</translation>
    </message>
    <message>
        <source>Small islands</source>
        <translation>Kleine Inseln</translation>
    </message>
    <message>
        <source>Select the islands that are shorter than this, at %1 texels per tile.</source>
        <translation>Die Inseln auswählen, die kürzer als dies sind, bei %1 Texeln je Kachel.</translation>
    </message>
    <message>
        <source>&amp;Shorter than:</source>
        <translation>&amp;Kürzer als:</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>S&amp;elect</source>
        <translation>Aus&amp;wählen</translation>
    </message>
    <message>
        <source>Texel density outliers</source>
        <translation>Ausreißer der Texeldichte</translation>
    </message>
    <message>
        <source>Select the islands with a texel density off the median, %1 px/unit, by more than this.</source>
        <translation>Die Inseln auswählen, deren Texeldichte um mehr als dies vom Median, %1 px/Einheit, abweicht.</translation>
    </message>
    <message>
        <source>&amp;Off by more than:</source>
        <translation>Abweichung ü&amp;ber:</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Flat with the selection</source>
        <translation>Eben mit der Auswahl</translation>
    </message>
    <message>
        <source>Select the connected faces between which the model is bent by no more than this angle.</source>
        <translation>Die verbundenen Flächen auswählen, zwischen denen das Modell nicht mehr als um diesen Winkel geknickt ist.</translation>
    </message>
</context>
<context>
    <name>autocuts::SelectTool</name>
    <message>
        <source>draw a lasso</source>
        <translation>ein Lasso zeichnen</translation>
    </message>
    <message>
        <source>paint, Shift+wheel sizes</source>
        <translation>malen, Umschalt+Mausrad ändert die Größe</translation>
    </message>
    <message>
        <source>drag a box</source>
        <translation>einen Rahmen aufziehen</translation>
    </message>
    <message>
        <source>Select vertices: click or %1, Shift adds, Ctrl+click takes the shortest way</source>
        <translation>Vertices auswählen: klicken oder %1, Umschalt fügt hinzu, Strg+Klick nimmt den kürzesten Weg</translation>
    </message>
    <message>
        <source>Select edges: click or %1, Shift adds, Ctrl+click takes the shortest way, double-click a loop</source>
        <translation>Kanten auswählen: klicken oder %1, Umschalt fügt hinzu, Strg+Klick nimmt den kürzesten Weg, Doppelklick eine Schleife</translation>
    </message>
    <message>
        <source>Select faces: click or %1, Shift adds, Ctrl takes away, double-click an island</source>
        <translation>Flächen auswählen: klicken oder %1, Umschalt fügt hinzu, Strg nimmt weg, Doppelklick eine Insel</translation>
    </message>
    <message>
        <source>Select islands: click or %1, Shift adds, Ctrl takes away, double-click a connected part</source>
        <translation>Inseln auswählen: klicken oder %1, Umschalt fügt hinzu, Strg nimmt weg, Doppelklick einen zusammenhängenden Teil</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Radius of the brush; Shift+wheel</source>
        <translation>Radius des Pinsels; Umschalt+Mausrad</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
</context>
<context>
    <name>autocuts::ShapeTool</name>
    <message>
        <source>Grab</source>
        <translation>Greifen</translation>
    </message>
    <message>
        <source>Pinch</source>
        <translation>Zusammenziehen</translation>
    </message>
    <message>
        <source>Relax</source>
        <translation>Entspannen</translation>
    </message>
    <message>
        <source>This island is locked</source>
        <translation>Diese Insel ist gesperrt</translation>
    </message>
    <message>
        <source>Relax: stroke over what is distorted</source>
        <translation>Entspannen: über das Verzerrte streichen</translation>
    </message>
    <message>
        <source>Pinch: stroke to draw the map together, Ctrl apart, Shift relaxes</source>
        <translation>Zusammenziehen: streichen zieht die Map zusammen, mit Strg auseinander, Umschalt entspannt</translation>
    </message>
    <message>
        <source>Grab: drag what is under the brush, Shift relaxes</source>
        <translation>Greifen: ziehen, was unter dem Pinsel ist, Umschalt entspannt</translation>
    </message>
    <message>
        <source>%1, %2 %</source>
        <translation>%1, %2 %</translation>
    </message>
    <message>
        <source>%1; wheel with Shift size, Ctrl strength, Alt hardness</source>
        <translation>%1; Mausrad mit Umschalt Größe, Strg Stärke, Alt Härte</translation>
    </message>
</context>
<context>
    <name>autocuts::ShortcutListDialog</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Search actions and keys</source>
        <translation>Aktionen und Tasten suchen</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Aktion</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>Was sie tut</translation>
    </message>
</context>
<context>
    <name>autocuts::ShortcutsPage</name>
    <message>
        <source>&amp;Clear</source>
        <translation>&amp;Leeren</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Zurücksetzen</translation>
    </message>
    <message>
        <source>Reset &amp;all</source>
        <translation>&amp;Alle zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;Take over</source>
        <translation>Über&amp;nehmen</translation>
    </message>
    <message>
        <source>Search actions and keys</source>
        <translation>Aktionen und Tasten suchen</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Aktion</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>No key for this action</source>
        <translation>Keine Taste für diese Aktion</translation>
    </message>
    <message>
        <source>The key that the action had at first</source>
        <translation>Die Taste, die die Aktion am Anfang hatte</translation>
    </message>
    <message>
        <source>The keys that all actions had at first</source>
        <translation>Die Tasten, die alle Aktionen am Anfang hatten</translation>
    </message>
    <message>
        <source>%1 is the key of: %2</source>
        <translation>%1 ist die Taste von: %2</translation>
    </message>
    <message>
        <source>Choose an action first</source>
        <translation>Zuerst eine Aktion wählen</translation>
    </message>
    <message>
        <source>It has no shortcut</source>
        <translation>Sie hat kein Tastenkürzel</translation>
    </message>
    <message>
        <source>It has the shortcut that it came with</source>
        <translation>Sie hat das Tastenkürzel, mit dem sie kam</translation>
    </message>
    <message>
        <source>No shortcut was changed</source>
        <translation>Kein Tastenkürzel wurde geändert</translation>
    </message>
</context>
<context>
    <name>autocuts::SolverController</name>
    <message>
        <source>The distortion of %1 is above the bound of %2: let the solver run on, allow more, or remove joins</source>
        <translation>Die Verzerrung von %1 liegt über der Grenze von %2: lassen Sie den Solver weiterlaufen, erlauben Sie mehr, oder entfernen Sie Verbindungen</translation>
    </message>
    <message>
        <source>The solve has ended: no better map was found, it stays as it was</source>
        <translation>Der Solver ist fertig: Keine bessere Map gefunden, sie bleibt, wie sie war</translation>
    </message>
    <message>
        <source>The solve found no map of this model: Unwrap makes one of flat patches</source>
        <translation>Der Solver fand keine Abwicklung dieses Modells: Abwickeln macht eine aus flachen Stücken</translation>
    </message>
</context>
<context>
    <name>autocuts::SolverPanel</name>
    <message>
        <source>Live map: D %1, seams %2, islands: %3</source>
        <translation>Live-Map: D %1, Nähte %2, Inseln: %3</translation>
    </message>
    <message>
        <source>Open a model to unwrap it.</source>
        <translation>Öffnen Sie ein Modell, um es abzuwickeln.</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Live</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>Erweitert</translation>
    </message>
    <message>
        <source>Make a packed map automatically, within the stretch that is allowed</source>
        <translation>Automatisch eine gepackte Map machen, innerhalb der erlaubten Dehnung</translation>
    </message>
    <message>
        <source>What usually comes next</source>
        <translation>Was meistens als Nächstes kommt</translation>
    </message>
    <message>
        <source>Seam preferences</source>
        <translation>Vorlieben für Nähte</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Starten</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Neustart</translation>
    </message>
    <message>
        <source>Start or pause the solver</source>
        <translation>Den Solver starten oder anhalten</translation>
    </message>
    <message>
        <source>Do one Newton step</source>
        <translation>Einen Newton-Schritt ausführen</translation>
    </message>
    <message>
        <source>Begin anew from the start chosen below</source>
        <translation>Von dem unten gewählten Start aus neu beginnen</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Fertigstellen</translation>
    </message>
    <message>
        <source>Turn the map into a final one: definite seams, no overlaps, within the stretch that is allowed</source>
        <translation>Die Map zu einer endgültigen machen: feste Nähte, keine Überlappungen, innerhalb der erlaubten Dehnung</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Von Hand</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Who chooses lambda and delta</source>
        <translation>Wer Lambda und Delta wählt</translation>
    </message>
    <message>
        <source>You choose lambda and delta</source>
        <translation>Sie wählen Lambda und Delta</translation>
    </message>
    <message>
        <source>The solver finds the shortest seams whose map stays within a distortion bound</source>
        <translation>Der Solver findet die kürzesten Nähte, deren Map innerhalb einer Verzerrungsgrenze bleibt</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Map</translation>
    </message>
    <message>
        <source>Soup</source>
        <translation>Suppe</translation>
    </message>
    <message>
        <source>Ghost</source>
        <translation>Geisterbild</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>What the views show while the solver runs</source>
        <translation>Was die Ansichten zeigen, während der Solver läuft</translation>
    </message>
    <message>
        <source>The definite map: valid at every moment. Pause puts it into the document</source>
        <translation>Die fertige Map: in jedem Augenblick gültig. Anhalten legt sie ins Dokument</translation>
    </message>
    <message>
        <source>The separate triangles that lambda and delta act on; Finish makes a map of them</source>
        <translation>Die einzelnen Dreiecke, auf die Lambda und Delta wirken; Fertigstellen macht eine Map daraus</translation>
    </message>
    <message>
        <source>The other one shines through in the UV view</source>
        <translation>Das jeweils andere scheint in der UV-Ansicht durch</translation>
    </message>
    <message>
        <source>Balance of the energy (1 − λ) D + λ S: 0 is no distortion, 1 is no seams</source>
        <translation>Gleichgewicht der Energie (1 − λ) D + λ S: 0 ist keine Verzerrung, 1 ist keine Nähte</translation>
    </message>
    <message>
        <source>Lambda λ</source>
        <translation>Lambda λ</translation>
    </message>
    <message>
        <source>How sharply an edge is either cut or joined: begin with 1 and halve it as the map settles</source>
        <translation>Wie scharf eine Kante entweder geschnitten oder verbunden ist: beginnen Sie mit 1 und halbieren Sie es, wenn die Map zur Ruhe kommt</translation>
    </message>
    <message>
        <source>Delta δ</source>
        <translation>Delta δ</translation>
    </message>
    <message>
        <source>Halve delta: sharper cuts</source>
        <translation>Delta halbieren: schärfere Schnitte</translation>
    </message>
    <message>
        <source>Double delta: softer cuts</source>
        <translation>Delta verdoppeln: weichere Schnitte</translation>
    </message>
    <message>
        <source>Iteration</source>
        <translation>Iteration</translation>
    </message>
    <message>
        <source>Newton steps since the start</source>
        <translation>Newton-Schritte seit dem Start</translation>
    </message>
    <message>
        <source>Per second</source>
        <translation>Pro Sekunde</translation>
    </message>
    <message>
        <source>Newton steps per second</source>
        <translation>Newton-Schritte pro Sekunde</translation>
    </message>
    <message>
        <source>Energy E</source>
        <translation>Energie E</translation>
    </message>
    <message>
        <source>(1 − λ) D + λ S, and the energy of pins and rectangles</source>
        <translation>(1 − λ) D + λ S, und die Energie der Pins und Rechtecke</translation>
    </message>
    <message>
        <source>Islands</source>
        <translation>Inseln</translation>
    </message>
    <message>
        <source>Islands that joining the nearly joined edges gives</source>
        <translation>Inseln, die sich ergeben, wenn fast verbundene Kanten verbunden werden</translation>
    </message>
    <message>
        <source>Distortion D</source>
        <translation>Verzerrung D</translation>
    </message>
    <message>
        <source>Area-weighted mean of the distortion energy, 4 where nothing is distorted</source>
        <translation>Mit dem Flächeninhalt gewichtetes Mittel der Verzerrungsenergie, 4 wo nichts verzerrt ist</translation>
    </message>
    <message>
        <source>In effect; the distortion budget chooses it by itself</source>
        <translation>In Kraft; das Verzerrungsbudget wählt es selbst</translation>
    </message>
    <message>
        <source>Separation S</source>
        <translation>Trennung S</translation>
    </message>
    <message>
        <source>Smoothed length of the seams, on the mesh scaled to area π</source>
        <translation>Geglättete Länge der Nähte, am Mesh, skaliert auf den Flächeninhalt π</translation>
    </message>
    <message>
        <source>Seam length</source>
        <translation>Nahtlänge</translation>
    </message>
    <message>
        <source>Length of the edges nearer to cut than to joined, on the mesh scaled to area π</source>
        <translation>Länge der Kanten, die eher geschnitten als verbunden sind, am Mesh, skaliert auf den Flächeninhalt π</translation>
    </message>
    <message>
        <source>Converged</source>
        <translation>Konvergiert</translation>
    </message>
    <message>
        <source>Running on the selection</source>
        <translation>Läuft für die Auswahl</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Waiting for a map that obeys the steering</source>
        <translation>Wartet auf eine Map, die den Vorgaben folgt</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Erledigt</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Vorlagen</translation>
    </message>
    <message>
        <source>Settings of this panel and of Packing under a name, also for the command line</source>
        <translation>Einstellungen dieses Bedienfelds und des Packens unter einem Namen, auch für die Befehlszeile</translation>
    </message>
</context>
<context>
    <name>autocuts::SolverSettingsForm</name>
    <message>
        <source>Rigid triangles</source>
        <translation>Starre Dreiecke</translation>
    </message>
    <message>
        <source>Tutte</source>
        <translation>Tutte</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>Zufall</translation>
    </message>
    <message>
        <source>Existing UVs</source>
        <translation>Vorhandene UVs</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Where Restart begins. Rigid: every triangle apart and without distortion. Tutte: flattened with few cuts. Random: triangles thrown anywhere. Existing UVs: the map as it is.</source>
        <translation>Womit Neustart anfängt. Starr: jedes Dreieck für sich und ohne Verzerrung. Tutte: mit wenigen Schnitten flach gelegt. Zufall: Dreiecke irgendwohin geworfen. Vorhandene UVs: die Map, wie sie ist.</translation>
    </message>
    <message>
        <source>Symmetric Dirichlet</source>
        <translation>Symmetrische Dirichlet-Energie</translation>
    </message>
    <message>
        <source>Conformal (AMIPS)</source>
        <translation>Konform (AMIPS)</translation>
    </message>
    <message>
        <source>Distortion</source>
        <translation>Verzerrung</translation>
    </message>
    <message>
        <source>What counts as distortion. Symmetric Dirichlet keeps lengths; conformal keeps angles. Both are 4 where nothing is distorted.</source>
        <translation>Was als Verzerrung zählt. Die symmetrische Dirichlet-Energie erhält Längen; konform erhält Winkel. Beide sind 4, wo nichts verzerrt ist.</translation>
    </message>
    <message>
        <source>Length of seams</source>
        <translation>Länge der Nähte</translation>
    </message>
    <message>
        <source>Number of seam edges</source>
        <translation>Anzahl der Nahtkanten</translation>
    </message>
    <message>
        <source>Minimise</source>
        <translation>Minimieren</translation>
    </message>
    <message>
        <source>What is kept small besides the distortion.</source>
        <translation>Was neben der Verzerrung klein gehalten wird.</translation>
    </message>
    <message>
        <source>Fast</source>
        <translation>Schnell</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Genau</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Solver</translation>
    </message>
    <message>
        <source>Fast: an approximate Newton step, many times quicker. Exact: the full Newton step of the paper.</source>
        <translation>Schnell: ein genäherter Newton-Schritt, um ein Vielfaches schneller. Genau: der volle Newton-Schritt des Artikels.</translation>
    </message>
    <message>
        <source>Rectangles</source>
        <translation>Rechtecke</translation>
    </message>
    <message>
        <source>Weight β of the energy that keeps islands inside their rectangles, 100 by default.</source>
        <translation>Gewicht β der Energie, die Inseln in ihren Rechtecken hält, in der Vorgabe 100.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Another number gives another random start. The same number always gives the same map.</source>
        <translation>Eine andere Zahl gibt einen anderen zufälligen Start. Dieselbe Zahl gibt immer dieselbe Map.</translation>
    </message>
</context>
<context>
    <name>autocuts::StartPage</name>
    <message>
        <source>Recent</source>
        <translation>Zuletzt benutzt</translation>
    </message>
    <message>
        <source>Autocuts</source>
        <translation>Autocuts</translation>
    </message>
    <message>
        <source>UV maps whose cuts and distortion are optimised together</source>
        <translation>UV-Maps, deren Schnitte und Verzerrung gemeinsam optimiert werden</translation>
    </message>
    <message>
        <source>Open a model or a session...</source>
        <translation>Modell oder Sitzung öffnen...</translation>
    </message>
    <message>
        <source>or drop a file on the window</source>
        <translation>oder eine Datei auf das Fenster ziehen</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Zuletzt benutzte Dateien</translation>
    </message>
    <message>
        <source>Reading recent files</source>
        <translation>Zuletzt benutzte Dateien werden gelesen</translation>
    </message>
</context>
<context>
    <name>autocuts::StatusBar</name>
    <message>
        <source>Vertices: %1, corners: %2</source>
        <translation>Vertices: %1, Ecken: %2</translation>
    </message>
    <message>
        <source>Edges: %1, length %2</source>
        <translation>Kanten: %1, Länge %2</translation>
    </message>
    <message>
        <source>Faces: %1, area %2</source>
        <translation>Flächen: %1, Inhalt %2</translation>
    </message>
    <message>
        <source>Islands: %1, %2</source>
        <translation>Inseln: %1, %2</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop the job; what it has so far is used when that makes sense</source>
        <translation>Den Auftrag anhalten; was er bis dahin hat, wird verwendet, wenn das sinnvoll ist</translation>
    </message>
    <message>
        <source>D</source>
        <translation>D</translation>
    </message>
    <message>
        <source>Distortion D: area-weighted mean of the distortion energy, 4 where nothing is distorted</source>
        <translation>Verzerrung D: mit dem Flächeninhalt gewichtetes Mittel der Verzerrungsenergie, 4 wo nichts verzerrt ist</translation>
    </message>
    <message>
        <source>seams</source>
        <translation>Nähte</translation>
    </message>
    <message>
        <source>Length of the seams, on the mesh scaled to area π</source>
        <translation>Länge der Nähte, am Mesh, skaliert auf den Flächeninhalt π</translation>
    </message>
    <message>
        <source>islands</source>
        <translation>Inseln</translation>
    </message>
    <message>
        <source>Number of islands</source>
        <translation>Anzahl der Inseln</translation>
    </message>
    <message>
        <source>flips</source>
        <translation>umgedreht</translation>
    </message>
    <message>
        <source>Flipped triangles of the map</source>
        <translation>Umgedrehte Dreiecke der Map</translation>
    </message>
    <message>
        <source>overlaps</source>
        <translation>Überlappungen</translation>
    </message>
    <message>
        <source>Pairs of triangles of the map that overlap</source>
        <translation>Paare von Dreiecken der Map, die überlappen</translation>
    </message>
    <message>
        <source>λ</source>
        <translation>λ</translation>
    </message>
    <message>
        <source>Lambda in effect: balance of distortion and seams</source>
        <translation>Lambda in Kraft: Gleichgewicht von Verzerrung und Nähten</translation>
    </message>
    <message>
        <source>δ</source>
        <translation>δ</translation>
    </message>
    <message>
        <source>Delta in effect: how sharply edges are cut or joined</source>
        <translation>Delta in Kraft: wie scharf Kanten geschnitten oder verbunden sind</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>Energy E = (1 − λ) D + λ S, and that of pins and rectangles</source>
        <translation>Energie E = (1 − λ) D + λ S, und die der Pins und Rechtecke</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>Separation S: smoothed length of the seams, on the mesh scaled to area π</source>
        <translation>Trennung S: geglättete Länge der Nähte, am Mesh, skaliert auf den Flächeninhalt π</translation>
    </message>
    <message>
        <source>it/s</source>
        <translation>it/s</translation>
    </message>
    <message>
        <source>Newton steps of the solver per second</source>
        <translation>Newton-Schritte des Solvers pro Sekunde</translation>
    </message>
    <message>
        <source>%1…</source>
        <translation>%1…</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Reading textures…</source>
        <translation>Texturen werden gelesen…</translation>
    </message>
    <message>
        <source>%1 – reading textures…</source>
        <translation>%1 – Texturen werden gelesen…</translation>
    </message>
    <message>
        <source>UV set: %1</source>
        <translation>UV-Satz: %1</translation>
    </message>
    <message>
        <source>Soup:</source>
        <translation>Suppe:</translation>
    </message>
    <message>
        <source>These figures are of the separate triangles that lambda and delta act on. Those of the definite map are in the Unwrap panel</source>
        <translation>Diese Werte sind die der einzelnen Dreiecke, auf die Lambda und Delta wirken. Die der fertigen Map stehen im Panel „Abwickeln“</translation>
    </message>
</context>
<context>
    <name>autocuts::StretchControl</name>
    <message>
        <source>D at most %1, a mean stretch of %2</source>
        <translation>D höchstens %1, eine mittlere Dehnung von %2</translation>
    </message>
    <message>
        <source>Mean stretch up to %1</source>
        <translation>Mittlere Dehnung bis %1</translation>
    </message>
    <message>
        <source>very low</source>
        <translation>sehr gering</translation>
    </message>
    <message>
        <source>low</source>
        <translation>gering</translation>
    </message>
    <message>
        <source>medium</source>
        <translation>mittel</translation>
    </message>
    <message>
        <source>high</source>
        <translation>hoch</translation>
    </message>
</context>
<context>
    <name>autocuts::TagDialog</name>
    <message>
        <source>Tags of islands</source>
        <translation>Markierungen von Inseln</translation>
    </message>
    <message>
        <source>A tag that there is, or the name of a new one</source>
        <translation>Eine vorhandene Markierung oder der Name einer neuen</translation>
    </message>
    <message>
        <source>&amp;Tag</source>
        <translation>&amp;Markieren</translation>
    </message>
    <message>
        <source>Give the selected islands this tag</source>
        <translation>Den ausgewählten Inseln diese Markierung geben</translation>
    </message>
    <message>
        <source>&amp;Untag</source>
        <translation>Markierung &amp;entfernen</translation>
    </message>
    <message>
        <source>Take this tag from the selected islands</source>
        <translation>Den ausgewählten Inseln diese Markierung nehmen</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>&amp;Auswählen</translation>
    </message>
    <message>
        <source>Select the islands with this tag</source>
        <translation>Die Inseln mit dieser Markierung auswählen</translation>
    </message>
    <message>
        <source>Islands selected: %1</source>
        <translation>Ausgewählte Inseln: %1</translation>
    </message>
    <message>
        <source>&amp;Name:</source>
        <translation>&amp;Name:</translation>
    </message>
    <message>
        <source>Select islands first</source>
        <translation>Zuerst Inseln auswählen</translation>
    </message>
    <message>
        <source>There is no such tag</source>
        <translation>Diese Markierung gibt es nicht</translation>
    </message>
    <message>
        <source>Type a name first</source>
        <translation>Zuerst einen Namen eingeben</translation>
    </message>
</context>
<context>
    <name>autocuts::Task</name>
    <message>
        <source>There is not enough memory. Close other programs or use a smaller model.</source>
        <translation>Es ist nicht genug Speicher da. Schließen Sie andere Programme oder nehmen Sie ein kleineres Modell.</translation>
    </message>
</context>
<context>
    <name>autocuts::TexelTool</name>
    <message>
        <source>Texels</source>
        <translation>Texel</translation>
    </message>
    <message>
        <source>Texels per length, compared with unpainted faces; Shift goes back to them, Ctrl inverts</source>
        <translation>Texel je Länge, verglichen mit unbemalten Flächen; Umschalt geht dahin zurück, Strg kehrt um</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>%1 times the texels</source>
        <translation>Das %1-Fache der Texel</translation>
    </message>
    <message>
        <source>Texel density %1 times: Shift goes back to 1, Ctrl inverts; wheel with Shift size, Ctrl strength, Alt hardness; X symmetry</source>
        <translation>Texeldichte das %1-Fache: Umschalt geht zurück auf 1, Strg kehrt um; Mausrad mit Umschalt Größe, Strg Stärke, Alt Härte; X Symmetrie</translation>
    </message>
</context>
<context>
    <name>autocuts::TexelWeightActions</name>
    <message>
        <source>Texel density weight</source>
        <translation>Gewicht der Texeldichte</translation>
    </message>
    <message>
        <source>How many times the texels per length of other faces, from 1/8 to 8. Unwrap, Finish and the live solve aim for it.</source>
        <translation>Wie viel mal so viele Texel je Länge wie andere Flächen, von 1/8 bis 8. Abwickeln, Fertigstellen und die Live-Berechnung streben es an.</translation>
    </message>
    <message>
        <source>&amp;Weight:</source>
        <translation>&amp;Gewicht:</translation>
    </message>
    <message>
        <source> times</source>
        <translation> mal</translation>
    </message>
    <message>
        <source>&amp;Set</source>
        <translation>&amp;Setzen</translation>
    </message>
</context>
<context>
    <name>autocuts::TexturePanel</name>
    <message>
        <source>Open a model to give it textures.</source>
        <translation>Öffnen Sie ein Modell, um ihm Texturen zu geben.</translation>
    </message>
    <message>
        <source>Normals for DirectX</source>
        <translation>Normalen für DirectX</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>The material whose pictures are listed; that of the selected face comes by itself</source>
        <translation>Das Material, dessen Bilder aufgeführt sind; das der ausgewählten Fläche kommt von selbst</translation>
    </message>
    <message>
        <source>In the views</source>
        <translation>In den Ansichten</translation>
    </message>
    <message>
        <source>Pictures of the material</source>
        <translation>Bilder des Materials</translation>
    </message>
    <message>
        <source>A double-click chooses another picture</source>
        <translation>Ein Doppelklick wählt ein anderes Bild</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Load folder…</source>
        <translation>Ordner laden …</translation>
    </message>
    <message>
        <source>Finds the pictures of all materials by their names, such as wood_BaseColor.png, wood_Roughness.png or wood_Normal.1001.png</source>
        <translation>Findet die Bilder aller Materialien an ihren Namen, etwa wood_BaseColor.png, wood_Roughness.png oder wood_Normal.1001.png</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Laden …</translation>
    </message>
    <message>
        <source>Chooses the picture of the marked channel</source>
        <translation>Wählt das Bild des markierten Kanals</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>The marked channel loses its picture, or gets back that of the model&apos;s file</source>
        <translation>Der markierte Kanal verliert sein Bild, oder bekommt das aus der Datei des Modells zurück</translation>
    </message>
    <message>
        <source>The green of the normal map points down, as DirectX has it; otherwise up, as in OpenGL. The wrong one makes bumps look like dents</source>
        <translation>Das Grün der Normalen zeigt nach unten, wie bei DirectX; sonst nach oben, wie bei OpenGL. Mit dem falschen sehen Beulen wie Dellen aus</translation>
    </message>
    <message>
        <source>Material %1</source>
        <translation>Material %1</translation>
    </message>
    <message>
        <source>Faces without a material</source>
        <translation>Flächen ohne Material</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>in the model&apos;s file</source>
        <translation>in der Datei des Modells</translation>
    </message>
    <message>
        <source>red</source>
        <translation>Rot</translation>
    </message>
    <message>
        <source>green</source>
        <translation>Grün</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>Blau</translation>
    </message>
    <message>
        <source>alpha</source>
        <translation>Alpha</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Load a folder of textures</source>
        <translation>Einen Ordner mit Texturen laden</translation>
    </message>
    <message>
        <source>no picture in the folder has the name of a channel</source>
        <translation>kein Bild in dem Ordner trägt den Namen eines Kanals</translation>
    </message>
    <message>
        <source>no picture in the folder has the name of a material: %1</source>
        <translation>kein Bild in dem Ordner trägt den Namen eines Materials: %1</translation>
    </message>
    <message>
        <source>Names such as %1_BaseColor.png, %1_Roughness.png and %1_Normal.png are understood</source>
        <translation>Namen wie %1_BaseColor.png, %1_Roughness.png und %1_Normal.png werden verstanden</translation>
    </message>
    <message>
        <source>%1; left out: %2</source>
        <translation>%1; ausgelassen: %2</translation>
    </message>
    <message>
        <source>Load a picture: %1</source>
        <translation>Ein Bild laden: %1</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Bilder (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Channels found: %1</source>
        <translation>Gefundene Kanäle: %1</translation>
    </message>
    <message>
        <source>Packed…</source>
        <translation>Gepackt …</translation>
    </message>
    <message>
        <source>Loads one picture that holds three channels: in its red, its green and its blue</source>
        <translation>Lädt ein Bild, das drei Kanäle enthält: in Rot, Grün und Blau</translation>
    </message>
    <message>
        <source>Occlusion, roughness, metalness (ORM, glTF)</source>
        <translation>Verdeckung, Rauheit, Metall (ORM, glTF)</translation>
    </message>
    <message>
        <source>Metalness, roughness, occlusion (MRA)</source>
        <translation>Metall, Rauheit, Verdeckung (MRA)</translation>
    </message>
    <message>
        <source>Roughness, metalness, occlusion (RMA)</source>
        <translation>Rauheit, Metall, Verdeckung (RMA)</translation>
    </message>
    <message>
        <source>Which numbers of its picture the marked channel is: several channels may share one picture, such as occlusion in red, roughness in green and metalness in blue</source>
        <translation>Welche Zahlen seines Bildes der markierte Kanal ist: Mehrere Kanäle können ein Bild teilen, etwa Verdeckung in Rot, Rauheit in Grün und Metall in Blau</translation>
    </message>
    <message>
        <source>Taken from</source>
        <translation>Kommt aus</translation>
    </message>
    <message>
        <source>all colours</source>
        <translation>allen Farben</translation>
    </message>
    <message>
        <source>Load a picture with three channels</source>
        <translation>Ein Bild mit drei Kanälen laden</translation>
    </message>
    <message>
        <source>The marked channel has no picture</source>
        <translation>Der markierte Kanal hat kein Bild</translation>
    </message>
    <message>
        <source>The material has no normal map</source>
        <translation>Das Material hat keine Normal-Map</translation>
    </message>
    <message>
        <source>The model has no other material</source>
        <translation>Das Modell hat kein anderes Material</translation>
    </message>
    <message>
        <source>Nothing else fits this channel</source>
        <translation>Nichts anderes passt zu diesem Kanal</translation>
    </message>
</context>
<context>
    <name>autocuts::ToolOptionBar</name>
    <message>
        <source>Tool options</source>
        <translation>Werkzeugoptionen</translation>
    </message>
</context>
<context>
    <name>autocuts::TransferDialog</name>
    <message>
        <source>O&amp;nly the selected faces</source>
        <translation>&amp;Nur die ausgewählten Flächen</translation>
    </message>
    <message>
        <source>Transfer UVs</source>
        <translation>UVs übertragen</translation>
    </message>
    <message>
        <source>&amp;Browse...</source>
        <translation>&amp;Suchen...</translation>
    </message>
    <message>
        <source>The same polygons, otherwise by position</source>
        <translation>Gleiche Polygone, sonst nach der Lage</translation>
    </message>
    <message>
        <source>Only if the polygons are the same</source>
        <translation>Nur wenn die Polygone gleich sind</translation>
    </message>
    <message>
        <source>By position</source>
        <translation>Nach der Lage</translation>
    </message>
    <message>
        <source>The same polygons: UVs are copied, wherever the models lie. By position: every face takes the UVs of the nearest points of the surface, for models of another resolution; both must lie in the same place.</source>
        <translation>Gleiche Polygone: UVs werden kopiert, wo auch immer die Modelle liegen. Nach der Lage: jede Fläche nimmt die UVs der nächsten Punkte der Oberfläche, für Modelle anderer Auflösung; beide müssen an derselben Stelle liegen.</translation>
    </message>
    <message>
        <source>&amp;Transfer</source>
        <translation>Ü&amp;bertragen</translation>
    </message>
    <message>
        <source>&amp;From:</source>
        <translation>&amp;Von:</translation>
    </message>
    <message>
        <source>F&amp;ile:</source>
        <translation>&amp;Datei:</translation>
    </message>
    <message>
        <source>&amp;UV set:</source>
        <translation>&amp;UV-Satz:</translation>
    </message>
    <message>
        <source>&amp;Object:</source>
        <translation>&amp;Objekt:</translation>
    </message>
    <message>
        <source>&amp;Match:</source>
        <translation>&amp;Zuordnung:</translation>
    </message>
    <message>
        <source>A file</source>
        <translation>Eine Datei</translation>
    </message>
    <message>
        <source>Another UV set</source>
        <translation>Ein anderer UV-Satz</translation>
    </message>
    <message>
        <source>Object %1</source>
        <translation>Objekt %1</translation>
    </message>
    <message>
        <source>An object of this model</source>
        <translation>Ein Objekt dieses Modells</translation>
    </message>
    <message>
        <source>Its UVs go to every other object, or to those with selected faces</source>
        <translation>Seine UVs gehen an jedes andere Objekt, oder an die mit ausgewählten Flächen</translation>
    </message>
    <message>
        <source>Choose a model or a session that has UVs.</source>
        <translation>Wählen Sie ein Modell oder eine Sitzung mit UVs.</translation>
    </message>
    <message>
        <source>There is no such file.</source>
        <translation>Diese Datei gibt es nicht.</translation>
    </message>
    <message>
        <source>Select faces first</source>
        <translation>Zuerst Flächen auswählen</translation>
    </message>
</context>
<context>
    <name>autocuts::UnwrapForm</name>
    <message>
        <source>Unwrap</source>
        <translation>Abwickeln</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Dehnung</translation>
    </message>
    <message>
        <source>Seams where they are hard to see</source>
        <translation>Nähte, wo man sie kaum sieht</translation>
    </message>
    <message>
        <source>Seams rather in folds, between parts, underneath; Advanced sets how strongly</source>
        <translation>Nähte eher in Falten, zwischen Teilen, unten; wie sehr, steht unter Erweitert</translation>
    </message>
    <message>
        <source>Seams along sharp edges</source>
        <translation>Nähte entlang scharfer Kanten</translation>
    </message>
    <message>
        <source>Where clear creases make up the sharp edges, seams rather run along them; Advanced sets how strongly</source>
        <translation>Wo deutliche Knicke die scharfen Kanten ausmachen, verlaufen Nähte eher an ihnen entlang; wie sehr, steht unter Erweitert</translation>
    </message>
    <message>
        <source>Straight and along the axes</source>
        <translation>Gerade und entlang der Achsen</translation>
    </message>
    <message>
        <source>On hard surfaces, islands run along the axes, and what is straight on the model is straight in the map, as far as the stretch allows; seams become a little longer</source>
        <translation>Auf harten Oberflächen liegen Inseln entlang der Achsen, und was am Modell gerade ist, ist in der Map gerade, soweit die Dehnung es erlaubt; Nähte werden etwas länger</translation>
    </message>
    <message>
        <source>Mirrored maps of mirrored parts</source>
        <translation>Gespiegelte Maps für gespiegelte Teile</translation>
    </message>
    <message>
        <source>Symmetric islands get symmetric maps, those of a left and a right part mirror images of each other; goes with the same cuts on both sides</source>
        <translation>Symmetrische Inseln bekommen symmetrische Maps, die eines linken und eines rechten Teils sind Spiegelbilder voneinander; passt zu gleichen Schnitten auf beiden Seiten</translation>
    </message>
    <message>
        <source>Any direction</source>
        <translation>Jede Richtung</translation>
    </message>
    <message>
        <source>Y of the model</source>
        <translation>Y des Modells</translation>
    </message>
    <message>
        <source>Z of the model</source>
        <translation>Z des Modells</translation>
    </message>
    <message>
        <source>Up in the map</source>
        <translation>Oben in der Map</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Beste</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>How much work Unwrap puts into short seams</source>
        <translation>Wie viel Arbeit Abwickeln in kurze Nähte steckt</translation>
    </message>
    <message>
        <source>How much the map may be stretched: little stretch needs long seams. D is the mean symmetric Dirichlet energy over the surface, 4 where nothing is distorted. Also used by the live solve and Finish.</source>
        <translation>Wie stark die Map gedehnt sein darf: wenig Dehnung braucht lange Nähte. D ist die mittlere symmetrische Dirichlet-Energie der Oberfläche, 4 wo nichts verzerrt ist. Gilt auch für die Live-Berechnung und Fertigstellen.</translation>
    </message>
    <message>
        <source>Keep flat faces rigid</source>
        <translation>Ebene Flächen starr lassen</translation>
    </message>
    <message>
        <source>Flat faces, and what unrolls without stretch, keep their shape; the stretch goes to the curved parts. Off: seams become shorter, and faces bend</source>
        <translation>Ebene Flächen, und was sich ohne Dehnung abrollen lässt, behalten ihre Form; gedehnt wird, was gewölbt ist. Aus: Die Nähte werden kürzer, und Flächen verbiegen sich</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Organic</source>
        <translation>Organisch</translation>
    </message>
    <message>
        <source>Hard surface</source>
        <translation>Harte Oberfläche</translation>
    </message>
    <message>
        <source>Recognise</source>
        <translation>Erkennen</translation>
    </message>
    <message>
        <source>Recognise (organic)</source>
        <translation>Erkennen (organisch)</translation>
    </message>
    <message>
        <source>Recognise (hard surface)</source>
        <translation>Erkennen (harte Oberfläche)</translation>
    </message>
    <message>
        <source>Recognise (%1 % hard surface)</source>
        <translation>Erkennen (%1 % harte Oberfläche)</translation>
    </message>
    <message>
        <source>What the model is like. Hard surface: flat faces with sharp edges; these keep their shape and get the seams. Organic: curved, so that the stretch may go anywhere. Recognise: each part by itself</source>
        <translation>Wie das Modell ist. Harte Oberfläche: ebene Flächen mit scharfen Kanten; diese behalten ihre Form und bekommen die Nähte. Organisch: gekrümmt, so dass die Dehnung überall hin darf. Erkennen: jedes Teil für sich</translation>
    </message>
    <message>
        <source>Each on its own</source>
        <translation>Jedes für sich</translation>
    </message>
    <message>
        <source>Same cuts</source>
        <translation>Gleiche Schnitte</translation>
    </message>
    <message>
        <source>Same cuts, stacked</source>
        <translation>Gleiche Schnitte, gestapelt</translation>
    </message>
    <message>
        <source>Alike parts</source>
        <translation>Gleiche Teile</translation>
    </message>
    <message>
        <source>Parts that are copies of each other, also mirrored ones, get the same seams and islands: one of them is solved, which is faster. Stacked: Unwrap also lays islands that are copies on each other. Parts that you cut or join by hand are left out</source>
        <translation>Teile, die Kopien voneinander sind, auch gespiegelte, bekommen dieselben Nähte und Inseln: Nur eines davon wird gelöst, was schneller ist. Gestapelt: Abwickeln legt außerdem Inseln, die Kopien sind, aufeinander. Teile, die Sie von Hand schneiden oder verbinden, sind ausgenommen</translation>
    </message>
    <message>
        <source>An organic surface has no flat faces to keep</source>
        <translation>Eine organische Oberfläche hat keine ebenen Flächen, die zu bewahren wären</translation>
    </message>
    <message>
        <source>Any cuts</source>
        <translation>Beliebige Schnitte</translation>
    </message>
    <message>
        <source>Same cuts if cheap</source>
        <translation>Gleiche Schnitte, wenn billig</translation>
    </message>
    <message>
        <source>Both sides</source>
        <translation>Beide Seiten</translation>
    </message>
    <message>
        <source>Whether both sides of a symmetric model are cut alike. If cheap: Unwrap does so on curved models where its seams hardly become longer, and symmetric seams stay symmetric</source>
        <translation>Ob beide Seiten eines symmetrischen Modells gleich geschnitten werden. Wenn billig: Abwickeln tut es bei gekrümmten Modellen, wo die Nähte kaum länger werden, und symmetrische Nähte bleiben symmetrisch</translation>
    </message>
    <message>
        <source>Y if cheap</source>
        <translation>Y, wenn billig</translation>
    </message>
    <message>
        <source>Z if cheap</source>
        <translation>Z, wenn billig</translation>
    </message>
    <message>
        <source>Turns islands so that this direction is up; they are packed as they stand. If cheap: an unwrap does so where it costs at most 5 % of the texel density</source>
        <translation>Dreht Inseln so, dass diese Richtung oben ist; sie werden gepackt, wie sie stehen. Wenn billig: Abwickeln tut es, wo es höchstens 5 % der Texeldichte kostet</translation>
    </message>
</context>
<context>
    <name>autocuts::UvActions</name>
    <message>
        <source>&amp;Pause</source>
        <translation>Anhal&amp;ten</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>S&amp;tarten</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Starten</translation>
    </message>
    <message>
        <source>Lambda is %1 already and cannot go further</source>
        <translation>Lambda ist schon %1 und kann nicht weiter</translation>
    </message>
    <message>
        <source>Delta is %1 already and cannot go further</source>
        <translation>Delta ist schon %1 und kann nicht weiter</translation>
    </message>
    <message>
        <source>Lambda and delta are set by hand now: undo, or %1, leaves them to the solver</source>
        <translation>Lambda und Delta werden jetzt von Hand gesetzt: Rückgängig oder %1 überlässt sie wieder dem Solver</translation>
    </message>
    <message>
        <source>Nothing to do: the selected islands are so already</source>
        <translation>Nichts zu tun: Die ausgewählten Inseln sind schon so</translation>
    </message>
</context>
<context>
    <name>autocuts::UvSetPanel</name>
    <message>
        <source>Open a model to see its UV sets.</source>
        <translation>Öffnen Sie ein Modell, um seine UV-Sätze zu sehen.</translation>
    </message>
    <message>
        <source>UV sets</source>
        <translation>UV-Sätze</translation>
    </message>
    <message>
        <source>The chosen set is shown and edited; a double-click renames it</source>
        <translation>Der gewählte Satz wird gezeigt und bearbeitet; ein Doppelklick benennt ihn um</translation>
    </message>
    <message>
        <source>A job is running: wait for its end, or cancel it</source>
        <translation>Eine Aufgabe läuft: warten Sie ihr Ende ab, oder brechen Sie sie ab</translation>
    </message>
</context>
<context>
    <name>autocuts::UvView</name>
    <message>
        <source>All of the map is hidden</source>
        <translation>Die ganze Map ist ausgeblendet</translation>
    </message>
    <message>
        <source>View &gt; Show all hidden brings it back</source>
        <translation>Ansicht &gt; Ausgeblendetes zeigen holt sie zurück</translation>
    </message>
    <message>
        <source>The map appears here as soon as there is one</source>
        <translation>Die Map erscheint hier, sobald es eine gibt</translation>
    </message>
    <message>
        <source>No UVs yet</source>
        <translation>Noch keine UVs</translation>
    </message>
</context>
<context>
    <name>autocuts::ViewActions</name>
    <message>
        <source>Pictures (%1)</source>
        <translation>Bilder (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Load texture</source>
        <translation>Textur laden</translation>
    </message>
    <message>
        <source>The texture cannot be read: %1</source>
        <translation>Die Textur lässt sich nicht lesen: %1</translation>
    </message>
    <message>
        <source>Choose a PNG, JPEG or TIFF file</source>
        <translation>Wählen Sie eine PNG-, JPEG- oder TIFF-Datei</translation>
    </message>
</context>
<context>
    <name>autocuts::ViewPanel</name>
    <message>
        <source>Open a model to choose how it is shown.</source>
        <translation>Öffnen Sie ein Modell, um zu wählen, wie es gezeigt wird.</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Einfarbig</translation>
    </message>
    <message>
        <source>Islands</source>
        <translation>Inseln</translation>
    </message>
    <message>
        <source>Signed stretch</source>
        <translation>Dehnung mit Vorzeichen</translation>
    </message>
    <message>
        <source>Magnitude of stretch</source>
        <translation>Betrag der Dehnung</translation>
    </message>
    <message>
        <source>Painted weights</source>
        <translation>Gemalte Gewichte</translation>
    </message>
    <message>
        <source>Texel density</source>
        <translation>Texeldichte</translation>
    </message>
    <message>
        <source>Painted texel density</source>
        <translation>Gemalte Texeldichte</translation>
    </message>
    <message>
        <source>What gives the faces their colour</source>
        <translation>Was den Flächen ihre Farbe gibt</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Full colour at</source>
        <translation>Volle Farbe bei</translation>
    </message>
    <message>
        <source>log2 of the area ratio that gets the full colour: at 1 that is half or double the right size</source>
        <translation>log2 des Flächenverhältnisses, das die volle Farbe bekommt: bei 1 ist das die halbe oder doppelte richtige Größe</translation>
    </message>
    <message>
        <source>Symmetric Dirichlet energy that gets the full colour; 4 is without distortion</source>
        <translation>Symmetrische Dirichlet-Energie, die die volle Farbe bekommt; 4 ist ohne Verzerrung</translation>
    </message>
    <message>
        <source>median of the map</source>
        <translation>Median der Map</translation>
    </message>
    <message>
        <source>Right density</source>
        <translation>Richtige Dichte</translation>
    </message>
    <message>
        <source>Texels per length of the model that get the colour in the middle; 0: the median of the map. Painted faces are to have theirs times their weight</source>
        <translation>Texel je Länge des Modells, die die Farbe in der Mitte bekommen; 0: der Median der Map. Bemalte Flächen sollen ihre mal ihr Gewicht haben</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>none: smooth colours</source>
        <translation>keine: glatte Farben</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Faces off the right density by no more than this get one colour, those with too many and with too few texels two others</source>
        <translation>Flächen, die höchstens so weit von der richtigen Dichte abweichen, bekommen eine Farbe, solche mit zu vielen und zu wenigen Texeln zwei andere</translation>
    </message>
    <message>
        <source>log2 of the factor that gets the full colour: at 1 that is half or double the right density</source>
        <translation>log2 des Faktors, der die volle Farbe bekommt: bei 1 ist das die halbe oder doppelte richtige Dichte</translation>
    </message>
    <message>
        <source>px per unit</source>
        <translation>px je Einheit</translation>
    </message>
    <message>
        <source>px per cm</source>
        <translation>px je cm</translation>
    </message>
    <message>
        <source>Shown as</source>
        <translation>Gezeigt als</translation>
    </message>
    <message>
        <source>The length to which texel densities refer</source>
        <translation>Die Länge, auf die sich Texeldichten beziehen</translation>
    </message>
    <message>
        <source> cm</source>
        <translation> cm</translation>
    </message>
    <message>
        <source>Model unit</source>
        <translation>Modelleinheit</translation>
    </message>
    <message>
        <source>How long a unit of the model is: 100 cm for metres, 1 for centimetres, 2.54 for inches</source>
        <translation>Wie lang eine Einheit des Modells ist: 100 cm für Meter, 1 für Zentimeter, 2,54 für Zoll</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>%1 px/cm</source>
        <translation>%1 px/cm</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Vorlagen</translation>
    </message>
    <message>
        <source>Usual right densities</source>
        <translation>Übliche richtige Dichten</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keines</translation>
    </message>
    <message>
        <source>Checkerboard</source>
        <translation>Schachbrett</translation>
    </message>
    <message>
        <source>Lettered cells</source>
        <translation>Beschriftete Felder</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Textur</translation>
    </message>
    <message>
        <source>What lies on the model, and behind the map</source>
        <translation>Was auf dem Modell und hinter der Map liegt</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Muster</translation>
    </message>
    <message>
        <source>Squares</source>
        <translation>Quadrate</translation>
    </message>
    <message>
        <source>Squares along the width of the texture</source>
        <translation>Quadrate entlang der Breite der Textur</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Felder</translation>
    </message>
    <message>
        <source>Lettered cells along the width of the texture</source>
        <translation>Beschriftete Felder entlang der Breite der Textur</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Laden…</translation>
    </message>
    <message>
        <source>Choose the picture to show on the model</source>
        <translation>Das Bild wählen, das auf dem Modell gezeigt wird</translation>
    </message>
    <message>
        <source>Picture that is shown on the model, and behind the map</source>
        <translation>Bild, das auf dem Modell und hinter der Map gezeigt wird</translation>
    </message>
    <message>
        <source> px/cm</source>
        <translation> px/cm</translation>
    </message>
    <message>
        <source> px/unit</source>
        <translation> px/Einheit</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>%1× too small</source>
        <translation>%1× zu klein</translation>
    </message>
    <message>
        <source>right</source>
        <translation>richtig</translation>
    </message>
    <message>
        <source>%1× too large</source>
        <translation>%1× zu groß</translation>
    </message>
    <message>
        <source>1/8</source>
        <translation>1/8</translation>
    </message>
    <message>
        <source>1×</source>
        <translation>1×</translation>
    </message>
    <message>
        <source>8×</source>
        <translation>8×</translation>
    </message>
    <message>
        <source>too coarse</source>
        <translation>zu grob</translation>
    </message>
    <message>
        <source>±%1 %</source>
        <translation>±%1 %</translation>
    </message>
    <message>
        <source>too fine</source>
        <translation>zu fein</translation>
    </message>
    <message>
        <source>%1× too coarse</source>
        <translation>%1× zu grob</translation>
    </message>
    <message>
        <source>%1× too fine</source>
        <translation>%1× zu fein</translation>
    </message>
    <message>
        <source>Textures of the model</source>
        <translation>Texturen des Modells</translation>
    </message>
    <message>
        <source>Textures</source>
        <translation>Texturen</translation>
    </message>
    <message>
        <source>Pictures that the model&apos;s file names. Behind the map lies that of the selected face, or that of the material with the most faces</source>
        <translation>Bilder, die die Datei des Modells nennt. Hinter der Map liegt das der ausgewählten Fläche, oder das des Materials mit den meisten Flächen</translation>
    </message>
    <message>
        <source>being read...</source>
        <translation>wird gelesen...</translation>
    </message>
    <message>
        <source>the model names none</source>
        <translation>das Modell nennt keine</translation>
    </message>
    <message numerus="yes">
        <source>of %n materials</source>
        <translation>
            <numerusform>von %n Material</numerusform>
            <numerusform>von %n Materialien</numerusform>
        </translation>
    </message>
    <message>
        <source>Texture sets in light</source>
        <translation>Textursätze im Licht</translation>
    </message>
    <message>
        <source>Live bake</source>
        <translation>Live-Backen</translation>
    </message>
    <message>
        <source>Vertex colours</source>
        <translation>Vertexfarben</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Map</translation>
    </message>
    <message>
        <source>Which map of the bake is shown while the UVs change</source>
        <translation>Welche Map des Backens gezeigt wird, während sich die UVs ändern</translation>
    </message>
</context>
<context>
    <name>autocuts::WeightTool</name>
    <message>
        <source>Symmetric</source>
        <translation>Symmetrisch</translation>
    </message>
    <message>
        <source>Paint the mirror image, in the plane x = 0, too; X</source>
        <translation>Auch das Spiegelbild an der Ebene x = 0 bemalen; X</translation>
    </message>
    <message>
        <source>%1, %2 %%3</source>
        <translation>%1, %2 %%3</translation>
    </message>
    <message>
        <source>, symmetric about X</source>
        <translation>, symmetrisch zu X</translation>
    </message>
</context>
<context>
    <name>autocuts::Workspace</name>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>UV maps by simultaneous distortion and cut optimization.</source>
        <translation>UV-Maps durch gleichzeitige Optimierung von Verzerrung und Schnitten.</translation>
    </message>
    <message>
        <source>Open a model made by the program: bumpycube, character, torus, machine.</source>
        <translation>Ein vom Programm gemachtes Modell öffnen: bumpycube, character, torus, machine.</translation>
    </message>
    <message>
        <source>Start solving at once.</source>
        <translation>Die Berechnung sofort starten.</translation>
    </message>
    <message>
        <source>A mesh or an .acproj session to open.</source>
        <translation>Ein Mesh oder eine .acproj-Sitzung, die geöffnet wird.</translation>
    </message>
</context>
</TS>
