#include "commands/changesettings.h"

#include "commands/commandreading.h"
#include "model/plain/settingsproperties.h"

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

//! The label for a change of one property; null when it changes none or several.
const char *solveText(int properties)
{
    switch (properties) {
    case LambdaProperty:
        return QT_TRANSLATE_NOOP("Undo Commands", "Change lambda");
    case DeltaProperty:
        return QT_TRANSLATE_NOOP("Undo Commands", "Change delta");
    case BoxWeightProperty:
        return QT_TRANSLATE_NOOP("Undo Commands", "Change rectangle weight");
    case EnergyProperty:
        return QT_TRANSLATE_NOOP("Undo Commands", "Change distortion energy");
    case WeightingProperty:
        return QT_TRANSLATE_NOOP("Undo Commands", "Change seam weighting");
    case StartProperty:
        return QT_TRANSLATE_NOOP("Undo Commands", "Change start");
    case SolverProperty:
        return QT_TRANSLATE_NOOP("Undo Commands", "Change solver");
    case SeedProperty:
        return QT_TRANSLATE_NOOP("Undo Commands", "Change seed");
    case CreasesProperty:
        return QT_TRANSLATE_NOOP("Undo Commands", "Change seams on creases");
    case CreaseStrengthProperty:
        return QT_TRANSLATE_NOOP("Undo Commands", "Change weight of creases");
    case VisibilityProperty:
        return QT_TRANSLATE_NOOP("Undo Commands", "Change hiding of seams");
    case SymmetryProperty:
        return QT_TRANSLATE_NOOP("Undo Commands", "Change symmetry of cuts");
    case SeamModeProperty:
        return QT_TRANSLATE_NOOP("Undo Commands", "Change whose seams");
    case SeamSourcesProperty:
        return QT_TRANSLATE_NOOP("Undo Commands", "Change sources of given seams");
    case SharpAngleProperty:
        return QT_TRANSLATE_NOOP("Undo Commands", "Change angle of sharp edges");
    case AlignProperty:
        return QT_TRANSLATE_NOOP("Undo Commands", "Change alignment to the axes");
    case MirrorMapsProperty:
        return QT_TRANSLATE_NOOP("Undo Commands", "Change mirrored maps");
    case WorldUpProperty:
        return QT_TRANSLATE_NOOP("Undo Commands", "Change what is up in the map");
    case FlatProperty:
        return QT_TRANSLATE_NOOP("Undo Commands", "Change shape of flat faces");
    case SurfaceProperty:
        return QT_TRANSLATE_NOOP("Undo Commands", "Change what the model is like");
    case AlikeProperty:
        return QT_TRANSLATE_NOOP("Undo Commands", "Change cuts of alike parts");
    case MaxDistortionProperty:
        return QT_TRANSLATE_NOOP("Undo Commands", "Change distortion budget");
    default:
        return nullptr;
    }
}

//! The same for the packing settings.
const char *packingText(int properties)
{
    switch (properties) {
    case TextureSizeProperty:
        return QT_TRANSLATE_NOOP("Undo Commands", "Change texture size");
    case MarginProperty:
        return QT_TRANSLATE_NOOP("Undo Commands", "Change margin");
    case UdimTileProperty:
        return QT_TRANSLATE_NOOP("Undo Commands", "Change UDIM tile");
    case RotationProperty:
        return QT_TRANSLATE_NOOP("Undo Commands", "Change rotation of islands");
    case KeepScaleProperty:
        return QT_TRANSLATE_NOOP("Undo Commands", "Change keep scale");
    case BorderProperty:
        return QT_TRANSLATE_NOOP("Undo Commands", "Change border of the tile");
    case EffortProperty:
        return QT_TRANSLATE_NOOP("Undo Commands", "Change packing effort");
    default:
        return nullptr;
    }
}

} // namespace

ChangeSettings::ChangeSettings(Document &document, const SolveSettings &solve, const PackingSettings &packing)
    : DocumentCommand(document), mSolveBefore(document.solveSettings()),
      mSolveAfter(isValid(solve) ? solve : mSolveBefore), mPackingBefore(document.packingSettings()),
      mPackingAfter(packing.isValid() ? packing : mPackingBefore),
      mSolveProperties(differences(mSolveBefore, mSolveAfter)),
      mPackingProperties(differences(mPackingBefore, mPackingAfter))
{}

bool ChangeSettings::hasAnyChanges() const
{
    return mSolveBefore != mSolveAfter || mPackingBefore != mPackingAfter;
}

void ChangeSettings::apply()
{
    setSolveSettings(mSolveAfter);
    setPackingSettings(mPackingAfter);
}

void ChangeSettings::revert()
{
    setSolveSettings(mSolveBefore);
    setPackingSettings(mPackingBefore);
}

bool ChangeSettings::absorb(const DocumentCommand &newer)
{
    const auto &other = static_cast<const ChangeSettings &>(newer);
    if (other.mSolveProperties != mSolveProperties || other.mPackingProperties != mPackingProperties)
        return false;
    mSolveAfter = other.mSolveAfter;
    mPackingAfter = other.mPackingAfter;
    return true;
}

QString ChangeSettings::label() const
{
    const int solve = differences(mSolveBefore, mSolveAfter);
    const int packing = differences(mPackingBefore, mPackingAfter);
    if (packing == 0 && solveText(solve))
        return plainText(solveText(solve));
    if (solve == 0 && packingText(packing))
        return plainText(packingText(packing));
    return plainText(QT_TRANSLATE_NOOP("Undo Commands", "Change settings"));
}

void ChangeSettings::writePayload(QCborMap &map) const
{
    map["solve"_L1] = autocuts::toCbor(mSolveAfter);
    map["packing"_L1] = autocuts::toCbor(mPackingAfter);
}

Result<std::unique_ptr<DocumentCommand>> ChangeSettings::fromCbor(Document &document, CborReader &reader)
{
    CborReader solveReader(reader.map("solve"_L1));
    CborReader packingReader(reader.map("packing"_L1));
    const SolveSettings solve = readSolveSettings(solveReader);
    const PackingSettings packing = readPackingSettings(packingReader);
    if (reader.failed() || solveReader.failed() || packingReader.failed())
        return damagedCommand();
    return std::unique_ptr<DocumentCommand>(std::make_unique<ChangeSettings>(document, solve, packing));
}

} // namespace autocuts
