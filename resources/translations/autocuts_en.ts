<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US">
<context>
    <name>autocuts::CarryDialog</name>
    <message numerus="yes">
        <source>%n of the new files exist already and would be replaced.</source>
        <translation>
            <numerusform>%n of the new files exists already and would be replaced.</numerusform>
            <numerusform>%n of the new files exist already and would be replaced.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>autocuts::MapController</name>
    <message numerus="yes">
        <source>Cancelled: %n pictures were finished in %1</source>
        <translation>
            <numerusform>Cancelled: %n picture was finished in %1</numerusform>
            <numerusform>Cancelled: %n pictures were finished in %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Baked %n pictures into %1</source>
        <translation>
            <numerusform>Baked %n picture into %1</numerusform>
            <numerusform>Baked %n pictures into %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Carried %n pictures over into %1</source>
        <translation>
            <numerusform>Carried %n picture over into %1</numerusform>
            <numerusform>Carried %n pictures over into %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n faces are not baked as a whole: they have no UVs, or their islands reach over the border of their tile</source>
        <translation>
            <numerusform>%n face is not baked as a whole: it has no UVs, or its island reaches over the border of its tile</numerusform>
            <numerusform>%n faces are not baked as a whole: they have no UVs, or their islands reach over the border of their tile</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n faces get nothing: they have no UVs, or their islands cross the border of a tile</source>
        <translation>
            <numerusform>%n face gets nothing: it has no UVs, or its island crosses the border of a tile</numerusform>
            <numerusform>%n faces get nothing: they have no UVs, or their islands cross the border of a tile</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>autocuts::Questions</name>
    <message numerus="yes">
        <source>Replace %n pictures? Undo does not bring them back.</source>
        <translation>
            <numerusform>Replace %n picture? Undo does not bring it back.</numerusform>
            <numerusform>Replace %n pictures? Undo does not bring them back.</numerusform>
        </translation>
    </message>
</context>
</TS>
