// The command that tags islands.
#pragma once

#include "commands/documentcommand.h"
#include "model/document/cborvalues.h"
#include "model/document/result.h"

namespace autocuts {

//! Adds a tag to islands or removes it, on all of their faces.
class SetIslandTag final : public DocumentCommand
{
public:
    //! \param islands indices in Document::islands(), in any order
    //! \param on true adds the tag; nothing changes when its name is empty or longer than maxNameLength
    SetIslandTag(Document &document, const QString &name, const std::vector<int> &islands, bool on);

    CommandId commandId() const override { return CommandId::SetIslandTag; }
    bool hasAnyChanges() const override { return mBefore != mAfter; }
    static Result<std::unique_ptr<DocumentCommand>> fromCbor(Document &document, CborReader &reader);
    //! Removes a tag from all faces.
    static std::unique_ptr<SetIslandTag> remove(Document &document, const QString &name);

protected:
    void apply() override { setTag(mName, mAfter); }
    void revert() override { setTag(mName, mBefore); }
    void writePayload(QCborMap &map) const override;
    QString label() const override;
    qint64 payloadBytes() const override;
    void clearPayload() override;

private:
    QString mName;
    bool mOn;
    int mCount;
    QList<int> mBefore, mAfter;
};

} // namespace autocuts
