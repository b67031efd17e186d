// The Layout menu: aligning, distributing, mirroring, turning, stacking and scattering islands.
#pragma once

#include "model/editing/arrangement.h"
#include "views/control/session/studiocontext.h"

#include "commands/setuvs.h"

#include <QObject>

#include <functional>

namespace autocuts {

class Questions;

//! Arranges the selected islands; each operation is one undo entry. A running live solve is paused first. The
//! islands of a group or stack move together as one piece, and locked ones stay.
class IslandActions final : public QObject
{
    Q_OBJECT

public:
    IslandActions(const StudioContext &context, Questions &questions, QObject *parent = nullptr);

Q_SIGNALS:
    //! What was done, or why nothing was. \param message translated, one line, for the status bar
    void said(const QString &message);

private:
    using Pieces = std::vector<IslandPiece>;
    using Transforms = std::vector<Eigen::Affine2d>;

    void connectMoves();
    void connectTurns();
    void connectStacks();
    void connectDialogs();
    //! Calls the function when the solve is paused, if there is a document.
    void onTriggered(const char *id, const std::function<void(Document &)> &function);
    //! Connects an action that moves the pieces of the selection.
    void onPieces(const char *id, UvEdit edit,
                  const std::function<Transforms(const Document &, const Pieces &)> &transforms);
    std::vector<int> selectedIslands(const Document &document) const;
    void stack(Document &document);
    void unstack(Document &document);
    void askScatter(Document &document);
    void askDensity(Document &document);
    void askPackDensity(Document &document);
    void askTile(Document &document);
    void lockTile(Document &document);
    void askTag(Document &document);

    StudioContext mContext;
    Questions &mQuestions;
    ScatterRanges mRanges;                      //!< the values last chosen in the dialog
    int mTile = PackingSettings::firstTile + 1; //!< the same
};

} // namespace autocuts
