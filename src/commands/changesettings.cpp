#include "commands/changesettings.h"

#include "model/plain/settingsproperties.h"

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

//! The label for a change of one property; empty when it changes none or several.
QString solveText(int properties)
{
    switch (properties) {
    case LambdaProperty:
        return UndoText::tr("Change lambda");
    case DeltaProperty:
        return UndoText::tr("Change delta");
    case BoxWeightProperty:
        return UndoText::tr("Change rectangle weight");
    case EnergyProperty:
        return UndoText::tr("Change distortion energy");
    case WeightingProperty:
        return UndoText::tr("Change seam weighting");
    case StartProperty:
        return UndoText::tr("Change start");
    case SolverProperty:
        return UndoText::tr("Change solver");
    case SeedProperty:
        return UndoText::tr("Change seed");
    case CreasesProperty:
        return UndoText::tr("Change seams on creases");
    case CreaseStrengthProperty:
        return UndoText::tr("Change weight of creases");
    case VisibilityProperty:
        return UndoText::tr("Change hiding of seams");
    case SymmetryProperty:
        return UndoText::tr("Change symmetry of cuts");
    case SeamModeProperty:
        return UndoText::tr("Change whose seams");
    case SeamSourcesProperty:
        return UndoText::tr("Change sources of given seams");
    case SharpAngleProperty:
        return UndoText::tr("Change angle of sharp edges");
    case AlignProperty:
        return UndoText::tr("Change alignment to the axes");
    case MirrorMapsProperty:
        return UndoText::tr("Change mirrored maps");
    case WorldUpProperty:
        return UndoText::tr("Change what is up in the map");
    case FlatProperty:
        return UndoText::tr("Change shape of flat faces");
    case SurfaceProperty:
        return UndoText::tr("Change what the model is like");
    case AlikeProperty:
        return UndoText::tr("Change cuts of alike parts");
    case MaxDistortionProperty:
        return UndoText::tr("Change distortion budget");
    default:
        return {};
    }
}

//! The same for the packing settings.
QString packingText(int properties)
{
    switch (properties) {
    case TextureSizeProperty:
        return UndoText::tr("Change texture size");
    case MarginProperty:
        return UndoText::tr("Change margin");
    case UdimTileProperty:
        return UndoText::tr("Change UDIM tile");
    case RotationProperty:
        return UndoText::tr("Change rotation of islands");
    case KeepScaleProperty:
        return UndoText::tr("Change keep scale");
    case BorderProperty:
        return UndoText::tr("Change border of the tile");
    case EffortProperty:
        return UndoText::tr("Change packing effort");
    default:
        return {};
    }
}

} // namespace

ChangeSettings::ChangeSettings(Document &document, const SolveSettings &solve, const PackingSettings &packing)
    : ChangeValue(document, {document.solveSettings(), document.packingSettings()},
                  {isValid(solve) ? solve : document.solveSettings(),
                   packing.isValid() ? packing : document.packingSettings()}),
      mSolveProperties(differences(mBefore.solve, mAfter.solve)),
      mPackingProperties(differences(mBefore.packing, mAfter.packing))
{}

void ChangeSettings::set(const BothSettings &settings)
{
    editor().setSolveSettings(settings.solve);
    editor().setPackingSettings(settings.packing);
}

bool ChangeSettings::absorb(const DocumentCommand &newer)
{
    const auto &other = static_cast<const ChangeSettings &>(newer);
    if (other.mSolveProperties != mSolveProperties || other.mPackingProperties != mPackingProperties)
        return false;
    mAfter = other.mAfter;
    return true;
}

QString ChangeSettings::label() const
{
    const int solve = differences(mBefore.solve, mAfter.solve);
    const int packing = differences(mBefore.packing, mAfter.packing);
    const QString text = packing == 0 ? solveText(solve) : solve == 0 ? packingText(packing) : QString();
    return text.isEmpty() ? UndoText::tr("Change settings") : text;
}

void ChangeSettings::writePayload(QCborMap &map) const
{
    map["solve"_L1] = autocuts::toCbor(mAfter.solve);
    map["packing"_L1] = autocuts::toCbor(mAfter.packing);
}

std::unique_ptr<ChangeSettings> ChangeSettings::fromCbor(Document &document, CborReader &reader)
{
    CborReader solveReader(reader.map("solve"_L1));
    CborReader packingReader(reader.map("packing"_L1));
    const SolveSettings solve = readSolveSettings(solveReader);
    const PackingSettings packing = readPackingSettings(packingReader);
    if (reader.failed() || solveReader.failed() || packingReader.failed())
        return nullptr;
    return std::make_unique<ChangeSettings>(document, solve, packing);
}

} // namespace autocuts
