// A stroke with a brush that shapes the map of a document.
#pragma once

#include "commands/setuvs.h"
#include "solver/definite/mapbrush.h"

#include <memory>

namespace autocuts {

//! Begins at the map of the document. Locked islands, hidden faces and pins stay. All commands of a stroke
//! become one entry of the history.
class BrushStroke final
{
public:
    //! \pre the mesh has area
    BrushStroke(Document &document, UvEdit edit);

    definite::MapBrush &brush() { return mBrush; }
    //! Number of the gesture, for cancelGesture().
    quint64 gesture() const { return mGesture; }
    //! The command that brings the document to the map under the brush.
    std::unique_ptr<SetUvs> command() const;

private:
    Document &mDocument;
    const UvEdit mEdit;
    const quint64 mGesture;
    definite::MapBrush mBrush;
};

} // namespace autocuts
