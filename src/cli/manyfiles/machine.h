// What a batch needs of the operating system beyond Qt.
#pragma once

#include <QProcess>

namespace autocuts::manyfiles {

//! Memory that is free, in bytes.
qint64 freeMemory();
//! Makes a process that is started next end with this program, where the system can do that, and leaves
//! Ctrl-C to the program. Its files are worked on for the batch only: without it nothing would note what
//! comes of them.
void endWithProgram(QProcess &process);

} // namespace autocuts::manyfiles
