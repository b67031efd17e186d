// The command that tags islands.
#pragma once

#include "commands/changevalue.h"

namespace autocuts {

//! Adds a tag to islands or removes it, on all of their faces.
class SetIslandTag final : public ChangeValue<QList<int>>
{
public:
    //! \param islands indices in Document::islands(), in any order
    //! \param on true adds the tag; nothing changes when its name is empty or longer than maxNameLength
    SetIslandTag(Document &document, const QString &name, const std::vector<int> &islands, bool on);

    CommandId commandId() const override { return CommandId::SetIslandTag; }
    static std::unique_ptr<SetIslandTag> fromCbor(Document &document, CborReader &reader);
    //! Removes a tag from all faces.
    static std::unique_ptr<SetIslandTag> remove(Document &document, const QString &name);

protected:
    void set(const QList<int> &faces) override { editor().setTag(mName, faces); }
    void writePayload(QCborMap &map) const override;
    QString label() const override;

private:
    QString mName;
    bool mOn;
    int mCount;
};

} // namespace autocuts
