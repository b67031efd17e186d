// What the fuzz targets share.
#pragma once

#include <QByteArray>
#include <QFile>
#include <QString>

#include <cstdio>
#include <cstdlib>

namespace autocuts::fuzz {

//! Ends the program when a property does not hold; libFuzzer then saves the input.
inline void require(bool holds, const char *what)
{
    if (holds)
        return;
    std::fprintf(stderr, "fuzz: %s\n", what);
    std::abort();
}

//! Writes an input to start from into the folder that AUTOCUTS_FUZZ_SEEDS names, if it names one.
inline void writeSeed(const QString &name, const QByteArray &bytes)
{
    const QString folder = qEnvironmentVariable("AUTOCUTS_FUZZ_SEEDS");
    if (folder.isEmpty())
        return;
    QFile file(folder + QLatin1Char('/') + name);
    require(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size(), "a seed cannot be written");
}

} // namespace autocuts::fuzz
