<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US">
<context>
    <name>UndoText</name>
    <message numerus="yes">
        <source>Tear %n edges</source>
        <translation>
            <numerusform>Tear %n edge</numerusform>
            <numerusform>Tear %n edges</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Rip %n edges</source>
        <translation>
            <numerusform>Rip %n edge</numerusform>
            <numerusform>Rip %n edges</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Stitch %n edges</source>
        <translation>
            <numerusform>Stitch %n edge</numerusform>
            <numerusform>Stitch %n edges</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Pin %n corners</source>
        <translation>
            <numerusform>Pin %n corner</numerusform>
            <numerusform>Pin %n corners</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Unpin %n corners</source>
        <translation>
            <numerusform>Unpin %n corner</numerusform>
            <numerusform>Unpin %n corners</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move %n pins</source>
        <translation>
            <numerusform>Move %n pin</numerusform>
            <numerusform>Move %n pins</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Change %n pins</source>
        <translation>
            <numerusform>Change %n pin</numerusform>
            <numerusform>Change %n pins</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Remove %n rectangles</source>
        <translation>
            <numerusform>Remove rectangle</numerusform>
            <numerusform>Remove %n rectangles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move %n rectangles</source>
        <translation>
            <numerusform>Move rectangle</numerusform>
            <numerusform>Move %n rectangles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Resize %n rectangles</source>
        <translation>
            <numerusform>Resize rectangle</numerusform>
            <numerusform>Resize %n rectangles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Assign faces to %n rectangles</source>
        <translation>
            <numerusform>Assign faces to rectangle</numerusform>
            <numerusform>Assign faces to %n rectangles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Rename %n rectangles</source>
        <translation>
            <numerusform>Rename rectangle</numerusform>
            <numerusform>Rename %n rectangles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Recolor %n rectangles</source>
        <translation>
            <numerusform>Recolor rectangle</numerusform>
            <numerusform>Recolor %n rectangles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Change %n rectangles</source>
        <translation>
            <numerusform>Change rectangle</numerusform>
            <numerusform>Change %n rectangles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Add %n textures</source>
        <translation>
            <numerusform>Add %n texture</numerusform>
            <numerusform>Add %n textures</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Hide %n faces</source>
        <translation>
            <numerusform>Hide %n face</numerusform>
            <numerusform>Hide %n faces</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Show %n faces</source>
        <translation>
            <numerusform>Show %n face</numerusform>
            <numerusform>Show %n faces</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Keep %n edges straight</source>
        <translation>
            <numerusform>Keep %n edge straight</numerusform>
            <numerusform>Keep %n edges straight</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Release %n straight edges</source>
        <translation>
            <numerusform>Release %n straight edge</numerusform>
            <numerusform>Release %n straight edges</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Lock %n islands</source>
        <translation>
            <numerusform>Lock %n island</numerusform>
            <numerusform>Lock %n islands</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Unlock %n islands</source>
        <translation>
            <numerusform>Unlock %n island</numerusform>
            <numerusform>Unlock %n islands</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Stack %n islands</source>
        <translation>
            <numerusform>Stack %n island</numerusform>
            <numerusform>Stack %n islands</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Unstack %n islands</source>
        <translation>
            <numerusform>Unstack %n island</numerusform>
            <numerusform>Unstack %n islands</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Group %n islands</source>
        <translation>
            <numerusform>Group %n island</numerusform>
            <numerusform>Group %n islands</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Ungroup %n islands</source>
        <translation>
            <numerusform>Ungroup %n island</numerusform>
            <numerusform>Ungroup %n islands</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Keep orientation of %n islands</source>
        <translation>
            <numerusform>Keep orientation of %n island</numerusform>
            <numerusform>Keep orientation of %n islands</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Free orientation of %n islands</source>
        <translation>
            <numerusform>Free orientation of %n island</numerusform>
            <numerusform>Free orientation of %n islands</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Clear flags of %n islands</source>
        <translation>
            <numerusform>Clear flags of %n island</numerusform>
            <numerusform>Clear flags of %n islands</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Tag %n islands</source>
        <translation>
            <numerusform>Tag %n island</numerusform>
            <numerusform>Tag %n islands</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Untag %n islands</source>
        <translation>
            <numerusform>Untag %n island</numerusform>
            <numerusform>Untag %n islands</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Cut %n edges</source>
        <translation>
            <numerusform>Cut %n edge</numerusform>
            <numerusform>Cut %n edges</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Join %n edges</source>
        <translation>
            <numerusform>Join %n edge</numerusform>
            <numerusform>Join %n edges</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Clear %n edges</source>
        <translation>
            <numerusform>Clear %n edge</numerusform>
            <numerusform>Clear %n edges</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Paint %n edges</source>
        <translation>
            <numerusform>Paint %n edge</numerusform>
            <numerusform>Paint %n edges</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Texel density weight of %n faces</source>
        <translation>
            <numerusform>Texel density weight of %n face</numerusform>
            <numerusform>Texel density weight of %n faces</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move %n islands</source>
        <translation>
            <numerusform>Move %n island</numerusform>
            <numerusform>Move %n islands</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Rotate %n islands</source>
        <translation>
            <numerusform>Rotate %n island</numerusform>
            <numerusform>Rotate %n islands</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Scale %n islands</source>
        <translation>
            <numerusform>Scale %n island</numerusform>
            <numerusform>Scale %n islands</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Drag %n vertices</source>
        <translation>
            <numerusform>Drag %n vertex</numerusform>
            <numerusform>Drag %n vertices</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Pack %n islands</source>
        <translation>
            <numerusform>Pack %n island</numerusform>
            <numerusform>Pack %n islands</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Align %n islands</source>
        <translation>
            <numerusform>Align %n island</numerusform>
            <numerusform>Align %n islands</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Distribute %n islands</source>
        <translation>
            <numerusform>Distribute %n island</numerusform>
            <numerusform>Distribute %n islands</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Mirror %n islands</source>
        <translation>
            <numerusform>Mirror %n island</numerusform>
            <numerusform>Mirror %n islands</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Orient %n islands</source>
        <translation>
            <numerusform>Orient %n island</numerusform>
            <numerusform>Orient %n islands</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Randomise %n islands</source>
        <translation>
            <numerusform>Randomise %n island</numerusform>
            <numerusform>Randomise %n islands</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Straighten %n chains of edges</source>
        <translation>
            <numerusform>Straighten %n chain of edges</numerusform>
            <numerusform>Straighten %n chains of edges</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Relax %n faces</source>
        <translation>
            <numerusform>Relax %n face</numerusform>
            <numerusform>Relax %n faces</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Align %n islands to the axes</source>
        <translation>
            <numerusform>Align %n island to the axes</numerusform>
            <numerusform>Align %n islands to the axes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Straighten %n faces to a grid</source>
        <translation>
            <numerusform>Straighten %n face to a grid</numerusform>
            <numerusform>Straighten %n faces to a grid</numerusform>
        </translation>
    </message>
</context>
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
    <name>autocuts::FileActions</name>
    <message numerus="yes">
        <source>Replace the pictures of %n tiles?</source>
        <translation>
            <numerusform>Replace the picture of %n tile?</numerusform>
            <numerusform>Replace the pictures of %n tiles?</numerusform>
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
<context>
    <name>autocuts::ViewPanel</name>
    <message numerus="yes">
        <source>of %n materials</source>
        <translation>
            <numerusform>of %n material</numerusform>
            <numerusform>of %n materials</numerusform>
        </translation>
    </message>
</context>
</TS>
