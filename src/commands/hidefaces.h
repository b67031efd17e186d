// The command that hides and shows faces.
#pragma once

#include "commands/changevalue.h"

namespace autocuts {

//! Chooses which faces are hidden. Hidden elements leave the selection.
class HideFaces final : public ChangeValue<QList<int>>
{
public:
    //! \param hidden all faces that are hidden afterwards, strictly ascending; nothing changes when the mesh
    //! does not have them
    HideFaces(Document &document, QList<int> hidden);

    //! Hides these faces as well, or shows them. \param faces strictly ascending
    static std::unique_ptr<HideFaces> change(Document &document, const QList<int> &faces, bool hide);
    //! Hides all other faces, too. \param faces strictly ascending
    static std::unique_ptr<HideFaces> others(Document &document, const QList<int> &faces);

    CommandId commandId() const override { return CommandId::HideFaces; }
    static std::unique_ptr<HideFaces> fromCbor(Document &document, CborReader &reader);

protected:
    void set(const QList<int> &faces) override { editor().setHiddenFaces(faces); }
    void writePayload(QCborMap &map) const override;
    QString label() const override;
};

} // namespace autocuts
