#include "commands/edituvsets.h"

#include "commands/uvrows.h"
#include "model/plain/uvlayout.h"

#include <algorithm>
#include <limits>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

int lastUvSet(const Document &document)
{
    return static_cast<int>(document.uvSets().size()) - 1;
}

} // namespace

ChooseUvSet::ChooseUvSet(Document &document, int index)
    : ChangeValue(document, document.activeUvSet(),
                  index >= 0 && index <= lastUvSet(document) ? index : document.activeUvSet())
{}

bool ChooseUvSet::absorb(const DocumentCommand &newer)
{
    mAfter = static_cast<const ChooseUvSet &>(newer).mAfter;
    return true;
}

QString ChooseUvSet::label() const
{
    return UndoText::tr("Choose UV set");
}

void ChooseUvSet::writePayload(QCborMap &map) const
{
    map["index"_L1] = mAfter;
}

std::unique_ptr<ChooseUvSet> ChooseUvSet::fromCbor(Document &document, CborReader &reader)
{
    const int index = static_cast<int>(reader.integer("index"_L1, 0, lastUvSet(document)));
    if (reader.failed())
        return nullptr;
    return std::make_unique<ChooseUvSet>(document, index);
}

AddUvSet::AddUvSet(Document &document, const QString &name, int source)
    : DocumentCommand(document),
      mName(uniqueUvSetName(document.uvSets(), name.isEmpty() ? u"UVMap"_s : name)),
      mSource(source <= lastUvSet(document) ? source : -1), mActiveBefore(document.activeUvSet())
{}

void AddUvSet::apply()
{
    const bool copies = mSource >= 0;
    UvSet set{mName, copies ? document().uvSets()[mSource].uv : emptyLayout(document().mesh())};
    const double scale = copies ? document().state().uvScales[mSource] : defaultUvScale;
    editor().insertUvSet(lastUvSet(document()) + 1, std::move(set), scale);
    editor().setActiveUvSet(lastUvSet(document()));
}

void AddUvSet::revert()
{
    editor().setActiveUvSet(mActiveBefore);
    editor().removeUvSet(lastUvSet(document()));
}

QString AddUvSet::label() const
{
    return UndoText::tr("Add UV set");
}

void AddUvSet::writePayload(QCborMap &map) const
{
    map["name"_L1] = mName;
    map["source"_L1] = mSource;
}

std::unique_ptr<AddUvSet> AddUvSet::fromCbor(Document &document, CborReader &reader)
{
    const QString name = reader.text("name"_L1);
    const int source = static_cast<int>(reader.integer("source"_L1, -1, lastUvSet(document)));
    if (reader.failed())
        return nullptr;
    return std::make_unique<AddUvSet>(document, name, source);
}

RenameUvSet::RenameUvSet(Document &document, int index, const QString &name)
    : ChangeValue(document, document.uvSets()[index].name, name), mIndex(index)
{
    if (name.isEmpty() || uniqueUvSetName(document.uvSets(), name) != name)
        mAfter = mBefore;
}

QString RenameUvSet::label() const
{
    return UndoText::tr("Rename UV set");
}

void RenameUvSet::writePayload(QCborMap &map) const
{
    map["index"_L1] = mIndex;
    map["name"_L1] = mAfter;
}

std::unique_ptr<RenameUvSet> RenameUvSet::fromCbor(Document &document, CborReader &reader)
{
    const int index = static_cast<int>(reader.integer("index"_L1, 0, lastUvSet(document)));
    const QString name = reader.text("name"_L1);
    if (reader.failed())
        return nullptr;
    return std::make_unique<RenameUvSet>(document, index, name);
}

DeleteUvSet::DeleteUvSet(Document &document, int index)
    : DocumentCommand(document), mIndex(index), mActiveBefore(document.activeUvSet()),
      mName(document.uvSets()[index].name), mScale(document.state().uvScales[index]),
      mContent(uvDelta(emptyLayout(document.mesh()), document.uvSets()[index].uv))
{}

void DeleteUvSet::apply()
{
    editor().removeUvSet(mIndex);
}

void DeleteUvSet::revert()
{
    UvSet set{mName, emptyLayout(document().mesh())};
    const UvMatrix rows = toggledRows(mContent, set.uv);
    Eigen::Index row = 0;
    mContent.indices().forEach([&](int corner) { set.uv.row(corner) = rows.row(row++); });
    editor().insertUvSet(mIndex, std::move(set), mScale);
    editor().setActiveUvSet(mActiveBefore);
}

QString DeleteUvSet::label() const
{
    return UndoText::tr("Delete UV set");
}

qint64 DeleteUvSet::payloadBytes() const
{
    return mContent.byteCount() + mName.size() * qint64(sizeof(QChar));
}

void DeleteUvSet::clearPayload()
{
    mContent = XorDelta(uvRowSize);
}

void DeleteUvSet::compact()
{
    mContent.pack(document().undoStack().pool(), document().adjacency().cornersByVertex());
}

void DeleteUvSet::writePayload(QCborMap &map) const
{
    map["index"_L1] = mIndex;
}

std::unique_ptr<DeleteUvSet> DeleteUvSet::fromCbor(Document &document, CborReader &reader)
{
    const int index = static_cast<int>(reader.integer("index"_L1, 0, lastUvSet(document)));
    if (reader.failed() || document.uvSets().size() < 2)
        return nullptr;
    return std::make_unique<DeleteUvSet>(document, index);
}

} // namespace autocuts
