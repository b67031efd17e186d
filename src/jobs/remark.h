// Remarks about the result of a job: as data, and as texts.
#pragma once

#include <QString>
#include <QStringList>

#include <vector>

namespace autocuts::jobs {

//! A fact that the user should know about a result.
struct Remark
{
    enum class Kind {
        Said,          //!< `names` has the whole text, already translated
        FacesNotBaked, //!< `number` faces: without UVs, or on islands that cross the border of their tile
        FacesWithoutPicture, //!< the same, where textures are carried over
        NoSuchColors,        //!< the model has no colours of the chosen kind
        UnreadableTextures,  //!< `names`
        MissingPictures,     //!< `names`
        UnpairedObjects,     //!< `names`: no object of the detailed model belongs to these
        NoCage,              //!< the models are far apart; `number`: the distance that was taken, a share
        TexelsMissed,        //!< `number`: the share of the texels
        CarriedTexelsMissed, //!< the same, of another model's map
        TexelsShared,        //!< `number`: the share of the texels with several faces
        LightCutOff,         //!< `number`: the share of the texels that are brighter than the file can hold

        // Of jobs that make maps: what could not be done.
        NothingFree,     //!< locks, pins, stacks, groups or the scope leave nothing to change
        NoRoom,          //!< for the margins
        NoRoomAtScale,   //!< for the islands at their scale
        TooManyTiles,    //!< the islands need more UDIM tiles than there are
        TooManyGroups,   //!< there are more objects or materials than UDIM tiles
        MadeSmaller,     //!< the islands of some tiles, which should keep their scale
        LargerThanTile,  //!< `number` islands, made smaller to fit
        UnmetPins,       //!< `items`: corners of hard pins
        UnmetJoins,      //!< `items`: edge pairs
        UnmetRectangles, //!< `items`: their indices
        MissingSeams,    //!< `items`: edge pairs that had to be cut, though only given seams may be
        BentLoops,       //!< `items`: edge pairs that should be straight
        HeldTogether,    //!< overlaps of a map that joined edges hold together
        HeldOverlaps,    //!< faces lie on each other that pins or locks hold
        StaysOverlapped, //!< `number` pairs within single polygons or held together by joined edges
        AboveBound,      //!< `number`: the distortion, `limit`
        OnlyPatches,     //!< the mesh is too odd for a map with few seams
        PatchesSoFar,    //!< stopped before there was a map with few seams
        NotStraight,     //!< stopped before all was straight that should be
        NotSymmetric,    //!< the mesh, so that the cuts are free
        PartlySymmetric, //!< `number`: the share of the area that has a mirror image
        NoSymmetricCuts, //!< none met the bound: they are free
        MapCancelled,    //!< stopped before there was a result: the map stays

        // Of the same jobs: what was done.
        NothingGained,  //!< the map stays as it was
        NotReplaced,    //!< `number` islands stay, because there is no room for better ones
        Straight,       //!< stopped, but straight
        Upright,        //!< the islands stand upright
        SymmetricSeams, //!< `number`: the share of their length
        NoOverlaps,     //!< the map stays as it is
        EdgesCut,       //!< `number` edges, to take overlaps apart
        IslandsPacked,  //!< `number` islands, `items`: into these tiles; none: into the one that was chosen
    };
    Kind kind = Kind::Said;
    double number = 0;
    QStringList names = {};
    std::vector<int> items = {};
    double limit = 0;
};

using Remarks = std::vector<Remark>;

//! Adds texts that the model's files have given.
void addSaid(Remarks &warnings, const QStringList &texts);

//! Adds a remark on a share of texels if the share is large enough: single texels at borders are normal.
void addTexels(Remarks &warnings, Remark::Kind kind, long long some, long long all);

//! Translated, one sentence without a full stop.
QString textOf(const Remark &remark);
QStringList textsOf(const Remarks &remarks);
//! The numbers in a row: 3, 17, 20.
QString inWords(const std::vector<int> &numbers);

} // namespace autocuts::jobs
