// Pictures of materials as messages of the live link have them.
#pragma once

#include "model/document/texturesets.h"

#include <QJsonArray>

#include <vector>

namespace autocuts::link {

//! Materials and what is known of their pictures.
struct NamedTextures
{
    std::vector<QString> names;
    std::vector<TextureSet> sets; //!< of each name; pictures that are files only

    //! \param list a "materials" field; what is no material in it has no name
    static NamedTextures read(const QJsonValue &list);
    QJsonArray written() const;
};

} // namespace autocuts::link
