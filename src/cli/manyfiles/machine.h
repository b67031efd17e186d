// What a batch needs of the operating system beyond Qt.
#pragma once

#include <QProcess>

namespace autocuts::manyfiles {

//! Memory that is free, in bytes.
qint64 freeMemory();
//! Prepares a process before its start. It is to end when this program ends, where the system can do that,
//! because then nobody would note its results; and Ctrl-C is to reach this program only.
void endWithProgram(QProcess &process);

} // namespace autocuts::manyfiles
