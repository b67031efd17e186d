// The Layout menu: islands aligned, distributed, mirrored, turned, stacked, scattered.
#pragma once

#include "model/document/arrangement.h"
#include "views/control/studiocontext.h"

#include "commands/setuvs.h"

#include <QObject>

#include <functional>

namespace autocuts {

class Questions;

//! Lays out the islands of the selection, each operation as one entry. A live solve is paused first. Islands
//! of one group or stack go as one piece, and locked ones stay.
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
    //! Calls the function once the map rests, when there is a document.
    void onTriggered(const char *id, const std::function<void(Document &)> &function);
    //! Makes an action move the pieces of the selection.
    void onPieces(const char *id, UvEdit edit,
                  const std::function<Transforms(const Document &, const Pieces &)> &transforms);
    std::vector<int> selectedIslands(const Document &document) const;
    void stack(Document &document);
    void unstack(Document &document);
    void askScatter(Document &document);
    void askDensity(Document &document);

    StudioContext mContext;
    Questions &mQuestions;
    ScatterRanges mRanges; //!< asked for last
};

} // namespace autocuts
