// What lets a shell complete the program's commands, options and values, made from the table in clitable.h.
#pragma once

#include <QString>
#include <QStringList>

namespace autocuts {

//! The shells that completionScript() knows: bash, zsh and fish.
const QStringList &completionShells();

//! A file for the folder in which the shell looks for completions.
//! \pre completionShells() contains the shell
QString completionScript(const QString &shell);

} // namespace autocuts
