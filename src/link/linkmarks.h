// What goes both ways over the live link beside models and maps: cuts, pins and the selection.
#pragma once

#include "link/message.h"
#include "link/vertexpairs.h"

#include <QList>

#include <compare>
#include <optional>

namespace autocuts::link {

//! A corner held at a place of the texture, as precise as modelling programs are. The texture is 1 x 1.
struct LinkPin
{
    int corner = 0;
    float u = 0, v = 0;

    auto operator<=>(const LinkPin &) const = default;
};

//! Changes of the marks on a mesh. Both sides send changes only, so that edits of both at the same time add
//! up.
struct MarkChanges
{
    std::vector<VertexPair> cuts, uncuts; //!< edges that are always seams from now on, and no more; ascending
    std::vector<LinkPin> pins;            //!< new or moved, ascending by corner, at most one per corner
    std::vector<int> unpins;              //!< corners, ascending
    std::optional<QList<int>> faces;      //!< all that are selected now, ascending; not set: as before

    bool isEmpty() const
    {
        return cuts.empty() && uncuts.empty() && pins.empty() && unpins.empty() && !faces;
    }
    bool operator==(const MarkChanges &) const = default;

    //! Adds what changes to a message.
    void writeTo(Message &message) const;
    //! Sorts what it reads. \returns an Error when indices are below 0 or not below these numbers, or a pin
    //! has no finite place
    static Result<MarkChanges> read(const Message &message, int vertices, int corners, int faces);
};

//! The marks on a mesh, each list ascending.
struct Marks
{
    std::vector<VertexPair> cuts;
    std::vector<LinkPin> pins;
    QList<int> faces;

    void apply(const MarkChanges &changes);
    MarkChanges changesTo(const Marks &other) const;
};

} // namespace autocuts::link
