// Tagging islands.
#pragma once

#include "commands/documentcommand.h"
#include "model/document/cborvalues.h"
#include "model/document/result.h"

namespace autocuts {

//! Puts a named tag on islands or takes it off, through their faces.
class SetIslandTag final : public DocumentCommand
{
public:
    //! \param islands numbers of Document::islands(), in any order
    //! \param on nothing changes when the name is empty or has more than maxNameLength characters
    SetIslandTag(Document &document, const QString &name, const std::vector<int> &islands, bool on);

    CommandId commandId() const override { return CommandId::SetIslandTag; }
    bool hasAnyChanges() const override { return mBefore != mAfter; }
    static Result<std::unique_ptr<DocumentCommand>> fromCbor(Document &document, CborReader &reader);
    //! Takes a tag off all faces.
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
