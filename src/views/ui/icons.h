// Icons drawn for this program: lines in one colour, tinted by the palette.
#pragma once

#include <QIcon>
#include <QString>
#include <QStringList>

namespace autocuts {

//! The icon of resources/icons with this name, in the text colour of the application's palette at the moment
//! it is painted, sharp at every size and pixel ratio. A null icon when there is none.
QIcon icon(const QString &name);
//! The same in the colours of the file: for messages.
QIcon coloredIcon(const QString &name);
//! The program's own icon.
QIcon applicationIcon();
//! Names of all icons.
QStringList iconNames();

} // namespace autocuts
