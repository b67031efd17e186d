// The events of Document::changed(). They name what changed, so that views redraw only that.
#pragma once

#include "model/plain/indexranges.h"
#include "model/plain/settingsproperties.h"

#include <QString>

namespace autocuts {

//! Base of all events. Switch over type and cast to the struct of that name.
struct ChangeEvent
{
    enum class Type {
        Model,
        Uv,
        UvSet,
        Seam,
        Pin,
        Rectangle,
        IslandFlag,
        Tag,
        Hidden,
        SolveSettings,
        PackingSettings,
        TexelWeight,
        Textures,
        SharedMeshes
    };

    const Type type;

protected:
    explicit ChangeEvent(Type t) : type(t) {}
    ~ChangeEvent() = default;
};

//! The model and everything that belongs to it were exchanged.
struct ModelEvent final : ChangeEvent
{
    ModelEvent() : ChangeEvent(Type::Model) {}
};

//! The UVs of one UV set changed.
struct UvEvent final : ChangeEvent
{
    enum Property { Values = 1, Scale = 2 };

    UvEvent(int set, int mask, IndexRanges changedCorners)
        : ChangeEvent(Type::Uv), uvSet(set), properties(mask), corners(std::move(changedCorners))
    {}

    int uvSet;
    int properties;      //!< mask of Property
    IndexRanges corners; //!< the corners whose UVs changed
};

//! The list of UV sets or the active set changed.
struct UvSetEvent final : ChangeEvent
{
    enum class Change { Added, Removed, Renamed, Activated };

    UvSetEvent(Change c, int i) : ChangeEvent(Type::UvSet), change(c), index(i) {}

    Change change;
    int index; //!< of the set; after a removal, the index that it had
};

//! Seams changed: states or painted weights of corner pairs, or which edges are kept straight.
struct SeamEvent final : ChangeEvent
{
    enum Property { State = 1, Weight = 2, Straight = 4 };

    SeamEvent(int mask, IndexRanges pairs)
        : ChangeEvent(Type::Seam), properties(mask), cornerPairs(std::move(pairs))
    {}

    int properties; //!< mask of Property
    IndexRanges cornerPairs;
};

//! Pins were added, removed or changed.
struct PinEvent final : ChangeEvent
{
    explicit PinEvent(IndexRanges changedCorners) : ChangeEvent(Type::Pin), corners(std::move(changedCorners))
    {}

    IndexRanges corners;
};

//! One rectangle was added, removed or changed.
struct RectangleEvent final : ChangeEvent
{
    enum Property { Added = 1, Removed = 2, Bounds = 4, Faces = 8, Name = 16, Color = 32, Strength = 64 };

    RectangleEvent(int rectangle, int mask) : ChangeEvent(Type::Rectangle), id(rectangle), properties(mask) {}

    int id;
    int properties; //!< mask of Property; Strength is the choice of hard or soft and the weight
};

//! Flags of faces changed.
struct IslandFlagEvent final : ChangeEvent
{
    enum Property { Locked = 1, Stack = 2, Group = 4, Upright = 8, Aligned = 16 };

    IslandFlagEvent(int mask, IndexRanges changedFaces)
        : ChangeEvent(Type::IslandFlag), properties(mask), faces(std::move(changedFaces))
    {}

    int properties; //!< mask of Property
    IndexRanges faces;
};

//! Painted texel weights of faces changed.
struct TexelWeightEvent final : ChangeEvent
{
    explicit TexelWeightEvent(IndexRanges changedFaces)
        : ChangeEvent(Type::TexelWeight), faces(std::move(changedFaces))
    {}

    IndexRanges faces;
};

//! One tag was added, removed or got other faces.
struct TagEvent final : ChangeEvent
{
    explicit TagEvent(QString tag) : ChangeEvent(Type::Tag), name(std::move(tag)) {}

    QString name;
};

//! Faces were hidden or shown.
struct HiddenEvent final : ChangeEvent
{
    HiddenEvent() : ChangeEvent(Type::Hidden) {}
};

//! The user's texture sets changed.
struct TexturesEvent final : ChangeEvent
{
    TexturesEvent() : ChangeEvent(Type::Textures) {}
};

//! Whether objects share meshes in the written file changed.
struct SharedMeshesEvent final : ChangeEvent
{
    SharedMeshesEvent() : ChangeEvent(Type::SharedMeshes) {}
};

//! Settings of the solver changed.
struct SolveSettingsEvent final : ChangeEvent
{
    explicit SolveSettingsEvent(int mask) : ChangeEvent(Type::SolveSettings), properties(mask) {}

    int properties; //!< mask of SolveProperty
};

//! Settings of the packer changed.
struct PackingSettingsEvent final : ChangeEvent
{
    explicit PackingSettingsEvent(int mask) : ChangeEvent(Type::PackingSettings), properties(mask) {}

    int properties; //!< mask of PackingProperty
};

} // namespace autocuts
