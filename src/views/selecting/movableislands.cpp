#include "views/selecting/movableislands.h"

#include "model/document/document.h"
#include "model/editing/arrangement.h"
#include "views/selecting/selecting.h"

namespace autocuts {

MovableIslands movableIslands(const Document &document, const ToolSettings &settings)
{
    MovableIslands result;
    const Islands &all = document.islands();
    for (const int island : all.islandsOf(facesOf(document, document.selection()))) {
        if (document.marks().flagsOf(all.faces(island)).locked != 0)
            continue;
        result.islands.push_back(island);
        result.box.extend(all.box(island));
    }
    if (result.isEmpty())
        return result;
    result.pivot = settings.pivot == Pivot::Cursor   ? settings.cursor
                   : settings.pivot == Pivot::Corner ? Vec2(result.box.min())
                                                     : Vec2(result.box.center());
    if (settings.pivot == Pivot::Individual) {
        for (const IslandPiece &piece : islandPieces(all, document.marks(), result.islands)) {
            for (const int island : piece.islands)
                result.own[island] = piece.box.center();
        }
    }
    return result;
}

} // namespace autocuts
