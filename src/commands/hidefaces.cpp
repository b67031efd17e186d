#include "commands/hidefaces.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

HideFaces::HideFaces(Document &document, QList<int> hidden)
    : ChangeValue(document, document.state().hiddenFaces, std::move(hidden))
{
    if (!isIndexSet(mAfter, document.mesh().faceCount()))
        mAfter = mBefore;
}

std::unique_ptr<HideFaces> HideFaces::change(Document &document, const QList<int> &faces, bool hide)
{
    const QList<int> &before = document.state().hiddenFaces;
    QList<int> after;
    if (hide)
        std::set_union(before.cbegin(), before.cend(), faces.cbegin(), faces.cend(),
                       std::back_inserter(after));
    else
        std::set_difference(before.cbegin(), before.cend(), faces.cbegin(), faces.cend(),
                            std::back_inserter(after));
    return std::make_unique<HideFaces>(document, after);
}

std::unique_ptr<HideFaces> HideFaces::others(Document &document, const QList<int> &faces)
{
    QList<int> all(document.mesh().faceCount());
    std::iota(all.begin(), all.end(), 0);
    QList<int> rest;
    std::set_difference(all.cbegin(), all.cend(), faces.cbegin(), faces.cend(), std::back_inserter(rest));
    return change(document, rest, true);
}

QString HideFaces::label() const
{
    const auto more = static_cast<int>(mAfter.size() - mBefore.size());
    if (mAfter.isEmpty())
        return UndoText::tr("Show all faces");
    if (more == 0)
        return UndoText::tr("Hide other faces");
    return more > 0 ? UndoText::tr("Hide %n faces", nullptr, more)
                    : UndoText::tr("Show %n faces", nullptr, -more);
}

void HideFaces::writePayload(QCborMap &map) const
{
    map["faces"_L1] = packedIntegers(mAfter);
}

std::unique_ptr<HideFaces> HideFaces::fromCbor(Document &document, CborReader &reader)
{
    const QList<int> faces = reader.indexSet("faces"_L1, document.mesh().faceCount());
    if (reader.failed())
        return nullptr;
    return std::make_unique<HideFaces>(document, faces);
}

} // namespace autocuts
