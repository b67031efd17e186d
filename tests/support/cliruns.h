// Runs of the command line program, in this process or on its own, and files for it to work on.
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>

namespace autocuts::test {

//! What a run left behind.
struct CliRun
{
    int code = -1; //!< exit code; -1 when it crashed
    QString out, err;
};

//! Parses the arguments and runs the command in this process, as the program does.
CliRun runInProcess(const QStringList &arguments);
//! Runs a program on its own, without a terminal, and waits for it.
CliRun runProgram(const QString &program, const QStringList &arguments);

//! Arguments for a quick unwrap.
QStringList draft(const QString &in, const QString &out);

//! Content of a file; empty when it cannot be read.
QByteArray readBytes(const QString &path);
//! Writes a file; false when that fails.
bool writeBytes(const QString &path, const QByteArray &bytes);

//! A folder of its own for the files of a test class.
class OwnFolder
{
protected:
    QString at(const char *name) const { return mFolder.filePath(QString::fromUtf8(name)); }
    //! Writes a file. \returns its path, empty when that failed
    QString file(const char *name, const QByteArray &bytes) const
    {
        const QString path = at(name);
        return writeBytes(path, bytes) ? path : QString();
    }

    QTemporaryDir mFolder;
};

//! An OBJ cube of quads with comments, groups, materials, normals and unknown lines, without UVs.
QByteArray quadCubeObj();
//! An OBJ file of n x n quads on a cylinder's half, without UVs.
QByteArray sheetObj(int n);

} // namespace autocuts::test
