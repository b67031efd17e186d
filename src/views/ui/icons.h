// The program's icons: lines in one colour, tinted with the palette.
#pragma once

#include <QIcon>
#include <QString>
#include <QStringList>

namespace autocuts {

//! The icon of this name in resources/icons. It is drawn in the text colour that the application's palette
//! has at that moment, and is sharp at every size and pixel ratio. A null icon when there is none.
QIcon icon(const QString &name);
//! The same icon in the colour of text on the accent colour; used on primary buttons.
QIcon accentIcon(const QString &name);
//! The same icon in the colours of its file; used in messages.
QIcon coloredIcon(const QString &name);
//! The icon of the program.
QIcon applicationIcon();
//! The names of all icons.
QStringList iconNames();

} // namespace autocuts
