// Arranges the islands of a running solve side by side, for the views.
#pragma once

#include "model/document/document.h"
#include "views/control/session/jobrunner.h"

#include <QElapsedTimer>

#include <memory>
#include <optional>
#include <vector>

namespace autocuts {

//! An arrangement of the islands of a map in progress. A *piece* is such an island: triangles connected over
//! edges with a separation below 0.5.
struct LiveArrangement
{
    std::vector<int> piece;   //!< per triangle
    std::vector<Vec2> middle; //!< per piece: the shown centre of its box
    std::vector<Vec2> extent; //!< per piece: size of its box when it was packed
    std::vector<char> held;   //!< per piece: shown at its own position

    bool operator==(const LiveArrangement &) const = default;
};

//! Shows the pieces of the solver's map without overlaps, by moving a copy of each as a whole. The solver and
//! the document are not changed. When the pieces have changed, a packer in the background makes a new
//! arrangement; until then every piece stays in its place. Pieces with pins or in rectangles are not moved.
//! Those of a layout of several tiles are arranged tile by tile.
class LivePacker final : public QObject
{
    Q_OBJECT

public:
    static constexpr int packInterval = 800; //!< milliseconds between two arrangements; chosen by hand
    static constexpr int mostPieces = 400;   //!< maps with more pieces are shown unchanged; chosen by hand

    explicit LivePacker(QObject *parent = nullptr);

    //! Moves the pieces to their places, and starts a new arrangement when it is due.
    //! \param uv one row per soup corner, texture space
    //! \param separation per corner pair
    void arrange(const Document &document, const std::vector<float> &separation, UvMatrix &uv);
    //! Discards the arrangement, for a new solve.
    void reset();

    //! Makes an arrangement; called in the background. \param faceTiles the tile around which the piece of
    //! each face lies, per face; empty, or 0: the first one. Nothing when there are too many pieces, or only
    //! one.
    static std::optional<LiveArrangement>
    makeArrangement(const MeshData &mesh, const std::vector<bool> &heldFaces,
                    const std::vector<int> &faceTiles, const PackingSettings &packing,
                    const std::vector<float> &separation, const UvMatrix &uv, const std::atomic<bool> &stop);

Q_SIGNALS:
    //! There is a new arrangement, so the map should be painted again.
    void arranged();

private:
    JobRunner mJobs{JobRunner::OnCancel::LetGo};
    QElapsedTimer mSince;
    std::optional<LiveArrangement> mArrangement;
};

} // namespace autocuts
