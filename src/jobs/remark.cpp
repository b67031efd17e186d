#include "jobs/remark.h"

#include "jobs/jobtexts.h"

namespace autocuts::jobs {

namespace {

//! Share of the texels. Chosen by hand.
constexpr double leastShare = 0.001;

QString percent(double share)
{
    return QString::number(100 * share, 'f', 1);
}

//! What of a map job could not be done.
QString textOfProblem(const Remark &remark)
{
    const QString count = QString::number(std::ssize(remark.items));
    switch (remark.kind) {
    case Remark::Kind::NothingFree:
        return JobTexts::tr(
            "The map stays as it is: locks, pins, stacks, groups or the scope leave nothing to change");
    case Remark::Kind::NoRoom:
        return JobTexts::tr("There is no room for the margins: use a smaller margin or a larger texture");
    case Remark::Kind::NoRoomAtScale:
        return JobTexts::tr(
            "The islands do not fit at their size: switch off \"Keep each island's scale\" or "
            "use a smaller margin");
    case Remark::Kind::TooManyTiles:
        return JobTexts::tr("The islands need more UDIM tiles than there are: choose a lower density or a "
                            "larger texture");
    case Remark::Kind::TooManyGroups:
        return JobTexts::tr("There are more objects or materials than UDIM tiles");
    case Remark::Kind::MadeSmaller:
        return JobTexts::tr("There is no room for the islands at their scale: all of a tile are smaller now");
    case Remark::Kind::LargerThanTile:
        return JobTexts::tr("Islands larger than a tile at this density, and made smaller to fit: %1")
            .arg(remark.number);
    case Remark::Kind::UnmetPins:
        return JobTexts::tr("Hard pins that could not be reached: %1").arg(count);
    case Remark::Kind::UnmetJoins:
        return JobTexts::tr("Joined edges that had to stay open: %1").arg(count);
    case Remark::Kind::UnmetRectangles:
        return JobTexts::tr("Rectangles that islands reach out of: %1").arg(count);
    case Remark::Kind::MissingSeams:
        return JobTexts::tr("Seams that are not given and were needed: %1").arg(count);
    case Remark::Kind::BentLoops:
        return JobTexts::tr("Edges kept straight, which are bent: %1").arg(count);
    case Remark::Kind::HeldTogether:
        return JobTexts::tr("The map still covers itself: joined edges hold it together there. Clear some "
                            "joins and finish again");
    case Remark::Kind::HeldOverlaps:
        return JobTexts::tr("Pins or locks hold faces on each other: remove some of them");
    case Remark::Kind::StaysOverlapped:
        return JobTexts::tr("Overlaps inside single polygons or across joined edges, which stay whole: %1")
            .arg(remark.number);
    case Remark::Kind::AboveBound:
        return JobTexts::tr("The distortion of %1 is above the bound of %2: allow more, or remove joins")
            .arg(remark.number, 0, 'f', 4)
            .arg(remark.limit, 0, 'f', 4);
    case Remark::Kind::OnlyPatches:
        return JobTexts::tr(
            "The mesh is too irregular for a map with few seams: this one is made of many flat patches");
    case Remark::Kind::PatchesSoFar:
        return JobTexts::tr("Stopped before a map with few seams was found: this one is made of many flat "
                            "patches");
    case Remark::Kind::NotStraight:
        return JobTexts::tr("Stopped early: this map is not, or not wholly, straightened");
    case Remark::Kind::NotSymmetric:
        return JobTexts::tr("The mesh is not symmetric: nor are the cuts");
    case Remark::Kind::PartlySymmetric:
        return JobTexts::tr("%1 % of the surface have no mirror image: their cuts are free")
            .arg(percent(1 - remark.number));
    case Remark::Kind::NoSymmetricCuts:
        return JobTexts::tr("No symmetric cuts met the bound: the cuts are free");
    case Remark::Kind::MapCancelled:
        return JobTexts::tr("Stopped before there was a result: the map stays as it was");
    default:
        return {};
    }
}

//! What a map job has done.
QString textOfNote(const Remark &remark)
{
    switch (remark.kind) {
    case Remark::Kind::NothingGained:
        return JobTexts::tr("No better map was found: it stays as it was");
    case Remark::Kind::NotReplaced:
        return JobTexts::tr("Islands that stay as they were, because there is no room for better ones: %1")
            .arg(remark.number);
    case Remark::Kind::Straight:
        return JobTexts::tr("Stopped early: this map is straightened");
    case Remark::Kind::Upright:
        return JobTexts::tr("The islands stand upright");
    case Remark::Kind::SymmetricSeams:
        return JobTexts::tr("Symmetric part of the seams: %1 %").arg(percent(remark.number));
    case Remark::Kind::NoOverlaps:
        return JobTexts::tr("There are no overlaps: the map stays as it is");
    case Remark::Kind::EdgesCut:
        return JobTexts::tr("Edges cut to take overlaps apart: %1").arg(remark.number);
    case Remark::Kind::IslandsPacked:
        return remark.items.empty() ? JobTexts::tr("Islands packed: %1").arg(remark.number)
                                    : JobTexts::tr("Islands packed: %1, into the tiles %2")
                                          .arg(QString::number(remark.number), inWords(remark.items));
    default:
        return {};
    }
}

QString textOfMap(const Remark &remark)
{
    const QString problem = textOfProblem(remark);
    return problem.isEmpty() ? textOfNote(remark) : problem;
}

} // namespace

void addSaid(Remarks &warnings, const QStringList &texts)
{
    for (const QString &text : texts)
        warnings.push_back({Remark::Kind::Said, 0, {text}});
}

void addTexels(Remarks &warnings, Remark::Kind kind, long long some, long long all)
{
    const double share = all > 0 ? double(some) / double(all) : 0;
    if (share >= leastShare)
        warnings.push_back({kind, share});
}

QString textOf(const Remark &remark)
{
    QString names = remark.names.join(QStringLiteral(", "));
    switch (remark.kind) {
    case Remark::Kind::Said:
        return names;
    case Remark::Kind::FacesNotBaked:
        return JobTexts::tr(
            "%n faces are not baked as a whole: they have no UVs, or their islands reach over the "
            "border of their tile",
            nullptr, static_cast<int>(remark.number));
    case Remark::Kind::FacesWithoutPicture:
        return JobTexts::tr("%n faces get nothing: they have no UVs, or their islands cross the border "
                            "of a tile",
                            nullptr, static_cast<int>(remark.number));
    case Remark::Kind::NoSuchColors:
        return JobTexts::tr("The model has no colours of the chosen kind: those of its materials are "
                            "baked");
    case Remark::Kind::UnreadableTextures:
        return JobTexts::tr("Textures that cannot be read: %1").arg(names);
    case Remark::Kind::MissingPictures:
        return JobTexts::tr("Pictures that are not there: %1").arg(names);
    case Remark::Kind::UnpairedObjects:
        return JobTexts::tr("No object of the detailed model belongs to: %1").arg(names);
    case Remark::Kind::NoCage:
        return JobTexts::tr("The detailed model is nowhere near this one: the cage is %1 % of its "
                            "diagonal")
            .arg(100 * remark.number);
    case Remark::Kind::TexelsMissed:
        return JobTexts::tr(
                   "%1 % of the texels found nothing of the detailed model: a larger cage reaches farther")
            .arg(percent(remark.number));
    case Remark::Kind::CarriedTexelsMissed:
        return JobTexts::tr("%1 % of the texels found nothing of the other model")
            .arg(percent(remark.number));
    case Remark::Kind::TexelsShared:
        return JobTexts::tr("%1 % of the texels are shared by several faces and show the first one")
            .arg(percent(remark.number));
    case Remark::Kind::LightCutOff:
        return JobTexts::tr("In %1 % of the texels light is above 1 and was cut off: EXR keeps it, or "
                            "take weaker lights")
            .arg(100 * remark.number, 0, 'f', 0);
    default:
        return textOfMap(remark);
    }
}

QStringList textsOf(const Remarks &remarks)
{
    QStringList texts;
    for (const Remark &remark : remarks)
        texts << textOf(remark);
    return texts;
}

QString inWords(const std::vector<int> &numbers)
{
    QStringList words;
    for (const int number : numbers)
        words << QString::number(number);
    return words.join(QStringLiteral(", "));
}

} // namespace autocuts::jobs
