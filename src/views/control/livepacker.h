// Showing the islands of a running solve beside each other.
#pragma once

#include "model/document/constraints.h"
#include "model/plain/packingsettings.h"
#include "views/control/jobrunner.h"

#include <QElapsedTimer>

#include <memory>
#include <optional>
#include <vector>

namespace autocuts {

//! Where the pieces of a map in progress are shown. A piece is what hangs together when nearly joined edges
//! count as joined.
struct LiveArrangement
{
    std::vector<int> piece;   //!< per triangle
    std::vector<Vec2> middle; //!< per piece: where the middle of its box is shown
    std::vector<Vec2> extent; //!< per piece: size of its box when it was packed
    std::vector<char> held;   //!< per piece: shown where it is

    bool operator==(const LiveArrangement &) const = default;
};

//! Lays the pieces of the solver's map out without overlaps, by moving each as a whole, on a copy for the
//! views: the solver and the document know nothing of it. A packer in the background makes a new arrangement
//! now and then, when the pieces have changed; between two of them every piece rests in its place. Pieces
//! with pins or in rectangles stay where they are.
class LivePacker final : public QObject
{
    Q_OBJECT

public:
    static constexpr int packInterval = 800; //!< milliseconds between two arrangements
    static constexpr int mostPieces = 400;   //!< a map in more pieces is shown as it is

    explicit LivePacker(QObject *parent = nullptr);

    //! Moves the pieces to their places, and has a new arrangement made when it is time.
    //! \param uv one row per soup corner, texture space
    //! \param separation per corner pair
    void arrange(const std::shared_ptr<const MeshData> &mesh, const Constraints &constraints,
                 const PackingSettings &packing, const std::vector<float> &separation, UvMatrix &uv);
    //! Forgets the arrangement: another solve begins.
    void reset();

    //! What the background does. Nothing when there are too many pieces or only one.
    static std::optional<LiveArrangement>
    makeArrangement(const MeshData &mesh, const std::vector<bool> &heldFaces, const PackingSettings &packing,
                    const std::vector<float> &separation, const UvMatrix &uv, const std::atomic<bool> &stop);

Q_SIGNALS:
    //! There is another arrangement: the map should be shown anew.
    void arranged();

private:
    JobRunner mJobs{JobRunner::OnCancel::LetGo};
    QElapsedTimer mSince;
    std::optional<LiveArrangement> mArrangement;
};

} // namespace autocuts
