// What the maps of a bake are called.
#pragma once

#include <QString>

namespace autocuts {

//! Translated; empty where the title says all. \param name one of jobs::bakeMapNames()
QString bakeMapTitle(const QString &name);
QString bakeMapTip(const QString &name);

} // namespace autocuts
